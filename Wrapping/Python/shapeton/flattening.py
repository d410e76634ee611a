"""Conformal maps of surfaces to the plane."""

from __future__ import annotations

from typing import Optional, Sequence

from . import _shapeton
from ._arguments import Lines, Progress, Values
from ._calls import public
from ._shapeton import ColonFlattening, ConformalMap, SurfaceHandle
from .mesh import Mesh

__all__ = ["ColonFlattening", "ConformalMap", "SurfaceHandle", "conformal_map", "flatten_tube"]


@public
def conformal_map(
    mesh: Mesh,
    *,
    domain: str = "slit",
    outer_boundary: int = 0,
    inner_boundary: int = 0,
    corners: Sequence[int] = (),
    edge_lengths: Optional[Values] = None,
    progress: Optional[Progress] = None,
) -> ConformalMap:
    """Maps an open surface conformally to the plane.

    mesh: one manifold, oriented component with a boundary.
    domain: "rectangle", "annulus" or "slit".
    outer_boundary: its number, from 1 by length; 0: the longest.
    inner_boundary: its number, from 1 by length; 0: the longest of the others.
    corners: four vertices of the only boundary of a rectangle.
    edge_lengths: another metric, in the order of `surfaces.surface_edges`.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.conformal_map(mesh, domain, outer_boundary, inner_boundary, corners, edge_lengths, progress)


@public
def flatten_tube(
    mesh: Mesh,
    centerline: Optional[Lines] = None,
    *,
    metric: str = "heatDiffusion",
    time: float = 0.0,
    eigenpairs: int = 50,
    remove_handles: bool = False,
    method: str = "conjugate",
    cut: Optional[Lines] = None,
    progress: Optional[Progress] = None,
) -> ColonFlattening:
    """Maps a tube, such as the wall of a colon, conformally to a rectangle.

    mesh: one manifold, oriented component with two boundary loops.
    centerline: from the rectum to the cecum; locates the rectum if the surface does not name it.
    metric: "heatDiffusion", "euclidean" or "truncatedHeatDiffusion".
    time: diffusion time, mm^2; 0: chosen for the mesh.
    eigenpairs: for truncatedHeatDiffusion.
    remove_handles: finds and cuts handles.
    method: "conjugate" or "published".
    cut: a curve near which the tube is cut; None: computed.
    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.flatten_tube(mesh, centerline, metric, time, eigenpairs, remove_handles, method, cut, progress)
