"""A stub of the part of 3D Slicer used by ShapetonLib, for tests without Slicer.

It stores files and records the calls on nodes. Names not listed in `api` raise AttributeError, and the test
StandInNamesWhatSlicerHas searches each name in Slicer's sources."""

import os
import tempfile

import vtk

# Declarations in Slicer of the names in the stub.
api = {
    "Base/Python/slicer/util.py": [
        "exportNode", "loadVolume", "loadLabelVolume", "loadColorTable", "loadModel", "loadMarkups", "loadNodesFromFile",
        "loadTable", "settingsValue", "startupEnvironment", "tryWithErrorDisplay", "tempDirectory", "setSliceViewerLayers",
        "VTKObservationMixin", "addObserver", "removeObservers", "updateVolumeFromArray", "arrayFromVolume",
        "updateTableFromArray", "loadSegmentation", "getNodesByClass", "resetThreeDViews",
    ],
    "Base/Python/slicer/ScriptedLoadableModule.py": [
        "ScriptedLoadableModule", "ScriptedLoadableModuleWidget", "setup", "cleanup",
    ],
    "Libs/MRML/Core/vtkMRMLNode.h": ["GetID", "SetName", "GetName"],
    "Libs/MRML/Core/vtkMRMLTransformableNode.h": ["GetParentTransformNode"],
    "Libs/MRML/Core/vtkMRMLDisplayableNode.h": ["GetDisplayNode", "CreateDefaultDisplayNodes"],
    "Libs/MRML/Core/vtkMRMLVolumeNode.h": ["SetIJKToRASMatrix"],
    "Libs/MRML/Core/vtkMRMLColorNode.h": ["SetTypeToUser", "NamesInitialisedOn"],
    "Libs/MRML/Core/vtkMRMLSegmentationNode.h": ["CreateClosedSurfaceRepresentation"],
    "Libs/MRML/Core/vtkMRMLSubjectHierarchyNode.h": [
        "GetSceneItemID", "CreateFolderItem", "GetItemByDataNode", "SetItemParent",
    ],
    "Libs/MRML/Core/vtkMRMLColorTableNode.h": ["SetNumberOfColors", "SetColor"],
    "Modules/Loadable/Markups/MRML/vtkMRMLMarkupsNode.h": [
        "GetNumberOfControlPoints", "GetNthControlPointPositionWorld", "PointPositionDefinedEvent",
    ],
    "Modules/Loadable/Markups/MRML/vtkMRMLMarkupsROINode.h": ["GetCenterWorld", "GetSizeWorld"],
    "Libs/MRML/Core/vtkMRMLDisplayNode.h": [
        "SetOpacity", "SetActiveScalar", "SetAndObserveColorNodeID", "SetScalarRangeFlag", "SetScalarVisibility",
        "SetVisibility", "SetVisibility2D", "SetVisibility3D", "UseColorNodeScalarRange",
    ],
    "Libs/MRML/Core/vtkMRMLScene.h": [
        "GetFirstNodeByClass", "AddNewNodeByClass", "IsNodePresent", "RemoveNode", "StartCloseEvent",
        "GetSubjectHierarchyNode",
    ],
    "Libs/MRML/Core/vtkMRMLCrosshairNode.h": ["SetCrosshairRAS", "GetCursorPositionRAS", "CursorPositionModifiedEvent"],
    "Modules/Loadable/Markups/Logic/vtkSlicerMarkupsLogic.h": ["JumpSlicesToLocation", "SetActiveList", "StartPlaceMode"],
    "Modules/Loadable/VolumeRendering/Logic/vtkSlicerVolumeRenderingLogic.h": [
        "GetFirstVolumeRenderingDisplayNode", "CreateDefaultVolumeRenderingNodes", "AddVolumePropertyFromFile",
    ],
    "Modules/Loadable/VolumeRendering/MRML/vtkMRMLVolumeRenderingDisplayNode.h": ["SetAndObserveVolumePropertyNodeID"],
    "Base/QTCore/qSlicerAbstractCoreModule.h": ["path", "logic"],
    "Base/QTCore/qSlicerCoreApplication.h": ["temporaryPath", "connect"],
}


class vtkMRMLDisplayNode:
    UseColorNodeScalarRange = 2

    def __init__(self):
        self._asked = {}

    def _setter(name):
        def set(self, *values):
            self._asked[name] = values

        return set

    for _name in ("SetOpacity", "SetActiveScalar", "SetAndObserveColorNodeID", "SetScalarRangeFlag", "SetScalarVisibility",
                  "SetVisibility", "SetVisibility2D", "SetVisibility3D", "SetAndObserveVolumePropertyNodeID"):
        locals()[_name] = _setter(_name)
    del _name, _setter


class Node:
    _count = 0

    def __init__(self, kind, file="", properties=None):
        Node._count += 1
        self._id = f"{kind}{Node._count}"
        self._kind, self._file, self._properties = kind, file, dict(properties or {})
        self._name = self._properties.get("name", os.path.basename(file))
        self._display = vtkMRMLDisplayNode()

    def GetID(self):
        return self._id

    def GetName(self):
        return self._name

    def SetName(self, name):
        self._name = name

    def GetDisplayNode(self):
        return self._display

    def CreateDefaultDisplayNodes(self):
        self._display = vtkMRMLDisplayNode()

    def GetParentTransformNode(self):
        return None

    def CreateClosedSurfaceRepresentation(self):
        assert self._kind == "vtkMRMLSegmentationNode"


