"""Glyphs through a server: the pictures of remote and of client rendering, and the glyphs that the client exports, are those
of a session without a server.

Usage: pvpython client_server.py DATA-FOLDER PVSERVER [MPIEXEC ARGUMENT...]
PVSERVER is run behind MPIEXEC ARGUMENT..., for a server of several ranks.
"""
import os
import socket
import subprocess
import sys

import numpy
import paraview.simple as pv

import comparison
import export
import parallel
import session

#: fraction of the pixels that may differ: those on outlines, where another order of the points rounds another way
OUTLINE = 0.0002
#: megabytes of geometry above which ParaView renders on the server: always, never
REMOTE, CLIENT = 0.0, 20.0


def scene(folder):
    """Particles spread over the ranks as arrows and spheres, on an opaque surface; (view, both representations)."""
    view = session.view(300, 200)
    spread = session.spread(folder + "/impact/impact_04.vtk")
    spheres = session.glyphs(spread, view, "Sphere", Orient=0, SelectScaleArray="diameter",
                             ScaleMode="Magnitude", ScaleFactor=1.0)
    session.solid(spheres, (0.9, 0.7, 0.3))
    lifted = pv.Transform(Input=spread)
    lifted.Transform.Translate = [0.0, 0.0, 12.0]
    arrows = session.glyphs(lifted, view, "Arrow", ArrowHeads="Fixed", SelectOrientationVectors="velocity", ScaleMode="Magnitude",
                            SelectScaleArray="velocity", ScaleFactor=0.2)
    pv.ColorBy(arrows, ("POINTS", "velocity"))
    arrows.SetScalarBarVisibility(view, False)
    ball = pv.Show(pv.Sphere(Center=[14.0, 14.0, 4.0], Radius=8.0, ThetaResolution=64, PhiResolution=64), view)
    ball.SetRepresentationType("Surface")
    session.solid(ball, (0.2, 0.5, 0.3))
    session.look(view, (11.0, -32.0, 26.0), (14.0, 14.0, 8.0), (0.0, 0.0, 1.0))
    return view, spheres, arrows


def legends():
    """Legends of arrows, whose heads depend on the scales of all of them, and of a mesh: the client that draws them may have no points."""
    view = session.view(200, 150)
    for shape, corner, further in (("Arrow", "Lower Left", {}), ("Mesh", "Upper Right", {"GlyphType": session.triangles(pv.Box(XLength=3.0, YLength=0.5))})):
        sizes = pv.Calculator(Input=pv.Sphere(ThetaResolution=6, PhiResolution=5), Function="0.001*(coordsX+2)", ResultArrayName="size")
        shown = session.glyphs(sizes, view, shape, ArrowHeads="Fixed", SelectOrientationVectors="Normals", ScaleMode="Magnitude", SelectScaleArray="size",
                               ScaleFactor=300.0, GlyphLegend=corner, GlyphLegendValue=0.002, **further)
        session.solid(shown, (1.0, 0.0, 0.0))
    session.look(view, (0.0, 0.0, 6.0))
    pv.Render(view)
    return view


def exported(view, name):
    """How many copies of each mesh the client exports."""
    import raytracedglyphs  # comes with the plugin
    path = session.output(name + ".glb")
    if os.path.exists(path):
        os.remove(path)
    raytracedglyphs.ExportGlyphs(path, view)
    return sorted((part.name, len(part.positions)) for parts in export.from_gltf(path) for part in parts)


def places(view):
    """What ParaView picks in space at some pixels: where a center of rotation or a widget's point would come to lie."""
    width, height = view.ViewSize
    found = {}
    for x in range(width // 8, width, width // 8):
        for y in range(height // 8, height, height // 8):
            place, normal = [0.0] * 3, [0.0] * 3
            if view.SMProxy.ConvertDisplayToPointOnSurface([x, y], place, normal, False):
                found[x, y] = place
    return found


def check_places(found, expected, what):
    """The same as without a server."""
    print("%s: %d places picked, %d expected" % (what, len(found), len(expected)))
    apart = [pixel for pixel in expected if pixel not in found or numpy.abs(numpy.subtract(found[pixel], expected[pixel])).max() > 1e-3]
    return ["%s: %d of %d places picked in space are others" % (what, len(apart), len(expected))] if apart or len(expected) < 5 else []


def start(command, log_name):
    """A process of its own that writes to a log of that name."""
    # This process is an MPI rank, too; an mpiexec that is told so starts nothing.
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("PMIX_", "ORTE_", "OMPI_"))
                   or name.startswith(("OMPI_ALLOW", "OMPI_MCA_rmaps", "OMPI_MCA_mpi_yield"))}
    with open(session.output(log_name), "w") as log:
        return subprocess.Popen(command, env=environment, stdout=log, stderr=subprocess.STDOUT)


