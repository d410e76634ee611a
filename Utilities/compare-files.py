#!/usr/bin/env python3
"""Compares the files of two folders by their decoded contents.

usage: compare-files.py OLD NEW [--names MAP]

Images, surfaces, pictures and compressed files are decoded; other files are compared byte by byte. MAP is a text file with an old and a new
word in each line, separated by a blank: the old word is replaced in the names and all text of the old files (also in the
headers of binary files). Lists files that differ or exist in only one folder, and the number of files; status 0 if there are none,
3 otherwise. Run records, logs and files of CTest are not compared, because they differ between equal runs."""

import argparse
import base64
import re
import sys
import zlib
from pathlib import Path

HASH = re.compile(rb"sha256:[0-9a-f]{64}")
IGNORED = re.compile(r"(^|/)(run\.json|[^/]*\.run\.json|[^/]*\.log|[^/]*\.tmp|CTest[^/]*)$")


def read_names(path):
    """Returns functions that replace old words by new ones, longest matches first, and hashes by a blank one."""
    if path is None:
        return (lambda text: text), (lambda text: text)
    pairs = [line.split() for line in path.read_text(encoding="utf-8").splitlines() if line.strip()]
    names = {old.encode(): new.encode() for old, new in pairs}
    pattern = re.compile(b"|".join(re.escape(old) for old in sorted(names, key=len, reverse=True)))
    blank = lambda text: HASH.sub(b"sha256:", text)
    return lambda text: pattern.sub(lambda match: names[match[0]], blank(text)), blank


def decode_nrrd(data, rename):
    header, _, voxels = data.partition(b"\n\n")
    if b"encoding: gz" in header:
        voxels = zlib.decompress(voxels, 47)
    return rename(header) + b"\n\n" + voxels


def decode_png(data, rename):
    """Returns the chunks, with inflated pixels."""
    chunks, at, pixels = [], 8, b""
    while at + 8 <= len(data):
        length, kind = int.from_bytes(data[at : at + 4], "big"), data[at + 4 : at + 8]
        body = data[at + 8 : at + 8 + length]
        if kind == b"IDAT":
            pixels += body
        else:
            chunks.append(kind + rename(body) if kind in (b"tEXt", b"iTXt") else kind + body)
        at += 12 + length
    return b"".join(chunks) + zlib.decompress(pixels)


def decode_xml(data, rename):
    """Decodes the base64 blocks of a VTK file or a page, and inflates compressed ones."""

    def block(match):
        decoded = base64.b64decode(match[0] + b"=" * (-len(match[0]) % 4))
        for start in (0, *range(16, min(len(decoded), 4096), 4)):  # VTK writes the block sizes first
            if decoded[start : start + 1] == b"\x78":
                try:
                    return decoded[:start] + zlib.decompress(decoded[start:])
                except zlib.error:
                    continue
        return decoded

    pieces, end = [], 0
    for match in re.finditer(rb"[A-Za-z0-9+/]{64,}={0,2}", data):
        pieces += [rename(data[end : match.start()]), block(match)]
        end = match.end()
    return b"".join(pieces) + rename(data[end:])


def decode(path, rename):
    data = path.read_bytes()
    if path.suffix in (".vtp", ".vti", ".html"):
        return decode_xml(rename(data), rename)
    if path.suffix == ".nrrd":
        return decode_nrrd(data, rename)
    if path.suffix == ".png":
        return decode_png(data, rename)
    if path.suffix == ".gz":
        return zlib.decompress(data, 47)
    return rename(data) if b"\0" not in data else data


def files(folder, rename=lambda text: text):
    names = {path.relative_to(folder).as_posix(): path for path in sorted(folder.rglob("*")) if path.is_file()}
    return {rename(name.encode()).decode(): path for name, path in names.items() if not IGNORED.search(name)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("--names", type=Path, help="file with old and new words")
    arguments = parser.parse_args()
    rename, blank = read_names(arguments.names)
    old, new = files(arguments.old, rename), files(arguments.new)
    differences = [f"only new: {name}" for name in sorted(new.keys() - old.keys())]
    differences += [f"only old: {name}" for name in sorted(old.keys() - new.keys())]
    differences += [f"differs:  {name}" for name in sorted(old.keys() & new.keys())
                    if old[name].read_bytes() != new[name].read_bytes() and decode(old[name], rename) != decode(new[name], blank)]
    print("\n".join([*differences, f"{len(new)} files, {len(differences)} differences"]))
    sys.exit(3 if differences else 0)


if __name__ == "__main__":
    main()
