#!/usr/bin/python3
"""usage: box-of-volume.py VOLUME.nrrd BOX.nrrd X,Y,Z RADIUS

Cuts the voxels within RADIUS mm of a point along each axis (LPS, mm) from a gzip NRRD volume of 16-bit integers with axes along
those of the patient. Called by make-figures.
"""
import gzip
import sys

import numpy as np


def main():
    if "--help" in sys.argv[1:2]:
        print(__doc__)
        return
    source, target, point, radius = sys.argv[1:]
    with open(source, "rb") as file:
        head, _, body = file.read().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line)
    columns, rows, slices = map(int, fields["sizes"].split())
    voxels = np.frombuffer(gzip.decompress(body), np.int16).reshape(slices, rows, columns)
    spacing = np.diag([list(map(float, part.strip("()").split(","))) for part in fields["space directions"].split()])
    origin = np.array(list(map(float, fields["space origin"].strip("()").split(","))))
    middle = (np.array(list(map(float, point.split(",")))) - origin) / spacing
    reach = float(radius) / np.abs(spacing)
    first = np.clip(np.round(middle - reach), 0, None).astype(int)
    last = np.round(middle + reach).astype(int)
    box = voxels[first[2]:last[2], first[1]:last[1], first[0]:last[0]]
    corner = origin + first * spacing
    fields["sizes"] = "{2} {1} {0}".format(*box.shape)
    fields["space origin"] = "({:g},{:g},{:g})".format(*corner)
    lines = ["NRRD0004"] + [f"{key}: {value}" for key, value in fields.items() if not key.startswith(("#", "Shapeton"))]
    with open(target, "wb") as file:
        file.write("\n".join(lines).encode() + b"\n\n" + gzip.compress(box.tobytes(), mtime=0))


if __name__ == "__main__":
    main()
