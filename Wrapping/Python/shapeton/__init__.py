"""Shape-based analysis of medical volumes.

Images are `Image` (an array ``[z, y, x]`` with its position in the patient), surfaces `Mesh`, lines `Curves`; all
points are LPS in mm. This module contains volumes, heat and shapetons; the others are

- `shapeton.surfaces`: files of surfaces, repair, simplification, spectrum, heat diffusion metric
- `shapeton.flattening`: conformal maps of surfaces
- `shapeton.colon`: from CT colonography to lumen, wall, folds, landmarks, candidates and registration
- `shapeton.shapes`: labels from seeds, signatures for shape retrieval
- `shapeton.graphs`: graphs, their embeddings and certificates

Long functions accept ``progress``, a function of the completed share (0 to 1) and the stage name. It is called at
most ten times a second; if it returns False, `Aborted` is raised. Ctrl-C ends them, and functions that read files, if
called from the main thread. The GIL is released. Errors are `ParameterError` and `InputError`, which are ValueErrors,
`OutputError`, an OSError, and `DeviceError`, a RuntimeError; the message contains a remedy. A missing file is
`MissingFileError`, an InputError and a FileNotFoundError.

Where an image is expected, images of nibabel, SimpleITK, itk, VTK and xarray are accepted, see `Image.of`; where a graph
is expected, those of networkx, lists of edges and adjacency matrices, see `graphs.as_graph`.
"""

import sys

from . import _shapeton, colon, flattening, graphs, shapes, surfaces
from ._arguments import MissingFileError
from ._repr import describe_results, show_public_names
from ._shapeton import (
    Aborted,
    DeviceError,
    DicomDefect,
    DicomSeries,
    Error,
    HeatClass,
    HeatHistogram,
    HeatObject,
    HeatObjects,
    HeatResult,
    InputError,
    OutputError,
    ParameterError,
    ShapeComponent,
    ShapetonResult,
)
from ._threads import set_threads, threads
from .examination import Examination
from .heat import (
    classify_heat,
    classify_visits,
    diffuse_heat,
    diffuse_shapetons,
    find_objects,
    heat_histogram,
    recorded_steps,
    visit_density,
)
from .image import Image
from .mesh import Curves, Mesh
from .volumes import list_series, read_volume, write_volume

__version__ = "0.2.0"

__all__ = [
    "Aborted",
    "Curves",
    "DeviceError",
    "DicomDefect",
    "DicomSeries",
    "Error",
    "Examination",
    "HeatClass",
    "HeatHistogram",
    "HeatObject",
    "HeatObjects",
    "HeatResult",
    "Image",
    "InputError",
    "Mesh",
    "MissingFileError",
    "OutputError",
    "ParameterError",
    "ShapeComponent",
    "ShapetonResult",
    "classify_heat",
    "classify_visits",
    "colon",
    "diffuse_heat",
    "diffuse_shapetons",
    "find_objects",
    "flattening",
    "graphs",
    "heat_histogram",
    "list_series",
    "read_volume",
    "recorded_steps",
    "set_threads",
    "shapes",
    "surfaces",
    "threads",
    "visit_density",
    "write_volume",
]

describe_results(_shapeton)
for _module in (colon, flattening, graphs, shapes, surfaces, sys.modules[__name__]):  # the last one names common classes
    show_public_names(_module)
