"""Conformal maps of surfaces to the plane."""

from ._shapeton import ColonFlattening, ConformalMap, SurfaceHandle, conformal_map, flatten_tube

__all__ = ["ColonFlattening", "ConformalMap", "SurfaceHandle", "conformal_map", "flatten_tube"]
