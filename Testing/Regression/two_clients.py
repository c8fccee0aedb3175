"""Two clients of one server: what one of them sets, and what its data suggest, is no choice of the other's user; both show the same.

Usage: pvpython two_clients.py PVPYTHON PVSERVER
"""
import json
import os
import sys
import time

import paraview.simple as pv
from paraview import servermanager

import client_server
import session
from checks import Checks

#: seconds within which the other client must have done something; it takes a few
LIMIT = 120.0
READY, DONE = "two-clients-ready", "two-clients-done.json"


def wait(holds):
    """Takes what the other client has done, until the condition holds; whether it does."""
    network = servermanager.vtkProcessModule.GetProcessModule().GetNetworkAccessManager()
    end = time.monotonic() + LIMIT
    while not holds() and time.monotonic() < end:
        network.ProcessEvents(50)
    return holds()


def found(shown):
    """What is compared."""
    return {"from the data": shown.ScaleFactorFromData, "factor": round(shown.ScaleFactor, 6),
            "light": str(shown.ShadingMode).strip("'"), "samples": shown.SamplesPerPixel}


def displays():
    """The displays that a client sees."""
    every = pv.servermanager.ProxyManager().GetProxiesInGroup("representations").values()
    return [shown for shown in every if shown.GetProperty("ScaleFactorFromData") is not None]


def second(port):
    """The other client, which is there before the first one renders."""
    pv.Connect("127.0.0.1", port)
    wait(displays)
    open(session.output(READY), "w").close()
    wait(lambda: displays()[0].SamplesPerPixel == 3)
    view = pv.GetActiveViewOrCreate("RenderView")
    pixels = session.capture(view, "two-clients-second")
    with open(session.output(DONE), "w") as file:
        json.dump({**found(displays()[0]), "covered": float((pixels != pixels[0, 0]).any(axis=2).mean())}, file)


def first(checks, pvpython, pvserver):
    """Shows glyphs, and renders when the other client sees them."""
    for name in (READY, DONE):
        if os.path.exists(session.output(name)):
            os.remove(session.output(name))
    server, port = client_server.start_server([pvserver, "--multi-clients"], "two-clients-server.log")
    pv.Connect("127.0.0.1", port)
    pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=True, ns=vars(pv))
    view = session.view(120, 90)
    shown = pv.Show(pv.PointSource(NumberOfPoints=100, Radius=1.0), view)
    shown.SetRepresentationType(session.REPRESENTATION)
    other = client_server.start([pvpython, os.path.abspath(__file__), "second", str(port)], "two-clients-second.log")
    checks.true("the second client sees no display", wait(lambda: os.path.exists(session.output(READY))))
    pv.Render(view)
    shown.ShadingMode, shown.SamplesPerPixel = "Ambient Occlusion", 3
    pv.Render(view)
    checks.true("the second client does not get the samples", wait(lambda: os.path.exists(session.output(DONE)) and other.poll() is not None))
    with open(session.output("two-clients-second.log")) as log:
        print(log.read())
    with open(session.output(DONE)) as file:
        there = json.load(file)
    checks.within("the second client's picture: covered", there.pop("covered"), 0.01, 0.9)
    checks.equal("what the second client has", there, found(shown))
    checks.equal("the size follows the data", found(shown)["from the data"], 1)
    client_server.stop(server)


def main(arguments):
    """Either client."""
    pv._DisableFirstRenderCameraReset()
    session.load()
    if arguments[0] == "second":
        second(int(arguments[1]))
        os._exit(0)
    checks = Checks()
    first(checks, *arguments)
    for failure in checks.failures:
        print("FAILED:", failure)
    print("TWO CLIENTS TEST " + ("FAILED" if checks.failures else "PASSED"))
    sys.stdout.flush()
    os._exit(1 if checks.failures else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
