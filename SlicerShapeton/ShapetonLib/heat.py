"""Heat of a volume of the scene, its classes and objects, and transfer functions of histogram lines."""

import csv
import os

import slicer

from ShapetonLib.scene import putInFolder, showSurfaces, showVolume
from ShapetonLib.toolrun import ToolRun, exportVolume

presets = ("automatic", "published")


class Line:
    """Heats from `lower` to `upper`, with a color (#rrggbb) and an opacity."""

    def __init__(self, lower, upper, color, opacity):
        self.lower, self.upper, self.color, self.opacity = lower, upper, color, opacity

    def __str__(self):
        return f"{self.lower:.9f}-{self.upper:.9f}:{self.color}:{self.opacity:g}"


class HeatLogic:
    def start(self, volumeNode, folder, preset=presets[0], intensityWindow=None, timeSteps=None, onProgress=lambda share, stage: None):
        """Runs CumulativeHeatDiffusion; parameters that are None are those of the preset."""
        os.makedirs(folder, exist_ok=True)
        exportVolume(volumeNode, self._path(folder, "input.nrrd"))
        arguments = [self._path(folder, "input.nrrd"), self._path(folder, "heat.nrrd")]
        arguments += ["--histogram", self.histogramPath(folder), "--classTable", self._path(folder, "classes.csv")]
        arguments += ["--labels", self._path(folder, "classes.seg.nrrd"), "--preset", preset]
        arguments += ["--timeSteps", timeSteps] if timeSteps else []
        if intensityWindow:
            arguments += ["--intensityWindow", "{:g},{:g}".format(*intensityWindow)]
        return ToolRun("CumulativeHeatDiffusion", arguments, onProgress)

    def startObjects(self, folder, onProgress=lambda share, stage: None):
        """Runs HeatObjects on the heat."""
        arguments = [self._path(folder, name) for name in ("input.nrrd", "heat.nrrd", "objects.seg.nrrd", "objects.csv")]
        return ToolRun("HeatObjects", arguments, onProgress)

    def load(self, volumeNode, folder):
        """Loads heat, classes and objects into a folder of the scene. The classes are shown in the slices, the objects in the
        3-D view. Returns the heat."""
        heat = slicer.util.loadVolume(self._path(folder, "heat.nrrd"), {"name": "Heat", "show": False})
        classes = self._loadSegmentation(folder, "classes.seg.nrrd", "Classes of heat")
        objects = self._loadSegmentation(folder, "objects.seg.nrrd", "Objects")
        table = slicer.util.loadTable(self._path(folder, "objects.csv"))
        table.SetName("Object table")
        putInFolder(f"Heat of {volumeNode.GetName()}", [heat, classes, objects, table])
        showVolume(volumeNode)
        showSurfaces(objects)
        objects.GetDisplayNode().SetVisibility2D(False)
        classes.GetDisplayNode().SetVisibility3D(False)
        return heat

    def histogramPath(self, folder):
        return self._path(folder, "histogram.png")

    def classLines(self, folder):
        """Returns the histogram classes except the background as selectable lines."""
        with open(self._path(folder, "classes.csv"), newline="") as table:
            rows = [row for row in csv.DictReader(table) if row["label"] != "0"]
        return [Line(float(row["lowerHeat"]), float(row["upperHeat"]), row["color"], 0.5) for row in rows]

    def startTransferFunction(self, folder, lines, onProgress=lambda share, stage: None):
        """Runs HeatTransferFunction for the selected lines."""
        if not lines:
            raise RuntimeError("Pick a line of the histogram first")
        arguments = [self._path(folder, "input.nrrd"), self._path(folder, "heat.nrrd"), self._path(folder, "lines.vp")]
        arguments += ["--lines", ",".join(str(line) for line in lines)]
        return ToolRun("HeatTransferFunction", arguments, onProgress)

    def show(self, heatNode, folder):
        """Renders the heat with the transfer function."""
        logic = slicer.modules.volumerendering.logic()
        display = logic.GetFirstVolumeRenderingDisplayNode(heatNode) or logic.CreateDefaultVolumeRenderingNodes(heatNode)
        volumeProperty = logic.AddVolumePropertyFromFile(self._path(folder, "lines.vp"))
        if volumeProperty is None:
            raise RuntimeError(f"{self._path(folder, 'lines.vp')} cannot be loaded")
        display.SetAndObserveVolumePropertyNodeID(volumeProperty.GetID())
        display.SetVisibility(True)
        return volumeProperty

    def _loadSegmentation(self, folder, file, name):
        node = slicer.util.loadSegmentation(self._path(folder, file))
        node.SetName(name)
        return node

    @staticmethod
    def _path(folder, name):
        return os.path.join(folder, name)
