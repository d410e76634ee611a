"""Finds the objects of a volume: heat, then a segmentation with a name and a color for each object, and their table.

In the Python console of 3D Slicer: findObjects(slicer.util.getNode("CTChest"), "/tmp/objects.csv")
or: Slicer --python-script find_objects.py VOLUME TABLE"""

import sys

import slicer


def run(tool, **parameters):
    """Runs a command-line module; its message is the exception if it fails."""
    node = slicer.cli.runSync(getattr(slicer.modules, tool.lower()), None, parameters)
    if node.GetStatusString() != "Completed":
        raise RuntimeError(node.GetErrorText())


def findObjects(volume, table):
    """Returns the segmentation; `table`: path of the CSV file with volume, heat and probability of each object."""
    heat = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLScalarVolumeNode", "Heat")
    objects = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLSegmentationNode", "Objects")
    run("CumulativeHeatDiffusion", inputVolume=volume, outputHeat=heat)
    run("HeatObjects", inputVolume=volume, heatVolume=heat, labels=objects, table=table)
    return objects


if __name__ == "__main__" and len(sys.argv) == 3:
    segmentation = findObjects(slicer.util.loadVolume(sys.argv[1]), sys.argv[2])
    segmentation.CreateClosedSurfaceRepresentation()
    slicer.util.resetThreeDViews()
