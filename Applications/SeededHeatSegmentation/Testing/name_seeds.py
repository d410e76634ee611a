#!/usr/bin/env python3
"""name_seeds.py LABELS.nrrd NAMED.seg.nrrd

Adds names, colors and terms of 3D Slicer to a label map: some with characters that DICOM encodes or does not allow.
"""

import sys

SEGMENTS = [
    (1, "W\u00fcrfel \u7acb\u65b9", "0.1 0.5 0.9", "SCT^91723000^Anatomical Structure", "SCT^39607008^Lung", "SCT^24028007^Right"),
    (2, "rod\\ball " + "x" * 70, "0.9 0.9 0.1", "SCT^49755003^Morphologically Altered Structure", "SCT^4147007^Mass", "^^"),
    (3, "plate", "0.2 0.7 0.3", "SCT^85756007^Tissue", "SCT^85756007^Tissue", "^^"),
]


def main(source, target):
    with open(source, "rb") as file:
        head, _, data = file.read().partition(b"\n\n")
    lines = ["Segmentation_MasterRepresentation:=Binary labelmap"]
    for i, (label, name, color, category, kind, region) in enumerate(SEGMENTS):
        tags = f"TerminologyEntry:Some list~{category}~{kind}~^^~Anatomic codes - DICOM master list~{region}~^^|"
        escaped = name.replace("\\", "\\\\")
        values = {"ID": f"Segment_{label}", "Name": escaped, "Color": color, "LabelValue": label, "Layer": 0, "Tags": tags}
        lines += [f"Segment{i}_{key}:={value}" for key, value in values.items()]
    with open(target, "wb") as file:
        file.write(head + b"\n" + "\n".join(lines).encode() + b"\n\n" + data)


if __name__ == "__main__":
    if len(sys.argv) != 3 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    main(*sys.argv[1:])
