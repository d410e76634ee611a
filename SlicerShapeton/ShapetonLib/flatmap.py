"""The flat wall of a colon: mapping between pixels and points in the patient."""

import gzip

import numpy
import vtk
from vtk.util import numpy_support


def readCoordinates(path):
    """Reads coordinates.nrrd of ColonFlattening as an array of rows, columns and 3 components: LPS in mm, NaN outside the
    wall. Slicer's readers expect volumes in space; this image is in the plane of the map."""
    with open(path, "rb") as file:
        header, data = file.read().split(b"\n\n", 1)
    lines = header.decode("utf-8").splitlines()
    fields = dict(line.split(": ", 1) for line in lines if ": " in line and not line.startswith("#"))
    if (fields["type"], fields["dimension"], fields.get("endian", "little")) != ("float", "3", "little"):
        raise ValueError(f"{path} is not a coordinate map")
    components, columns, rows = (int(size) for size in fields["sizes"].split())
    if fields["encoding"] == "gzip":
        data = gzip.decompress(data)
    return numpy.frombuffer(data, "<f4", components * columns * rows).reshape(rows, columns, components)


class FlatMap:
    """Points are RAS in mm, as in Slicer's scene; pixels are (column, row), the first row on top."""

    def __init__(self, path):
        self.places = readCoordinates(path).astype(float) * (-1.0, -1.0, 1.0)
        self.isWall = numpy.isfinite(self.places).all(axis=2)
        self._pixels = numpy.argwhere(self.isWall)  # (row, column)
        self._points = vtk.vtkPolyData()  # the locator does not own it
        points = vtk.vtkPoints()
        points.SetData(numpy_support.numpy_to_vtk(self.places[self.isWall], deep=True))
        self._points.SetPoints(points)
        self._locator = vtk.vtkStaticPointLocator()
        self._locator.SetDataSet(self._points)
        self._locator.BuildLocator()

    @property
    def size(self):
        """(columns, rows)"""
        return self.places.shape[1], self.places.shape[0]

    def placeOf(self, column, row):
        """Returns the point of a pixel; None outside the wall."""
        columns, rows = self.size
        if not (0 <= column < columns and 0 <= row < rows) or not self.isWall[row, column]:
            return None
        return tuple(self.places[row, column])

    def pixelOf(self, place, within):
        """Returns the wall pixel nearest to a point; None beyond the limit (mm)."""
        distance = vtk.reference(0.0)
        index = self._locator.FindClosestPointWithinRadius(within, place, distance)
        if index < 0:
            return None
        row, column = self._pixels[index]
        return int(column), int(row)

    def writePicture(self, path):
        """Returns the relief of the wall (PNG), lit from the left of the map; white outside the wall."""
        along = numpy.gradient(self.places, axis=1)
        around = numpy.gradient(self.places, axis=0)
        normal = numpy.cross(along, around)
        axis = numpy.nan_to_num(along).sum(axis=0, keepdims=True)  # light direction
        cosine = (normal * axis).sum(axis=2) / (
            numpy.linalg.norm(normal, axis=2) * numpy.linalg.norm(axis, axis=2) + 1e-12
        )
        shade = numpy.where(numpy.isfinite(cosine), 140 + 110 * cosine, 255).clip(0, 255).astype(numpy.uint8)
        image = vtk.vtkImageData()
        image.SetDimensions(self.size[0], self.size[1], 1)
        flipped = numpy.ascontiguousarray(shade[::-1]).ravel()  # VTK's first row is the lowest
        image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(flipped, deep=True))
        writer = vtk.vtkPNGWriter()
        writer.SetFileName(path)
        writer.SetInputData(image)
        writer.Write()
