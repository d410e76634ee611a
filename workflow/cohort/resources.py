"""What an examination needs, from the size of its volumes."""

import functools
import os
import subprocess


@functools.cache
def voxels_of(folder):
    """An upper bound, as if all files below the folder were slices like the first. 0 where there is no DICOM file.
    One slice is read: for 10,000 examinations Snakemake asks before the first of them starts."""
    files = sorted(os.path.join(place, name) for place, _, names in os.walk(folder) for name in names if not name.startswith("."))
    for file in files[:20]:  # a folder may begin with a text
        size = _slice_size(file)
        if size:
            return size * len(files)
    return 0


def megabytes(voxels, attempt, greatest=None):
    """Memory: 600 MB, of which Snakemake takes 120, and 28 bytes for each voxel (measured: 3,453 MB for 112.7 million voxels); the
    double in a second attempt. Never more than the machine has: there the examination runs alone."""
    asked = int((600 + 28e-6 * voxels) * attempt)
    return min(asked, greatest) if greatest else asked


def minutes(voxels, attempt):
    """Time limit on a cluster: ten times what was measured on one core."""
    return int((10 + 60e-8 * voxels) * attempt)


def _slice_size(file):
    command = ["dcmdump", "-q", "+P", "Rows", "+P", "Columns", "+P", "NumberOfFrames", "-s", file]
    lines = subprocess.run(command, capture_output=True, text=True, errors="replace").stdout.splitlines()
    values = {line[:11]: line.split()[2].strip("[]") for line in lines if len(line.split()) > 2}
    try:
        return int(values["(0028,0010)"]) * int(values["(0028,0011)"]) * int(values.get("(0028,0008)", 1))
    except (KeyError, ValueError):
        return 0
