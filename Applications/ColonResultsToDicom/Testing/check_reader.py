#!/usr/bin/env python3
"""check_reader.py EXAM_FOLDER PARTIAL_FOLDER COMPLETE_FOLDER

Checks sr-reader.dcm of ColonResultsToDicom with pydicom, for the verdicts of MakeVerdicts.cmake: observer, flags,
categories, and the accepted polyps.
"""

import csv
import pathlib
import re
import sys

import check_objects
import pydicom
from check_objects import check, contents


def text_of(group, name):
    return next(contents(group, name)).TextValue


def code_of(group, name):
    return next(contents(group, name)).ConceptCodeSequence[0].CodeValue


def check_flags(report, completion):
    flags = (report.CompletionFlag, report.VerificationFlag, report.PreliminaryFlag)
    check(flags == (completion, "UNVERIFIED", "PRELIMINARY"), f"flags {flags}")


def check_category(report, name, expected):
    code = next(contents(report, name)).ConceptCodeSequence[0]
    found = (code.CodeValue, code.CodingSchemeDesignator, code.CodeMeaning)
    check(found == expected, f"category {found}, expected {expected}")


def check_observer(report, name):
    check(code_of(report, "Observer Type") == "121006", "the observer is a person")
    person = next(contents(report, "Person Observer Name")).PersonName
    check(str(person) == name, f"name of the observer: {person}")


def check_candidate(group, row, segmentation):
    check(code_of(group, "Finding") == "68496003", "candidate: a polyp of the colon")
    size = next(contents(group, "Polyp size, largest dimension"))
    check(float(size.MeasuredValueSequence[0].NumericValue) == 12.5, "candidate: size of the reader")
    check(not list(contents(group, "Algorithm Name")), "candidate: not all numbers are the program's")
    notes = [c.TextValue for c in contents(group, "Comment")]
    said = [note for note in notes if re.fullmatch(r"(.*): measured by Shapeton VirtualColonoscopy .*", note)]
    check(len(said) == 1 and said[0].startswith("Distance from anus"), "candidate: the program measured the distance")
    check(code_of(group, "Morphology of a polyp") == "25126001", "candidate: pedunculated")
    pixel, space = contents(group, "Center")
    check((pixel.ValueType, space.ValueType) == ("SCOORD", "SCOORD3D"), "candidate: center in pixels and in space")
    center = [float(value) for value in space.GraphicData]
    check(all(abs(a - float(row[axis])) < 1e-3 for a, axis in zip(center, "xyz")), "candidate: center")
    segment = next(contents(group, "Referenced Segment")).ReferencedSOPSequence[0]
    check(segment.ReferencedSOPInstanceUID == segmentation.SOPInstanceUID, "candidate: refers to seg.dcm")
    check("note of the reader: größer" in notes, "candidate: note of the reader")


def check_finding(group):
    check(code_of(group, "Finding Site") == "32713005", "finding: cecum")
    center = list(contents(group, "Center"))[-1]
    check(list(center.GraphicData) == [10.0, 20.0, -30.5], "finding: center")
    check(not list(contents(group, "Polyp size, largest dimension")), "finding: no size was entered")


def main(exam, partial, complete):
    with open(exam / "polyps" / "candidates.csv", encoding="utf-8") as table:
        first = next(csv.DictReader(table))
    report = pydicom.dcmread(partial / "sr-reader.dcm")
    check_flags(report, "PARTIAL")
    check_observer(report, "Müller^Anna")
    check_category(report, "Colon Overall Assessment", ("112243", "DCM", "C3 - Polyp, Possibly Advanced Adenoma"))
    check(text_of(report, "Extracolonic assessment") == "no category entered", "no extracolonic category")
    groups = {text_of(g, "Tracking Identifier"): g for g in contents(report, "Measurement Group")}
    check(list(groups) == ["candidate 1", "finding F1"], f"groups {list(groups)}")
    check_candidate(groups["candidate 1"], first, pydicom.dcmread(partial / "seg.dcm"))
    check_finding(groups["finding F1"])
    report = pydicom.dcmread(complete / "sr-reader.dcm")
    check_flags(report, "COMPLETE")
    check_category(report, "Colon Overall Assessment", ("CRADS-C2B", "99SHAPETON", "C2b - Likely Benign Diverticular Finding"))
    check(code_of(report, "Extracolonic assessment") == "CRADS-E1E2", "extracolonic category")
    check_observer(report, "anonymous^")
    return 1 if check_objects.failures else 0


if __name__ == "__main__":
    if len(sys.argv) != 4 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    sys.exit(main(*(pathlib.Path(argument) for argument in sys.argv[1:])))
