import unittest

from case import Case, finish, slicer

from ShapetonLib.heat import HeatLogic, Line


class HeatTest(Case):
    def setUp(self):
        Case.setUp(self)
        self.logic = HeatLogic()
        self.volume = slicer.Node("vtkMRMLScalarVolumeNode", self.phantom())
        for run in (lambda: self.logic.start(self.volume, self.folder, timeSteps=20000), lambda: self.logic.startObjects(self.folder)):
            run = run()
            finish(run)
            run.requireSuccess()

    def testThePhantomHasItsClasses(self):
        heat = self.logic.load(self.volume, self.folder)
        self.assertEqual((heat._kind, heat.GetName()), ("vtkMRMLScalarVolumeNode", "Heat"))
        parents = slicer.mrmlScene.GetSubjectHierarchyNode()._parents
        for name in ("Heat", "Classes of heat", "Objects", "Object table"):
            self.assertEqual(parents[name], f"Heat of {self.volume.GetName()}")
        with open(self.logic.histogramPath(self.folder), "rb") as picture:
            self.assertEqual(picture.read(4), b"\x89PNG")
        lines = self.logic.classLines(self.folder)
        self.assertGreaterEqual(len(lines), 2)  # a cube and spheres of two sizes, without the background
        for line in lines:
            self.assertTrue(0.0 <= line.lower < line.upper <= 1.0)
        for line, following in zip(lines, lines[1:]):
            self.assertLessEqual(line.upper, following.lower)

    def testLinesThatArePickedAreRendered(self):
        heat = self.logic.load(self.volume, self.folder)
        lines = self.logic.classLines(self.folder)
        run = self.logic.startTransferFunction(self.folder, lines[-1:])
        finish(run)
        run.requireSuccess()
        volumeProperty = self.logic.show(heat, self.folder)
        display = slicer.modules.volumerendering.logic().GetFirstVolumeRenderingDisplayNode(heat)
        self.assertEqual(display._asked["SetAndObserveVolumePropertyNodeID"], (volumeProperty.GetID(),))
        self.assertEqual(display._asked["SetVisibility"], (True,))
        self.assertOpacity(volumeProperty._file, lines[-1])

    def testAllLinesTogetherDoNotOverlap(self):
        run = self.logic.startTransferFunction(self.folder, self.logic.classLines(self.folder))
        finish(run)
        run.requireSuccess()

    def testNoLineIsAnError(self):
        with self.assertRaisesRegex(RuntimeError, "Pick a line"):
            self.logic.startTransferFunction(self.folder, [])

    def testALineIsWrittenWithoutAnExponent(self):
        self.assertEqual(str(Line(1e-5, 0.25, "#22bfcf", 0.5)), "0.000010000-0.250000000:#22bfcf:0.5")

    def testAVolumeUnderATransformIsRefused(self):
        self.volume.GetParentTransformNode = lambda: object()
        with self.assertRaisesRegex(RuntimeError, "harden the transform"):
            self.logic.start(self.volume, self.folder)

    def assertOpacity(self, path, line):
        """Scalar opacity of the volume property: 0.5 in the middle of the line, 0 far from the line."""
        with open(path) as file:
            rows = [row.split() for row in file if row.strip()]
        numbers = [float(part) for part in next(row for row in rows if len(row) > 5)[1:]]
        points = list(zip(numbers[0::2], numbers[1::2]))
        inside = [opacity for heat, opacity in points if line.lower < heat < line.upper]
        outside = [opacity for heat, opacity in points if heat < line.lower - 0.01]
        self.assertEqual(max(inside), 0.5)
        self.assertEqual(set(outside), {0.0})


if __name__ == "__main__":
    unittest.main()
