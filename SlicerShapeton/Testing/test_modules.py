"""Runs the widget code on dummy widgets."""

import time
import unittest

from case import Case, slicer

import qt  # the stub
from ShapetonColonoscopy import ShapetonColonoscopy, ShapetonColonoscopyWidget
from ShapetonHeat import ShapetonHeat, ShapetonHeatWidget


class ModulesTest(Case):
    def testTheModulesSayWhatTheyAreNot(self):
        for module in (ShapetonHeat, ShapetonColonoscopy):
            parent = type("Parent", (), {})()
            module(parent)
            self.assertIn("not a diagnosis", parent.helpText)

    def testHeatFromTheVolumeToTheRendering(self):
        widget = ShapetonHeatWidget()
        widget.setup()
        widget.volume._node = slicer.Node("vtkMRMLScalarVolumeNode", self.phantom())
        widget.panel.outputFolder.currentPath = self.folder
        widget.preset.currentText = "published"
        widget.intensityWindow.text = "0"
        with self.assertRaisesRegex(RuntimeError, "minimum,maximum"):
            widget.onApply()
        widget.intensityWindow.text = " 0, 1000 "
        widget.timeSteps.value = 2000
        widget.onApply()
        self.finish(widget.panel)
        self.assertEqual(widget.heat.GetName(), "Heat")
        self.assertGreater(widget.lines._table.rowCount, 1)
        widget.lines._table.item(0, 0).setCheckState(qt.Qt.Checked)
        self.assertEqual(len(widget.lines.picked()), 1)
        widget.onRender()
        self.finish(widget.panel)
        display = slicer.modules.volumerendering.logic().GetFirstVolumeRenderingDisplayNode(widget.heat)
        self.assertIn("SetAndObserveVolumePropertyNodeID", display._asked)
        widget.onSceneClose(None, None)
        self.assertIsNone(widget.heat)
        self.assertEqual(widget.lines._table.rowCount, 0)
        widget.cleanup()

    def testColonoscopyTellsWhatIsWrongAndCanBeCanceled(self):
        widget = ShapetonColonoscopyWidget()
        widget.setup()
        widget.onApply()  # no effect without a selected volume
        self.assertFalse(widget.panel.isBusy)
        widget.volume._node = slicer.Node("vtkMRMLScalarVolumeNode", self.phantom())
        widget.panel.outputFolder.currentPath = self.folder
        widget.position.currentText = "supine"
        widget.onApply()
        with self.assertRaisesRegex(RuntimeError, "the stage segmentation"):  # cube and spheres are not a colon
            self.finish(widget.panel)
        widget.onMapClick(1, 1)
        widget.onCursor(None, None)
        widget.onApply()
        widget.panel.cancel()
        self.finish(widget.panel)
        self.assertEqual(widget.panel.stage.text, "Canceled")

    def testTheFolderOfToolsIsRemembered(self):
        widget = ShapetonHeatWidget()
        widget.setup()
        widget.panel.toolsFolder._connected["currentPathChanged(QString)"]("/somewhere")
        self.assertEqual(slicer.util.settingsValue("Shapeton/ToolsFolder", ""), "/somewhere")

    def finish(self, panel):
        while panel.isBusy:
            panel._poll()
            time.sleep(0.02)


if __name__ == "__main__":
    unittest.main()