class vtkMRMLVolumeNode(Node):
    """A volume without a file."""

    def __init__(self, kind):
        Node.__init__(self, kind)
        self._display = self._array = self._matrix = None

    def SetIJKToRASMatrix(self, matrix):
        self._matrix = matrix


class vtkMRMLColorTableNode(Node):
    def __init__(self):
        Node.__init__(self, "vtkMRMLColorTableNode")
        self._colors, self._hasNames = [], False

    def SetTypeToUser(self):
        pass

    def NamesInitialisedOn(self):
        self._hasNames = True

    def SetNumberOfColors(self, number):
        self._colors = (self._colors + [None] * number)[:number]

    def SetColor(self, entry, name, red, green, blue, opacity):
        self._colors[entry] = (name if self._hasNames else f"R={red} G={green} B={blue}", red, green, blue, opacity)


class vtkMRMLMarkupsNode(vtk.vtkObject):
    """Its observers are real ones."""

    PointPositionDefinedEvent = vtk.vtkCommand.UserEvent + 1

    def __init__(self):
        self._kind, self._points = "vtkMRMLMarkupsFiducialNode", []

    def GetNumberOfControlPoints(self):
        return len(self._points)

    def GetNthControlPointPositionWorld(self, index, place):
        place[:] = self._points[index]

    def _place(self, point):
        self._points.append(point)
        self.InvokeEvent(self.PointPositionDefinedEvent)


class vtkMRMLMarkupsROINode(vtkMRMLMarkupsNode):
    def __init__(self, center, size):
        self._kind, self._center, self._size = "vtkMRMLMarkupsROINode", center, size

    def GetCenterWorld(self, center):
        center[:] = self._center

    def GetSizeWorld(self, size):
        size[:] = self._size


class vtkMRMLCrosshairNode(Node):
    CursorPositionModifiedEvent = 22000

    def __init__(self):
        Node.__init__(self, "vtkMRMLCrosshairNode")
        self._crosshair = self._cursor = None

    def SetCrosshairRAS(self, x, y, z):
        self._crosshair = (x, y, z)

    def GetCursorPositionRAS(self, place):
        if self._cursor is None:
            return False
        place[:] = self._cursor
        return True


class vtkMRMLSubjectHierarchyNode:
    """The items are names of folders and nodes."""

    def __init__(self):
        self._parents = {}

    def GetSceneItemID(self):
        return "scene"

    def CreateFolderItem(self, parent, name):
        self._parents[name] = parent
        return name

    def GetItemByDataNode(self, node):
        return node.GetName()

    def SetItemParent(self, item, parent):
        self._parents[item] = parent


class vtkMRMLScene:
    StartCloseEvent = 66000


class _Scene:
    def __init__(self):
        self._crosshair = vtkMRMLCrosshairNode()
        self._hierarchy = vtkMRMLSubjectHierarchyNode()
        self._nodes = []

    def GetFirstNodeByClass(self, kind):
        return {"vtkMRMLCrosshairNode": self._crosshair}[kind]

    def GetSubjectHierarchyNode(self):
        return self._hierarchy

    def AddNewNodeByClass(self, kind, name):
        makers = {"vtkMRMLColorTableNode": vtkMRMLColorTableNode, "vtkMRMLMarkupsFiducialNode": vtkMRMLMarkupsNode,
                  "vtkMRMLTableNode": lambda: Node(kind)}
        node = makers.get(kind, lambda: vtkMRMLVolumeNode(kind))()
        node._name = name
        self._nodes.append(node)
        return node

    def IsNodePresent(self, node):
        return node in self._nodes

    def RemoveNode(self, node):
        self._nodes.remove(node)


class _MarkupsLogic:
    def JumpSlicesToLocation(self, x, y, z, centered):
        self._place = (x, y, z)

    def SetActiveList(self, node):
        self._active = node

    def StartPlaceMode(self, isPersistent):
        self._isPersistent = isPersistent


class _VolumeRenderingLogic:
    def __init__(self):
        self._displays = {}

    def GetFirstVolumeRenderingDisplayNode(self, node):
        return self._displays.get(node)

    def CreateDefaultVolumeRenderingNodes(self, node):
        return self._displays.setdefault(node, vtkMRMLDisplayNode())

    def AddVolumePropertyFromFile(self, file):
        return Node("vtkMRMLVolumePropertyNode", file) if os.path.isfile(file) else None


class _Module:
    def __init__(self, logic):
        self._logic = logic

    def logic(self):
        return self._logic


class modules:
    markups = _Module(_MarkupsLogic())
    volumerendering = _Module(_VolumeRenderingLogic())


class app:
    temporaryPath = tempfile.gettempdir()

    @staticmethod
    def connect(signal, slot):
        pass


mrmlScene = _Scene()


class qMRMLNodeComboBox:
    def __init__(self):
        self._node = None

    def setMRMLScene(self, scene):
        pass

    def currentNode(self):
        return self._node


from slicer import util  # noqa: E402, F401
