#!/usr/bin/env python3
"""label_report.py SR_OHIF.dcm OUTPUT.dcm

Changes sr-ohif.dcm as a reader does in OHIF: labels candidate 1 as a polyp and candidate 2 as none, deletes candidate 3,
lengthens the line of candidate 4 by 4 mm, adds a polyp, and a line without a verdict.
"""

import copy
import sys

import pydicom

from check_objects import contents


def comment_of(group):
    return next(contents(group, "Comment"))


def length_of(group):
    return next(contents(group, "Length"))


def scheme_of(item):
    codes = item.get("ConceptCodeSequence", [])
    return codes[0].CodingSchemeDesignator if codes else None


def add_copy(groups, label):
    group = copy.deepcopy(groups[-1])
    group.ContentSequence = [item for item in group.ContentSequence if scheme_of(item) != "99SHAPETON"]
    comment_of(group).TextValue = label
    line = length_of(group).ContentSequence[0]
    line.GraphicData = [value + 3.0 for value in line.GraphicData]
    groups.append(group)


def main(report, output):
    dataset = pydicom.dcmread(report)
    groups = next(contents(dataset, "Imaging Measurements")).ContentSequence
    for group in groups:  # OHIF writes neither the suffix of the name nor other points
        next(contents(group, "Tracking Identifier")).TextValue = "Cornerstone3DTools@^0.1.0:Length"
        group.ContentSequence = [item for item in group.ContentSequence if not item.ValueType.startswith("SCOORD")]
    comment_of(groups[0]).TextValue = "Polyp"
    comment_of(groups[1]).TextValue = "candidate 2: not a polyp, a fold"
    value = length_of(groups[3]).MeasuredValueSequence[0]
    value.NumericValue = f"{float(value.NumericValue) + 4.0:.4f}"
    del groups[2]
    add_copy(groups, "polyp behind a fold")
    add_copy(groups, "width of the lumen")
    dataset.save_as(output)


if __name__ == "__main__":
    if len(sys.argv) != 3 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    main(*sys.argv[1:])
