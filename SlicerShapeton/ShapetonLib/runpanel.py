"""Common widgets of the modules: tools folder, results folder, progress and cancel."""

import os

import ctk
import qt
import slicer

from ShapetonLib.toolrun import toolsFolderKey


class RunPanel:
    """Shows one ToolRun at a time. A timer polls it, because Slicer's event loop blocks Python threads."""

    interval = 200  # ms

    def __init__(self, layout):
        self._run = None
        self._finished = None

        folders = ctk.ctkCollapsibleGroupBox()
        folders.title = "Folders"
        folders.collapsed = True
        rows = qt.QFormLayout(folders)
        self.outputFolder = ctk.ctkPathLineEdit()
        self.outputFolder.filters = ctk.ctkPathLineEdit.Dirs
        self.outputFolder.currentPath = os.path.join(slicer.app.temporaryPath, "Shapeton")
        self.outputFolder.setToolTip("Folder for result files; another run on the same volume resumes from them.")
        rows.addRow("Results:", self.outputFolder)

        self.toolsFolder = ctk.ctkPathLineEdit()
        self.toolsFolder.filters = ctk.ctkPathLineEdit.Dirs
        self.toolsFolder.currentPath = slicer.util.settingsValue(toolsFolderKey, "")
        self.toolsFolder.setToolTip("Folder of Shapeton's tools; by default the tools of this extension.")
        self.toolsFolder.connect("currentPathChanged(QString)", self._rememberToolsFolder)
        rows.addRow("Tools:", self.toolsFolder)
        layout.addRow(folders)

        self.progress = qt.QProgressBar()
        self.progress.setRange(0, 1000)
        self.stage = qt.QLabel()
        self.cancelButton = qt.QPushButton("Cancel")
        self.cancelButton.enabled = False
        self.cancelButton.connect("clicked()", self.cancel)
        layout.addRow(self.stage, self.progress)
        layout.addRow(self.cancelButton)

        self._timer = qt.QTimer()
        self._timer.setInterval(self.interval)
        self._timer.connect("timeout()", self._poll)

    @property
    def folder(self):
        return self.outputFolder.currentPath

    @property
    def isBusy(self):
        return self._run is not None

    def start(self, startRun, finished):
        """startRun(onProgress) returns a ToolRun; finished() is called after success."""
        with slicer.util.tryWithErrorDisplay("Shapeton could not start.", waitCursor=True):
            self._run = startRun(self._showProgress)
            self._finished = finished
            self.cancelButton.enabled = True
            self._timer.start()

    def cancel(self):
        if self._run:
            self.stage.text = "Ending"
            self._run.cancel()

    def _poll(self):
        run = self._run
        if not run.poll():
            return
        self._timer.stop()
        self._run = None
        self.cancelButton.enabled = False
        self.progress.value = 0
        self.stage.text = "Canceled" if run.canceled else ""
        if run.canceled:
            return
        with slicer.util.tryWithErrorDisplay(f"{run.name} failed.", waitCursor=True):
            run.requireSuccess()
            self._finished()
            self.stage.text = "\n".join(run.messages)

    def _showProgress(self, share, stage):
        self.progress.value = round(1000 * share)
        self.stage.text = stage

    @staticmethod
    def _rememberToolsFolder(path):
        qt.QSettings().setValue(toolsFolderKey, path)


def volumeSelector(scene):
    selector = slicer.qMRMLNodeComboBox()
    selector.nodeTypes = ["vtkMRMLScalarVolumeNode"]
    selector.selectNodeUponCreation = False
    selector.addEnabled = False
    selector.removeEnabled = False
    selector.setMRMLScene(scene)
    return selector


def section(layout, title):
    """A titled section of a module's panel; returns its form layout."""
    button = ctk.ctkCollapsibleButton()
    button.text = title
    layout.addWidget(button)
    return qt.QFormLayout(button)
