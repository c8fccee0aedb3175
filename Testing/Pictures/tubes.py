"""Lines as tubes: chains of forces between grains, and streamlines of a flow. With "paraview", ParaView's Tube filter draws them.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython tubes.py CONTACTS.vtk OUTPUT-FOLDER [WIDTH HEIGHT] [paraview]
CONTACTS.vtk is what Data/contacts.py makes of Data/impact/impact_02.vtk.
"""
import sys

import paraview.simple as pv

from simulation import begin, look, new_view, save, scalar_bar

#: Arnold, Beltrami and Childress: a flow along which the vorticity is the velocity
FLOW = "iHat*(sin(0.4*coordsZ)+0.7*cos(0.4*coordsY))+jHat*(0.8*sin(0.4*coordsX)+cos(0.4*coordsZ))+kHat*(0.7*sin(0.4*coordsY)+0.8*cos(0.4*coordsX))"


def color(shown, view, association, array, limits, preset, title):
    """Colors by an array, with a scalar bar."""
    pv.ColorBy(shown, (association, array))
    scalar_bar(pv.GetColorTransferFunction(array), shown, view, limits, preset, title, (0.58, 0.82))


def tubes(source, view, ours, radius, array):
    """Shows lines as tubes; `array`: what their radius is proportional to."""
    if ours:
        shown = pv.Show(source, view)
        shown.SetRepresentationType("Ray Traced Tubes")
        if array:
            shown.TubeRadiusArray = array
        shown.TubeRadius = radius
        shown.ShadingMode, shown.SamplesPerPixel, shown.AmbientOcclusionRadius = "Ambient Occlusion", 32, 4.0
        return shown
    if array:
        thick = pv.Calculator(Input=pv.CellDatatoPointData(Input=source), ResultArrayName="radius", Function="%g*%s" % (radius, array))
        return pv.Show(pv.Tube(Input=thick, VaryRadius="By Absolute Scalar", Scalars=["POINTS", "radius"], NumberofSides=12), view)
    return pv.Show(pv.Tube(Input=source, VaryRadius="Off", Radius=radius, NumberofSides=12), view)


def chains(view, contacts, ours):
    """Contacts between grains that a ball has just hit, as thick as the root of their force."""
    thick = pv.Calculator(Input=pv.LegacyVTKReader(FileNames=[contacts]), AttributeType="Cell Data", ResultArrayName="root", Function="sqrt(force)")
    shown = tubes(thick, view, ours, 0.006, "root")
    color(shown, view, "CELLS", "force", (0.0, 990.0), "Plasma", "force between two grains")
    look(view, (10.0, -12.0, 17.0), (12.9, 12.0, 5.5), (0.0, 0.0, 1.0))
    view.CameraViewAngle = 21.0


def streamlines(view, ours):
    """The flow through a cube."""
    flow = pv.Calculator(Input=pv.Wavelet(WholeExtent=[-12, 12, -12, 12, -12, 12]), ResultArrayName="flow", Function=FLOW)
    seeds = {"SeedType": "Point Cloud"}
    lines = pv.StreamTracer(Input=flow, Vectors=["POINTS", "flow"], **seeds)
    lines.SeedType.Center, lines.SeedType.Radius, lines.SeedType.NumberOfPoints = [0.0] * 3, 11.0, 120
    lines.MaximumStreamlineLength = 24.0
    shown = tubes(lines, view, ours, 0.22, None)
    color(shown, view, "POINTS", "flow", (0.0, 2.4), "Viridis", "speed")
    look(view, (34.0, -42.0, 28.0), (0.0, 0.0, 1.5), (0.0, 0.0, 1.0))


def main():
    """Makes the pictures."""
    contacts, folder = begin()
    ours = "paraview" not in sys.argv
    size = [int(value) for value in sys.argv[3:5] if value.isdigit()] or [1200, 900]
    for name, draw in (("chains", lambda view: chains(view, contacts, ours)), ("streamlines", lambda view: streamlines(view, ours))):
        view = new_view(size)
        draw(view)
        pv.Render(view)
        save(view, folder, name if ours else name + "-paraview", size)
    pv.Disconnect()


if __name__ == "__main__":
    main()
