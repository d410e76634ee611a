#!/usr/bin/python3
"""usage: second-position.py LUMEN.nrrd MOVED.nrrd POINTS.csv

Simulates a second position of a segmented colon: moves its lumen by a known smooth field of up to 15 mm, and writes corresponding
points on both walls (columns sx,sy,sz,px,py,pz; LPS, mm). The field bends, stretches and compresses the colon but creates no new
folds, and gas stays where it is; a real second position differs more. Called by make-figures.
"""
import sys

import numpy as np
import volumes

LARGEST = 15.0  # mm, of the displacement
WAVELENGTHS = (260.0, 410.0)  # mm, longer than folds and shorter than the abdomen
POINT_EVERY = 97  # wall voxels; a prime, so that points do not form rows


def displacement(points):
    """Displacement (mm) of points (3 x n, mm): waves along the other two axes, with fixed phases."""
    waves = np.empty_like(points)
    for axis in range(3):
        along, across = points[(axis + 1) % 3], points[(axis + 2) % 3]
        waves[axis] = np.sin(2 * np.pi * along / WAVELENGTHS[0] + axis) + np.sin(2 * np.pi * across / WAVELENGTHS[1] + 2 * axis)
    return waves * (LARGEST / (2 * np.sqrt(3)))


def sample(mask, indices):
    """Trilinear values of a mask at indices (x, y, z: 3 x n)."""
    indices = np.clip(indices, 0, np.array(mask.shape[::-1])[:, None] - 1.001)
    low = indices.astype(int)
    x, y, z = indices - low
    value = np.zeros(indices.shape[1], np.float32)
    for corner in range(8):
        i, j, k = corner & 1, corner >> 1 & 1, corner >> 2
        weight = (x if i else 1 - x) * (y if j else 1 - y) * (z if k else 1 - z)
        value += weight.astype(np.float32) * mask[low[2] + k, low[1] + j, low[0] + i]
    return value


def box_of(mask, spacing):
    """Slices (z, y, x) of the voxels that may be reached by the mask."""
    box = []
    for axis in range(3):
        inside = np.flatnonzero(mask.any(axis=tuple(other for other in range(3) if other != axis)))
        margin = int(LARGEST / spacing[2 - axis]) + 2
        box.append(slice(max(inside[0] - margin, 0), min(inside[-1] + margin + 1, mask.shape[axis])))
    return box


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    fields, voxels = volumes.read(sys.argv[1])
    spacing, origin = volumes.grid_of(fields)
    mask = (voxels > 0).astype(np.float32)
    box = box_of(mask, spacing)
    rows, columns = np.mgrid[box[1], box[2]].astype(np.float64)
    moved, pairs = np.zeros(mask.shape, np.uint8), []
    for slice_ in range(box[0].start, box[0].stop):
        points = np.stack([columns.ravel(), rows.ravel(), np.full(rows.size, slice_)]) * spacing[:, None]
        sources = points + displacement(points)
        value = sample(mask, sources / spacing[:, None])
        moved[slice_, box[1], box[2]] = (value > 0.5).reshape(rows.shape)
        wall = np.flatnonzero((value > 0.4) & (value < 0.6))
        pairs.append(np.concatenate([sources[:, wall], points[:, wall]]))
    pairs = np.concatenate(pairs, axis=1)[:, ::POINT_EVERY] + np.tile(origin, 2)[:, None]
    volumes.write(sys.argv[2], fields, moved)
    np.savetxt(sys.argv[3], pairs.T, "%.3f", delimiter=",", header="sx,sy,sz,px,py,pz", comments="")


if __name__ == "__main__":
    main()
