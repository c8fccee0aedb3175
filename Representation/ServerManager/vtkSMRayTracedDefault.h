/**
 * Defaults that ParaView's domains choose for properties of this plugin: arrays, places and sizes that fit the data.
 *
 * Every display of a data set has these properties, whatever it is shown as, and ParaView would name them in the trace
 * and the Python state of any display: scripts that do not run without this plugin. So on displays that show nothing
 * ray traced a value that ParaView has chosen counts as the default; so does, on all displays, a number that follows
 * the data or is but another name of one of ParaView's own (PathMetallic is Metallic).
 *
 * In XML such properties are written as RayTracedStringVectorProperty, with si_class, and so on. All others of displays
 * become RayTracedPlainStringVectorProperty and so on (CMakeLists.txt): state files do not have them either.
 */
#ifndef vtkSMRayTracedDefault_h
#define vtkSMRayTracedDefault_h

class vtkSMProxy;

namespace vtkSMRayTracedDefault
{
/**
 * Makes the kinds of properties known to the server manager. May be called again.
 */
void Register();

/**
 * A property is being set that the defaults of others depend on.
 */
void Follow(vtkSMProxy* representation, const char* name);

/**
 * After an update of the view, before its render: what the data shown before had nothing for, these may have, as the
 * first time step with particles has arrays. While time goes on a default that was found stays; other data may have
 * others.
 */
void Renew(vtkSMProxy* display, vtkSMProxy* view, bool otherTime);
}

#endif
// VTK-HeaderTest-Exclude: vtkSMRayTracedDefault.h
