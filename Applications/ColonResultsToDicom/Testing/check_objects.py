#!/usr/bin/env python3
"""check_objects.py SERIES_FOLDER EXAM_FOLDER RESULT_FOLDER

Checks the objects of ColonResultsToDicom with pydicom, voxel by voxel: the segmentation against lumen.nrrd, references,
patient, study, dates, numbers of the report against candidates.csv.
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
    check(result.SOPInstanceUID.startswith("2.25.") and len(result.SOPInstanceUID) <= 64, f"{name}: UID under 2.25")


def check_segmentation(result, slices, lumen):
    check(result.ContentQualification == "RESEARCH", "seg: for research")
    check(result.FrameOfReferenceUID == slices[0].FrameOfReferenceUID, "seg: frame of reference")
    referenced = [i.ReferencedSOPInstanceUID for i in result.ReferencedSeriesSequence[0].ReferencedInstanceSequence]
    check(referenced == [s.SOPInstanceUID for s in slices], "seg: refers to all slices in order")
    names = {s.SegmentNumber: s.SegmentLabel for s in result.SegmentSequence}
    voxels = {name: numpy.zeros(lumen.shape, bool) for name in names.values()}
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
    check((voxels["gas"] == (lumen == 1)).all(), "seg: gas equals lumen.nrrd")
    check((voxels["fluid"] == (lumen == 2)).all(), "seg: fluid equals lumen.nrrd")
    colon = ("rectum", "sigmoid", "descending", "transverse", "ascending", "cecum")
    together = sum(voxels[name].astype(int) for name in colon)
    check((together == ((lumen == 1) | (lumen == 2))).all(), "seg: each lumen voxel is in one segment of the colon")
    tissue = [name for name in voxels if name.startswith("candidate") or name == "haustral folds"]
    check(len(tissue) > 1, "seg: candidates and folds exist")
    together = sum(voxels[name].astype(int) for name in tissue)
    check(together.max() == 1 and not (together.astype(bool) & (lumen > 0)).any(), "seg: folds and heads are tissue")
    return {s.TrackingUID: (s.SegmentNumber, int(voxels[s.SegmentLabel].sum())) for s in result.SegmentSequence}


def check_report(result, segmentation, slices, candidates, tracked):
    flags = (result.CompletionFlag, result.VerificationFlag, result.PreliminaryFlag)
    check(flags == ("PARTIAL", "UNVERIFIED", "PRELIMINARY"), "sr: flags")
    evidence = {
        instance.ReferencedSOPInstanceUID
        for study in result.CurrentRequestedProcedureEvidenceSequence
        for series in study.ReferencedSeriesSequence
        for instance in series.ReferencedSOPSequence
    }
    expected = {s.SOPInstanceUID for s in slices} | {segmentation.SOPInstanceUID}
    check(evidence == expected, "sr: the evidence contains slices and segmentation")
    groups = {next(contents(g, "Tracking Identifier")).TextValue: g for g in contents(result, "Measurement Group")}
    for row in candidates:
        group = groups["candidate " + row["candidate"]]
        segment = next(contents(group, "Referenced Segment")).ReferencedSOPSequence[0]
        uid = next(contents(group, "Tracking Unique Identifier")).UID
        check(segment.ReferencedSOPInstanceUID == segmentation.SOPInstanceUID, "sr: refers to the segmentation")
        check(segment.ReferencedSegmentNumber == tracked[uid][0], "sr: a candidate has its segment")
        for column, name in (("diameter", "Diameter"), ("height", "Height"), ("arcLength", "Distance from anus")):
            value = float(next(contents(group, name)).MeasuredValueSequence[0].NumericValue)
            check(abs(value / float(row[column]) - 1) < 1e-3, f"sr: {name} of a candidate")
        center = numpy.array(next(contents(group, "Center")).GraphicData, float)
        place = numpy.array([float(row[axis]) for axis in "xyz"])
        check(numpy.abs(center - place).max() < 1e-3, "sr: center of a candidate")
    for name in ("rectum", "cecum"):
        check(len(list(contents(groups[name], "Path length"))) == 1, f"sr: length of the {name}")


def main(series, exam, folder):
    slices = read_series(series)
    lumen = read_labels(exam / "segmentation" / "lumen.nrrd")
    with open(exam / "polyps" / "candidates.csv", encoding="utf-8") as table:
        candidates = list(csv.DictReader(table))
    objects = {name: pydicom.dcmread(folder / f"{name}.dcm") for name in ("seg", "sr", "cad", "sc", "stl")}
    for name, result in objects.items():
        check_header(name, result, slices[0])
    check(len({o.SeriesInstanceUID for o in objects.values()}) == len(objects), "each object is in a separate series")
    tracked = check_segmentation(objects["seg"], slices, lumen)
    check_report(objects["sr"], objects["seg"], slices, candidates, tracked)
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
