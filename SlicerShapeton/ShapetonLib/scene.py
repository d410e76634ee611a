"""Results in the scene: what the views show, and a subject hierarchy folder for each run."""

import slicer


def showVolume(node):
    """Shows a volume in the slices, which are fitted to it as is the 3-D view."""
    slicer.util.setSliceViewerLayers(background=node, foreground=None, label=None, fit=True)
    slicer.util.resetThreeDViews()


def showSurfaces(segmentation):
    """Shows the segments in the 3-D view."""
    segmentation.CreateClosedSurfaceRepresentation()
    slicer.util.resetThreeDViews()


def putInFolder(name, nodes):
    """Makes a subject hierarchy folder with the nodes."""
    hierarchy = slicer.mrmlScene.GetSubjectHierarchyNode()
    folder = hierarchy.CreateFolderItem(hierarchy.GetSceneItemID(), name)
    for node in nodes:
        hierarchy.SetItemParent(hierarchy.GetItemByDataNode(node), folder)


def loadMarkupsOf(path):
    """Loads all nodes of a markups file; Slicer returns only the first of them."""
    before = slicer.util.getNodesByClass("vtkMRMLMarkupsNode")
    slicer.util.loadNodesFromFile(path, "MarkupsFile", {})
    return [node for node in slicer.util.getNodesByClass("vtkMRMLMarkupsNode") if node not in before]
