/**
 * Makes raytracedglyphs.py known to ParaView's Python, so that scripts can import it once the plugin is loaded.
 *
 * ParaView's own means is PYTHON_MODULES of paraview_add_plugin(). In ParaView 6.1 it replaces the XML of the plugin's
 * C++ proxies by that of the module's Python proxies (vtkPVPythonAlgorithmPlugin::GetXMLs), here by none, and runs the
 * module while the plugin is loaded, on servers too.
 */
#ifndef RayTracedGlyphsPython_h
#define RayTracedGlyphsPython_h

void RegisterRayTracedGlyphsPython();

#endif
