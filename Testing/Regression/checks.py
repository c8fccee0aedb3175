"""Checks of a regression test: each one that fails is kept as a sentence, and report() prints them all.

Usage: checks = Checks(); checks.equal("ids", found, wanted); ...; checks.report()
"""
import time

import numpy
import paraview.simple as pv

import comparison
import session

#: words by which ParaView and VTK begin a message
MESSAGE_MARKS = ("ERR:", "ERROR:", "Error:", "Warning:", "WARN")


class Checks:
    """What has failed so far."""

    def __init__(self):
        self.failures = []

    def true(self, what, holds):
        """A condition that the sentence states."""
        if not holds:
            self.failures.append(what)

    def equal(self, what, found, wanted):
        """A value that must be exactly the wanted one."""
        self.true("%s: %s, not %s" % (what, found, wanted), found == wanted)

    def within(self, what, found, low, high):
        """A number that must lie in [low, high]."""
        self.true("%s: %s is not in [%s, %s]" % (what, found, low, high), low <= found <= high)

    def picture(self, what, found, wanted, pixels=comparison.PIXELS, mean=comparison.MEAN):
        """A picture that equals another one: few pixels differ by more than comparison.LEVELS, and the mean by little."""
        if found.shape[:2] != wanted.shape[:2]:
            self.failures.append("%s: size %s, not %s" % (what, found.shape, wanted.shape))
            return
        share, average, apart = comparison.difference(found[..., :3], wanted[..., :3])
        print("%s: %.3f%% of the pixels differ by more than %d, mean %.3f" % (what, 100 * share, comparison.LEVELS, average))
        if share > pixels or average > mean:
            name = what.replace(" ", "-").replace(",", "").lower()
            comparison.write_image(session.output(name + "-difference.png"), 4 * apart)
            self.failures.append("%s: %.3f%% of the pixels differ by more than %d (allowed %.3f%%), mean %.3f (allowed %.3f)"
                                 % (what, 100 * share, comparison.LEVELS, 100 * pixels, average, mean))

    def covered(self, what, found, low, high=1.0):
        """A picture of which that fraction of the pixels is not background."""
        self.within(what + ": covered fraction of the picture", round(float(comparison.covered(found).mean()), 4), low, high)

    def no_message(self, what, text):
        """ParaView has said nothing."""
        self.true("%s: %d messages: %s" % (what, number_of_messages(text), text.strip()), not text.strip())

    def one_message(self, what, text, *words):
        """ParaView has given exactly one message, which contains the words."""
        count = number_of_messages(text)
        missing = [word for word in words if word.lower() not in text.lower()]
        self.true("%s: %d messages, not 1: %s" % (what, count, text.strip()), count == 1)
        self.true("%s: the message does not contain %s: %s" % (what, missing, text.strip()), count == 0 or not missing)

    def report(self):
        """Prints what has failed and ends the process: 0 when nothing has."""
        session.finish(self.failures)


def number_of_messages(text):
    """Errors and warnings in what session.messages() has returned."""
    return sum(text.count(mark) for mark in MESSAGE_MARKS)


def information(shown, name):
    """Present value of an information property, or of a number of RenderStatistics."""
    if not shown.SMProxy.GetProperty(name):
        return session.statistics(shown)[name]
    shown.SMProxy.UpdatePropertyInformation(shown.SMProxy.GetProperty(name))
    return shown.SMProxy.GetProperty(name).GetElement(0)


def stepwise(shown, samples=-1):
    """Makes each render add so many samples to the image; -1: what time allows, as in ParaView's window; 0: all."""
    shown.SMProxy.GetProperty("SamplesPerRender").SetElement(0, samples)
    shown.SMProxy.UpdateVTKObjects()
    return shown


def pending(shown):
    """Whether more renders would improve the image of a representation."""
    return information(shown, "RefinementProgress") < 1.0


def refine(view, shown, seconds=150.0, look=lambda: None):
    """Renders until the image is finished, as ParaView's window does, with look() before each render and in the end.
    False: it is not finished after so many seconds.

    Renders are no measure: while a program is compiled, which a busy machine does for long, each of them adds nothing.
    """
    end = time.monotonic() + seconds
    while True:
        look()
        if not pending(shown):
            return True
        if time.monotonic() > end:
            return False
        pv.Render(view)


def cloud(count=300, seed=3, radius=1.0):
    """A source of random points in a cube with a scalar array."""
    points = numpy.random.default_rng(seed).uniform(-radius, radius, (count, 3))
    return session.source(session.poly_data(points, scalar=points[:, 0]))
