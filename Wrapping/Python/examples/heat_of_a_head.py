"""The heat of a head: cumulative heat diffusion of an MR volume, its histogram and its classes.

usage: heat_of_a_head.py VOLUME PICTURE.png

The volume is a NIfTI, NRRD or MetaImage file or a folder of DICOM slices, for example Debian's ch2.nii.gz (package
mricron-data). Lines with %% start cells for editors that support them.
"""

# %% The volume
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import shapeton

volume, picture = sys.argv[1:3]
head = shapeton.read_volume(volume)
print(head)

# %% Heat: few steps show edges and thin parts, many show whole objects
steps = 3000
result = shapeton.diffuse_heat(
    head,
    p=20.0,  # edges in MR are weak
    time_steps=steps,
    histogram_steps=shapeton.recorded_steps(steps, 100),
    progress=lambda share, stage: print(f"\r{stage}: {share:4.0%}", end="", file=sys.stderr),
)
print(file=sys.stderr)

# %% Classes: the lines of the histogram
labels, classes = shapeton.classify_heat(result.heat)
for c in classes:
    print(f"class {c.label}: heat {c.lower_heat:.4f} to {c.upper_heat:.4f}, {c.volume / 1000.0:.0f} ml")
print(f"{len(classes) - 1} classes without the background")

# %% A picture: a slice, its heat, its classes, the histogram
middle = head.array.shape[0] // 2
across, along = head.spacing[:2]
figure, axes = plt.subplots(2, 2, figsize=(11, 10))
slices = [
    (head.array[middle], "gray", "intensity"),
    (np.log10(np.maximum(result.heat.array[middle], 1e-5)), "inferno", "heat (log 10)"),
    (labels.array[middle], "tab20", "classes"),
]
for (pixels, colors, title), axis in zip(slices, axes.flat):
    axis.imshow(pixels, cmap=colors, aspect=along / across, origin="lower", interpolation="nearest")
    axis.set_title(title)
    axis.set_axis_off()
histogram = result.histogram
edges = histogram.edges[1:]  # without the background
plot = axes.flat[3]
rows = np.maximum(histogram.time_steps, 0.5)  # step 0 has no logarithm
density = histogram.counts[:, 1:] / np.diff(np.log(edges))  # bins are narrower where heat is low
plot.pcolormesh(edges[:-1], rows, np.log1p(density), shading="nearest")
plot.set(xscale="log", yscale="log", xlim=(1e-3, 1.0), xlabel="heat", ylabel="time step", title="heat histogram")
figure.tight_layout()
figure.savefig(picture, dpi=100)
