"""What the panel's buttons and the menus do with the properties of a display: copy and paste, save as default, restore
defaults, undo and redo of a quality, animation of numbers.

Usage: pvpython panel_buttons.py
"""
import numpy
import paraview.simple as pv
from paraview.modules.vtkRemotingMisc import vtkSMProxyClipboard
from paraview.modules.vtkRemotingServerManager import vtkSMProxyManager, vtkSMSettings, vtkSMUndoStack, vtkSMUndoStackBuilder

import session
from checks import Checks, cloud

#: what is set, no default among it
SET = {"GlyphShape": "Capsule", "ScaleFactor": 0.31, "GlyphScaleFunction": "Square Root", "ScaleMode": "Magnitude", "SelectScaleArray": "scalar",
       "GlyphLegend": "Upper Left", "ShutterTime": 0.5, "ShutterOpening": "Forward", "ShadingMode": "Ambient Occlusion", "SamplesPerPixel": 3, "Exposure": 0.5}
#: what the data have a say in, whatever was saved or restored; ParaView saves no defaults of what depends on another property
FROM_DATA = {"ScaleFactor", "SelectScaleArray", "ShutterTime"}
#: what is chosen by the data, and other values
OTHERS = {"SelectScaleArray": "other", "SelectOrientationVectors": "force", "GlyphTensorArray": "None", "VelocityArray": "force", "TubeRadius": 7.0,
          "ScaleFactor": 0.11}
CHOSEN = tuple(OTHERS)
QUALITY = ("RenderingQuality", "ShadingMode", "SamplesPerPixel", "Denoising", "Shadows", "GroundShadow", "OutlineWidth")


def values(shown, names=tuple(SET)):
    """The properties as they are."""
    return {name: str(shown.GetPropertyValue(name)).strip("'") for name in names}


def show(view, **properties):
    """Some points as glyphs with these properties."""
    shown = pv.Show(cloud(50), view)
    shown.SetRepresentationType(session.REPRESENTATION)
    for name, value in properties.items():
        setattr(shown, name, value)
    pv.Render(view)
    return shown


def copy_and_paste(checks, view):
    """All that was set arrives; what shares nothing with it stays."""
    shown, other = show(view, **SET), show(session.view(60, 40))
    clipboard = vtkSMProxyClipboard()
    checks.true("nothing can be copied", clipboard.Copy(shown.SMProxy))
    checks.true("nothing can be pasted", clipboard.CanPaste(other.SMProxy) and clipboard.Paste(other.SMProxy))
    checks.equal("pasted", values(other), values(shown))
    return shown


def defaults(checks, view, shown):
    """Restored, the properties are as at first; saved, the next display has them."""
    first = show(session.view(60, 40))
    plain = values(first)
    wanted = values(shown)
    names = [name for name in SET if name not in FROM_DATA]
    checks.true("a display has from the beginning what is set: %s" % plain, all(plain[name] != wanted[name] for name in names))
    settings = vtkSMSettings.GetInstance()
    settings.SetProxySettings(shown.SMProxy)
    later = show(session.view(60, 40))
    checks.equal("saved as default", values(later, names), {name: wanted[name] for name in names})
    settings.ClearAllSettings()
    later.SMProxy.ResetPropertiesToDefault()
    later.SetRepresentationType(session.REPRESENTATION)
    pv.Render(pv.GetActiveView())
    checks.equal("restored", values(later, names), {name: plain[name] for name in names})


def panel_button(shown):
    """What the panel's button Restore Application Default Setting Values resets: every value, in the order of the names."""
    properties = shown.SMProxy.NewPropertyIterator()
    properties.UnRegister(None)
    properties.Begin()
    while not properties.IsAtEnd():
        found = properties.GetProperty()
        if found.IsA("vtkSMVectorProperty") and not found.GetInformationOnly() and not found.GetNoCustomDefault():
            found.ResetToDefault()
        properties.Next()
    shown.SMProxy.UpdateVTKObjects()


def one_by_one(shown):
    """What scripts do."""
    for name in CHOSEN:
        pv.ResetProperty(name, shown)


