#!@Python_EXECUTABLE@
"""Benchmark of the Python package against the tool: time and memory of heat, import, two diffusions in two threads, and
delay from Ctrl-C to the end of a call.

usage: PythonBenchmark [--size VOXELS] [--steps STEPS] [--repeats NUMBER]

The tool and the package alternate on the same volume in separate processes: both read it, run the heat diffusion
and write the heat, which must be equal.
"""

import argparse
import os
import statistics
import sys
import tempfile
import time
from pathlib import Path

PACKAGE, TOOLS = "@CMAKE_BINARY_DIR@/python", "@CMAKE_RUNTIME_OUTPUT_DIRECTORY@"
sys.path.insert(0, PACKAGE)

import numpy as np

import shapeton

HEAT = """
import sys, shapeton
volume, heat, steps = sys.argv[1:4]
image = shapeton.read_volume(volume)
shapeton.write_volume(shapeton.diffuse_heat(image, time_steps=int(steps)).heat, heat)
"""

ABORT = """
import os, signal, sys, threading, time, shapeton
image = shapeton.read_volume(sys.argv[1])
sent = []
def interrupt():
    sent.append(time.perf_counter())
    os.kill(os.getpid(), signal.SIGINT)
threading.Timer(float(sys.argv[2]), interrupt).start()
try:
    shapeton.diffuse_heat(image, time_steps=10**7)
except KeyboardInterrupt:
    print(time.perf_counter() - sent[0])
"""


THREADS = """
import sys, time, shapeton
from concurrent.futures import ThreadPoolExecutor
image = shapeton.read_volume(sys.argv[1])
shapeton.set_threads(1)
def diffuse(_):
    return shapeton.diffuse_heat(image, time_steps=int(sys.argv[2]))
begin = time.perf_counter()
for i in range(2):
    diffuse(i)
middle = time.perf_counter()
with ThreadPoolExecutor(2) as pool:
    list(pool.map(diffuse, range(2)))
print((time.perf_counter() - middle) / (middle - begin))
"""


def run(command):
    """Runs a program; returns its time, its CPU time (s), its peak memory (MB) and its output."""
    begin = time.perf_counter()
    reader, writer = os.pipe()
    actions = [(os.POSIX_SPAWN_DUP2, writer, 1)]
    child = os.posix_spawn(command[0], command, {**os.environ, "PYTHONPATH": PACKAGE}, file_actions=actions)
    os.close(writer)
    with os.fdopen(reader) as stream:
        printed = stream.read()
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"{command} has failed")
    return time.perf_counter() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0, printed


def volume_of(size, folder):
    """Balls in noise, as CT."""
    random = np.random.default_rng(1)
    z, y, x = np.ogrid[0:size, 0:size, 0:size]
    voxels = np.full((size, size, size), -1000.0, np.float32)
    for _ in range(40):
        center, radius = random.uniform(0.1, 0.9, 3) * size, random.uniform(0.02, 0.1) * size
        inside = (z - center[0]) ** 2 + (y - center[1]) ** 2 + (x - center[2]) ** 2 < radius**2
        voxels[inside] = random.uniform(0.0, 1000.0)
    voxels += random.normal(0.0, 10.0, voxels.shape).astype(np.float32)
    shapeton.write_volume(shapeton.Image(voxels), str(folder / "volume.nrrd"))
    return str(folder / "volume.nrrd")


def compare_heat(volume, folder, steps, repeats):
    program = os.path.join(TOOLS, "CumulativeHeatDiffusion")
    tool = [program, volume, str(folder / "tool.nrrd"), "--timeSteps", str(steps)]
    package = [sys.executable, "-c", HEAT, volume, str(folder / "package.nrrd"), str(steps)]
    runs = [(run(tool), run(package)) for _ in range(repeats)]
    for index, name, unit in ((0, "time", "s"), (1, "computing time", "s"), (2, "memory", "MB")):
        one, other = (statistics.median(pair[side][index] for pair in runs) for side in (0, 1))
        print(f"heat, {name}: tool {one:.2f} {unit}, package {other:.2f} {unit}, ratio {other / one:.3f}")
    heats = [shapeton.read_volume(str(folder / name)).array for name in ("tool.nrrd", "package.nrrd")]
    print("heat, voxels:", "equal bytes" if heats[0].tobytes() == heats[1].tobytes() else "DIFFERENT")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--steps", type=int, default=100000)
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    for module in ("numpy", "shapeton"):
        runs = [run([sys.executable, "-c", f"import {module}"]) for _ in range(9)]
        times = [statistics.median(r[index] for r in runs) for index in (0, 1)]
        print(f"import {module}: {times[0]:.3f} s, computing {times[1]:.3f} s")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        volume = volume_of(options.size, folder)
        compare_heat(volume, folder, options.steps, options.repeats)
        share = float(run([sys.executable, "-c", THREADS, volume, str(options.steps)])[3])
        print(f"two diffusions of one thread each, at once against one after the other: ratio {share:.3f}")
        for delay in (0.05, 0.2, 0.4, 0.6, 3.0, 5.0):
            elapsed = float(run([sys.executable, "-c", ABORT, volume, str(delay)])[3])
            print(f"Ctrl-C {delay} s after the start of heat: the call ends after {elapsed:.3f} s")


if __name__ == "__main__":
    main()