def start_server(program, log_name="client-server.log"):
    """A server that waits for this process and writes to a log of that name; (process, port)."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    return start(program + ["--server-port=%d" % port], log_name), port


def stop(process):
    """Ends the server: ParaView's own of several ranks stays when its client leaves, and MPI may hold back SIGTERM."""
    process.terminate()
    try:
        process.wait(timeout=20)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def check_statistics(shown, what):
    """Information properties speak of the process that traced."""
    found = session.statistics(shown)
    print("%s: %s" % (what, found))
    if not found.get("DeviceName") or found.get("AccumulatedSamples") != 1 or found.get("dispatches", 0) < 1:
        return ["%s: RenderStatistics %s" % (what, found)]
    return []


def main(folder, server):
    """The same scene without a server, then with one that renders, then with one that only has the data."""
    pv._DisableFirstRenderCameraReset()
    session.load()
    view = scene(folder)[0]
    pv.Render(view)
    # Two servers may be tested at once.
    test = "client-server" + ("-ranks" if len(server) > 1 else "")
    log_name = test + ".log"
    expected = session.capture(view, test + "-none")
    expected_places = places(view)
    expected_copies = exported(view, test + "-none")
    expected_blocks = [session.capture(block_view, picture) for picture, block_view in parallel.block_pictures(test + "-none")]
    expected_legends = session.capture(legends(), test + "-legends-none")
    pv.Disconnect()

    process, port = start_server(server, log_name)
    failures = []
    try:
        pv.Connect("127.0.0.1", port)
        session.load()
        pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=True, ns=vars(pv))
        for where, threshold in (("remote", REMOTE), ("client", CLIENT)):
            view, spheres, arrows = scene(folder)
            view.RemoteRenderThreshold = threshold
            pv.Render(view)
            failures += check_statistics(spheres, where) + check_statistics(arrows, where)
            failures += check_places(places(view), expected_places, where)
            legend_view = legends()
            legend_view.RemoteRenderThreshold = threshold
            pv.Render(legend_view)
            found = [(name, session.capture(of_view, name), wanted)
                     for name, of_view, wanted in ((test + "-" + where, view, expected), (test + "-legends-" + where, legend_view, expected_legends))]
            for wanted, (picture, block_view) in zip(expected_blocks, parallel.block_pictures(test + "-" + where)):
                block_view.RemoteRenderThreshold = threshold
                pv.Render(block_view)
                found.append((picture, session.capture(block_view, picture), wanted))
            for name, pixels, wanted in found:
                share, mean, apart = comparison.difference(pixels, wanted)
                print("%s: %.3f%% of the pixels differ by more than %d, mean %.4f" % (name, 100 * share, comparison.LEVELS, mean))
                if share > OUTLINE:
                    comparison.write_image(session.output(name + "-difference.png"), 4 * apart)
                    failures.append("%s rendering: the picture is not that without a server" % name)
            copies = exported(view, test + "-" + where)
            if copies != expected_copies:
                failures.append("%s rendering: exports %s, not %s" % (where, copies, expected_copies))
            pv.Delete(view)
            pv.Delete(legend_view)
    finally:
        stop(process)
    with open(session.output(log_name)) as log:
        print(log.read())
    for failure in failures:
        print("FAILED:", failure)
    print("CLIENT SERVER TEST " + ("FAILED" if failures else "PASSED"))
    sys.stdout.flush()
    os._exit(1 if failures else 0)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[3:] + [sys.argv[2]])
