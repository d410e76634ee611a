"""Runs tools with different numbers and sources of threads. All files must be equal except run records, and a tool must not
compute with more threads than --threads allows, nor its child processes.

usage: check_threads.py TOOL_FOLDER WORK_FOLDER [--colonoscopy]"""

import os
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path

from check_limits import content, fast_commands, inputs

#: The first one is the reference. oneTBB is the default of a build with it.
RUNS = [(1, ""), (2, ""), (3, ""), (8, ""), (2, "itk"), (8, "itk")]
ROUNDING = 0.3  # seconds of CPU time that the accounting of many processes may add


def results(tools, command, out, threads, source):
    """Returns the files and the fault of a run, if any."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir()
    words = [str(word).replace("OUT/", f"{out}/") for word in command]
    environment = {**os.environ, "SHAPETON_THREADS_FROM": source}
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run([tools / words[0], *words[1:], "--threads", str(threads), "--quiet"], check=True, env=environment)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    fault = f"{words[0]} --threads {threads} computed {cpu:.2f} s in {wall:.2f} s" if cpu > threads * wall + ROUNDING else ""
    return {name: data for name, data in content(out).items() if not name.endswith("run.json")}, fault


def faults_of(tools, work, command):
    out = work / "out"  # the same for all runs, because files may contain its name
    reference, faults = None, []
    for threads, source in RUNS:
        files, fault = results(tools, command, out, threads, source)
        faults += [fault] if fault else []
        reference = reference or files
        different = [name for name in sorted({*reference, *files}) if reference.get(name) != files.get(name)]
        if different:
            faults.append(f"{command[0]} with {threads} threads of {source or 'oneTBB'} differs: {', '.join(different)}")
    return faults if reference else [f"{command[0]} wrote nothing"]


def main(tools, work, is_colonoscopy):
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    inputs(tools, work, "128,128,120" if is_colonoscopy else "64,64,60")
    commands = fast_commands(work)
    if is_colonoscopy:
        commands = [["VirtualColonoscopy", work / "colon", "OUT/run", "--faces", "20000", "--viewer", "--dicomResults"]]
    faults = [fault for command in commands for fault in faults_of(tools, work, command)]
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve(), "--colonoscopy" in sys.argv[3:])
