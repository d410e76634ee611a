"""Files that are whole or absent, and documents that may be absent."""

import json
import os


def write_whole(path, text):
    """A reader sees the old file or the new one, whatever kills the writer."""
    temporary = f"{path}.{os.getpid()}.part"
    with open(temporary, "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(temporary, path)


def read_json(path):
    """The document, or an empty one where the file is absent."""
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except FileNotFoundError:
        return {}
