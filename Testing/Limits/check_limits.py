"""Runs tools on a full disk or with too little memory. The last message must state the reason, the status must be 1, and existing
files must be kept.

usage: check_limits.py disk|memory TOOL_FOLDER WORK_FOLDER [--colonoscopy]

disk mounts a small file system in a new namespace; without the permission to do so, the status is 77 (skipped). --colonoscopy tests
VirtualColonoscopy, which must resume after its finished stages; otherwise the fast tools are tested."""

import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SKIPPED = 77
MEMORY = re.compile(r": not enough memory[^\n]*; use [^\n]*$")
DISK = re.compile(r": No space left on device; free some space or choose another folder(; kept: .*)?$")
EARLIER = b"an earlier result"


def inputs(tools, work, size):
    run = lambda *command: subprocess.run([tools / command[0], *command[1:]], check=True, capture_output=True)
    run("ColonPhantom", work / "colon", "--size", size, "--seed", "7")
    run("ShapePhantom", work / "shapes.nrrd", "--shape", "figure2.7a", "--size", "64,64,64")
    run("SensorNetworkSimulator", work / "network", "--nodes", "150", "--steps", "1")


def fast_commands(work):
    """Returns command lines of the tools; arguments that start with OUT/ are outputs."""
    shapes, data = work / "shapes.nrrd", Path(__file__).parents[2] / "Data"
    return [
        ["ColonPhantom", "OUT/series", "--size", "64,64,60"],
        ["DicomSeriesToImage", work / "colon", "OUT/image.nrrd"],
        ["DicomSeriesToImage", work / "colon", "OUT/image.nii.gz"],
        ["CumulativeHeatDiffusion", shapes, "OUT/heat.nrrd", "--timeSteps", "30", "--report", "OUT/report"],
        ["ShapetonDiffusion", shapes, "OUT/density.nrrd", "--preset", "published", "--shapetons", "2000", "--timeSteps", "50", "--report", "OUT/report"],
        ["SensorNetworkSimulator", "OUT/steps", "--nodes", "150", "--steps", "2"],
        ["GraphEmbedding", work / "network/step-0000.graphml", "OUT/certificate.json", "--svg", "OUT/graph.svg", "--report", "OUT/report"],
        ["SurfaceSpectrum", data / "Torus.off", "OUT/spectrum.csv", "--eigenpairs", "20", "--heatKernelSignature", "OUT/hks.vtp"],
    ]


def run(tools, command, out, memory=None):
    """Returns the status, the messages, and the peak address space in bytes."""
    limit = (lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory))) if memory else None
    arguments = [str(tools / command[0]), *(str(word).replace("OUT/", f"{out}/") for word in command[1:]), "--quiet"]
    with tempfile.TemporaryFile("w+", encoding="utf-8") as messages:
        process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=messages, preexec_fn=limit)
        peak = 0
        while process.poll() is None:
            status = Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
            peak = max([peak] + [1024 * int(size) for size in re.findall(r"VmPeak:\s+(\d+)", status)])
            time.sleep(0.002)
        messages.seek(0)
        return process.returncode, messages.read(), peak


