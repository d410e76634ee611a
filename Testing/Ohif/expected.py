#!/usr/bin/env python3
"""expected.py SERIES_FOLDER RESULT_FOLDER [SECOND_SERIES_FOLDER SECOND_RESULT_FOLDER]

Prints as JSON what a viewer must show of the DICOM results of one or two series of a study: for each segmentation and label map
the voxels of every segment, with a hash for each slice; for each measurement report the patient coordinates of every measurement
group. Read by pydicom.
"""

import hashlib
import json
import pathlib
import sys
import zlib

import numpy
import pydicom
from pydicom.encaps import generate_pixel_data_frame

SEGMENTATION = "1.2.840.10008.5.1.4.1.1.66.4"
LABEL_MAP = "1.2.840.10008.5.1.4.1.1.66.7"
REPORTS = ("1.2.840.10008.5.1.4.1.1.88.22", "1.2.840.10008.5.1.4.1.1.88.33", "1.2.840.10008.5.1.4.1.1.88.34")
NOT_FOR_OHIF = ("1.2.840.10008.5.1.4.1.1.88.69", "1.2.840.10008.5.1.4.1.1.104.3")  # colon CAD, STL
DEFLATED_FRAMES = "1.2.840.10008.1.2.8.1"
MEASUREMENT_GROUP = "125007"
TRACKING_IDENTIFIER = "112039"
TRACKING_UID = "112040"
FAR = 2  # pixels from a segment to a pixel that must keep its gray


def read_frames(result):
    """Returns the frames as an array of shape (frames, rows, columns)."""
    if result.file_meta.TransferSyntaxUID == DEFLATED_FRAMES:
        frames = [zlib.decompress(frame, -zlib.MAX_WBITS) for frame in generate_pixel_data_frame(result.PixelData)]
        kind = numpy.uint8 if result.BitsAllocated <= 8 else numpy.dtype("<u2")
        bits = [numpy.frombuffer(frame, kind) for frame in frames]
        if result.BitsAllocated == 1:
            bits = [numpy.unpackbits(frame, bitorder="little") for frame in bits]
        size = (result.Rows, result.Columns)
        return numpy.stack([frame[: size[0] * size[1]].reshape(size) for frame in bits])
    frames = result.pixel_array
    return frames.reshape((-1,) + frames.shape[-2:])


def slice_of(result, frame):
    """Returns the UID of the CT slice of a frame."""
    for groups in (result.PerFrameFunctionalGroupsSequence[frame], result.SharedFunctionalGroupsSequence[0]):
        if "DerivationImageSequence" in groups:
            return groups.DerivationImageSequence[0].SourceImageSequence[0].ReferencedSOPInstanceUID
    raise ValueError(f"frame {frame} refers to no image")


def masks_of(result):
    """Returns the mask of every slice of every segment: {number: {slice UID: mask}}."""
    masks = {segment.SegmentNumber: {} for segment in result.SegmentSequence}
    for index, frame in enumerate(read_frames(result)):
        if result.SOPClassUID == LABEL_MAP:
            numbers = [int(n) for n in numpy.unique(frame) if n]
        else:
            groups = result.PerFrameFunctionalGroupsSequence[index]
            numbers = [groups.SegmentIdentificationSequence[0].ReferencedSegmentNumber]
        for number in numbers:
            mask = frame == number if result.SOPClassUID == LABEL_MAP else frame > 0
            if mask.any():
                masks[number][slice_of(result, index)] = mask
    return masks


def shifted(mask, rows, columns):
    return numpy.roll(mask, (rows, columns), (0, 1))


def samples_of(slices):
    """Returns a slice, a pixel [column, row] in the middle of a segment, and one away from it."""
    uid, mask = max(slices.items(), key=lambda entry: entry[1].sum())
    near = range(-FAR, FAR + 1)
    neighbors = sum(shifted(mask, row, column).astype(int) for row in near for column in near)
    inside = numpy.unravel_index(numpy.argmax(neighbors * mask), mask.shape)
    rows, columns = numpy.indices(mask.shape)
    distance = numpy.hypot(rows - inside[0], columns - inside[1]) + mask.size * (neighbors > 0)
    outside = numpy.unravel_index(numpy.argmin(distance), mask.shape)
    return {"slice": uid, "inside": [int(n) for n in inside[::-1]], "outside": [int(n) for n in outside[::-1]]}


