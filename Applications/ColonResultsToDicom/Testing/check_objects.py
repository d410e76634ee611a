#!/usr/bin/env python3
"""check_objects.py SERIES_FOLDER EXAM_FOLDER RESULT_FOLDER

Checks the objects of ColonResultsToDicom with pydicom, voxel by voxel: the segmentations against lumen.nrrd, references,
patient, study, dates, numbers and places of the report against candidates.csv and the segmentations.
"""

import csv
import gzip
import pathlib
import re
import sys

import numpy
import pydicom

failures = 0


def check(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED:", what)


def read_labels(path):
    header, data = path.read_bytes().split(b"\n\n", 1)
    size = [int(n) for n in re.search(rb"sizes: (\d+) (\d+) (\d+)", header).groups()]
    return numpy.frombuffer(gzip.decompress(data), numpy.uint8).reshape(size[::-1])


def contents(item, wanted):
    """Returns all nested content items whose concept has this meaning."""
    for child in item.get("ContentSequence", []):
        name = child.get("ConceptNameCodeSequence")
        if name and name[0].CodeMeaning == wanted:
            yield child
        yield from contents(child, wanted)


def read_series(folder):
    slices = [pydicom.dcmread(path, stop_before_pixels=True) for path in sorted(folder.glob("*.dcm"))]
    return sorted(slices, key=lambda s: float(s.ImagePositionPatient[2]))


def check_header(name, result, source):
    for key in ("PatientID", "PatientName", "StudyInstanceUID", "StudyDate", "StudyTime", "AccessionNumber"):
        check(result.get(key) == source.get(key), f"{name}: {key} equals the source")
    check(result.ContentDate == source.AcquisitionDate, f"{name}: the date equals the source")
    check(result.SeriesInstanceUID != source.SeriesInstanceUID, f"{name}: the series is new")
    check(result.get("TimezoneOffsetFromUTC") == source.get("TimezoneOffsetFromUTC"), f"{name}: time zone")
    check(result.SOPInstanceUID.startswith("2.25.") and len(result.SOPInstanceUID) <= 64, f"{name}: UID under 2.25")


def check_private_codes(name, result):
    """Private codes name their coding scheme; nothing else does."""
    used = any(item.value == "99SHAPETON" for item in result.iterall() if item.keyword == "CodingSchemeDesignator")
    named = [scheme.CodingSchemeDesignator for scheme in result.get("CodingSchemeIdentificationSequence", [])]
    check(named == (["99SHAPETON"] if used else []), f"{name}: identifies its private codes")


def read_segmentation(result, slices):
    """Returns a mask per segment, on the grid of the series."""
    check(result.SegmentsOverlap == "NO", "seg: no overlap")
    check(result.BodyPartExamined == "COLON", "seg: body part")
    check(result.ContentQualification == "RESEARCH", "seg: for research")
    check(result.FrameOfReferenceUID == slices[0].FrameOfReferenceUID, "seg: frame of reference")
    referenced = [i.ReferencedSOPInstanceUID for i in result.ReferencedSeriesSequence[0].ReferencedInstanceSequence]
    check(referenced == [s.SOPInstanceUID for s in slices], "seg: refers to all slices in order")
    names = {s.SegmentNumber: s.SegmentLabel for s in result.SegmentSequence}
    shape = (len(slices), slices[0].Rows, slices[0].Columns)
    voxels = {name: numpy.zeros(shape, bool) for name in names.values()}
    pixels = result.pixel_array
    check(all(frame.any() for frame in pixels), "seg: no frame is empty")
    for frame, group in zip(pixels, result.PerFrameFunctionalGroupsSequence):
        place = numpy.array(group.PlanePositionSequence[0].ImagePositionPatient, float)
        image = group.DerivationImageSequence[0].SourceImageSequence[0].ReferencedSOPInstanceUID
        slice_number = referenced.index(image)
        source = numpy.array(slices[slice_number].ImagePositionPatient, float)
        check(numpy.abs(source - place).max() < 1e-6, "seg: a frame is in the slice to which it refers")
        name = names[group.SegmentIdentificationSequence[0].ReferencedSegmentNumber]
        voxels[name][slice_number] |= frame > 0
    check(sum(mask.astype(int) for mask in voxels.values()).max() == 1, "seg: each voxel is in one segment")
    colors = [tuple(s.RecommendedDisplayCIELabValue) for s in result.SegmentSequence]
    check(len(set(colors)) == len(colors), "seg: each segment has its own color")
    return voxels


def tracked_segments(objects, masks):
    """Tracking UID: instance, number and mask of its segment."""
    return {
        s.TrackingUID: (objects[name].SOPInstanceUID, s.SegmentNumber, masks[name][s.SegmentLabel])
        for name in masks
        for s in objects[name].SegmentSequence
    }


def check_segments(voxels, lumen):
    check((voxels["gas"] == (lumen == 1)).all(), "seg: gas equals lumen.nrrd")
    check((voxels["fluid"] == (lumen == 2)).all(), "seg: fluid equals lumen.nrrd")
    colon = ("rectum", "sigmoid", "descending", "transverse", "ascending", "cecum")
    together = sum(voxels[name].astype(int) for name in colon)
    check((together == ((lumen == 1) | (lumen == 2))).all(), "seg: each lumen voxel is in one segment of the colon")
    tissue = [name for name in voxels if name.startswith("candidate") or name == "haustral folds"]
    check(len(tissue) > 1, "seg: candidates and folds exist")
    together = sum(voxels[name].astype(int) for name in tissue)
    check(together.max() == 1 and not (together.astype(bool) & (lumen > 0)).any(), "seg: folds and heads are tissue")


def voxel_of(point, slices):
    """Index (slice, row, column) of a point of an axis-parallel series."""
    origin = numpy.array(slices[0].ImagePositionPatient, float)
    step = [*reversed([float(s) for s in slices[0].PixelSpacing]), 0.0]
    step[2] = float(slices[1].ImagePositionPatient[2]) - origin[2]
    return tuple(int(round(n)) for n in reversed((numpy.array(point, float) - origin) / step))


def check_center(group, slices):
    """The center comes first in pixels of a slice, then in space, and both agree. Returns its voxel."""
    pixel, space = contents(group, "Center")
    check((pixel.ValueType, space.ValueType) == ("SCOORD", "SCOORD3D"), "sr: a center in pixels, then in space")
    number, row, column = voxel_of(space.GraphicData, slices)
    image = pixel.ContentSequence[0].ReferencedSOPSequence[0].ReferencedSOPInstanceUID
    check(image == slices[number].SOPInstanceUID, "sr: the center is in the nearest slice")
    place = numpy.array(pixel.GraphicData, float) - 0.5  # 0 is the outer corner of the first pixel
    check(numpy.abs(place - [column, row]).max() <= 0.5001, "sr: both places of a center agree")
    return number, row, column


def check_groups(groups, slices, tracked):
    for name, group in groups.items():
        voxel = check_center(group, slices)
        uid = next(contents(group, "Tracking Unique Identifier")).UID
        check(len(list(contents(group, "Algorithm Name"))) == 1, f"sr: one algorithm for {name}")
        check(not any(list(contents(n, "Algorithm Name")) for n in group.ContentSequence), "sr: numbers have none")
        segment = next(contents(group, "Referenced Segment")).ReferencedSOPSequence[0]
        instance, number, mask = tracked[uid]
        check(segment.ReferencedSOPInstanceUID == instance, f"sr: {name} refers to its segmentation")
        check(segment.ReferencedSegmentNumber == number, f"sr: {name} refers to its segment")
        check(name.startswith("candidate") or mask[voxel], f"sr: the center of {name} is in its segment")


def check_report(result, segmentations, slices, candidates, tracked):
    flags = (result.CompletionFlag, result.VerificationFlag, result.PreliminaryFlag)
    check(flags == ("PARTIAL", "UNVERIFIED", "PRELIMINARY"), "sr: flags")
    evidence = {
        instance.ReferencedSOPInstanceUID
        for study in result.CurrentRequestedProcedureEvidenceSequence
        for series in study.ReferencedSeriesSequence
        for instance in series.ReferencedSOPSequence
    }
    expected = {s.SOPInstanceUID for s in slices} | {s.SOPInstanceUID for s in segmentations}
    check(evidence == expected, "sr: the evidence contains slices and segmentations")
    groups = {next(contents(g, "Tracking Identifier")).TextValue: g for g in contents(result, "Measurement Group")}
    check_groups(groups, slices, tracked)
    for row in candidates:
        group = groups["candidate " + row["candidate"]]
        for column, name in (("diameter", "Diameter"), ("height", "Height"), ("arcLength", "Distance from anus")):
            value = float(next(contents(group, name)).MeasuredValueSequence[0].NumericValue)
            check(abs(value / float(row[column]) - 1) < 1e-3, f"sr: {name} of a candidate")
        center = numpy.array(list(contents(group, "Center"))[1].GraphicData, float)
        place = numpy.array([float(row[axis]) for axis in "xyz"])
        check(numpy.abs(center - place).max() < 1e-3, "sr: center of a candidate")
    for name in ("rectum", "cecum"):
        check(len(list(contents(groups[name], "Path length"))) == 1, f"sr: length of the {name}")


def main(series, exam, folder):
    slices = read_series(series)
    lumen = read_labels(exam / "segmentation" / "lumen.nrrd")
    with open(exam / "polyps" / "candidates.csv", encoding="utf-8") as table:
        candidates = list(csv.DictReader(table))
    objects = {
        name: pydicom.dcmread(folder / f"{name}.dcm") for name in ("seg", "seg-anatomy", "sr", "cad", "sc", "stl")
    }
    for name, result in objects.items():
        check_header(name, result, slices[0])
        check_private_codes(name, result)
    check(len({o.SeriesInstanceUID for o in objects.values()}) == len(objects), "each object is in a separate series")
    masks = {name: read_segmentation(objects[name], slices) for name in ("seg", "seg-anatomy")}
    check_segments({**masks["seg"], **masks["seg-anatomy"]}, lumen)
    tracked = tracked_segments(objects, masks)
    check_report(objects["sr"], [objects[name] for name in masks], slices, candidates, tracked)
    findings = list(contents(objects["cad"], "Single Image Finding"))
    check(len(findings) == len(candidates), "cad: a finding for each candidate")
    check(objects["sc"].pixel_array.shape[2] == 3, "sc: a color picture")
    check(objects["stl"].EncapsulatedDocument[:5] != b"solid", "stl: binary")
    return 1 if failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 4 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    sys.exit(main(*(pathlib.Path(argument) for argument in sys.argv[1:])))
