"""NIfTI files. License: CC0 1.0."""
import gzip
import struct

import numpy as np
from case_files import Grid, case, oblique, phantom

TYPES = {"u1": 2, "i2": 4, "i4": 8, "f4": 16, "f8": 64, "i1": 256, "u2": 512}
SPEC = "nifti1.h, "
RAS = np.diag([-1.0, -1.0, 1.0])


def quaternion(matrix):
    """b, c, d of a rotation whose angle is less than a half turn."""
    a = 0.5 * np.sqrt(1.0 + np.trace(matrix))
    return [(matrix[i] - matrix[j]) / (4 * a) for i, j in (((2, 1), (1, 2)), ((0, 2), (2, 0)), ((1, 0), (0, 1)))]


def header(grid, kind, order="<", sform=True, qform=False, qfac=1.0, slope=(0.0, 0.0), units=2, offset=352, magic=b"n+1\0", dim=3):
    """A NIfTI-1 header; the grid is in LPS, the file in RAS."""
    direction, origin = RAS @ grid.direction, RAS @ np.array(grid.origin)
    rotation = direction @ np.diag([1.0, 1.0, qfac])
    rows = np.column_stack([direction * grid.spacing, origin])
    quatern = quaternion(rotation) if qform else [0.0, 0.0, 0.0]
    fields = struct.pack(order + "i10s18sihcB", 348, b"", b"", 0, 0, b"r", 0)
    fields += struct.pack(order + "8h", dim, *grid.size, 1, 1, 1, 1)
    fields += struct.pack(order + "3f4h", 0, 0, 0, 0, TYPES[kind], 8 * int(kind[1]), 0)
    fields += struct.pack(order + "8f", qfac, *grid.spacing, 1, 1, 1, 1)
    fields += struct.pack(order + "3fh2B4f2i", offset, *slope, 0, 0, units, 0, 0, 0, 0, 0, 0)
    fields += struct.pack(order + "80s24s2h", b"conformance", b"", int(qform), int(sform))
    fields += struct.pack(order + "6f12f", *quatern, *(origin if qform else np.zeros(3)), *(rows.ravel() if sform else np.zeros(12)))
    return fields + struct.pack(order + "16s4s", b"", magic)


def write(path, grid, voxels, kind="i2", order="<", extension=b"\0\0\0\0", **options):
    content = header(grid, kind, order, **options) + extension + voxels.astype(order + kind).tobytes()
    path.write_bytes(gzip.compress(content, mtime=0) if path.suffix == ".gz" else content)


def nifti(name, title, clause, grid=Grid(), voxels=None, expected=None, file="volume.nii.gz", **options):
    stored = phantom() if voxels is None else voxels

    @case(name, "NIfTI", title, SPEC + clause)
    def _(folder):
        write(folder / file, grid, stored, **options)
        return grid, stored if expected is None else expected


nifti("nifti-sform", "an oblique sform", "method 3", Grid(direction=oblique()))
nifti("nifti-qform", "an oblique qform alone", "method 2", Grid(direction=oblique()), sform=False, qform=True)
nifti(
    "nifti-qfac", "a qform of left-handed axes (qfac = -1)", "method 2",
    Grid(direction=oblique() @ np.diag([1.0, 1.0, -1.0])), sform=False, qform=True, qfac=-1.0,
)  # fmt: skip
nifti("nifti-slope", "scl_slope 0.5 and scl_inter -20", "scl_slope", slope=(0.5, -20.0), expected=phantom() * 0.5 - 20)
nifti("nifti-slope-zero", "scl_slope 0 switches scaling off, scl_inter 7 too", "scl_slope", slope=(0.0, 7.0))
nifti("nifti-big-endian", "big endian", "byte order", order=">", file="volume.nii")
nifti("nifti-int8", "signed bytes", "datatype", voxels=phantom() // 5 - 60, kind="i1")
nifti("nifti-uint16", "unsigned words above 32,767", "datatype", voxels=phantom() + 40000, kind="u2")
nifti(
    "nifti-extension", "a header extension of 32 bytes before the voxels", "vox_offset",
    extension=b"\1\0\0\0" + struct.pack("<2i", 32, 6) + b"a comment".ljust(24, b"\0"), offset=384,
)  # fmt: skip


@case("nifti-meters", "NIfTI", "units of length are meters", SPEC + "xyzt_units")
def _(folder):
    grid = Grid()
    scaled = Grid(grid.size, tuple(s / 1000 for s in grid.spacing), tuple(o / 1000 for o in grid.origin))
    write(folder / "volume.nii.gz", scaled, phantom(), units=1)
    return grid, phantom()


@case("nifti-pair", "NIfTI", "a pair .hdr and .img", SPEC + "magic")
def _(folder):
    grid = Grid()
    (folder / "volume.hdr").write_bytes(header(grid, "i2", offset=0, magic=b"ni1\0") + b"\0\0\0\0")
    (folder / "volume.img").write_bytes(phantom().astype("<i2").tobytes())
    return grid, phantom()


@case("nifti-2", "NIfTI", "NIfTI-2", "nifti2.h")
def _(folder):
    grid = Grid()
    rows = np.column_stack([RAS * grid.spacing, RAS @ np.array(grid.origin)])
    content = struct.pack("<i8s2h", 540, b"n+2\0\r\n\x1a\n", TYPES["i2"], 16)
    content += struct.pack("<8q3d8d", 3, *grid.size, 1, 1, 1, 1, 0, 0, 0, 1, *grid.spacing, 1, 1, 1, 1)
    content += struct.pack("<q6d2q", 544, 1, 0, 0, 0, 0, 0, 0, 0) + struct.pack("<80s24s2i", b"conformance", b"", 0, 1)
    content += struct.pack("<6d12d3i16sB15s", 0, 0, 0, 0, 0, 0, *rows.ravel(), 0, 2, 0, b"", 0, b"")
    (folder / "volume.nii").write_bytes(content + b"\0\0\0\0" + phantom().astype("<i2").tobytes())
    return grid, phantom()
