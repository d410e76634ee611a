#!/usr/bin/python3
"""uids.py FOLDER...: prints a line "SOP instance, series, study, file" per DICOM file below the folders, sorted. Reads
top-level attributes only; dcmdump +P would include sequences. Status 1 if a file is not DICOM or truncated."""

import os
import sys

import pydicom


def line_of(path):
    try:
        data = pydicom.dcmread(path)
        return f"{data.SOPInstanceUID} {data.SeriesInstanceUID} {data.StudyInstanceUID} {path}"
    except Exception as error:  # pydicom raises many types for malformed files
        sys.exit(f"{path} is not a complete DICOM file: {error}")


if __name__ == "__main__":
    paths = (os.path.join(place, name) for top in sys.argv[1:] for place, _, names in os.walk(top) for name in names)
    print("".join(f"{line}\n" for line in sorted(map(line_of, paths))), end="")
