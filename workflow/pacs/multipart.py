#!/usr/bin/python3
"""Helpers for DICOMweb with curl.
multipart.py values KEYWORD FILE        prints the values of a keyword in a QIDO-RS response
multipart.py split FILE FOLDER          writes the parts of a WADO-RS response as files
multipart.py join BOUNDARY FILE         prints a body for STOW-RS"""

import json
import sys

TAGS = {"StudyInstanceUID": "0020000D", "SeriesInstanceUID": "0020000E", "SOPInstanceUID": "00080018",
        "SeriesDescription": "0008103E", "Modality": "00080060"}


def values(keyword, path):
    with open(path, "rb") as file:
        text = file.read()  # an empty response means no matches
    found = {str(value) for item in json.loads(text or "[]") for value in item.get(TAGS[keyword], {}).get("Value", [])}
    print("".join(f"{value}\n" for value in sorted(found)), end="")


def split(path, folder):
    """Splits a response. Parts start with headers and are separated by boundary lines; the first line is the
    boundary."""
    with open(path, "rb") as file:
        content = file.read()
    boundary = b"\r\n" + content.lstrip(b"\r\n").split(b"\r\n", 1)[0]
    parts = (b"\r\n" + content.lstrip(b"\r\n")).split(boundary)
    if parts[-1].strip() != b"--":
        sys.exit("the response ends before its last boundary")
    for number, part in enumerate(parts[1:-1]):
        with open(f"{folder}/{number:06d}.dcm", "wb") as file:
            file.write(part.split(b"\r\n\r\n", 1)[1])


def join(boundary, path):
    with open(path, "rb") as file:
        content = file.read()
    head = f"--{boundary}\r\nContent-Type: application/dicom\r\n\r\n".encode()
    sys.stdout.buffer.write(head + content + f"\r\n--{boundary}--\r\n".encode())


if __name__ == "__main__":
    {"values": values, "split": split, "join": join}[sys.argv[1]](*sys.argv[2:])
