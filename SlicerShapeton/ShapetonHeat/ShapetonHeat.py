import qt
import slicer
from slicer.ScriptedLoadableModule import ScriptedLoadableModule, ScriptedLoadableModuleWidget
from slicer.util import VTKObservationMixin

from ShapetonLib.heat import HeatLogic, Line
from ShapetonLib.livepanel import LivePanel
from ShapetonLib.runpanel import RunPanel, section, volumeSelector


class ShapetonHeat(ScriptedLoadableModule):
    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        parent.title = "Shapeton Heat"
        parent.categories = ["Shapeton"]
        parent.contributors = ["The Shapeton developers"]
        parent.helpText = (
            "Computes a shape descriptor of every voxel of a volume by heat diffusion, and renders selected lines of "
            "the heat histogram. A live session shows shapetons, heat and objects while they are computed. For research "
            "use; not a diagnosis."
        )
        parent.acknowledgementText = "Shapeton, Apache License 2.0."


class LineTable:
    """Selectable lines of the histogram; heats, color and opacity can be changed."""

    columns = ("Show", "From", "To", "Color", "Opacity")

    def __init__(self, layout):
        self._table = qt.QTableWidget(0, len(self.columns))
        self._table.setHorizontalHeaderLabels(self.columns)
        layout.addRow(self._table)

    def show(self, lines):
        self._table.setRowCount(len(lines))
        for row, line in enumerate(lines):
            pick = qt.QTableWidgetItem()
            pick.setCheckState(qt.Qt.Unchecked)
            self._table.setItem(row, 0, pick)
            for column, text in enumerate((f"{line.lower:.6f}", f"{line.upper:.6f}", line.color, f"{line.opacity:g}"), 1):
                self._table.setItem(row, column, qt.QTableWidgetItem(text))

    def picked(self):
        return [self._lineOf(row) for row in range(self._table.rowCount) if self._isPicked(row)]

    def _isPicked(self, row):
        return self._table.item(row, 0).checkState() == qt.Qt.Checked

    def _lineOf(self, row):
        lower, upper, color, opacity = (self._table.item(row, column).text() for column in range(1, len(self.columns)))
        return Line(float(lower), float(upper), color, float(opacity))


class ShapetonHeatWidget(ScriptedLoadableModuleWidget, VTKObservationMixin):
    def __init__(self, parent=None):
        ScriptedLoadableModuleWidget.__init__(self, parent)
        VTKObservationMixin.__init__(self)

    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        self.logic = HeatLogic()
        self.heat = None
        self.heatFolder = None
        form = section(self.layout, "Heat")
        self.volume = volumeSelector(slicer.mrmlScene)
        form.addRow("Volume:", self.volume)
        self.intensityWindow = self._range()
        form.addRow("Intensity window:", self.intensityWindow)
        self.timeSteps = qt.QSpinBox()
        self.timeSteps.setRange(0, 100000000)
        self.timeSteps.specialValueText = "automatic"  # for 0
        form.addRow("Time steps:", self.timeSteps)
        self.panel = RunPanel(form)
        form.addRow(self._button("Apply", self.onApply))
        lines = section(self.layout, "Lines of the histogram")
        self.histogram = qt.QLabel()
        lines.addRow(self.histogram)
        self.lines = LineTable(lines)
        lines.addRow(self._button("Render the selected lines", self.onRender))
        live = section(self.layout, "Live session")
        self.live = LivePanel(live, self.volume.currentNode, lambda: self.panel.folder)
        self.layout.addStretch(1)
        self.addObserver(slicer.mrmlScene, slicer.vtkMRMLScene.StartCloseEvent, self.onSceneClose)

    def cleanup(self):
        self.removeObservers()
        self.panel.cancel()
        self.live.cleanup()

    def onSceneClose(self, caller, event):
        self.live.cleanup()

    def onApply(self):
        node = self.volume.currentNode()
        if node is None or self.panel.isBusy:
            return
        folder, window, timeSteps = self.panel.folder, self._window(), self.timeSteps.value
        self.panel.start(
            lambda onProgress: self.logic.start(node, folder, window, timeSteps, onProgress=onProgress),
            lambda: self.onHeat(folder),
        )

    def onHeat(self, folder):
        self.heat = self.logic.loadHeat(folder)
        self.heatFolder = folder
        self.histogram.setPixmap(qt.QPixmap(self.logic.histogramPath(folder)).scaledToWidth(600))
        self.lines.show(self.logic.classLines(folder))

    def onRender(self):
        if self.heat is None or self.panel.isBusy:
            return
        self.panel.start(
            lambda onProgress: self.logic.startTransferFunction(self.heatFolder, self.lines.picked(), onProgress),
            lambda: self.logic.show(self.heat, self.heatFolder),
        )

    def _window(self):
        """Returns the intensity window; None for the whole range."""
        text = self.intensityWindow.text.strip()
        return tuple(float(part) for part in text.split(",")) if text else None

    @staticmethod
    def _range():
        edit = qt.QLineEdit()
        edit.placeholderText = "minimum,maximum in the units of the volume; whole range if empty"
        return edit

    @staticmethod
    def _button(text, clicked):
        button = qt.QPushButton(text)
        button.connect("clicked()", clicked)
        return button
