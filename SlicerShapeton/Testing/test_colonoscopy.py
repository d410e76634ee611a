import csv
import json
import os
import shutil
import tempfile
import time
import unittest
import xml.etree.ElementTree

import numpy
import vtk
from case import Case, finish, slicer, tool, tools
from ShapetonColonoscopy import ShapetonColonoscopyWidget
from vtk.util import numpy_support

from ShapetonLib.colonoscopy import ColonoscopyLogic


def polyData(path):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


class ColonoscopyTest(Case):
    """One run of a synthetic patient, canceled and resumed."""

    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.work)
        volume = os.path.join(cls.work, "patient.nrrd")
        tool("DicomSeriesToImage", os.environ["SHAPETON_PATIENT"], volume)
        slicer.util._settings["Shapeton/ToolsFolder"] = tools
        cls.logic = ColonoscopyLogic()
        cls.examination = os.path.join(cls.work, "examination")
        node = slicer.Node("vtkMRMLScalarVolumeNode", volume)
        cls.secondsToCancel = cls.canceled(node)
        cls.stages = []
        run = cls.logic.start(node, cls.examination, "supine", lambda share, stage: cls.stages.append((share, stage)))
        finish(run)
        run.requireSuccess()
        cls.results = cls.logic.load(cls.examination)

    @classmethod
    def canceled(cls, node):
        run = cls.logic.start(node, cls.examination, "supine")
        while "flattening" not in run.stage:
            assert not run.poll(), run.requireSuccess()
            time.sleep(0.02)
        begin = time.monotonic()
        run.cancel()
        finish(run)
        return time.monotonic() - begin

    def testCancelEndsTheRunAndTheNextGoesOn(self):
        self.assertLess(self.secondsToCancel, 5.0)
        self.assertFalse([stage for share, stage in self.stages if stage.startswith("segmentation: ")])
        self.assertTrue([stage for share, stage in self.stages if stage.startswith("flattening: ")])
        shares = [share for share, stage in self.stages]
        self.assertEqual(shares, sorted(shares))

    def testEachResultIsANode(self):
        results = self.results
        self.assertEqual(results.volume._kind, "vtkMRMLScalarVolumeNode")
        self.assertEqual(results.lumen._kind, "vtkMRMLLabelMapVolumeNode")
        self.assertIn("vtkMRMLColorTableNode", results.lumen._properties["colorNodeID"])
        kinds = [node._kind for node in results.landmarks]
        self.assertIn("vtkMRMLMarkupsFiducialNode", kinds)  # flexures
        self.assertIn("vtkMRMLMarkupsClosedCurveNode", kinds)  # their loops
        self.assertEqual(kinds.count("vtkMRMLMarkupsCurveNode"), 3)  # taeniae

    def testTheWallIsColoredBySegments(self):
        surface = polyData(self.results.wall._file)
        space = surface.GetFieldData().GetAbstractArray("SPACE")
        self.assertIn("LPS", space.GetValue(0))  # read by Slicer
        segments = numpy_support.vtk_to_numpy(surface.GetCellData().GetArray("segment"))
        asked = self.results.wall.GetDisplayNode()._asked
        self.assertEqual(asked["SetActiveScalar"], ("segment", vtk.vtkAssignAttribute.CELL_DATA))
        self.assertEqual(asked["SetScalarVisibility"], (True,))
        with open(os.path.join(self.examination, "colon/slicer/segments.ctbl")) as table:
            labels = {int(line.split()[0]) for line in table if not line.startswith("#")}
        self.assertLessEqual(set(segments), labels)
        self.assertGreaterEqual(len(set(segments)), 4)

    def testMarkupsSayLPSAndHaveColors(self):
        for node in [self.results.centerline, self.results.candidates] + self.results.landmarks:
            with open(node._file) as file:
                for markup in json.load(file)["markups"]:
                    self.assertEqual(markup["coordinateSystem"], "LPS")
                    self.assertEqual(len(markup["display"]["color"]), 3)

    def testTheMapIsTheWall(self):
        """Vertices of the wall are at the map pixel of their (u, v)."""
        flatMap = self.results.flatMap
        surface = polyData(self.results.wall._file)
        points = numpy_support.vtk_to_numpy(surface.GetPoints().GetData()) * (-1, -1, 1)
        uv = numpy_support.vtk_to_numpy(surface.GetPointData().GetArray("uv"))
        circumference = surface.GetFieldData().GetArray("circumference").GetValue(0)
        columns, rows = flatMap.size
        pixel = circumference / rows
        distances = []
        for point, (u, v) in zip(points[::97], uv[::97]):
            place = flatMap.placeOf(int(u / pixel), int((circumference - v % circumference) / pixel))
            if place:
                distances.append(numpy.linalg.norm(point - place))
        self.assertGreater(len(distances), 100)
        self.assertLess(numpy.median(distances), 2.0)

    def testAClickOnACandidateGoesToIt(self):
        flatMap = self.results.flatMap
        with open(self.results.candidateTable._file, newline="") as table:
            candidate = next(csv.DictReader(table))
        place = (-float(candidate["x"]), -float(candidate["y"]), float(candidate["z"]))
        column, row = flatMap.pixelOf(place, self.logic.reach)
        self.assertTrue(self.logic.jumpTo(flatMap, column, row))
        there = slicer.modules.markups.logic()._place
        self.assertLess(numpy.linalg.norm(numpy.subtract(there, place)), 3.0)
        self.assertEqual(slicer.mrmlScene.GetFirstNodeByClass("vtkMRMLCrosshairNode")._crosshair, there)
        self.assertFalse(self.logic.jumpTo(flatMap, -1, 0))

    def testTheCursorIsMarkedOnTheMap(self):
        flatMap = self.results.flatMap
        crosshair = slicer.mrmlScene.GetFirstNodeByClass("vtkMRMLCrosshairNode")
        columns, rows = flatMap.size
        for column, row in ((columns // 3, rows // 2), (columns // 2, 3), (2 * columns // 3, rows - 2)):
            crosshair._cursor = flatMap.placeOf(column, row)
            there = flatMap.placeOf(*self.logic.pixelOfCursor(flatMap))
            self.assertLess(numpy.linalg.norm(numpy.subtract(there, crosshair._cursor)), 1e-3)
        crosshair._cursor = (1000.0, 0.0, 0.0)
        self.assertIsNone(self.logic.pixelOfCursor(flatMap))
        crosshair._cursor = None
        self.assertIsNone(self.logic.pixelOfCursor(flatMap))

    def testThePictureHasAPixelForEachOfTheMap(self):
        path = os.path.join(self.folder, "map.png")
        self.results.flatMap.writePicture(path)
        reader = vtk.vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions()[:2], self.results.flatMap.size)
        shades = numpy_support.vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
        self.assertGreater(shades.std(), 20.0)  # folds are visible

    def testTheWidgetShowsTheMapAndFollows(self):
        """Runs the widget code on dummy widgets."""
        widget = ShapetonColonoscopyWidget()
        widget.setup()
        widget.onFinished(self.examination)
        columns, rows = widget.results.flatMap.size
        widget.mapView._clicks._clicked(columns // 2 * widget.mapView.scale, rows // 2 * widget.mapView.scale)
        there = slicer.modules.markups.logic()._place
        self.assertEqual(there, widget.results.flatMap.placeOf(columns // 2, rows // 2))
        slicer.mrmlScene.GetFirstNodeByClass("vtkMRMLCrosshairNode")._observers[-1](None, None)

    def testTheSceneOutputsOfTheToolAreDeclaredAsNodes(self):
        tree = xml.etree.ElementTree.parse(os.path.join(tools, "VirtualColonoscopy.xml"))
        outputs = [element for element in tree.iter() if element.findtext("channel") == "output"]
        kinds = {element.findtext("name"): element.tag for element in outputs}
        self.assertEqual(kinds["wallModel"], "geometry")
        self.assertEqual(kinds["candidateTable"], "table")
        self.assertEqual(kinds["centerlineCurve"], "pointfile")
        self.assertEqual(kinds["cleansedVolume"], "image")


if __name__ == "__main__":
    unittest.main()
