"""What a frame costs while the camera turns."""
import resource
import statistics
import time

import paraview.simple as pv


def cpu_seconds():
    """User and system time of this process on all cores."""
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def turning(view, frames):
    """Medians of wall and processor seconds a frame, the camera turning by a degree before each."""
    camera, wall, cpu = pv.GetActiveCamera(), [], []
    for _ in range(frames):
        camera.Azimuth(1.0)
        start, start_cpu = time.monotonic(), cpu_seconds()
        pv.Render(view)
        wall.append(time.monotonic() - start)
        cpu.append(cpu_seconds() - start_cpu)
    return statistics.median(wall), statistics.median(cpu)
