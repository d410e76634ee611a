# Slicer writes the CMake package of the extension here.
