#!/usr/bin/python3
"""usage: few-visits.py VOLUME.nrrd VISITS.nrrd LOWEST MOST PICTURE.png

Draws the three middle slices of a volume (-1000 to 200) and, in blue, the voxels of at least LOWEST with fewer than MOST visits.
Called by make-figures.
"""
import sys

import numpy as np
import volumes
from PIL import Image

SIZE, GAP, BLUE = 300, 6, (90, 120, 255)


def main():
    if "--help" in sys.argv[1:2] or len(sys.argv) != 6:
        print(__doc__)
        return
    volume, visits = (volumes.read(path)[1] for path in sys.argv[1:3])
    colors = np.stack([np.clip((volume + 1000.0) / 1200.0 * 255.0, 0, 255)] * 3, axis=-1).astype(np.uint8)
    colors[(volume >= int(sys.argv[3])) & (visits < int(sys.argv[4]))] = BLUE
    slices, rows, columns = (size // 2 for size in volume.shape)
    sheet = Image.new("RGB", (3 * SIZE + 2 * GAP, SIZE), "white")
    for i, part in enumerate((colors[slices], colors[::-1, rows], colors[::-1, :, columns])):
        sheet.paste(Image.fromarray(part).resize((SIZE, SIZE), Image.Resampling.NEAREST), (i * (SIZE + GAP), 0))
    sheet.save(sys.argv[5])


if __name__ == "__main__":
    main()
