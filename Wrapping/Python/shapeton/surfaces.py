"""Triangle surfaces: files, inspection, repair, simplification, spectrum, heat diffusion metric."""

from ._shapeton import (
    HeatDiffusionMetric,
    SurfaceSpectrum,
    diffuse_over_surface,
    edge_lengths,
    enclosed_volume,
    heat_diffusion_metric,
    inspect_surface,
    read_curves,
    read_surface,
    remesh_surface,
    repair_surface,
    simplify_surface,
    spectrum,
    surface_area,
    surface_edges,
    write_curves,
    write_surface,
)
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
