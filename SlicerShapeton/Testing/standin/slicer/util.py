"""Functions of slicer.util: files become nodes that store their name."""

import contextlib
import json
import os
import shutil
import tempfile

import slicer

_settings = {}


def settingsValue(key, default):
    return _settings.get(key, default)


def startupEnvironment():
    return dict(os.environ)


def tempDirectory():
    return tempfile.mkdtemp()


@contextlib.contextmanager
def tryWithErrorDisplay(message, waitCursor=False):
    yield  # Slicer shows the exception; tests need it raised


def setSliceViewerLayers(background=None, foreground=None, label=None, foregroundOpacity=None, labelOpacity=None, fit=False):
    pass


def resetThreeDViews():
    pass


def getNodesByClass(kind):
    assert kind == "vtkMRMLMarkupsNode"
    return [node for node in slicer.mrmlScene._nodes if node._kind.startswith("vtkMRMLMarkups")]


def updateVolumeFromArray(node, array):
    node._array = array.copy()
    node._updates = getattr(node, "_updates", 0) + 1


def arrayFromVolume(node):
    return node._array


def updateTableFromArray(node, arrays, columnNames):
    assert len(arrays) == len(columnNames)
    node._columns = dict(zip(columnNames, arrays))


def exportNode(node, path, properties):
    shutil.copyfile(node._file, path)
    return True


def _loader(kind, suffix):
    def load(path, properties=None):
        if not os.path.isfile(path) or not path.endswith(suffix):
            raise RuntimeError(f"Failed to load node from file: {path}")
        return slicer.Node(kind, path, properties)

    return load


loadVolume = _loader("vtkMRMLScalarVolumeNode", ".nrrd")
loadLabelVolume = _loader("vtkMRMLLabelMapVolumeNode", ".nrrd")
loadColorTable = _loader("vtkMRMLColorTableNode", ".ctbl")
loadModel = _loader("vtkMRMLModelNode", ".vtp")
loadMarkups = _loader("vtkMRMLMarkupsNode", ".mrk.json")
loadSegmentation = _loader("vtkMRMLSegmentationNode", ".seg.nrrd")
loadTable = _loader("vtkMRMLTableNode", ".csv")


def loadNodesFromFile(path, filetype, properties):
    """Adds the nodes of all markups, but returns the first, as Slicer does."""
    assert filetype == "MarkupsFile"
    with open(path) as file:
        nodes = [slicer.Node("vtkMRMLMarkups" + markup["type"] + "Node", path) for markup in json.load(file)["markups"]]
    slicer.mrmlScene._nodes += nodes
    return iter(nodes[:1])


class VTKObservationMixin:
    def addObserver(self, node, event, method):
        node._observers = getattr(node, "_observers", []) + [method]

    def removeObservers(self):
        pass
