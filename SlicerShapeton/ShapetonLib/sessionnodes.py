"""The nodes that show a live session: density, heat, labels of objects with their colors, and the table of objects."""

import numpy
import slicer
import vtk


def ijkToRAS(grid):
    """The matrix of a grid of the session (LPS, mm)."""
    toRAS = numpy.array((-1.0, -1.0, 1.0))
    matrix = numpy.eye(4)
    matrix[:3, :3] = (numpy.array(grid["axes"]) * numpy.array(grid["spacing"])[:, None]).T * toRAS[:, None]
    matrix[:3, 3] = numpy.array(grid["origin"]) * toRAS
    return matrix


def lpsOf(ras):
    """The same point in LPS, and the reverse."""
    return [-ras[0], -ras[1], ras[2]]


class SessionNodes:
    """Nodes are made once and then updated; one that was removed from the scene is made again."""

    columns = ("object", "parent", "heat", "voxels", "volume_mm3", "probability", "R", "A", "S")

    def __init__(self):
        self._nodes = {}
        self._shownLayer = None

    def find(self, name):
        """The node of this name; None before it is made."""
        node = self._nodes.get(name)
        return node if node is not None and slicer.mrmlScene.IsNodePresent(node) else None

    def showValues(self, name, grid, values):
        """name: Density or Heat; values: [z, y, x]."""
        node = self._volume("vtkMRMLScalarVolumeNode", name, grid, values)
        if self._shownLayer != name:
            isFirst, self._shownLayer = self._shownLayer is None, name
            slicer.util.setSliceViewerLayers(foreground=node, foregroundOpacity=0.5, fit=isFirst)

    def showObjects(self, grid, labels, objects):
        isNew = self.find("Objects") is None
        node = self._volume("vtkMRMLLabelMapVolumeNode", "Objects", grid, labels)
        self.showSelected(objects, 0)
        node.GetDisplayNode().SetAndObserveColorNodeID(self.find("Object colors").GetID())
        listed = [entry for entry in objects if not entry["isOffer"]]
        rows = [
            (entry["number"], entry["parent"], entry["heat"], entry["voxels"], entry["volume"], entry["probability"],
             *lpsOf(entry["center"]))
            for entry in listed
        ]
        values = numpy.array(rows, float).reshape(-1, len(self.columns))
        arrays = [values[:, column].astype(int if column < 2 else float) for column in range(len(self.columns))]
        slicer.util.updateTableFromArray(self._node("vtkMRMLTableNode", "Object table"), arrays, list(self.columns))
        if isNew:
            slicer.util.setSliceViewerLayers(label=node, labelOpacity=0.5)

    def showSelected(self, objects, selected):
        """Colors the selected object with those in it; all without offers if none is selected."""
        colors = self._node("vtkMRMLColorTableNode", "Object colors")
        colors.SetTypeToUser()
        colors.SetNumberOfColors(len(objects) + 1)
        if not hasattr(colors, "SetColorDefined"):  # before Slicer 5.10, names follow the colors otherwise
            colors.NamesInitialisedOn()
        colors.SetColor(0, "none", 0.0, 0.0, 0.0, 0.0)
        for entry in objects:
            isShown = self._isIn(entry, selected, objects) if selected else not entry["isOffer"]
            color = self._color(objects[(selected or entry["number"]) - 1]) + (float(isShown),)
            name = f"object {entry['number']}, {entry['volume']:.0f} mm3, {100 * entry['probability']:.0f} %"
            colors.SetColor(entry["number"], name, *color)

    def forgetObjects(self):
        """Empties labels and table, because the session has a new heat."""
        labels = self.find("Objects")
        if labels is not None:
            slicer.util.updateVolumeFromArray(labels, numpy.zeros_like(slicer.util.arrayFromVolume(labels)))
            empty = [numpy.array([], float)] * len(self.columns)
            slicer.util.updateTableFromArray(self._node("vtkMRMLTableNode", "Object table"), empty, list(self.columns))

    def _volume(self, kind, name, grid, values):
        node = self._node(kind, name)
        matrix = vtk.vtkMatrix4x4()
        matrix.DeepCopy(ijkToRAS(grid).ravel())
        node.SetIJKToRASMatrix(matrix)
        slicer.util.updateVolumeFromArray(node, values)
        if node.GetDisplayNode() is None:
            node.CreateDefaultDisplayNodes()
        return node

    def _node(self, kind, name):
        node = self.find(name)
        if node is None:
            node = self._nodes[name] = slicer.mrmlScene.AddNewNodeByClass(kind, f"Shapeton {name.lower()}")
        return node

    @staticmethod
    def _isIn(entry, outer, objects):
        number = entry["number"]
        while number and number != outer:
            number = objects[number - 1]["parent"]
        return number == outer

    @staticmethod
    def _color(entry):
        return tuple(channel / 255 for channel in bytes.fromhex(entry["color"][1:]))