def content(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def size_on_disk(folder):
    return sum(path.stat().st_blocks * 512 for path in folder.rglob("*") if path.is_file())


def earlier_results(command, folder):
    """Creates files of an earlier run at the output paths of the command."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for word in map(str, command):
        if word.startswith("OUT/") and "." in word:
            (folder / word[4:]).write_bytes(EARLIER)


def judge(status, messages, pattern, before, out, complete):
    """Returns the fault of a run with limited resources, if any: it must write all files, or fail with the right message."""
    after = content(out)
    if status == 0:
        return None if set(after) == complete else f"success without {sorted(complete ^ set(after))}"
    if status != 1:
        return f"status {status}: {messages.strip() or 'no message'}"
    if not pattern.search(messages.strip()):
        return f"message: {messages.strip() or 'none'}"
    return None if before == after else f"files changed: {sorted(set(before) ^ set(after))}"


def mounted(folder, size):
    subprocess.run(["umount", folder], check=False, capture_output=True)
    folder.mkdir(exist_ok=True)
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "shapeton", folder], check=True)


def disk_faults(tools, work, command):
    full = work / "full"
    free = work / "free"
    earlier_results(command, free)
    status, messages, _ = run(tools, command, free)
    if status != 0:
        return [f"{command[0]} fails without a limit: {messages}"]
    complete, needed = set(content(free)), size_on_disk(free)
    faults, failures = [], 0
    for share in (0.1, 0.5, 0.9):
        mounted(full, max(4 * resource.getpagesize(), int(share * needed)))
        earlier_results(command, full / "out")
        before = content(full / "out")
        status, messages, _ = run(tools, command, full / "out")
        failures += status != 0
        fault = judge(status, messages, DISK, before, full / "out", complete)
        faults += [f"{command[0]} with {share} of {needed} bytes of disk: {fault}"] if fault else []
    return faults + ([] if failures else [f"{command[0]} never filled the disk"])


def colonoscopy_faults(tools, work):
    """Fills the disk in each stage in turn; each run with more space must resume the previous one."""
    full = work / "full"
    command = ["VirtualColonoscopy", work / "colon", "OUT/run", "--faces", "20000", "--viewer", "--dicomResults"]
    mounted(full, 1 << 20)
    (full / "out").mkdir()
    faults, stages = [], []
    for megabytes in (1, 4, 10, 20, 40, 80, 1000):
        subprocess.run(["mount", "-o", f"remount,size={megabytes}m", full], check=True)
        finished = content(full / "out")
        status, messages, _ = run(tools, command, full / "out")
        stages.append(len(finished))
        if status == 0:
            return faults + ([] if len(set(stages)) > 3 else [f"the disk was never full halfway: {stages} files before each run"])
        if status != 1 or not DISK.search(messages.strip()):
            faults.append(f"VirtualColonoscopy with {megabytes} MB of disk: status {status}: {messages}")
    return faults + [f"VirtualColonoscopy does not resume after space was freed: {messages}"]


def memory_faults(tools, work, command):
    out = work / "out"
    command = command + ["--threads", "2"]
    earlier_results(command, out)
    status, messages, peak = run(tools, command, out)
    if status != 0:
        return [f"{command[0]} fails without a limit: {messages}"]
    complete = set(content(out))
    _, _, least = run(tools, [command[0], "--xml"], out)  # below this, libraries abort before our code starts
    faults = []
    for share in (0.97, 0.9, 0.8, 0.7, 0.6):
        if share * peak < 1.1 * least:
            break
        earlier_results(command, out)
        before = content(out)
        status, messages, _ = run(tools, command, out, int(share * peak))
        fault = judge(status, messages, MEMORY, before, out, complete)
        faults += [f"{command[0]} with {share} of {peak} bytes of memory: {fault}"] if fault else []
    return faults


def main(kind, tools, work, is_colonoscopy):
    if kind == "disk" and "SHAPETON_NAMESPACE" not in os.environ:
        unshare = ["unshare", "--mount"] + ([] if os.geteuid() == 0 else ["--map-root-user"])
        if subprocess.run([*unshare, "mount", "-t", "tmpfs", "none", "/mnt"], check=False, capture_output=True).returncode != 0:
            print("no permission to mount a file system")
            sys.exit(SKIPPED)
        os.environ["SHAPETON_NAMESPACE"] = "1"
        os.execvp("unshare", [*unshare, sys.executable, *sys.argv])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    inputs(tools, work, "128,128,120" if is_colonoscopy else "64,64,60")
    check = disk_faults if kind == "disk" else memory_faults
    if is_colonoscopy:
        faults = colonoscopy_faults(tools, work)
    else:
        faults = [fault for command in fast_commands(work) for fault in check(tools, work, command)]
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve(), "--colonoscopy" in sys.argv[4:])
