"""The stiffness of crystals by direction.

Usage: RTGLYPHS_PLUGIN=PLUGIN.so pvpython directions.py DATA-FOLDER OUTPUT-FOLDER
"""
import numpy
import paraview.simple as pv

import simulation
from simulation import source

#: Stiffness in GPa at room temperature, c11 c12 c13 c33 c44 c14; of cubic crystals c13 is c12 and c33 is c11.
CRYSTALS = (
    ("copper", (168.4, 121.4, 121.4, 168.4, 75.4, 0.0)),  # W. C. Overton and J. Gaffney, Physical Review 98, 969 (1955)
    ("tungsten", (522.4, 204.4, 204.4, 522.4, 160.6, 0.0)),  # F. H. Featherston and J. R. Neighbours, Physical Review 130, 1324 (1963)
    ("zinc", (163.7, 36.4, 53.0, 63.5, 38.8, 0.0)),  # G. A. Alers and J. R. Neighbours, Journal of Physics and Chemistry of Solids 7, 58 (1958)
    # H. J. McSkimin, P. Andreatch and R. N. Thurston, Journal of Applied Physics 36, 1624 (1965)
    ("quartz", (86.8, 7.04, 11.91, 105.75, 58.2, -18.04)),
)


def stiffness(c11, c12, c13, c33, c44, c14):
    """The 36 components of a cubic, hexagonal or trigonal crystal, rows and columns in the order xx, yy, zz, yz, xz, xy."""
    c66 = c44 if c11 == c33 else 0.5 * (c11 - c12)
    return numpy.array([[c11, c12, c13, c14, 0, 0], [c12, c11, c13, -c14, 0, 0], [c13, c13, c33, 0, 0, 0],
                        [c14, -c14, 0, c44, 0, 0], [0, 0, 0, 0, c44, c14], [0, 0, 0, 0, c14, c66]]).ravel()


def crystals(view):
    """In a row across the view, each as large as the others."""
    toward = numpy.array([2.0, -6.0, 3.0]) / 7.0
    across = numpy.cross((0.0, 0.0, 1.0), toward) / numpy.linalg.norm(toward[:2])
    places = numpy.array([(1.15 * i - 1.725) * across for i in range(len(CRYSTALS))])
    shown = simulation.show(source(places, stiffness=[stiffness(*constants) for _, constants in CRYSTALS]), view, "Fourth-Order Tensor",
                            GlyphTensorArray="stiffness", GlyphScaleFunction="All the Same", ScaleFactor=1.0, Orient=0,
                            GlyphDirectionColoring="Axes", Ambient=0.2)
    simulation.look(view, 6.0 * toward, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    view.CameraParallelProjection, view.CameraParallelScale = 1, 0.6
    return shown


def main():
    """Makes the picture."""
    _, folder = simulation.begin()
    view = simulation.new_view([720, 194])
    crystals(view).SamplesPerPixel = 32
    simulation.save(view, folder, "crystals", [720, 194])
    pv.Disconnect()


if __name__ == "__main__":
    main()
