"""What the modules of SlicerShapeton share. The logic is apart from the widgets and needs no window."""
