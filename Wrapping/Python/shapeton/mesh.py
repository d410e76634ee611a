"""Triangle surfaces and curves as arrays."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ._shapeton import InputError, ParameterError
from .image import for_vtk

Arrays = Mapping[str, Any]


class _Geometry:
    """Base of surfaces and curves: points, arrays on them, facts."""

    __slots__ = ("_vertices", "point_arrays", "cell_arrays", "field_arrays", "facts", "notes")

    def __init__(
        self,
        vertices: Any,
        point_arrays: Optional[Arrays],
        cell_arrays: Optional[Arrays],
        field_arrays: Optional[Arrays],
        facts: Union[Mapping[str, str], Iterable[tuple[str, str]]],
        notes: Iterable[str],
    ) -> None:
        self._vertices = _rows_of_three("vertices", vertices, np.float64)
        self.point_arrays = _data_arrays(point_arrays)
        self.cell_arrays = _data_arrays(cell_arrays)
        self.field_arrays = _data_arrays(field_arrays)
        pairs = facts.items() if isinstance(facts, Mapping) else facts
        self.facts: list[tuple[str, str]] = [(str(n), str(v)) for n, v in pairs]
        self.notes: list[str] = [notes] if isinstance(notes, str) else list(notes)

    @property
    def vertices(self) -> NDArray[Any]:
        """n x 3, float64; LPS, mm."""
        return self._vertices


class Mesh(_Geometry):
    """A triangle surface.

    vertices
        n x 3, float64; LPS, mm.
    faces
        m x 3, int32: indices of vertices, counterclockwise as seen from outside.
    point_arrays, cell_arrays, field_arrays
        By name: one row per vertex, one row per face, data of the whole surface. Integers are kept
        as int32; all other data are float64.
    facts
        Pairs of strings or a dictionary, for example provenance; stored in VTP files.
    notes
        Notes of `read_surface`.
    """

    __slots__ = ("_faces",)

    def __init__(
        self,
        vertices: Any,
        faces: Any,
        point_arrays: Optional[Arrays] = None,
        cell_arrays: Optional[Arrays] = None,
        field_arrays: Optional[Arrays] = None,
        facts: Union[Mapping[str, str], Iterable[tuple[str, str]]] = (),
        notes: Iterable[str] = (),
    ) -> None:
        super().__init__(vertices, point_arrays, cell_arrays, field_arrays, facts, notes)
        self._faces = _rows_of_three("faces", faces, np.int32)

    @property
    def faces(self) -> NDArray[Any]:
        """m x 3, int32."""
        return self._faces

    def __repr__(self) -> str:
        return f"<shapeton.Mesh {len(self.vertices)} vertices, {len(self.faces)} faces>"

    @classmethod
    def from_vtk(cls, poly_data: Any) -> Mesh:
        """From a vtkPolyData of triangles in LPS, mm, with its point, cell and numeric field data."""
        from vtkmodules.util.numpy_support import vtk_to_numpy

        polys = poly_data.GetPolys()
        corners = vtk_to_numpy(polys.GetConnectivityArray())
        sizes = np.diff(vtk_to_numpy(polys.GetOffsetsArray()))
        if np.any(sizes != 3) or poly_data.GetNumberOfCells() != polys.GetNumberOfCells():
            raise InputError("the vtkPolyData contains cells other than triangles; apply vtkTriangleFilter, PassLinesOff")
        if poly_data.GetPoints() is None:
            raise InputError("the vtkPolyData has no points")
        return cls(
            vtk_to_numpy(poly_data.GetPoints().GetData()),
            corners.reshape(-1, 3),
            _arrays_of(poly_data.GetPointData()),
            _arrays_of(poly_data.GetCellData()),
            _arrays_of(poly_data.GetFieldData()),
        )

    def to_vtk(self) -> Any:
        """A vtkPolyData in LPS, mm, with all arrays; points and float arrays are views."""
        from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

        points = vtkPoints()
        points.SetData(numpy_to_vtk(self.vertices))
        if len(self.faces) > 0 and self.faces.max() >= len(self.vertices):
            raise InputError(f"a face refers to vertex {self.faces.max()}, but there are {len(self.vertices)}")
        corners = self.faces.astype(np.int64).ravel()
        cells = vtkCellArray()
        cells.SetData(3, numpy_to_vtkIdTypeArray(corners, deep=True))
        poly_data = vtkPolyData()
        poly_data.SetPoints(points)
        poly_data.SetPolys(cells)
        _add_arrays(self.point_arrays, poly_data.GetPointData())
        _add_arrays(self.cell_arrays, poly_data.GetCellData())
        _add_arrays(self.field_arrays, poly_data.GetFieldData())
        return poly_data

    @classmethod
    def from_pyvista(cls, surface: Any) -> Mesh:
        """From a pyvista.PolyData of triangles, which is a vtkPolyData."""
        return cls.from_vtk(surface)

    def to_pyvista(self) -> Any:
        """A pyvista.PolyData."""
        import pyvista

        return pyvista.wrap(self.to_vtk())


class Curves(_Geometry):
    """Polylines in space, such as a centerline, and single points.

    vertices
        n x 3, float64; LPS, mm.
    curves
        For each curve the indices of its vertices in order, int32; a curve of one vertex is a point. One curve through
        all vertices if omitted.
    point_arrays, cell_arrays, field_arrays
        By name: one row per vertex, one row per curve, data of all curves.
    """

    __slots__ = ("_curves",)

    def __init__(
        self,
        vertices: Any,
        curves: Optional[Sequence[Any]] = None,
        point_arrays: Optional[Arrays] = None,
        cell_arrays: Optional[Arrays] = None,
        field_arrays: Optional[Arrays] = None,
        facts: Union[Mapping[str, str], Iterable[tuple[str, str]]] = (),
        notes: Iterable[str] = (),
    ) -> None:
        super().__init__(vertices, point_arrays, cell_arrays, field_arrays, facts, notes)
        lists = [np.arange(len(self.vertices))] if curves is None else curves
        if any(np.ndim(curve) != 1 for curve in lists):
            raise ParameterError("the parameter \"curves\" must have a sequence of indices for each curve, as [[0, 1, 2]]")
        self._curves = [_whole_numbers("curves", curve) for curve in lists]

    @property
    def curves(self) -> list[NDArray[Any]]:
        """For each curve the indices of its vertices in order."""
        return self._curves

    def points(self, curve: int = 0) -> NDArray[Any]:
        """The points of a curve in order, k x 3; LPS, mm."""
        return np.asarray(self.vertices[self._curves[curve]])

    def __repr__(self) -> str:
        return f"<shapeton.Curves {len(self._curves)} curves, {len(self.vertices)} vertices>"


def refuse_mask(name: str, values: Any) -> None:
    """Raises ParameterError for a masked array, because its hidden values would be used."""
    if np.ma.is_masked(values):
        raise ParameterError(f"the parameter \"{name}\" is masked; fill it or leave the masked values out")


def _data_arrays(arrays: Optional[Arrays]) -> dict[str, NDArray[Any]]:
    for name, values in (arrays or {}).items():
        refuse_mask(name, values)
        if not isinstance(name, str):
            raise ParameterError(f"the name {name!r} of an array is not a str")
    return {name: np.asarray(values) for name, values in (arrays or {}).items()}


def _whole_numbers(name: str, values: Any) -> NDArray[Any]:
    array = np.asarray(values)
    if array.dtype.kind not in "iu" and array.size > 0:
        raise ParameterError(f"the parameter \"{name}\" has the type {array.dtype}; indices must be integers")
    if array.size > 0 and (array.min() < 0 or array.max() > np.iinfo(np.int32).max):
        raise ParameterError(f"the parameter \"{name}\" contains an index below 0 or beyond 2^31 - 1")
    return np.ascontiguousarray(array, dtype=np.int32)


def _rows_of_three(name: str, values: Any, dtype: Any) -> NDArray[Any]:
    refuse_mask(name, values)
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ParameterError(f"the parameter \"{name}\" has the shape {array.shape}; rows of three numbers are required")
    if dtype == np.int32:
        return _whole_numbers(name, array)
    if array.dtype.kind not in "iuf":
        raise ParameterError(f"the parameter \"{name}\" has the type {array.dtype}; points must be real numbers")
    return np.ascontiguousarray(array, dtype=dtype)


def _arrays_of(data: Any) -> dict[str, NDArray[Any]]:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkDataArray

    arrays = [data.GetAbstractArray(i) for i in range(data.GetNumberOfArrays())]
    return {a.GetName() or "": vtk_to_numpy(a) for a in arrays if isinstance(a, vtkDataArray)}


def _add_arrays(arrays: Mapping[str, NDArray[Any]], data: Any) -> None:
    from vtkmodules.util.numpy_support import numpy_to_vtk

    for name, values in arrays.items():
        array = numpy_to_vtk(for_vtk(values))
        array.SetName(name)
        data.AddArray(array)
