/**
 * Defaults that ParaView's domains choose for properties of this plugin: arrays, places and sizes that fit the data.
 *
 * Every display of a data set has these properties, in every representation, and ParaView would name them in the trace
 * and the Python state of any display: scripts that do not run without this plugin. So on displays that show nothing
 * ray traced a value that ParaView has chosen counts as the default; so does, on all displays, a number that follows
 * the data.
 *
 * In XML such properties are written as RayTracedStringVectorProperty, with si_class, and so on. All others of displays
 * become RayTracedPlainStringVectorProperty and so on (CMakeLists.txt): state files do not have them either.
 */
#ifndef RayTracedDefault_h
#define RayTracedDefault_h

class vtkSMProperty;
class vtkSMProxy;

namespace rtglyphs::RayTracedDefault
{
/**
 * Makes the kinds of properties known to the server manager. May be called again.
 */
void Register();

/**
 * Which of the values that ParaView, or the plugin, has chosen are chosen anew.
 */
enum class Where
{
  Everywhere,
  Lost,   // arrays that are in no list of arrays any more, and what Missing names
  Missing // None, and what stands in the XML, where the data had nothing to choose
};

/**
 * Whether a display is one of ParaView's window; scripts set what they need.
 */
bool IsInWindow(vtkSMProxy* display);

/**
 * Whether the domains of a property would choose its present value.
 */
bool IsOfDomains(vtkSMProperty* property);

/**
 * A property is being set that the defaults of others depend on.
 */
void Follow(vtkSMProxy* representation, const char* name);

/**
 * After an update of the view, before its render: what the data shown before had nothing for, these may have, as the
 * first time step with particles has arrays. While time goes on a default that was found stays; other data may have
 * others. Returns whether something was chosen anew.
 */
bool Renew(vtkSMProxy* display, bool otherTime);
}

#endif
