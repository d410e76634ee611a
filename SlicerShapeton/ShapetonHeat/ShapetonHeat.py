import qt
import slicer
from slicer.ScriptedLoadableModule import ScriptedLoadableModule, ScriptedLoadableModuleWidget
from slicer.util import VTKObservationMixin

from ShapetonLib.heat import HeatLogic, Line, presets
from ShapetonLib.livepanel import LivePanel
from ShapetonLib.runpanel import RunPanel, section, volumeSelector
from ShapetonLib.sampledata import registerSampleData


class ShapetonHeat(ScriptedLoadableModule):
    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        parent.title = "Shapeton Heat"
        parent.categories = ["Shapeton"]
        parent.contributors = ["The Shapeton developers"]
        parent.helpText = (
            "Finds the objects of a volume by heat diffusion, and renders selected lines of the heat histogram. A live "
            "session shows shapetons, heat and objects while they are computed. For research use; not a diagnosis."
        )
        parent.acknowledgementText = (
            "Implements K. Gurijala, Shape-based analysis, Stony Brook University. Apache License 2.0."
        )
        slicer.app.connect("startupCompleted()", registerSampleData)


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
    panelWidth = 450  # pixels of a usual module panel, for the height of the histogram

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
        self.preset = qt.QComboBox()
        self.preset.addItems(presets)
        self.preset.setToolTip("How window, p, smoothing and time are chosen: such that objects separate, or as published.")
        form.addRow("Preset:", self.preset)
        self.intensityWindow = self._range()
        form.addRow("Intensity window:", self.intensityWindow)
        self.timeSteps = qt.QSpinBox()
        self.timeSteps.setRange(0, 100000000)
        self.timeSteps.specialValueText = "of the preset"  # for 0
        form.addRow("Time steps:", self.timeSteps)
        form.addRow(self._button("Find objects", self.onApply))
        self.panel = RunPanel(form)
        lines = section(self.layout, "Lines of the histogram")
        self.histogram = qt.QLabel()
        self.histogram.setSizePolicy(qt.QSizePolicy.Ignored, qt.QSizePolicy.Fixed)  # as wide as the panel
        self.histogram.setScaledContents(True)
        lines.addRow(self.histogram)
        self.lines = LineTable(lines)
        lines.addRow(self._button("Render the selected lines", self.onRender))
        live = section(self.layout, "Live session")
        self.live = LivePanel(live, self.volume.currentNode, lambda: self.panel.folder)
        self.sections = [form.parentWidget(), lines.parentWidget(), live.parentWidget()]
        for further in self.sections[1:]:
            further.collapsed = True
        self.layout.addStretch(1)
        self.addObserver(slicer.mrmlScene, slicer.vtkMRMLScene.StartCloseEvent, self.onSceneClose)

    def cleanup(self):
        self.removeObservers()
        self.panel.cancel()
        self.live.cleanup()

    def onSceneClose(self, caller, event):
        self.panel.cancel()
        self.live.cleanup()
        self.heat = None
        self.histogram.clear()
        self.lines.show([])

    def onApply(self):
        node = self.volume.currentNode()
        if node is None or self.panel.isBusy:
            return
        with slicer.util.tryWithErrorDisplay("Shapeton could not start."):
            folder, preset, window, timeSteps = self.panel.folder, self.preset.currentText, self._window(), self.timeSteps.value
            self.panel.start(
                lambda onProgress: self.logic.start(node, folder, preset, window, timeSteps, onProgress),
                lambda: self.onHeat(node, folder),
            )

    def onHeat(self, node, folder):
        self.panel.start(lambda onProgress: self.logic.startObjects(folder, onProgress), lambda: self.onObjects(node, folder))

    def onObjects(self, node, folder):
        self.heat = self.logic.load(node, folder)
        self.heatFolder = folder
        picture = qt.QPixmap(self.logic.histogramPath(folder))
        self.histogram.setPixmap(picture)
        self.histogram.setFixedHeight(self.panelWidth * picture.height() // picture.width())
        self.lines.show(self.logic.classLines(folder))

    def onRender(self):
        if self.heat is None or self.panel.isBusy:
            return
        self.panel.start(
            lambda onProgress: self.logic.startTransferFunction(self.heatFolder, self.lines.picked(), onProgress),
            lambda: self.logic.show(self.heat, self.heatFolder),
        )

    def _window(self):
        """Returns the intensity window; None for that of the preset."""
        text = self.intensityWindow.text.strip()
        if not text:
            return None
        try:
            lower, upper = (float(part) for part in text.split(","))
        except ValueError:
            raise RuntimeError(f'The intensity window "{text}" is not of the form minimum,maximum') from None
        return lower, upper

    @staticmethod
    def _range():
        edit = qt.QLineEdit()
        edit.placeholderText = "minimum,maximum; of the preset if empty"
        return edit

    @staticmethod
    def _button(text, clicked):
        button = qt.QPushButton(text)
        button.connect("clicked()", clicked)
        return button