def segments_of(result):
    masks = masks_of(result)
    for segment in result.SegmentSequence:
        slices = masks[segment.SegmentNumber]
        hashes = {uid: hashlib.sha256(mask.astype(numpy.uint8).tobytes()).hexdigest() for uid, mask in slices.items()}
        voxels = sum(int(mask.sum()) for mask in slices.values())
        yield {"number": segment.SegmentNumber, "label": segment.SegmentLabel, "voxels": voxels, "slices": hashes, **samples_of(slices)}


def items_of(dataset, value):
    """Yields all nested content items whose concept has this code value."""
    for item in dataset.get("ContentSequence", []):
        name = item.get("ConceptNameCodeSequence")
        if name and name[0].CodeValue == value:
            yield item
        yield from items_of(item, value)


def place_in_slice(item, series):
    """Returns the patient coordinates of the first point of a SCOORD; the corner of the first pixel is 0, 0."""
    image = series[item.ContentSequence[0].ReferencedSOPSequence[0].ReferencedSOPInstanceUID]
    row, column = numpy.array(image.ImageOrientationPatient, float).reshape(2, 3)
    between_rows, between_columns = (float(n) for n in image.PixelSpacing)
    x, y = numpy.array(item.GraphicData[:2], float) - 0.5
    return numpy.array(image.ImagePositionPatient, float) + x * between_columns * row + y * between_rows * column


def groups_of(report, series):
    for group in items_of(report, MEASUREMENT_GROUP):
        points = {kind: [i for i in group.ContentSequence if i.ValueType == kind] for kind in ("SCOORD", "SCOORD3D")}
        place = None
        if points["SCOORD3D"]:
            place = [float(x) for x in points["SCOORD3D"][0].GraphicData[:3]]
        elif points["SCOORD"]:
            place = place_in_slice(points["SCOORD"][0], series).tolist()
        identifier = next(items_of(group, TRACKING_IDENTIFIER)).TextValue
        yield {"uid": next(items_of(group, TRACKING_UID)).UID, "identifier": identifier, "place": place}


def axes_of(series):
    """Returns the directions of rows, columns and slices, with their spacing."""
    some = next(iter(series.values()))
    row, column = numpy.array(some.ImageOrientationPatient, float).reshape(2, 3)
    normal = numpy.cross(row, column)
    heights = sorted(float(normal @ numpy.array(s.ImagePositionPatient, float)) for s in series.values())
    axes = [(row, float(some.PixelSpacing[1])), (column, float(some.PixelSpacing[0])), (normal, heights[1] - heights[0])]
    return [{"direction": direction.tolist(), "spacing": spacing} for direction, spacing in axes]


def objects_of(series, result_folder, position):
    axes = axes_of(series)
    for path in sorted(result_folder.glob("*.dcm")):
        result = pydicom.dcmread(path)
        shown = result.SOPClassUID not in NOT_FOR_OHIF
        known = {"file": "second-" * position + path.name, "position": position, "uid": result.SOPInstanceUID, "isShown": shown}
        if result.SOPClassUID in (SEGMENTATION, LABEL_MAP):
            known["segments"] = list(segments_of(result))
        if result.SOPClassUID in REPORTS:
            known.update(axes=axes, groups=list(groups_of(result, series)))
        yield known


def main(folders):
    expected = {"series": len(folders) // 2, "objects": []}
    studies = set()
    for position, (series_folder, result_folder) in enumerate(zip(folders[::2], folders[1::2])):
        series = {s.SOPInstanceUID: s for s in (pydicom.dcmread(p, stop_before_pixels=True) for p in series_folder.glob("*.dcm"))}
        studies.update(s.StudyInstanceUID for s in series.values())
        expected["objects"] += objects_of(series, result_folder, position)
    (expected["study"],) = studies
    json.dump(expected, sys.stdout)


if __name__ == "__main__":
    if len(sys.argv) not in (3, 5) or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    main([pathlib.Path(argument) for argument in sys.argv[1:]])
