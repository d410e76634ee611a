"""Atomically written files, documents that may be absent, and the files of an examination."""

import json
import os
import pathlib

_FORMAT = pathlib.Path(__file__).resolve().parents[2] / "Modules/Colon/ColonExamination/format/files.json"
_FILES = {
    file["id"]: os.path.join(stage["name"], file["name"])
    for stage in json.loads(_FORMAT.read_text("utf-8"))["stages"]
    for file in stage["files"]
}


def file_of(exam, name):
    """Returns the path of a file of an examination, by its id in the declaration of the format."""
    return os.path.join(exam, _FILES[name])


def write_whole(path, text):
    """Writes a file atomically: a reader sees the old or the new one, even if the writer is killed."""
    temporary = f"{path}.{os.getpid()}.part"
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(temporary, path)


def read_json(path):
    """Reads a document; returns an empty one if the file is absent."""
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except FileNotFoundError:
        return {}
