"""Labels from seeds, and signatures for shape retrieval."""

from __future__ import annotations

from typing import List, Optional, Sequence

from . import _shapeton
from ._arguments import Path, Progress
from ._calls import constructor, public
from ._shapeton import (
    NamedShape,
    SeededLabels,
    ShapeNeighbor,
    ShapeRow,
    ShapeSearchResult,
    ShapeSignature,
    ShapeTable,
)
from .heat import SeededHeat
from .image import Image

__all__ = [
    "NamedShape",
    "SeededHeat",
    "SeededLabels",
    "ShapeNeighbor",
    "ShapeRow",
    "ShapeSearchResult",
    "ShapeSignature",
    "ShapeTable",
    "describe_shapes",
    "find_shape",
    "read_shape_database",
    "read_shape_table",
    "seeds_of_classes",
    "signature_distance",
    "write_shape_table",
]


@constructor(NamedShape)
def _named_shape(self: NamedShape, name: str, signature: ShapeSignature) -> None:
    """name: any text, not necessarily unique."""


@public
def seeds_of_classes(labels: Image, *, classes: Sequence[int] = (), components: int = 0) -> Image:
    """Seeds from classes, such as those of `classify_heat`, eroded by one voxel.

    labels: the class of each voxel, integers.
    classes: the classes to use; none: all but 0.
    components: 0: one label per class; otherwise one label for each of this number of largest components per class.

    Labels count from 1 in the order of the classes.
    """
    return _shapeton.seeds_of_classes(labels, classes, components)


@public
def describe_shapes(
    image: Image, labels: Image, *, components: bool = False, progress: Optional[Progress] = None
) -> ShapeTable:
    """The signature of each label, or of each connected component of each label.

    image: intensities, used for mean_intensity only.
    labels: integers from 0 (background) to 65535, on the same grid.
    components: describes each connected component of a label.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.

    A shape takes half a second. Shapes of fewer than 64 voxels, or too thin, are skipped with a warning.
    """
    return _shapeton.describe_shapes(image, labels, components, progress)


@public
def write_shape_table(table: ShapeTable, path: Path) -> None:
    """Writes a CSV file as the tool ShapeSignature does."""
    _shapeton.write_shape_table(table, path)


@public
def read_shape_table(path: Path) -> ShapeTable:
    """Reads a table written by `write_shape_table`."""
    return _shapeton.read_shape_table(path)


@public
def read_shape_database(path: Path) -> List[NamedShape]:
    """All shapes of an SQLite file of the tool ShapeSearch, in insertion order."""
    return _shapeton.read_shape_database(path)


@public
def signature_distance(a: ShapeSignature, b: ShapeSignature) -> float:
    """Distance of two signatures, at least 0; copies of one shape are about 1 apart. The volume is ignored."""
    return _shapeton.signature_distance(a, b)


@public
def find_shape(signature: ShapeSignature, entries: Sequence[NamedShape], nearest: int = 5) -> ShapeSearchResult:
    """Searches a signature among named ones.

    nearest: maximum number of neighbors to return.
    """
    return _shapeton.find_shape(signature, entries, nearest)
