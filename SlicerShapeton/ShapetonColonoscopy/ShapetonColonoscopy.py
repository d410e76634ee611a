import os

import qt
import slicer
from slicer.ScriptedLoadableModule import ScriptedLoadableModule, ScriptedLoadableModuleWidget
from slicer.util import VTKObservationMixin

from ShapetonLib.colonoscopy import ColonoscopyLogic, positions
from ShapetonLib.runpanel import RunPanel, section, volumeSelector
from ShapetonLib.scene import showVolume


class ShapetonColonoscopy(ScriptedLoadableModule):
    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        parent.title = "Shapeton Colonoscopy"
        parent.categories = ["Shapeton"]
        parent.contributors = ["The Shapeton developers"]
        parent.helpText = (
            "From CT colonography to wall, centerline, landmarks, polyp candidates and the flat colon. "
            "For research use; not a diagnosis."
        )
        parent.acknowledgementText = "Shapeton, Apache License 2.0."


class MapClicks(qt.QObject):
    """Reports clicks on the map picture."""

    def __init__(self, clicked):
        qt.QObject.__init__(self)
        self._clicked = clicked

    def eventFilter(self, watched, event):
        if event.type() != qt.QEvent.MouseButtonPress:
            return False
        self._clicked(event.pos().x(), event.pos().y())
        return True


class FlatMapView:
    """Enlarged picture of the flat colon with a mark."""

    scale = 3

    def __init__(self, layout, clicked):
        self._clicked = clicked
        self._picture = None
        self._label = qt.QLabel()
        self._clicks = MapClicks(lambda x, y: self._clicked(x // self.scale, y // self.scale))
        self._label.installEventFilter(self._clicks)
        self._area = qt.QScrollArea()
        self._area.setWidget(self._label)
        layout.addRow(self._area)

    def show(self, flatMap):
        path = os.path.join(slicer.util.tempDirectory(), "flat.png")
        flatMap.writePicture(path)
        picture = qt.QPixmap(path)
        self._picture = picture.scaled(picture.width() * self.scale, picture.height() * self.scale)
        self._label.setPixmap(self._picture)
        self._label.resize(self._picture.size())
        self._area.setMinimumHeight(self._picture.height() + 30)

    def clear(self):
        self._label.clear()

    def mark(self, pixel):
        marked = qt.QPixmap(self._picture)
        if pixel:
            x, y = (int((part + 0.5) * self.scale) for part in pixel)
            painter = qt.QPainter(marked)
            painter.setPen(qt.QPen(qt.QColor("red"), 2))
            painter.drawEllipse(x - 6, y - 6, 12, 12)
            painter.end()
            self._area.ensureVisible(x, y)
        self._label.setPixmap(marked)


class ShapetonColonoscopyWidget(ScriptedLoadableModuleWidget, VTKObservationMixin):
    def __init__(self, parent=None):
        ScriptedLoadableModuleWidget.__init__(self, parent)
        VTKObservationMixin.__init__(self)
        self.logic = None
        self.results = None

    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        self.logic = ColonoscopyLogic()
        form = section(self.layout, "Examination")
        self.volume = volumeSelector(slicer.mrmlScene)
        form.addRow("CT colonography:", self.volume)
        self.position = qt.QComboBox()
        self.position.addItems(positions)
        form.addRow("Position:", self.position)
        self.panel = RunPanel(form)
        self.applyButton = qt.QPushButton("Apply")
        self.applyButton.connect("clicked()", self.onApply)
        form.addRow(self.applyButton)
        self.mapView = FlatMapView(section(self.layout, "Flat colon: click to show in slices"), self.onMapClick)
        self.layout.addStretch(1)
        crosshair = slicer.mrmlScene.GetFirstNodeByClass("vtkMRMLCrosshairNode")
        self.addObserver(crosshair, slicer.vtkMRMLCrosshairNode.CursorPositionModifiedEvent, self.onCursor)
        self.addObserver(slicer.mrmlScene, slicer.vtkMRMLScene.StartCloseEvent, self.onSceneClose)

    def cleanup(self):
        self.panel.cancel()
        self.removeObservers()

    def onApply(self):
        node = self.volume.currentNode()
        if node is None or self.panel.isBusy:
            return
        folder, position = self.panel.folder, self.position.currentText
        self.panel.start(
            lambda onProgress: self.logic.start(node, folder, position, onProgress), lambda: self.onFinished(folder)
        )

    def onFinished(self, folder):
        self.results = self.logic.load(folder)
        showVolume(self.results.volume)
        slicer.util.setSliceViewerLayers(label=self.results.lumen, labelOpacity=0.3)
        self.mapView.show(self.results.flatMap)

    def onSceneClose(self, caller, event):
        self.panel.cancel()
        self.results = None
        self.mapView.clear()

    def onMapClick(self, column, row):
        if self.results and self.logic.jumpTo(self.results.flatMap, column, row):
            self.mapView.mark((column, row))

    def onCursor(self, caller, event):
        if self.results:
            self.mapView.mark(self.logic.pixelOfCursor(self.results.flatMap))
