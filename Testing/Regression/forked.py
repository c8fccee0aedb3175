"""Runs tests in processes that fork from one pvpython: it has loaded what all of them load, which takes 2 s of CPU time each.

Usage: python3 forked.py start FOLDER PVPYTHON PLUGIN | stop FOLDER | run FOLDER SCRIPT ARGUMENT...
start: pvpython in the background, which listens to a socket in FOLDER. run: the script with this process's environment, folder,
streams and exit status, as pvpython would run it; it ends with this process.

A fork has one thread. The pvpython of ParaView 6 starts with two, so there each script has a pvpython of its own.
"""
import json
import os
import runpy
import select
import shutil
import signal
import socket
import subprocess
import sys
import time

#: Each process goes to FOLDER before it names the socket: a socket's path has at most 107 characters.
SOCKET = "pvpython.socket"
#: a link to the pvpython that runs each script by itself, where none can fork
ALONE = "pvpython.alone"
#: exit status of a pvpython that cannot fork
CANNOT_FORK = 3
#: seconds that pvpython may take to start
START = 120.0
#: what a connection begins with
RUN, STOP = b"r", b"s"


def connect(folder):
    """A connection to the pvpython of that folder; None where there is none."""
    before = os.getcwd()
    connection = socket.socket(socket.AF_UNIX)
    try:
        os.chdir(folder)
        connection.connect(SOCKET)
        return connection
    except OSError:
        connection.close()
        return None
    finally:
        os.chdir(before)


def start(folder, pvpython, plugin):
    os.makedirs(folder, exist_ok=True)
    stop(folder)
    # Symbols are bound once here instead of when each test first needs them.
    environment = {**os.environ, "LD_BIND_NOW": "1"}
    with open(os.path.join(folder, "pvpython.log"), "w", encoding="utf-8") as log:
        server = subprocess.Popen([pvpython, "--no-mpi", os.path.abspath(__file__), "serve", plugin], cwd=folder, env=environment,
                                  stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True)
    end = time.monotonic() + START
    while server.poll() is None and time.monotonic() < end:
        connection = connect(folder)
        if connection:
            connection.close()
            return 0
        time.sleep(0.1)
    if server.returncode == CANNOT_FORK:
        os.symlink(shutil.which(pvpython), os.path.join(folder, ALONE))
        print("each script has a pvpython of its own")
        return 0
    print("forked.py: pvpython did not start; see %s" % log.name, file=sys.stderr)
    return 1


def stop(folder):
    if os.path.lexists(os.path.join(folder, ALONE)):
        os.remove(os.path.join(folder, ALONE))
    connection = connect(folder)
    if connection:
        with connection:
            connection.sendall(STOP)
            connection.recv(1)  # until it has gone
    return 0


def run(folder, argv):
    alone = os.path.join(folder, ALONE)
    if os.path.exists(alone):
        pvpython = os.readlink(alone)
        os.execvp(pvpython, [pvpython] + argv)
    connection = connect(folder)
    if not connection:
        print("forked.py: no pvpython; run 'forked.py start %s PVPYTHON' first" % folder, file=sys.stderr)
        return 1
    with connection:
        wanted = {"argv": argv, "folder": os.getcwd(), "environment": dict(os.environ)}
        socket.send_fds(connection, [RUN], [0, 1, 2])
        connection.sendall(json.dumps(wanted).encode() + b"\n")
        status = connection.recv(64)
    if not status:
        print("forked.py: pvpython has gone", file=sys.stderr)
        return 1
    status = int(status)
    if status < 0:
        print("forked.py: %s" % signal.strsignal(-status), file=sys.stderr)
        return 128 - status
    return status


def line(connection):
    """What a connection says in one line of JSON."""
    text = b""
    while not text.endswith(b"\n"):
        text += connection.recv(65536)
    return json.loads(text)


def prepare(plugin):
    """What every script does first: loads the plugin, makes a view and a display. Proxies that ParaView has made by then stay."""
    import numpy  # noqa: F401
    import paraview.simple as pv
    from vtkmodules.numpy_interface import dataset_adapter  # noqa: F401
    from vtkmodules.util import numpy_support  # noqa: F401

    os.environ.pop("DISPLAY", None)  # each script has one of its own
    pv.LoadPlugin(plugin, remote=False, ns={})
    view, sphere = pv.CreateView("RenderView"), pv.Sphere()
    for made in (pv.Show(sphere, view), sphere, view):
        pv.Delete(made)


def serve():
    """Forks a process for each connection until one asks it to stop. Returns in the process of a test: what it is to do."""
    threads = os.listdir("/proc/self/task")
    if len(threads) != 1:
        print("pvpython has %d threads" % len(threads))
        sys.exit(CANNOT_FORK)
    if os.path.exists(SOCKET):
        os.remove(SOCKET)
    listener = socket.socket(socket.AF_UNIX)
    listener.bind(SOCKET)
    listener.listen(64)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # no process waits for those that watch a test
    while True:
        connection, _ = listener.accept()
        first, streams, _, _ = socket.recv_fds(connection, 1, 3)
        if first == STOP:
            os.remove(SOCKET)
            os._exit(0)
        if first == RUN and os.fork() == 0:
            listener.close()
            return watch(connection, streams)
        for stream in streams:
            os.close(stream)
        connection.close()


def watch(connection, streams):
    """Forks the test, and ends with it or with who asked for it. Returns in the test."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    wanted = line(connection)
    test = os.fork()
    if test == 0:
        os.setpgid(0, 0)
        connection.close()
        for number, stream in enumerate(streams):
            os.dup2(stream, number)
            os.close(stream)
        return wanted
    ended = os.pidfd_open(test)
    while ended not in select.select([connection, ended], [], [])[0]:
        if not connection.recv(1):
            os.killpg(test, signal.SIGKILL)
            break
    _, status = os.waitpid(test, 0)
    try:
        connection.sendall(b"%d" % os.waitstatus_to_exitcode(status))
    finally:
        os._exit(0)


if __name__ == "__main__":
    action, rest = sys.argv[1], sys.argv[2:]
    if action != "serve":
        sys.exit(run(rest[0], rest[1:]) if action == "run" else {"start": start, "stop": stop}[action](*rest))
    prepare(*rest)
    task = serve()
    os.environ.clear()
    os.environ.update(task["environment"])
    os.chdir(task["folder"])
    sys.argv = task["argv"]
    sys.path[0] = os.path.dirname(sys.argv[0])
    runpy.run_path(sys.argv[0], run_name="__main__")
