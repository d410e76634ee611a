"""Reads raw and gzip NRRD volumes for the scripts of this folder."""
import gzip

import numpy as np

TYPES = {"short": "i2", "unsigned char": "u1", "uint8": "u1", "float": "f4", "unsigned int": "u4"}


def read(path):
    """Returns the fields of the header and the voxels, slices first."""
    with open(path, "rb") as file:
        head, _, body = file.read().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line and ":=" not in line)
    columns, rows, slices = map(int, fields["sizes"].split())
    body = gzip.decompress(body) if fields["encoding"] == "gzip" else body
    return fields, np.frombuffer(body, TYPES[fields["type"]]).reshape(slices, rows, columns)


def grid_of(fields):
    """Returns spacing (along x, y, z) and origin of an axis-aligned volume."""
    vectors = [list(map(float, part.strip("()").split(","))) for part in fields["space directions"].split()]
    return np.diag(vectors), np.array(list(map(float, fields["space origin"].strip("()").split(","))))


def write(path, fields, voxels):
    """Writes voxels with the other fields of a header."""
    fields = {**fields, "encoding": "gzip", "sizes": "{2} {1} {0}".format(*voxels.shape)}
    lines = ["NRRD0004"] + [f"{key}: {value}" for key, value in fields.items() if not key.startswith(("#", "Shapeton"))]
    with open(path, "wb") as file:
        file.write("\n".join(lines).encode() + b"\n\n" + gzip.compress(voxels.tobytes(), mtime=0))
