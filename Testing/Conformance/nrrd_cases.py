"""NRRD files. License: CC0 1.0."""
import bz2
import gzip

import numpy as np
from case_files import REFUSAL, Grid, case, oblique, phantom

SPEC = "NRRD format, "
SPACES = {
    "left-posterior-superior": (1, 1, 1),
    "right-anterior-superior": (-1, -1, 1),
    "left-anterior-superior": (1, -1, 1),
}


def text(vector):
    return "(" + ",".join(repr(float(v)) for v in vector) + ")"


def frame(grid, space, scale=1.0):
    signs = scale * np.array(SPACES[space])
    vectors = [text(signs * grid.direction[:, i] * grid.spacing[i]) for i in range(3)]
    return {"space": space, "space directions": " ".join(vectors), "space origin": text(signs * np.array(grid.origin))}


def write(path, fields, data=b"", kind="short", sizes="14 10 6", dimension=3):
    lines = ["NRRD0004", f"type: {kind}", f"dimension: {dimension}", f"sizes: {sizes}"]
    lines += [f"{key}: {value}" for key, value in fields.items()]
    path.write_bytes("\n".join(lines).encode() + b"\n" + (b"\n" + data if data else b""))


def nrrd(name, title, clause, space="left-posterior-superior", data=None, grid=Grid(), scale=1.0, voxels=None, **fields):
    stored = phantom() if voxels is None else voxels

    @case(name, "NRRD", title, SPEC + clause)
    def _(folder):
        content = stored.astype("<i2").tobytes()
        all_fields = {**frame(grid, space, scale), "endian": "little", "encoding": "raw"}
        all_fields.update({key.replace("_", " "): value for key, value in fields.items()})
        write(folder / "volume.nrrd", all_fields, data(content) if data else content)
        return grid, stored


nrrd("nrrd-lps", "oblique, left-posterior-superior", "space", grid=Grid(direction=oblique()))
nrrd("nrrd-ras", "oblique, right-anterior-superior", "space", "right-anterior-superior", grid=Grid(direction=oblique()))
nrrd("nrrd-las", "oblique, left-anterior-superior", "space", "left-anterior-superior", grid=Grid(direction=oblique()))
nrrd("nrrd-meters", "units of length are meters", "space units", scale=0.001, space_units='"m" "m" "m"')
nrrd("nrrd-bzip2", "bzip2", "encoding", data=bz2.compress, encoding="bzip2")
nrrd("nrrd-ascii", "numbers as text", "encoding", encoding="ascii",
     data=lambda b: " ".join(map(str, np.frombuffer(b, "<i2"))).encode() + b"\n")  # fmt: skip
nrrd("nrrd-big-endian", "big endian", "endian", endian="big", data=lambda b: np.frombuffer(b, "<i2").byteswap().tobytes())
nrrd("nrrd-byte-skip-last", "byte skip -1: the voxels are the last bytes", "byte skip", byte_skip="-1", data=lambda b: b"x" * 77 + b)
nrrd("nrrd-line-skip-gzip", "two lines before gzip data", "line skip", line_skip="2", encoding="gzip",
     data=lambda b: b"one\ntwo\n" + gzip.compress(b, mtime=0))  # fmt: skip


@case("nrrd-list-of-one", "NRRD", "a list axis of one component before x, y, z", SPEC + "kinds")
def _(folder):
    grid = Grid()
    fields = {**frame(grid, "left-posterior-superior"), "kinds": "list domain domain domain", "endian": "little", "encoding": "raw"}
    fields["space directions"] = "none " + fields["space directions"]
    write(folder / "volume.nrrd", fields, phantom().astype("<i2").tobytes(), sizes="1 14 10 6", dimension=4)
    return grid, phantom()


def detached(name, title, value, clause="data file"):
    @case(name, "NRRD", title, SPEC + clause)
    def _(folder):
        grid = Grid()
        for k, part in enumerate(np.split(phantom().astype("<i2"), 6)):
            (folder / f"slice{k + 1:02d}.raw").write_bytes(part.tobytes())
        write(folder / "volume.nhdr", {**frame(grid, "left-posterior-superior"), "endian": "little", "encoding": "raw", "data file": value})
        return grid, phantom()


detached("nrrd-data-pattern", "a pattern of six data files", "slice%02d.raw 1 6 1")


@case("nrrd-not-a-number", "NRRD", "invalid: a direction is x", SPEC + "space directions", REFUSAL)
def _(folder):
    fields = {**frame(Grid(), "left-posterior-superior"), "endian": "little", "encoding": "raw"}
    fields["space directions"] = "(0.75,0,0) (0,x,0) (0,0,2.5)"
    write(folder / "volume.nrrd", fields, phantom().astype("<i2").tobytes())
    return None, None


@case("nrrd-truncated", "NRRD", "invalid: the file ends within the voxels", SPEC + "sizes", REFUSAL)
def _(folder):
    fields = {**frame(Grid(), "left-posterior-superior"), "endian": "little", "encoding": "raw"}
    write(folder / "volume.nrrd", fields, phantom().astype("<i2").tobytes()[:-100])
    return None, None
