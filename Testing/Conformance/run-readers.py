#!/usr/bin/env python3
"""run-readers.py CASES RESULTS [--baseline MATRIX.csv] [READER...]

Runs readers (default: the installed ones) on the cases of make-cases.py and writes RESULTS/matrix.csv and RESULTS/matrix.md: right,
refused, wrong, or wrong with a warning; with the versions. See README.md for the definitions. With --baseline, ends with status 1
if an outcome differs from that matrix.
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import readers
from case_files import BRIGHT

HERE = pathlib.Path(__file__).parent
OHIF = HERE.parent / "Ohif/ohif.mjs"
PLACE_TOLERANCE = 0.02  # voxels; rounding of decimal strings and single precision is smaller
VALUE_TOLERANCE = 0.01  # intensities are multiples of 1/8
CENTER_TOLERANCE = 0.75  # mm; a resampled box of 9 to 13 mm; slices at wrong places move it by 2 mm or more
EXTENT_TOLERANCE = 0.15  # of the standard deviation
LONGEST_LINE = 200  # characters of the log


def has_voxels(case, expected, pieces):
    """Whether each expected voxel is at its place in one of the pieces."""
    size = [int(case[f"size_{a}"]) for a in "xyz"]
    matrix = np.eye(4)
    direction = np.array([[float(case[f"direction_{r}{c}"]) for c in "xyz"] for r in "xyz"])
    matrix[:3, :3] = direction * [float(case[f"spacing_{a}"]) for a in "xyz"]
    matrix[:3, 3] = [float(case[f"origin_{a}"]) for a in "xyz"]
    z, y, x = np.indices(size[::-1])
    places = matrix @ np.stack([x.ravel(), y.ravel(), z.ravel(), np.ones(x.size)])
    is_found = np.isnan(expected)
    for array, own in pieces:
        index = (np.linalg.inv(own) @ places)[:3]
        nearest = np.rint(index).astype(int)
        bounds = np.array(array.shape[::-1])[:, None]
        is_here = (np.abs(index - nearest) < PLACE_TOLERANCE).all(axis=0) & ((nearest >= 0) & (nearest < bounds)).all(axis=0)
        i, j, k = nearest[:, is_here]
        is_found[is_here] |= np.abs(array[k, j, i] - expected[is_here]) < VALUE_TOLERANCE
    return bool(is_found.all())


def has_places(case, pieces):
    """Whether the bright voxels have the expected center and extent."""
    found = []
    for array, own in pieces:
        k, j, i = np.nonzero(array > BRIGHT)
        found.append((own @ np.stack([i, j, k, np.ones(len(i))]))[:3])
    found = np.concatenate(found, axis=1)
    if found.shape[1] == 0:
        return False
    center = np.array([float(case[f"origin_{a}"]) for a in "xyz"])
    extent = np.array([float(case[f"spacing_{a}"]) for a in "xyz"])
    is_there = np.abs(found.mean(axis=1) - center).max() < CENTER_TOLERANCE
    return bool(is_there and np.abs(found.std(axis=1) / extent - 1).max() < EXTENT_TOLERANCE)


def judge(case, cases, reader):
    """The outcome and the last line of the reader's output."""
    if case["format"] not in readers.READERS[reader][1]:
        return "", ""
    with tempfile.TemporaryDirectory() as folder:
        result = folder + "/result.npz"
        command = [sys.executable, HERE / "readers.py", reader, cases / "cases" / case["name"], result]
        done = subprocess.run(list(map(str, command)), capture_output=True, text=True, errors="replace")
        output = (done.stdout + done.stderr).strip()
        last = output.splitlines()[-1][:LONGEST_LINE] if output else ""
        if done.returncode != 0:
            return ("right" if case["expectation"] == "refusal" else "refused"), last
        data = np.load(result)
        pieces = [(data[f"array{i}"], data[f"matrix{i}"]) for i in range(len(data.files) // 2)]
    if case["expectation"] == "places":
        is_right = has_places(case, pieces)
    elif case["expectation"] == "voxels":
        is_right = has_voxels(case, np.fromfile(cases / "expected" / (case["name"] + ".f32"), "<f4").astype(float), pieces)
    else:
        is_right = False
    warns = any(word in output.lower() for word in ("warn", "error", "note:"))
    return "right" if is_right else "wrong, warns" if warns else "wrong", last


def version_of(reader):
    commands = {
        "shapeton": "$SHAPETON_TOOLS/DicomSeriesToImage --version",
        "itk": "dpkg-query -W -f '${Version}' libinsighttoolkit5-dev",
        "plastimatch": "dpkg-query -W -f '${Version}' plastimatch",
        "dcm2niix": "dpkg-query -W -f '${Version}' dcm2niix",
        "gdcm": "dpkg-query -W -f '${Version}' python3-gdcm",
        "pydicom": "dpkg-query -W -f '${Version}' python3-pydicom",
        "nibabel": "dpkg-query -W -f '${Version}' python3-nibabel",
        "ohif": "command -v Orthanc chromium > /dev/null && sed -n \"s/^const PACKAGE = '@ohif.app@\\(.*\\)';/\\1/p\" " + str(OHIF),
        "dcmjs": "node -p \"require('$SHAPETON_NODE_MODULES/node_modules/dcmjs/package.json').version\"",
    }
    return subprocess.run(commands[reader], shell=True, capture_output=True, text=True).stdout.strip().rpartition(" ")[2]


def write_matrix(cases, versions, outcomes, results):
    names = list(versions)
    with open(results / "matrix.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["name", "format", "title", "clause", *names])
        table.writerow(["version", "", "", "", *versions.values()])
        for case in cases:
            own = (outcomes[case["name"], name] for name in names)
            table.writerow([case["name"], case["format"], case["title"], case["clause"], *own])
    marks = {"right": "right", "refused": "-", "wrong": "**wrong**", "wrong, warns": "**wrong**, warns", "": ""}
    lines = ["| case | " + " | ".join(names) + " |", "|---|" + "---|" * len(names)]
    lines.append("| version | " + " | ".join(versions.values()) + " |")
    for outcome in ("right", "refused", "wrong"):
        counts = [sum(outcomes[c["name"], n].startswith(outcome) for c in cases) for n in names]
        lines.append(f"| {outcome} | " + " | ".join(map(str, counts)) + " |")
    for case in cases:
        row = " | ".join(marks[outcomes[case["name"], n]] for n in names)
        lines.append(f"| `{case['name']}`: {case['title']} ({case['clause']}) | {row} |")
    (results / "matrix.md").write_text("\n".join(lines) + "\n")


def changes(outcomes, baseline):
    """Lines about outcomes that differ from a matrix."""
    with open(baseline) as file:
        before = {row["name"]: row for row in csv.DictReader(file)}
    return [
        f"{case}: {reader} was {before.get(case, {}).get(reader)!r}, is {outcome!r}"
        for (case, reader), outcome in outcomes.items()
        if before.get(case, {}).get(reader) != outcome
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--baseline")
    parser.add_argument("readers", nargs="*", default=list(readers.READERS))
    given = parser.parse_intermixed_args()
    unknown = sorted(set(given.readers) - set(readers.READERS))
    if unknown:
        parser.error("unknown reader " + ", ".join(unknown) + "; known: " + ", ".join(readers.READERS))
    versions = {name: version_of(name) for name in given.readers}
    missing = [name for name, version in versions.items() if not version]
    if missing:
        print("not installed, left out: " + ", ".join(missing))
        versions = {name: version for name, version in versions.items() if version}
    with open(given.cases / "cases.csv") as file:
        cases = list(csv.DictReader(file))
    given.results.mkdir(parents=True, exist_ok=True)
    outcomes = {}
    with open(given.results / "log.txt", "w") as log:
        for case in cases:
            for name in versions:
                outcomes[case["name"], name], last = judge(case, given.cases, name)
                log.write(f"{case['name']}\t{name}\t{outcomes[case['name'], name]}\t{last}\n")
                log.flush()
    write_matrix(cases, versions, outcomes, given.results)
    found = changes(outcomes, given.baseline) if given.baseline else []
    print("\n".join(found))
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
