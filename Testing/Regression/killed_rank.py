"""A rank that is killed while all trace ends the others, and a client's session, within seconds and with a message.

Usage: pvpython killed_rank.py PVPYTHON PVBATCH PVSERVER MPIEXEC ARGUMENT...
       pvbatch killed_rank.py                what the ranks run
       pvpython killed_rank.py client PORT   what the client of a server runs
"""
import os
import re
import signal
import subprocess
import sys
import time

import paraview.simple as pv

import client_server
import session
from checks import Checks

#: seconds within which all must have ended, and a number of samples that takes very much longer
LIMIT, SAMPLES = 30.0, 10000000
#: Script of a source with points on each rank. The last rank says which process it is.
POINTS = """
import os
points, arrays, mine = numpy.random.default_rng(rank).uniform(-1.0, 1.0, (200, 3)), {}, slice(None)
if rank == ranks - 1:
    os.write(1, b"last rank: process %d\\n" % os.getpid())
"""


def trace():
    """Renders on all ranks, for hours."""
    session.load()
    view = session.view(300, 200)
    view.RemoteRenderThreshold = 0.0  # on the server, if there is one
    source = session.points_of_ranks(POINTS)
    session.glyphs(source, view, "Sphere", Orient=0, ScaleFactor=0.2, samples=SAMPLES)
    session.look(view, (0.0, 0.0, 5.0))
    pv.Render(view)


def trace_on_server(port):
    """The same by a client of that server, which draws."""
    pv.Connect("127.0.0.1", port)
    session.load()
    pv.LoadPlugin(os.environ["RTGLYPHS_PLUGIN"], remote=True, ns=vars(pv))
    trace()


def ends(checks, name, process, logs):
    """Kills the last rank once all trace; `process` must end soon. What the logs say."""
    def said():
        return "".join(open(session.output(log)).read() for log in logs)
    victim = None
    while not victim and process.poll() is None:
        time.sleep(0.1)
        victim = re.search(r"last rank: process (\d+)", said())
    checks.true("%s: no rank traced: %s" % (name, said()), victim)
    if not victim:
        return ""
    time.sleep(2.0)  # until all trace
    os.kill(int(victim.group(1)), signal.SIGKILL)
    began = time.monotonic()
    try:
        process.wait(timeout=LIMIT)
    except subprocess.TimeoutExpired:
        client_server.stop(process)
    seconds = time.monotonic() - began
    print("%s: ended %.1f s after the rank" % (name, seconds))
    checks.true("%s: ended %.1f s after a rank was killed, not within %g s" % (name, seconds, LIMIT), seconds < LIMIT)
    return said()


def main(pvpython, pvbatch, pvserver, mpiexec):
    """Ranks without and with a client."""
    checks = Checks()
    script = os.path.abspath(__file__)
    said = ends(checks, "pvbatch", client_server.start(mpiexec + [pvbatch, script], "killed-batch.log"), ["killed-batch.log"])
    checks.true("pvbatch: no word of the rank in '%s'" % said, said and re.search(r"rank 1\b.*(Killed|signal 9)", said, re.S))
    server, port = client_server.start_server(mpiexec + [pvserver], "killed-server.log")
    try:
        client = client_server.start([pvpython, script, "client", str(port)], "killed-client.log")
        said = ends(checks, "client", client, ["killed-server.log", "killed-client.log"])
        checks.true("client: no word of the connection in '%s'" % said, said and "connection" in said.lower())
    finally:
        client_server.stop(server)
    print("KILLED RANK TEST " + ("FAILED" if checks.failures else "PASSED"))
    checks.report()


if len(sys.argv) == 1:
    trace()
elif sys.argv[1] == "client":
    trace_on_server(int(sys.argv[2]))
else:
    main(sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:])
