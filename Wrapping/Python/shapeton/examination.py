"""The folder of a virtual colonoscopy."""

from __future__ import annotations

import csv
import json
import pathlib
import re
from typing import Any, Dict, List, Optional, Union

import numpy as np

from . import surfaces
from ._arguments import MissingFileError, Path
from ._calls import public
from ._shapeton import InputError
from .image import Image
from .volumes import read_volume

_FORMAT: Dict[str, Any] = json.loads(pathlib.Path(__file__).with_name("examination_files.json").read_text("utf-8"))


def _snake(name: str) -> str:
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


#: Each file with its stage, by name.
_FILES: Dict[str, Dict[str, Any]] = {
    _snake(file["id"]): {**file, "stage": stage["name"], "tool": stage["tool"]}
    for stage in _FORMAT["stages"]
    for file in stage["files"]
}


def _value(text: str) -> Union[None, float, str]:
    """A cell of a table: a number, a text, or None if it is empty."""
    try:
        return float(text) if text else None
    except ValueError:
        return text


def _labels(path: pathlib.Path) -> Image:
    image = read_volume(path)
    return Image(image.array.astype(np.uint16), image.spacing, image.origin, image.direction)


def _table(path: pathlib.Path) -> List[Dict[str, Any]]:
    with open(path, encoding="utf-8", newline="") as file:
        return [{name: _value(cell) for name, cell in row.items()} for row in csv.DictReader(file)]


#: Readers by kind of file; the others are returned as paths.
_READERS: Dict[str, Any] = {
    "volume": read_volume,
    "labels": _labels,
    "surface": lambda path: surfaces.read_surface(path, component=-1),
    "curves": surfaces.read_curves,
    "table": _table,
    "document": lambda path: json.loads(path.read_text("utf-8")),
}


class Examination:
    """The results of VirtualColonoscopy for one position, each read when it is first used.

    The attributes are the names in `files()`: volumes are `Image`, surfaces `Mesh`, lines `Curves`, tables lists of
    dictionaries, documents dictionaries; pictures, pages and DICOM objects are paths. The page
    *Files of an examination* of the API reference describes the contents.

    exam = shapeton.Examination("results")
    exam.lumen.array                            # labels: 1 gas, 2 tagged fluid, 3 terminal ileum
    [one["score"] for one in exam.candidates]
    if exam.second is not None: exam.second.centerline
    """

    @public
    def __init__(self, folder: Path) -> None:
        """Raises MissingFileError for a missing folder, InputError for another version of the format."""
        self.folder = pathlib.Path(folder)
        if not self.folder.is_dir():
            raise MissingFileError(f"the examination \"{folder}\" was not found; give a folder written by VirtualColonoscopy")
        if self.has("format") and self.format.get("version") != _FORMAT["version"]:
            raise InputError(
                f"\"{self.path('format')}\" states the version {self.format.get('version')} of the format, but this package "
                f"reads {_FORMAT['version']}; run VirtualColonoscopy again"
            )

    @public
    def path(self, name: str) -> pathlib.Path:
        """The path of a file, whether it exists or not."""
        if name not in _FILES:
            raise AttributeError(f"an examination has no file \"{name}\"; files() lists those that exist")
        return self.folder / _FILES[name]["stage"] / _FILES[name]["name"]

    @public
    def has(self, name: str) -> bool:
        """Whether a file exists."""
        return self.path(name).is_file()

    @public
    def files(self) -> Dict[str, str]:
        """The names of the existing files, with what they hold."""
        return {name: file["sentence"] for name, file in _FILES.items() if self.has(name)}

    @property
    def second(self) -> Optional[Examination]:
        """The second position; None if there is none."""
        folder = self.folder / "second"
        return Examination(folder) if folder.is_dir() else None

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        path = self.path(name)
        if not path.is_file():
            file = _FILES[name]
            raise MissingFileError(
                f"the examination lacks \"{path}\", written by the stage {file['stage']} ({file['tool']}); let "
                "VirtualColonoscopy finish it"
            )
        value = _READERS.get(_FILES[name]["kind"], pathlib.Path)(path)
        setattr(self, name, value)
        return value

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *self.files()]

    def __repr__(self) -> str:
        return f"<shapeton.Examination {str(self.folder)!r}: {len(self.files())} files>"
