#!/usr/bin/env python3
"""check_label_maps.py BINARY_FOLDER LABEL_MAP_FOLDER

Checks label maps with pydicom: their attributes against Supplement 243, their voxels against binary segmentations.
"""

import pathlib
import sys

import check_objects
import numpy
import pydicom
from check_objects import check

pydicom.config.settings.reading_validation_mode = pydicom.config.RAISE

# Attributes of the Label Map Segmentation IOD with one allowed value here (PS3.3 A.51, C.8.20.2).
EXPECTED = {
    "SOPClassUID": "1.2.840.10008.5.1.4.1.1.66.7",
    "Modality": "SEG",
    "SegmentationType": "LABELMAP",
    "SamplesPerPixel": 1,
    "PhotometricInterpretation": "MONOCHROME2",
    "BitsAllocated": 8,
    "BitsStored": 8,
    "HighBit": 7,
    "PixelRepresentation": 0,
    "PixelPaddingValue": 0,
    "LossyImageCompression": "00",
    "ContentQualification": "RESEARCH",
}
FORBIDDEN = ("SegmentsOverlap", "SegmentationFractionalType", "MaximumFractionalValue")
REQUIRED_OF_SEGMENTS = (
    "SegmentNumber",
    "SegmentLabel",
    "SegmentAlgorithmType",
    "SegmentAlgorithmName",
    "SegmentedPropertyCategoryCodeSequence",
    "SegmentedPropertyTypeCodeSequence",
)


def check_attributes(name, label_map):
    for keyword, value in EXPECTED.items():
        check(label_map.get(keyword) == value, f"{name}: {keyword} is {label_map.get(keyword)}")
    for keyword in FORBIDDEN:
        check(keyword not in label_map, f"{name}: has {keyword}")
    for segment in label_map.SegmentSequence:
        for keyword in REQUIRED_OF_SEGMENTS:
            check(keyword in segment, f"{name}: a segment lacks {keyword}")
        check(segment.SegmentNumber > 0, f"{name}: the background is not a segment")
    for frame in label_map.PerFrameFunctionalGroupsSequence:
        check("SegmentIdentificationSequence" not in frame, f"{name}: a frame has all segments")
        check("PlanePositionSequence" in frame and "FrameContentSequence" in frame, f"{name}: place of a frame")


def masks_of_binary(binary):
    masks = {segment.SegmentLabel: {} for segment in binary.SegmentSequence}
    names = {segment.SegmentNumber: segment.SegmentLabel for segment in binary.SegmentSequence}
    for pixels, group in zip(binary.pixel_array, binary.PerFrameFunctionalGroupsSequence):
        place = tuple(group.PlanePositionSequence[0].ImagePositionPatient)
        masks[names[group.SegmentIdentificationSequence[0].ReferencedSegmentNumber]][place] = pixels
    return masks


def check_voxels(name, label_map, masks):
    labels = {segment.SegmentLabel: segment.SegmentNumber for segment in label_map.SegmentSequence}
    check(labels.keys() == masks.keys(), f"{name}: segments {sorted(labels)}")
    for pixels, group in zip(label_map.pixel_array, label_map.PerFrameFunctionalGroupsSequence):
        place = tuple(group.PlanePositionSequence[0].ImagePositionPatient)
        for label, number in labels.items():
            expected = masks[label].get(place, numpy.zeros_like(pixels))
            check(((pixels == number) == (expected > 0)).all(), f"{name}: voxels of {label} at {place}")


def main(binary, folder):
    for name in ("seg", "seg-anatomy"):
        label_map = pydicom.dcmread(folder / f"{name}.dcm")
        check_attributes(name, label_map)
        check_voxels(name, label_map, masks_of_binary(pydicom.dcmread(binary / f"{name}.dcm")))
    return 1 if check_objects.failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 3 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    sys.exit(main(*(pathlib.Path(argument) for argument in sys.argv[1:])))
