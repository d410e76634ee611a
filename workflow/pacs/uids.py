#!/usr/bin/python3
"""uids.py FOLDER...: a line "SOP instance, series, study, file" for each DICOM file below the folders, sorted. Top-level attributes alone:
dcmdump +P also finds those of sequences. Status 1 when a file is none, or is cut off."""

import os
import sys

import pydicom


def line_of(path):
    try:
        data = pydicom.dcmread(path)
        return f"{data.SOPInstanceUID} {data.SeriesInstanceUID} {data.StudyInstanceUID} {path}"
    except Exception as error:  # pydicom raises many kinds for malformed files
        sys.exit(f"{path} is no whole DICOM file: {error}")


if __name__ == "__main__":
    paths = (os.path.join(place, name) for top in sys.argv[1:] for place, _, names in os.walk(top) for name in names)
    print("".join(f"{line}\n" for line in sorted(map(line_of, paths))), end="")
