#!/usr/bin/python3
"""usage: box-of-volume.py VOLUME.nrrd BOX.nrrd X,Y,Z RADIUS [MASK.nrrd LOWEST]

Cuts the voxels within RADIUS mm of a point along each axis (LPS, mm) from a gzip NRRD volume of 16-bit integers with axes along
those of the patient, and writes a mask of those of at least LOWEST. Called by make-figures.
"""
import sys

import numpy as np
import volumes


def main():
    if "--help" in sys.argv[1:2]:
        print(__doc__)
        return
    source, target, point, radius = sys.argv[1:5]
    fields, voxels = volumes.read(source)
    spacing, origin = volumes.grid_of(fields)
    middle = (np.array(list(map(float, point.split(",")))) - origin) / spacing
    reach = float(radius) / np.abs(spacing)
    first = np.clip(np.round(middle - reach), 0, None).astype(int)
    last = np.round(middle + reach).astype(int)
    box = voxels[first[2]:last[2], first[1]:last[1], first[0]:last[0]]
    fields["space origin"] = "({:g},{:g},{:g})".format(*(origin + first * spacing))
    volumes.write(target, fields, box)
    if len(sys.argv) > 5:
        fields["type"] = "unsigned char"
        volumes.write(sys.argv[5], fields, (box >= int(sys.argv[6])).astype(np.uint8))


if __name__ == "__main__":
    main()
