"""One glyph on the Vulkan device: for CTest, which looks for the validation layers in what the Vulkan loader prints.

Usage: VK_LOADER_DEBUG=layer pvpython validation_layers.py
"""
import numpy
import paraview.simple as pv

import session


def main():
    """Renders once."""
    session.load()
    view = session.view(20, 16)
    session.glyphs(session.source(session.poly_data(numpy.zeros((1, 3)))), view, Orient=0)
    session.look(view, (0.0, 0.0, 5.0))
    pv.Render(view)
    session.finish()


if __name__ == "__main__":
    main()
