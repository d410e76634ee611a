"""A colon from CT to its flat map: lumen, centerline, wall, conformal map, folds, taeniae, polyp candidates.

usage: colon_to_flat_map.py PICTURE.png [FOLDER-OF-DICOM-SLICES]

Without a folder a synthetic patient is scanned. Lines with %% start cells for editors that
support them.
"""

# %% The CT
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import shapeton
from shapeton import colon, flattening


def tell(share, stage):
    print(f"\r{share:4.0%} {stage:40}", end="", file=sys.stderr)


picture = sys.argv[1]
if len(sys.argv) > 2:
    ct = shapeton.read_volume(sys.argv[2])
    position = ct.facts["patient_position"]
else:
    ct = colon.colon_phantom(size=(120, 120, 112), spacing=(3.0, 3.0, 3.0), progress=tell).ct
    position = "supine"
print(ct)

# %% Lumen, centerline and wall
model = colon.build_colon(ct, position=position, progress=tell)
if model.failure:
    sys.exit(model.failure)
wall = model.wall.simplified
print(f"{model.centerline.length / 10.0:.0f} cm, a wall of {len(wall.faces)} faces")

# %% The flat map
flattened = flattening.flatten_tube(wall, model.centerline.curve, progress=tell)
flat = colon.FlatColon(flattened.flat)
statistics = flattened.statistics
print(f"{flat.length:.0f} x {flat.circumference:.0f} mm, {statistics['flips']} flips")

# %% Structures on the map
landmarks = colon.find_landmarks(flat, model.centerline.curve, progress=tell)
folds = colon.find_folds(flat)
candidates = colon.find_candidates(
    model.wall.repaired,
    model.lumen.labels,
    centerline=model.centerline.curve,
    ct=model.cleansed,
    flat=flat,
    segments=landmarks.segments,
    progress=tell,
)
print(file=sys.stderr)
print(f"{len(folds.folds)} folds, {len(landmarks.taeniae.curves)} taeniae, {len(candidates)} polyp candidates")

# %% A picture: the flat wall in four rows, folds bright; taeniae as dots, candidates as rings
rows = 4
curvature = np.clip(flat.curvature(), -0.15, 0.15)
figure, axes = plt.subplots(rows, 1, figsize=(14, 13))
taeniae = flat.pixels(landmarks.taeniae.point_arrays.get("uv", np.empty((0, 2))))
places = flat.pixels(np.array([candidate.uv for candidate in candidates]).reshape(-1, 2))
for row, axis in enumerate(axes):
    axis.imshow(curvature, cmap="bone", aspect="equal")
    axis.plot(taeniae[:, 1], taeniae[:, 0], ".", color="gold", markersize=1.5)
    axis.plot(places[:, 1], places[:, 0], "o", markerfacecolor="none", markeredgecolor="red", markersize=9)
    axis.set(xlim=np.array([row, row + 1]) * flat.shape[1] / rows, ylim=(flat.shape[0], 0))
axes[-1].set_xlabel(f"pixels of {flat.pixel_size:.2f} mm along the flat map, from the rectum")
figure.tight_layout()
figure.savefig(picture, dpi=100)
