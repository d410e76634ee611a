"""Resources of an examination, from the size of its volumes."""

import functools
import os
import subprocess


@functools.cache
def voxels_of(folder):
    """Returns an upper bound, assuming that all files below the folder are slices like the first; 0 without DICOM. Only
    one slice is read, because Snakemake calls this for all examinations before the first one starts."""
    files = sorted(os.path.join(place, name) for place, _, names in os.walk(folder) for name in names if not name.startswith("."))
    for file in files[:20]:  # the first files may not be DICOM
        size = _slice_size(file)
        if size:
            return size * len(files)
    return 0


def megabytes(voxels, attempt, greatest=None):
    """Returns the memory: 600 MB, including 120 for Snakemake, plus 28 bytes per voxel (measured: 3,453 MB for 112.7 million
    voxels); doubled in a second attempt. Limited to the memory of the machine, where the examination then runs
    alone."""
    asked = int((600 + 28e-6 * voxels) * attempt)
    return min(asked, greatest) if greatest else asked


def minutes(voxels, attempt):
    """Returns the time limit on a cluster: ten times the time measured on one core."""
    return int((10 + 60e-8 * voxels) * attempt)


def _slice_size(file):
    command = ["dcmdump", "-q", "+P", "Rows", "+P", "Columns", "+P", "NumberOfFrames", "-s", file]
    lines = subprocess.run(command, capture_output=True, text=True, errors="replace").stdout.splitlines()
    values = {line[:11]: line.split()[2].strip("[]") for line in lines if len(line.split()) > 2}
    try:
        return int(values["(0028,0010)"]) * int(values["(0028,0011)"]) * int(values.get("(0028,0008)", 1))
    except (KeyError, ValueError):
        return 0
