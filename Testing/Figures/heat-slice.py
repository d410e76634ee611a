#!/usr/bin/python3
"""usage: heat-slice.py HEAT.nrrd PICTURE.png MARGIN

Draws the middle slice of a volume without a margin of voxels, from its lowest value (blue) to its highest (red). Called by
make-figures.
"""
import sys

import numpy as np
import volumes
from PIL import Image

SIZE = 320
COLORS = np.array([[40, 80, 200], [90, 200, 220], [250, 240, 120], [240, 130, 40], [200, 30, 30]])


def main():
    if "--help" in sys.argv[1:2] or len(sys.argv) != 4:
        print(__doc__)
        return
    _, volume = volumes.read(sys.argv[1])
    margin = int(sys.argv[3])
    part = volume[len(volume) // 2, margin:-margin, margin:-margin]
    share = (part - part.min()) / max(np.ptp(part), 1e-30) * (len(COLORS) - 1)
    picture = np.stack([np.interp(share, range(len(COLORS)), channel) for channel in COLORS.T], axis=-1)
    Image.fromarray(picture.astype(np.uint8)).resize((SIZE, SIZE), Image.Resampling.NEAREST).save(sys.argv[2])


if __name__ == "__main__":
    main()
