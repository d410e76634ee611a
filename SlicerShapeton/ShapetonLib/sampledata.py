"""Phantoms in the module Sample Data, made by the tools."""

import os
import subprocess

import slicer

from ShapetonLib.toolrun import toolEnvironment, toolPath

# Name, tool and arguments; ColonPhantom writes a DICOM series, which DicomSeriesToImage converts.
phantoms = (
    ("ShapetonShapes", "ShapePhantom", ["--shape", "figure2.7a", "--size", "96,96,96"]),
    ("ShapetonVessels", "ShapePhantom", ["--shape", "vessels", "--size", "128,128,128"]),
    ("ShapetonColon", "ColonPhantom", ["--size", "256,256,240"]),
)


def makePhantom(name, tool, arguments):
    """Makes a phantom in Slicer's cache and loads it."""
    folder = os.path.join(slicer.app.temporaryPath, "Shapeton", name)
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, "volume.nrrd")

    def run(program, *words):
        result = subprocess.run([toolPath(program), *words, "--quiet"], env=toolEnvironment(), capture_output=True, text=True)
        if result.returncode != 0:
            raise RuntimeError(result.stderr.strip() or f"{program} ended with status {result.returncode}")

    if tool == "ColonPhantom":
        run(tool, os.path.join(folder, "series"), *arguments)
        run("DicomSeriesToImage", os.path.join(folder, "series"), path)
    else:
        run(tool, path, *arguments)
    return slicer.util.loadVolume(path, {"name": name})


def registerSampleData():
    import SampleData

    if "Shapeton" in getattr(slicer.modules, "sampleDataSources", {}):
        return
    for name, tool, arguments in phantoms:
        SampleData.SampleDataLogic.registerCustomSampleDataSource(
            category="Shapeton", sampleName=name, uris="", fileNames=f"{name}.nrrd", nodeNames=name,
            customDownloader=lambda source, phantom=(name, tool, arguments): makePhantom(*phantom),
        )
