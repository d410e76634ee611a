import os
import time
import unittest

from case import Case, finish, slicer

from ShapetonLib.toolrun import ToolRun, toolPath, toolsFolderKey


class ToolRunTest(Case):
    def heat(self, steps, onProgress=lambda share, stage: None):
        arguments = [self.phantom(), os.path.join(self.folder, "heat.nrrd"), "--timeSteps", steps]
        return ToolRun("CumulativeHeatDiffusion", arguments, onProgress)

    def testProgressRisesToTheEnd(self):
        shares = []
        run = self.heat(20000, lambda share, stage: shares.append(share))
        finish(run)
        run.requireSuccess()
        self.assertGreater(len(shares), 5)
        self.assertEqual(shares, sorted(shares))
        self.assertGreater(shares[-1], 0.9)
        self.assertTrue(run.stage)

    def testFailureIsTheLineOfTheTool(self):
        run = ToolRun("CumulativeHeatDiffusion", [os.path.join(self.folder, "absent.nrrd"), "x.nrrd"])
        finish(run)
        with self.assertRaisesRegex(RuntimeError, "^[^\n]*absent.nrrd[^\n]*$"):
            run.requireSuccess()

    def testCancelEndsTheToolAndLeavesNothing(self):
        run = self.heat(2000000000 // 2)
        while run.share == 0.0 and not run.poll():
            time.sleep(0.01)
        begin = time.monotonic()
        run.cancel()
        finish(run)
        self.assertLess(time.monotonic() - begin, 5.0)
        with self.assertRaises(RuntimeError):
            run.requireSuccess()
        self.assertEqual([name for name in os.listdir(self.folder) if "heat" in name], [])

    def testAnAbsentToolIsNamed(self):
        with self.assertRaisesRegex(RuntimeError, "NoSuchTool was not found .*; set the folder of Shapeton's tools"):
            toolPath("NoSuchTool")
        slicer.util._settings.pop(toolsFolderKey)
        with self.assertRaisesRegex(RuntimeError, "ShapePhantom was not found"):
            toolPath("ShapePhantom")  # the stub has no command-line modules


if __name__ == "__main__":
    unittest.main()
