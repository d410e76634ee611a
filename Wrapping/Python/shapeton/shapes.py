"""Labels from seeds, and signatures for shape retrieval."""

from .heat import SeededHeat
from ._shapeton import (
    NamedShape,
    SeededLabels,
    ShapeNeighbor,
    ShapeRow,
    ShapeSearchResult,
    ShapeSignature,
    ShapeTable,
    describe_shapes,
    find_shape,
    read_shape_database,
    read_shape_table,
    seeds_of_classes,
    signature_distance,
    write_shape_table,
)

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
