"""Virtual colonoscopy of a volume of the scene."""

import os

import slicer
import vtk

from ShapetonLib.flatmap import FlatMap
from ShapetonLib.scene import loadMarkupsOf, putInFolder
from ShapetonLib.toolrun import ToolRun, exportVolume

positions = ("auto", "supine", "prone", "leftDecubitus", "rightDecubitus")


class ColonoscopyResults:
    """Results of a run in the scene; `flatMap` is not a node."""

    def __init__(self):
        self.volume = self.lumen = self.wall = self.centerline = self.candidates = self.candidateTable = None
        self.landmarks = []
        self.flatMap = None


class ColonoscopyLogic:
    # Points farther from the wall than this are outside the colon.
    reach = 30.0  # mm

    def start(self, volumeNode, folder, position="auto", onProgress=lambda share, stage: None):
        """Runs VirtualColonoscopy; results of an earlier run on the same volume in the folder are reused."""
        os.makedirs(folder, exist_ok=True)
        volume = os.path.join(folder, "input.nrrd")
        exportVolume(volumeNode, volume)
        arguments = [volume, os.path.join(folder, "colon"), "--position", position]
        return ToolRun("VirtualColonoscopy", arguments, onProgress)

    def load(self, folder):
        """Loads the results of a run in the folder as nodes."""
        colon = os.path.join(folder, "colon")

        def path(name):
            return os.path.join(colon, name)

        results = ColonoscopyResults()
        results.volume = slicer.util.loadVolume(path("segmentation/cleansed.nrrd"), {"name": "Cleansed CT"})
        colors = slicer.util.loadColorTable(path("slicer/lumen.ctbl"))
        results.lumen = slicer.util.loadLabelVolume(
            path("segmentation/lumen.nrrd"), {"name": "Lumen", "colorNodeID": colors.GetID()}
        )
        results.wall = self._loadWall(path("landmarks/segments.vtp"), path("slicer/segments.ctbl"))
        results.centerline = slicer.util.loadMarkups(path("slicer/centerline.mrk.json"))
        for name in ("landmarks/flexures.mrk.json", "landmarks/taeniae.mrk.json"):
            results.landmarks += loadMarkupsOf(path(name))
        results.candidates = slicer.util.loadMarkups(path("polyps/candidates.mrk.json"))
        results.candidateTable = slicer.util.loadTable(path("polyps/candidates.csv"))
        results.flatMap = FlatMap(path("flattening/coordinates.nrrd"))
        nodes = [results.volume, results.lumen, results.wall, results.centerline, results.candidates, results.candidateTable]
        putInFolder("Virtual colonoscopy", nodes + results.landmarks)
        return results

    def jumpTo(self, flatMap, column, row):
        """Shows a point of the map in the slices; returns False outside the wall."""
        place = flatMap.placeOf(column, row)
        if place is None:
            return False
        slicer.modules.markups.logic().JumpSlicesToLocation(*place, True)
        crosshair = slicer.mrmlScene.GetFirstNodeByClass("vtkMRMLCrosshairNode")
        crosshair.SetCrosshairRAS(*place)
        return True

    def pixelOfCursor(self, flatMap):
        """Returns the slice cursor's position on the map; None if it is not near the wall."""
        crosshair = slicer.mrmlScene.GetFirstNodeByClass("vtkMRMLCrosshairNode")
        place = [0.0, 0.0, 0.0]
        if not crosshair.GetCursorPositionRAS(place):
            return None
        return flatMap.pixelOf(place, self.reach)

    def _loadWall(self, path, colorPath):
        wall = slicer.util.loadModel(path)
        wall.SetName("Colon wall")
        display = wall.GetDisplayNode()
        display.SetOpacity(0.5)
        if os.path.isfile(colorPath):  # missing if no segments were found
            colors = slicer.util.loadColorTable(colorPath)
            display.SetActiveScalar("segment", vtk.vtkAssignAttribute.CELL_DATA)
            display.SetAndObserveColorNodeID(colors.GetID())
            display.SetScalarRangeFlag(slicer.vtkMRMLDisplayNode.UseColorNodeScalarRange)
            display.SetScalarVisibility(True)
        return wall
