#!/usr/bin/env python3
"""make-cases.py FOLDER [NAME...]

Writes hard but valid DICOM, NIfTI and NRRD files, and some invalid ones, with what a reader must return:
  FOLDER/cases/NAME/      the input: one file, or a folder of files
  FOLDER/expected/NAME.f32  intensities in little-endian single precision, x fastest, then y, then z
  FOLDER/cases.csv        one row per case; see README.md
All pixels are computed. License: CC0 1.0.
"""
import csv
import pathlib
import sys

import case_files
import dicom_cases  # noqa: F401 (registers its cases)
import dicom_enhanced_cases  # noqa: F401
import nifti_cases  # noqa: F401
import nrrd_cases  # noqa: F401
import segment_cases  # noqa: F401


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    (folder / "expected").mkdir(parents=True, exist_ok=True)
    rows = []
    for case in case_files.CASES:
        if len(sys.argv) > 2 and case.name not in sys.argv[2:]:
            continue
        rows.append(case.write(folder))
    with open(folder / "cases.csv", "w", newline="") as file:
        table = csv.DictWriter(file, case_files.COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


if __name__ == "__main__":
    main()
