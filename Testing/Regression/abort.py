"""A long trace asks the window whether to go on, and ends when the window says no; the view goes on afterwards. The
abort callback may draw: the picture stays the same.

Usage: pvpython abort.py
"""
import time

import paraview.simple as pv

import accumulation
import session
from checks import Checks, cloud, information

SAMPLES = 32
GL_FRAMEBUFFER = 0x8D40  # of OpenGL's headers


def seconds(action):
    """Processor seconds that it takes: other tests may run at the same time."""
    start = time.process_time()
    action()
    return time.process_time() - start


def main():
    """A whole render, an interrupted one, an interactive one after it, and a whole one again."""
    session.load()
    checks = Checks()
    view = session.view(240, 180)
    shown = session.glyphs(cloud(2000), view, Orient=0, ScaleFactor=0.15, ShadingMode="Ambient Occlusion")
    session.solid(shown, (0.9, 0.9, 0.9))
    session.look(view, (0.0, 0.0, 7.0))
    pv.Render(view)  # programs are compiled
    shown.SamplesPerPixel = SAMPLES
    session.look(view, (0.0, 0.0, 6.0))
    whole = seconds(lambda: pv.Render(view))
    expected = accumulation.shown_by(view)
    checks.covered("whole picture", expected, 0.2)

    window, asked = view.SMProxy.GetRenderWindow(), []

    def stop(*_):
        asked.append(True)
        window.SetAbortRender(1)

    session.look(view, (1.0, 0.0, 6.0))
    observer = window.AddObserver("AbortCheckEvent", stop)
    said = []
    interrupted = seconds(lambda: said.append(session.messages(lambda: pv.Render(view))))
    window.RemoveObserver(observer)
    print("whole %.2f s, interrupted %.2f s, asked %d times, %d samples"
          % (whole, interrupted, len(asked), information(shown, "AccumulatedSamples")))
    checks.true("the window was not asked whether to go on", bool(asked))
    checks.true("an interrupted render takes %.2f s, a whole one %.2f s" % (interrupted, whole), interrupted < 0.4 * whole)
    checks.no_message("interrupted render", said[0])
    checks.true("an interrupted image is called finished", information(shown, "AccumulatedSamples") < SAMPLES)

    view.SMProxy.InteractiveRender()
    checks.covered("interactive picture after an interrupted one", accumulation.shown_by(view), 0.2)
    session.look(view, (0.0, 0.0, 6.0))
    checks.no_message("next render", session.messages(lambda: pv.Render(view)))
    checks.equal("samples of the next render", information(shown, "AccumulatedSamples"), SAMPLES)
    checks.picture("picture of the next render", accumulation.shown_by(view), expected)

    def draw(*_):
        """What a window leaves behind that repaints itself when it is asked."""
        state = window.GetState()
        state.vtkglBindFramebuffer(GL_FRAMEBUFFER, 0)
        state.vtkglViewport(0, 0, 20, 10)
        state.vtkglScissor(0, 0, 20, 10)

    session.look(view, (1.0, 0.0, 6.0))
    pv.Render(view)
    session.look(view, (0.0, 0.0, 6.0))
    observer = window.AddObserver("AbortCheckEvent", draw)
    pv.Render(view)
    window.RemoveObserver(observer)
    checks.picture("picture of a render in which a window repaints itself", accumulation.shown_by(view), expected)
    checks.report()


if __name__ == "__main__":
    main()