def all_at_once(shown):
    """The input, too, which ParaView resets first, so that no data are known when the arrays' turn comes."""
    shown.SMProxy.ResetPropertiesToDefault()
    shown.SMProxy.UpdateVTKObjects()


def reset(checks):
    """Reset, a display looks as when it was first shown: what the data have chosen is chosen again."""
    random = numpy.random.default_rng(5)
    source = session.source(session.poly_data(random.uniform(-1.0, 1.0, (40, 3)), other=random.uniform(size=40), radius=random.uniform(0.1, 0.3, 40),
                                              force=random.normal(size=(40, 3)), velocity=random.normal(size=(40, 3)),
                                              stress=random.normal(size=(40, 6))))
    view = session.view(120, 90)
    session.look(view, (0.0, 0.0, 6.0))
    for way in (panel_button, one_by_one, all_at_once):
        shown = session.glyphs(source, view, ScaleMode="Magnitude")
        expected, first = session.capture(view, "panel-buttons-first"), values(shown, CHOSEN)
        checks.equal("chosen", [first[name] for name in CHOSEN[:4]], ["radius", "velocity", "stress", "velocity"])
        for name, value in OTHERS.items():
            setattr(shown, name, value)
        pv.Render(view)
        checks.true("everything is as at first: %s" % first, all(value != first[name] for name, value in values(shown, CHOSEN).items()))
        way(shown)
        shown.SetRepresentationType(session.REPRESENTATION)
        # What is 3D Glyphs' has ParaView's defaults, but for the size.
        shown.GlyphType, shown.ScaleMode, shown.SamplesPerPixel = "Sphere", "Magnitude", 1
        shown.Scaling, shown.Orient, shown.SelectScaleArray, shown.SelectOrientationVectors = 1, 1, "radius", "velocity"
        picture = session.capture(view, "panel-buttons-reset")
        checks.equal("reset, " + way.__name__, values(shown, CHOSEN), first)
        checks.picture("reset, " + way.__name__, picture, expected, pixels=0.0, mean=0.0)
        pv.Delete(shown)
    pv.Delete(view)


def undo(checks, view, shown):
    """One undo takes a quality back with all that it has set, one redo gives it again."""
    stack, builder = vtkSMUndoStack(), vtkSMUndoStackBuilder()
    builder.SetUndoStack(stack)
    vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(builder)
    shown.SamplesPerPixel = 5  # the first change after a stack is there only gives it the old values
    for name in ("Fast", "Balanced", "Publication"):
        before = values(shown, QUALITY)
        builder.Begin(name)
        shown.RenderingQuality = name
        builder.End()
        builder.PushToStack()
        after = values(shown, QUALITY)
        checks.equal("quality", after["RenderingQuality"], name)
        stack.Undo()
        checks.equal(name + ": after undo", values(shown, QUALITY), before)
        stack.Redo()
        checks.equal(name + ": after redo", values(shown, QUALITY), after)
    vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(None)


def animated(checks, view, shown):
    """Numbers follow an animation track, those that hold for a view, too."""
    scene = pv.GetAnimationScene()
    scene.PlayMode, scene.StartTime, scene.EndTime, scene.NumberOfFrames = "Sequence", 0.0, 1.0, 3
    for name, first, last in (("ScaleFactor", 0.1, 0.5), ("Exposure", -1.0, 1.0), ("GlyphTensorSharpness", 0.5, 3.0)):
        track = pv.GetAnimationTrack(name, index=0, proxy=shown)
        frames = [pv.CompositeKeyFrame(KeyTime=time, KeyValues=[value]) for time, value in ((0.0, first), (1.0, last))]
        track.KeyFrames = frames
        for time in (0.0, 0.5, 1.0):
            scene.AnimationTime = time
            value = first + time * (last - first)
            checks.within("%s at %g" % (name, time), getattr(shown, name), value - 1e-6, value + 1e-6)
        track.Enabled = 0


def main():
    """All parts."""
    session.load()
    checks = Checks()
    view = session.view(60, 40)
    shown = copy_and_paste(checks, view)
    undo(checks, view, shown)
    animated(checks, view, shown)
    for name, value in SET.items():
        setattr(shown, name, value)
    defaults(checks, view, shown)
    reset(checks)
    checks.report()


if __name__ == "__main__":
    main()
