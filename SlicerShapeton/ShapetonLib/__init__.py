"""Shared code of the modules of SlicerShapeton. The logic is separate from the widgets and requires no window."""
