"""Atomically written files, and documents that may be absent."""

import json
import os


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
