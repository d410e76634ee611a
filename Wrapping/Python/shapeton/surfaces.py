"""Triangle surfaces: files, inspection, repair, simplification, spectrum, heat diffusion metric."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

from numpy.typing import NDArray

from . import _shapeton
from ._arguments import Lines, Path, Progress, Values
from ._calls import public
from ._shapeton import HeatDiffusionMetric, SurfaceSpectrum
from .mesh import Curves, Mesh

__all__ = [
    "Curves",
    "HeatDiffusionMetric",
    "Mesh",
    "SurfaceSpectrum",
    "diffuse_over_surface",
    "edge_lengths",
    "enclosed_volume",
    "heat_diffusion_metric",
    "inspect_surface",
    "read_curves",
    "read_surface",
    "remesh_surface",
    "repair_surface",
    "simplify_surface",
    "spectrum",
    "surface_area",
    "surface_edges",
    "write_curves",
    "write_surface",
]


@public
def read_surface(
    path: Path, *, part: str = "", component: int = 0, unit: str = "file", any_extent: bool = False, repair: bool = False
) -> Mesh:
    """Reads VTP, STL, OBJ, PLY, OFF, glTF or GLB; LPS, mm.

    part: name of a part of the file; "" for all.
    component: from 1, by number of faces; 0: the only one; -1: all.
    unit: "file", the unit of the format, or "m", "mm" or "um", which accept any extent.
    any_extent: accepts a surface that is not between 5 mm and 5 m wide, with a note.
    repair: repairs as `repair_surface` does.

    Repairs and doubts are in the `notes` of the mesh.
    """
    return _shapeton.read_surface(path, part, component, unit, any_extent, repair)


@public
def write_surface(mesh: Mesh, path: Path) -> None:
    """Writes VTP (all arrays and facts), STL, PLY or OBJ by extension; equal surfaces give byte-identical files."""
    _shapeton.write_surface(mesh, path)


@public
def read_curves(path: Path) -> Curves:
    """Reads the lines and points of a VTP file, such as a centerline."""
    return _shapeton.read_curves(path)


@public
def write_curves(curves: Lines, path: Path) -> None:
    """Writes curves as VTP with their arrays and facts; equal curves give byte-identical files."""
    _shapeton.write_curves(curves, path)


@public
def inspect_surface(mesh: Mesh) -> Dict[str, Any]:
    """Topology, measures and defects of a surface, as a dictionary with the keys of SurfaceInspector.

    vertices, edges, faces, eulerCharacteristic, genus (None: not defined), manifold, closed, oriented, area (mm^2), volume
    (mm^3; None if open), extent, components, boundaryLoops, edgeLength, smallestAngle (degrees), defects, ...
    """
    return _shapeton.inspect_surface(mesh)


@public
def repair_surface(
    mesh: Mesh, *, merge_distance: float = 0.0, merge_vertices: bool = True, orient: bool = True, split: bool = True
) -> Tuple[Mesh, List[str]]:
    """A manifold, consistently oriented surface of the same faces: (mesh, repairs in words).

    merge_distance: largest distance of merged vertices, mm; 0: coincident.
    merge_vertices: merges vertices.
    orient: flips faces so that neighbors agree.
    split: cuts the surface where it is not manifold.
    """
    return _shapeton.repair_surface(mesh, merge_distance, merge_vertices, orient, split)


@public
def simplify_surface(
    mesh: Mesh,
    faces: int,
    *,
    smallest_angle: float = 20.0,
    boundary_weight: float = 10.0,
    progress: Optional[Progress] = None,
) -> Mesh:
    """A surface with at most this number of faces and the same topology, by edge collapses. Arrays are dropped.

    smallest_angle: degrees, 0 to 30; no angle becomes smaller.
    boundary_weight: of boundary edges against faces.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.simplify_surface(mesh, faces, smallest_angle, boundary_weight, progress)


@public
def remesh_surface(mesh: Mesh, edge_length: float, *, iterations: int = 8, progress: Optional[Progress] = None) -> Mesh:
    """A surface of nearly equilateral triangles with this edge length (mm). Its arrays are dropped.

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.remesh_surface(mesh, edge_length, iterations, progress)


@public
def surface_area(mesh: Mesh) -> float:
    """mm^2."""
    return _shapeton.surface_area(mesh)


@public
def enclosed_volume(mesh: Mesh) -> float:
    """mm^3, of a closed oriented surface; negative if its faces are oriented inwards."""
    return _shapeton.enclosed_volume(mesh)


@public
def surface_edges(mesh: Mesh) -> NDArray[Any]:
    """The edges of a surface, e x 2, int32: the smaller vertex first, sorted."""
    return _shapeton.surface_edges(mesh)


@public
def edge_lengths(mesh: Mesh) -> NDArray[Any]:
    """Euclidean edge lengths in the order of `surface_edges`, e values; mm."""
    return _shapeton.edge_lengths(mesh)


@public
def spectrum(mesh: Mesh, eigenpairs: int = 50, *, progress: Optional[Progress] = None) -> SurfaceSpectrum:
    """The smallest eigenpairs of the Laplacian of a surface with one manifold component.

    eigenpairs: their number.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.spectrum(mesh, eigenpairs, progress)


@public
def heat_diffusion_metric(
    mesh: Mesh,
    time: Optional[float] = None,
    *,
    eigenpairs: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> HeatDiffusionMetric:
    """The heat diffusion distances along all edges, as new edge lengths.

    mesh: one manifold component.
    time: diffusion time, mm^2; None: 8 times the squared mean edge length at 55,000 faces.
    eigenpairs: uses only this number of eigenpairs, as published; None: exact distances, without eigenpairs.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.heat_diffusion_metric(mesh, time, eigenpairs, progress)


@public
def diffuse_over_surface(
    mesh: Mesh, values: Values, time: float, *, progress: Optional[Progress] = None
) -> NDArray[Any]:
    """Smooths values over a surface by heat flow; a new array of the shape of `values`.

    values: n, or n x k in columns.
    time: diffusion time, mm^2, from 0.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.

    Two implicit time steps: the component of eigenvalue x is multiplied by (1 + x time / 2)^-2, where the exact factor
    is exp(-x time). For the exact one use `spectrum`.
    """
    return _shapeton.diffuse_over_surface(mesh, values, time, progress)
