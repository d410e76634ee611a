#!/usr/bin/env python3
"""check_segments.py LABELS.seg.nrrd SEGMENTATION.dcm [STL_FOLDER [SCENE.glb]]

Checks a DICOM segmentation and surfaces against the label map of the same run: names, terms, colors and voxels of every segment,
read by pydicom, and the volume that every surface encloses.
"""

import gzip
import json
import pathlib
import re
import struct
import sys

import numpy
import pydicom

pydicom.config.settings.reading_validation_mode = pydicom.config.RAISE

LABEL_MAP = "1.2.840.10008.5.1.4.1.1.66.7"
LONGEST_NAME = 64
COLOR_STEP = 0.01  # largest error of a channel, of 1: CIELab is stored in 16 bits
VOLUME_SHARE = 0.03  # largest difference of the volumes of surface and voxels; corners are cut

failures = []


def check(holds, message):
    if not holds:
        failures.append(message)
        print(message)


def read_nrrd(path):
    """Returns the header as a dictionary, and the voxels as [slice, row, column]."""
    head, _, data = path.read_bytes().partition(b"\n\n")
    header = dict(re.split(r":=|: ", line, maxsplit=1) for line in head.decode().split("\n") if re.search(r":=|: ", line))
    kinds = {"unsigned short": "<u2", "ushort": "<u2", "uint16": "<u2"}
    data = gzip.decompress(data) if header["encoding"] in ("gzip", "gz") else data
    size = [int(n) for n in header["sizes"].split()]
    return header, numpy.frombuffer(data, kinds[header["type"]]).reshape(size[::-1])


def segments_of(header):
    """Returns the segments of a header by label."""
    segments = {}
    for i in range(sum(key.endswith("_ID") for key in header)):
        value = {key: header[f"Segment{i}_{key}"] for key in ("Name", "Color", "LabelValue", "Tags")}
        terms = value["Tags"].split(":", 1)[1].split("|")[0].split("~")
        segments[int(value["LabelValue"])] = {
            "name": value["Name"].replace("\\\\", "\\"),
            "color": [float(c) for c in value["Color"].split()],
            "terms": [tuple(term.split("^")) for term in (terms[1], terms[2], terms[5])],
        }
    return segments


def srgb_of_lab(words):
    """Decodes DICOM's CIELab (D50); PS3.3 C.10.7.1.1, CIE 15, IEC 61966-2-1."""
    lightness, a, b = words[0] / 655.35, words[1] / 257 - 128, words[2] / 257 - 128
    y = (lightness + 16) / 116
    xyz = numpy.array([y + a / 500, y, y - b / 200])
    xyz = numpy.where(xyz > 6 / 29, xyz**3, 3 * (6 / 29) ** 2 * (xyz - 4 / 29)) * [0.9642, 1, 0.8249]
    to_xyz = [[0.4361, 0.3851, 0.1431], [0.2225, 0.7169, 0.0606], [0.0139, 0.0971, 0.7141]]
    linear = numpy.clip(numpy.linalg.solve(to_xyz, xyz), 0, 1)
    return numpy.where(linear > 0.0031308, 1.055 * linear ** (1 / 2.4) - 0.055, 12.92 * linear)


def code_of(item, keyword):
    if keyword not in item:
        return ("", "", "")
    code = item[keyword].value[0]
    return (code.CodingSchemeDesignator, code.CodeValue, code.CodeMeaning)


def check_segments(segmentation, segments):
    """Returns the numbers of the segments in the file by label."""
    with_voxels = [label for label in segments if segments[label]["voxels"] > 0]
    check(len(segmentation.SegmentSequence) == len(with_voxels), "number of segments")
    for label, item in zip(with_voxels, segmentation.SegmentSequence):
        segment = segments[label]
        name = segment["name"].replace("\\", "/")[:LONGEST_NAME].strip()
        check(item.SegmentLabel == name, f"{item.SegmentLabel} should be {name}")
        keywords = ("SegmentedPropertyCategoryCodeSequence", "SegmentedPropertyTypeCodeSequence", "AnatomicRegionSequence")
        terms = [code_of(item, keyword) for keyword in keywords]
        check(terms == segment["terms"], f"{name}: {terms} should be {segment['terms']}")
        error = numpy.abs(srgb_of_lab(item.RecommendedDisplayCIELabValue) - segment["color"]).max()
        check(error < COLOR_STEP, f"{name}: its color differs by {error}")
    trackings = {item.TrackingUID for item in segmentation.SegmentSequence}
    check(len(trackings) == len(with_voxels), "tracking UIDs are not unique")
    return {label: item.SegmentNumber for label, item in zip(with_voxels, segmentation.SegmentSequence)}


