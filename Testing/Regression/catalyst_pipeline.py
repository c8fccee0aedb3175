# script-version: 2.0
"""A Catalyst script as ParaView's File > Save Catalyst State writes them, with a display of the plugin: pictures of the steps 4 and 7.

In situ its source is what the simulation calls grains; in pvpython it is the file, whose extracts in_situ.py saves.
"""
import os

import paraview.simple as pv
from paraview import catalyst

pv._DisableFirstRenderCameraReset()
pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=False, ns=vars(pv))
grains = pv.LegacyVTKReader(registrationName="grains", FileNames=[os.environ["RTGLYPHS_DATA"] + "/impact/impact_%02d.vtk" % step for step in range(8)])
view = pv.CreateView("RenderView")
view.ViewSize = [200, 150]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 0.0, 1.0]
view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [11.0, -32.0, 26.0], [14.0, 14.0, 8.0], [0.0, 0.0, 1.0]
shown = pv.Show(grains, view)
shown.SetRepresentationType("Ray Traced Glyphs")
shown.GlyphType = "Arrow"
shown.Orient, shown.SelectOrientationVectors = 1, "velocity"
shown.Scaling, shown.ScaleMode, shown.SelectScaleArray = 1, "Magnitude", "velocity"
shown.ScaleFactor = 0.2
shown.ColorArrayName = ["POINTS", ""]
shown.AmbientColor = shown.DiffuseColor = [0.9, 0.8, 0.2]

extractor = pv.CreateExtractor("PNG", view, registrationName="picture")
extractor.Trigger = "TimeStep"
extractor.Trigger.UseStartTimeStep, extractor.Trigger.StartTimeStep, extractor.Trigger.Frequency = 1, 4, 3
extractor.Writer.FileName = "step_{timestep:d}.png"
extractor.Writer.ImageResolution = [200, 150]

options = catalyst.Options()
options.GlobalTrigger = "TimeStep"
options.ExtractsOutputDirectory = os.environ["RTGLYPHS_EXTRACTS"]
