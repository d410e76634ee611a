#!/usr/bin/env python3
"""Compares runs of VirtualColonoscopy with Modules/Colon/ColonExamination/format/files.json: each file and each of its arrays,
columns and entries (two levels) must be declared, and each declared one without ? must be in the file.

usage: check_contents.py RUN...     prints "path: problem" for each difference and exits with 1 if there is any
"""

from __future__ import annotations

import csv
import fnmatch
import json
import pathlib
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator

DECLARATION = pathlib.Path(__file__).resolve().parents[3] / "Modules/Colon/ColonExamination/format/files.json"
OTHER_FILES = (".*", "run.json", "*.run.json", "report")
OTHER_FOLDERS = {"": ("stages", "second"), "viewer": ("data",)}  # by stage
ARRAYS = {"PointData": "point array ", "CellData": "cell array ", "FieldData": "field array "}
PROVENANCE = ("SPACE", "Shapeton.*", "tool", "version", "input.*", "option.*")
Objects = Iterator[tuple[str, list[str]]]  # of a file: the prefix of the names in an object, and the names


def matches(name: str, patterns: tuple[str, ...]) -> bool:
    return any(fnmatch.fnmatchcase(name, pattern) for pattern in patterns)


def arrays(path: pathlib.Path) -> Objects:
    head = path.read_bytes().partition(b"<AppendedData")[0]
    root = ElementTree.fromstring(head + b"</VTKFile>")
    for section, kind in ARRAYS.items():
        names = [array.get("Name", "") for part in root.iter(section) for array in part]
        yield kind, [name for name in names if not matches(name, PROVENANCE)]


def columns(path: pathlib.Path) -> Objects:
    with path.open(encoding="utf-8", newline="") as file:
        yield "", next(csv.reader(file))


def entries(path: pathlib.Path) -> Objects:
    document = json.loads(path.read_text("utf-8"))
    yield "", list(document)
    for name, value in document.items():
        prefix, elements = (f"{name}[].", value) if isinstance(value, list) else (f"{name}.", [value])
        for element in elements:
            if isinstance(element, dict) and name != "provenance":  # whose names depend on the options
                yield prefix, list(element)


READERS = {"surface": arrays, "curves": arrays, "table": columns, "document": entries}


def kind_of_array(sentence: str) -> str:
    first = sentence.partition(": ")[0]
    return f"{first.lower()} " if first in ("Cell array", "Field array") else "point array "


def declared_names(file: dict, files: dict[str, dict]) -> dict[str, bool]:
    """The names in a file, those of arrays after their kind, and whether they are always there."""
    names = declared_names(files[file["sameAs"]], files) if "sameAs" in file else {}
    for group, sentence in file.get("contents", {}).items():
        kind = kind_of_array(sentence) if READERS[file["kind"]] is arrays else ""
        names.update({kind + name.rstrip("?"): not name.endswith("?") for name in group.split(", ")})
    return names


def problems_of_file(path: pathlib.Path, file: dict, files: dict[str, dict]) -> list[str]:
    declared = declared_names(file, files)
    problems = []
    for prefix, names in READERS[file["kind"]](path):
        found = [prefix + name for name in names]
        here = [name for name in declared if name.startswith(prefix) and "." not in name[len(prefix) :]]
        problems += [f"{path}: {name} is not declared" for name in found if name not in declared]
        problems += [f"{path}: {name} is missing" for name in here if declared[name] and name not in found]
    return list(dict.fromkeys(problems))  # the elements of a list may have the same problem


def problems_of_run(run: pathlib.Path, declaration: dict) -> list[str]:
    stages = {stage["name"]: stage["files"] for stage in declaration["stages"]}
    files = {file["id"]: file for list_of_stage in stages.values() for file in list_of_stage}
    problems, checked = [], 0
    for stage, list_of_stage in stages.items():
        others = OTHER_FILES + OTHER_FOLDERS.get(stage, ()) + (tuple(stages) if stage == "" else ())
        for path in sorted((run / stage).glob("*")):
            file = next((file for file in list_of_stage if file["name"] == path.name), None)
            if file and file["kind"] in READERS and file["id"] != "fhirBundle":  # which its standard describes
                problems += problems_of_file(path, file, files)
                checked += 1
            elif not file and not matches(path.name, others):
                problems.append(f"{path}: it is not declared")
    return problems if checked else [f"{run}: it is not a run of VirtualColonoscopy"]


def main() -> None:
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    declaration = json.loads(DECLARATION.read_text("utf-8"))
    folders = [pathlib.Path(name) for name in sys.argv[1:]]
    folders += [run / "second" for run in folders if (run / "second").is_dir()]
    problems = [problem for folder in folders for problem in problems_of_run(folder, declaration)]
    print(*problems, sep="\n", end="\n" if problems else "")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