def check_voxels(segmentation, voxels, numbers):
    masks = {number: numpy.zeros(voxels.shape, bool) for number in numbers.values()}
    places = sorted({tuple(group.PlanePositionSequence[0].ImagePositionPatient) for group in segmentation.PerFrameFunctionalGroupsSequence},
                    key=lambda place: numpy.dot(place, numpy.cross(*numpy.reshape(axes_of(segmentation), (2, 3)))))
    present = [z for z in range(len(voxels)) if voxels[z].any() or segmentation.SOPClassUID == LABEL_MAP]
    check(len(places) == len(present), f"{len(places)} slices of {len(present)}")
    for pixels, group in zip(segmentation.pixel_array, segmentation.PerFrameFunctionalGroupsSequence):
        z = present[places.index(tuple(group.PlanePositionSequence[0].ImagePositionPatient))]
        if segmentation.SOPClassUID == LABEL_MAP:
            for number in masks:
                masks[number][z] = pixels == number
        else:
            masks[group.SegmentIdentificationSequence[0].ReferencedSegmentNumber][z] = pixels > 0
    for label, number in numbers.items():
        check((masks[number] == (voxels == label)).all(), f"segment {number} differs from label {label}")


def axes_of(segmentation):
    return segmentation.SharedFunctionalGroupsSequence[0].PlaneOrientationSequence[0].ImageOrientationPatient


def volume_of(triangles):
    """Encloses by the divergence theorem; triangles as [face, corner, axis]."""
    return numpy.einsum("fi,fi->", triangles[:, 0], numpy.cross(triangles[:, 1], triangles[:, 2])) / 6


def check_stl(folder, segments, voxel):
    files = sorted(folder.glob("segment-*.stl"))
    expected = [f"segment-{label:05}.stl" for label in segments if segments[label]["voxels"] > 0]
    check([file.name for file in files] == expected, f"{[file.name for file in files]} should be {expected}")
    for file in files:
        data = numpy.frombuffer(file.read_bytes()[84:], numpy.dtype([("v", "<f4", (4, 3)), ("n", "<u2")]))["v"]
        label = int(file.stem.split("-")[1])
        compare_volumes(file.name, volume_of(data[:, 1:].astype(float)), segments[label]["voxels"] * voxel)


def check_scene(path, segments, voxel):
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    document, binary = json.loads(data[20 : 20 + length]), data[28 + length :]
    present = [segment for segment in segments.values() if segment["voxels"] > 0]
    nodes = [document["nodes"][child] for child in document["nodes"][0]["children"]]
    check([node["name"] for node in nodes] == [segment["name"] for segment in present], f"{path.name}: names of nodes")

    def values_of(accessor, kind, width):
        view = document["bufferViews"][document["accessors"][accessor]["bufferView"]]
        return numpy.frombuffer(binary, kind, document["accessors"][accessor]["count"] * width, view["byteOffset"])

    for node, segment in zip(nodes, present):
        primitive = document["meshes"][node["mesh"]]["primitives"][0]
        points = values_of(primitive["attributes"]["POSITION"], "<f4", 3).reshape(-1, 3).astype(float)
        compare_volumes(node["name"], volume_of(points[values_of(primitive["indices"], "<u4", 1).reshape(-1, 3)]), segment["voxels"] * voxel)


def compare_volumes(name, found, expected):
    check(abs(found / expected - 1) < VOLUME_SHARE, f"{name}: encloses {found:.1f} mm^3, voxels have {expected:.1f}")


def main(labels, dicom, stl=None, scene=None):
    header, voxels = read_nrrd(labels)
    segments = segments_of(header)
    for label, segment in segments.items():
        segment["voxels"] = int((voxels == label).sum())
    check(sum(segment["voxels"] > 0 for segment in segments.values()) > 1, "fewer than two segments have voxels")
    segmentation = pydicom.dcmread(dicom)
    check_voxels(segmentation, voxels, check_segments(segmentation, segments))
    directions = re.findall(r"\(([^)]*)\)", header["space directions"])
    voxel = abs(numpy.linalg.det([[float(x) for x in direction.split(",")] for direction in directions]))
    if stl:
        check_stl(stl, segments, voxel)
    if scene:
        check_scene(scene, segments, voxel)
    print(f"{len(segments)} segments, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    if not 3 <= len(sys.argv) <= 5 or "--help" in sys.argv:
        print(__doc__)
        sys.exit(0 if "--help" in sys.argv else 2)
    sys.exit(main(*(pathlib.Path(argument) for argument in sys.argv[1:])))
