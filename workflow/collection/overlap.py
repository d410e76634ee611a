"""overlap.py OUTPUT TOOLS MASKS: compares the lumen of each finished examination with published masks, and appends a row per
series to OUTPUT/overlaps.tsv. Series that have a row are skipped."""

import csv
import json
import os
import subprocess
import sys
import tempfile

from cohort.files import file_of
from cohort.table import read_table

COLUMNS = ("subject", "position", "series", "dice", "assd", "hd95", "fault")
FARTHEST = 95.0  # percentile of the distances between the surfaces
GAS, FLUID = 1, 2  # labels of the lumen


def main():
    output, tools, folder = sys.argv[1:4]
    rows = [row for series in read_table(f"{output}/cohort.tsv").values() for row in series]
    masks = masks_of(folder, {row.series for row in rows})
    path = f"{output}/overlaps.tsv"
    done = {row["series"] for row in read_overlaps(path)}
    if not os.path.exists(path):
        _append(path, COLUMNS)
    for subject, position, series, exam in series_of(output):
        lumen = file_of(exam, "lumen")
        if series in masks and series not in done and os.path.exists(lumen):
            _append(path, (subject, position, series, *compare(tools, lumen, masks[series])))
    print(f"{len(masks)} of {len(rows)} series have a mask; {len(read_overlaps(path))} are compared: {path}")


def series_of(output):
    """Yields (subject, position, series, folder of its results) of the table."""
    for subject, rows in read_table(f"{output}/cohort.tsv").items():
        exam = f"{output}/examinations/{subject}/exam"
        for row, place in zip(rows, (exam, f"{exam}/second")):
            yield subject, row.position, row.series, place


def read_overlaps(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file, delimiter="\t"))


def masks_of(folder, uids):
    """Returns {series UID: file}. A mask has the UID in its name, or in a line of a .jsonl file that also names the mask."""
    files = {name: os.path.join(place, name) for place, _, names in os.walk(folder) for name in names}
    found = {uid: path for name, path in files.items() for uid in uids if uid in name}
    for name, path in files.items():
        if name.endswith(".jsonl"):
            with open(path, encoding="utf-8") as lines:
                for values in (json.loads(line).values() for line in lines if line.strip()):
                    texts = [value for value in values if isinstance(value, str)]
                    masks = [files[os.path.basename(text)] for text in texts if os.path.basename(text) in files]
                    found.update({text: masks[0] for text in texts if text in uids and masks})
    return found


def compare(tools, lumen, mask):
    """Returns Dice, mean distance and 95th percentile of the distances (mm) as texts, and a fault."""
    try:
        found, matrix = _read(tools, lumen)
        truth, own = _read(tools, mask)
        found = (found == GAS) | (found == FLUID)
        truth = _on_grid(truth > 0, own, found.shape, matrix)
    except (subprocess.CalledProcessError, ValueError) as error:
        return "", "", "", " ".join(str(getattr(error, "stderr", "") or error).split())
    return (*(f"{value:.4g}" for value in measures(found, truth, _spacing(matrix))), "")


def measures(found, truth, spacing):
    """Dice; mean of the distances of each surface from the other one; and the greater of their 95th percentiles (mm)."""
    import numpy
    from scipy import ndimage

    both = found | truth
    if not (found.any() and truth.any()):
        raise ValueError("one of the masks is empty")
    box = ndimage.find_objects(both.astype(int))[0]
    found, truth = numpy.pad(found[box], 1), numpy.pad(truth[box], 1)
    dice = 2.0 * (found & truth).sum() / (found.sum() + truth.sum())
    surfaces = [mask & ~ndimage.binary_erosion(mask) for mask in (found, truth)]
    distances = [
        ndimage.distance_transform_edt(~other, sampling=spacing)[own] for own, other in (surfaces, surfaces[::-1])
    ]
    return dice, numpy.concatenate(distances).mean(), max(numpy.percentile(one, FARTHEST) for one in distances)


def _read(tools, path):
    """The voxels of a volume, and the matrix from their indices to RAS in mm."""
    import nibabel
    import numpy

    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(folder, "copy.nii")
        command = [os.path.join(tools, "DicomSeriesToImage"), path, copy, "--quiet"]
        subprocess.run(command, check=True, capture_output=True, text=True)
        image = nibabel.load(copy)
        return numpy.asarray(image.dataobj), image.affine


def _spacing(matrix):
    import numpy

    return numpy.linalg.norm(matrix[:3, :3], axis=0)


def _on_grid(mask, own, size, matrix):
    """A mask on another grid whose axes may be mirrored or exchanged, and which may be cropped; ValueError if its voxels are others."""
    import numpy

    change = numpy.linalg.inv(matrix) @ own
    steps = numpy.rint(change).astype(int)
    if numpy.abs(change[:3, :3] - steps[:3, :3]).max() * max(mask.shape) > 0.5 or numpy.abs(change[:3, 3] - steps[:3, 3]).max() > 0.1:
        raise ValueError("the mask is not on the grid of the series")
    voxels = steps[:3, :3] @ numpy.array(numpy.nonzero(mask)) + steps[:3, 3:]
    if voxels.size and (voxels.min() < 0 or (voxels.max(axis=1) >= size).any()):
        raise ValueError("the mask extends beyond the series")
    result = numpy.zeros(size, bool)
    result[tuple(voxels)] = True
    return result


def _append(path, cells):
    with open(path, "a", encoding="utf-8") as file:
        file.write("\t".join(cells) + "\n")


if __name__ == "__main__":
    main()
