"""Cumulative heat diffusion of a volume of the scene, and transfer functions of histogram lines."""

import csv
import os

import slicer

from ShapetonLib.toolrun import ToolRun, exportVolume


class Line:
    """Heats from `lower` to `upper`, with a color (#rrggbb) and an opacity."""

    def __init__(self, lower, upper, color, opacity):
        self.lower, self.upper, self.color, self.opacity = lower, upper, color, opacity

    def __str__(self):
        return f"{self.lower:.9f}-{self.upper:.9f}:{self.color}:{self.opacity:g}"


class HeatLogic:
    def start(self, volumeNode, folder, intensityWindow=None, timeSteps=None, p=None, onProgress=lambda share, stage: None):
        """Runs CumulativeHeatDiffusion; parameters that are None are chosen from the data."""
        os.makedirs(folder, exist_ok=True)
        exportVolume(volumeNode, self._path(folder, "input.nrrd"))
        arguments = [self._path(folder, "input.nrrd"), self._path(folder, "heat.nrrd")]
        arguments += ["--histogram", self.histogramPath(folder), "--classTable", self._path(folder, "classes.csv")]
        arguments += ["--timeSteps", timeSteps or "auto", "--p", p or "auto"]
        if intensityWindow:
            arguments += ["--intensityWindow", "{:g},{:g}".format(*intensityWindow)]
        return ToolRun("CumulativeHeatDiffusion", arguments, onProgress)

    def loadHeat(self, folder):
        return slicer.util.loadVolume(self._path(folder, "heat.nrrd"), {"name": "Heat"})

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

    @staticmethod
    def _path(folder, name):
        return os.path.join(folder, name)
