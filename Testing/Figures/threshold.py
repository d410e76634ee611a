#!/usr/bin/python3
"""usage: threshold.py VOLUME.nii.gz MASK.nii LOWEST HIGHEST [X0,X1,Y0,Y1,Z0,Z1]

Writes the voxels of intensities from LOWEST to HIGHEST as a mask; with a box of voxels, only those within it. Called by make-figures.
"""
import gzip
import struct
import sys

import numpy as np

HEADER = 352  # bytes of a NIfTI-1 header with an empty extension
TYPES = {2: "u1", 4: "<i2", 8: "<i4", 16: "<f4", 64: "<f8"}


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    with gzip.open(sys.argv[1]) as file:
        volume = file.read()
    header = bytearray(volume[:HEADER])
    columns, rows, slices = struct.unpack("<3h", header[42:48])
    kind, = struct.unpack("<h", header[70:72])
    begin, slope, intercept = struct.unpack("<3f", header[108:120])
    voxels = np.frombuffer(volume, TYPES[kind], columns * rows * slices, int(begin)).reshape(slices, rows, columns)
    values = voxels * (slope or 1) + intercept
    mask = (values >= float(sys.argv[3])) & (values <= float(sys.argv[4]))
    if len(sys.argv) > 5:
        left, right, front, back, bottom, top = map(int, sys.argv[5].split(","))
        inside = np.zeros_like(mask)
        inside[bottom:top, front:back, left:right] = True
        mask &= inside
    header[70:74] = struct.pack("<2h", 2, 8)
    header[108:124] = struct.pack("<3f4x", HEADER, 1, 0)
    with open(sys.argv[2], "wb") as file:
        file.write(bytes(header) + mask.astype(np.uint8).tobytes())


if __name__ == "__main__":
    main()
