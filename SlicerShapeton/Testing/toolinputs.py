"""Small inputs of all tools, and the arguments that a panel of 3D Slicer passes to a tool.

The volumes are oblique and anisotropic."""

import os
import subprocess
import xml.etree.ElementTree

# Parameters that are nodes in Slicer's scene; they reach a tool as files.
torus = os.path.join(os.path.dirname(__file__), "..", "..", "Data", "Torus.off")
nodeTags = ("image", "geometry", "table", "pointfile", "transform", "measurement")
oblique = ["--direction", "0.96,-0.28,0,0.28,0.96,0,0,0,1", "--spacing", "1,1.2,1.5"]


class Tools:
    """Runs the tools of a folder."""

    def __init__(self, folder):
        self.folder = folder

    def run(self, name, *arguments):
        command = [os.path.join(self.folder, name), *map(str, arguments), "--quiet"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def makeInputs(tools, folder, patient):
    """Returns what must be chosen for each tool, by tool and parameter: the paths of files. `patient`: a folder
    with the DICOM series of a colon phantom."""

    def path(name):
        return os.path.join(folder, name)

    run = tools.run
    run("ShapePhantom", path("shapes.nrrd"), "--shape", "figure2.7a", "--size", "72,66,60", "--labels", path("labels.nrrd"), *oblique)
    run("CumulativeHeatDiffusion", path("shapes.nrrd"), path("heat.nrrd"), "--labels", path("classes.nrrd"))
    run("ShapeSignature", path("shapes.nrrd"), path("labels.nrrd"), path("shapes.csv"))
    run("ShapeSearch", path("shapes.csv"), path("shapes.sqlite"), "--add", "phantom")
    run("SensorNetworkSimulator", path("network"), "--nodes", 150, "--steps", 2)
    run("GraphEmbedding", path("network/step-0000.graphml"), path("certificate.json"))
    run("SurfaceSpectrum", torus, path("torus.csv"), "--eigenpairs", 8, "--heatKernelSignature", path("torus.vtp"))
    run("VirtualColonoscopy", patient, path("colon"), "--faces", 20000)
    run("ColonResultsToDicom", path("colon"), path("dicom"), "--source", patient)
    side = range(12)  # a grid graph
    edges = [(12 * row + column, 12 * row + column + step) for row in side for column in side for step in (1, 12)]
    with open(path("grid.txt"), "w") as file:
        file.writelines(f"{a} {b}\n" for a, b in edges if b < 144 and (b - a == 12 or b % 12))
    shapes, flat = {"inputVolume": path("shapes.nrrd")}, path("colon/flattening/flat.vtp")
    colon, graph = path("colon"), path("network/step-0000.graphml")
    wall, centerline = path("colon/segmentation/wall.vtp"), path("colon/segmentation/centerline.vtp")
    return {
        "ColonFlattening": {"inputSurface": wall},
        "ColonFolds": {"inputFlat": flat},
        "ColonLandmarks": {"inputFlat": flat, "inputCenterline": centerline},
        "ColonPhantom": {},
        "ColonPolyps": {"inputFolder": colon},
        "ColonRegistration": {"supineFolder": colon, "proneFolder": colon},
        "ColonResultsToDicom": {"exam": colon, "source": patient},
        "ColonSegmentation": {"inputVolume": patient},
        "ColonViewer": {"exam": colon},
        "ConformalMap": {"inputSurface": flat},
        "CumulativeHeatDiffusion": shapes,
        "DicomResultsToColon": {"input": path("dicom/seg.dcm"), "source": patient, "labels": path("from-dicom.nrrd")},
        "DicomSeriesInspector": {"inputFolder": patient},
        "DicomSeriesToImage": {"inputVolume": patient},
        "DynamicGraph": {"sequenceFolder": path("network")},
        "GraphCompare": {"graphA": graph, "graphB": path("network/step-0001.graphml")},
        "GraphConformalType": {"graph": path("grid.txt")},
        "GraphCurvature": {"graph": graph},
        "GraphEmbedding": {"graph": graph},
        "GraphEmbeddingVerifier": {"certificate": path("certificate.json")},
        "HeatObjects": {**shapes, "heatVolume": path("heat.nrrd")},
        "HeatTransferFunction": {**shapes, "heatVolume": path("heat.nrrd")},
        "SeededHeatSegmentation": {**shapes, "seeds": path("classes.nrrd")},
        "SensorNetworkSimulator": {},
        "ShapePhantom": {},
        "ShapeSearch": {"table": path("shapes.csv"), "database": path("shapes.sqlite")},
        "ShapeSignature": {**shapes, "labels": path("labels.nrrd")},
        "ShapetonDiffusion": shapes,
        "ShapetonSession": shapes,
        "SurfaceInspector": {"inputSurface": wall},
        "SurfaceRicciFlow": {"inputSurface": path("torus.vtp")},
        "SurfaceSpectrum": {"inputSurface": wall},
        "VirtualColonoscopy": {"inputVolume": patient},
    }


def parametersOf(description):
    """The elements of all parameters of a tool's XML file, in its order."""
    root = xml.etree.ElementTree.parse(description).getroot()
    return [parameter for group in root.iter("parameters") for parameter in group if parameter.find("name") is not None]


def extensionOf(parameter):
    """The extension of the file that Slicer writes or expects for a parameter."""
    listed = parameter.get("fileExtensions")
    if listed:
        return listed.split(",")[0]
    return {"image": ".nrrd", "geometry": ".vtp", "table": ".csv", "pointfile": ".mrk.json"}.get(parameter.tag, "")


def argumentsOfPanel(description, values, outputFolder):
    """What vtkSlicerCLIModuleLogic passes on Apply when only `values` were chosen: each number and enumeration
    with its default, texts, vectors and files that are not empty, the current folder for an optional <directory>, and the
    positional arguments, of which outputs get names in `outputFolder`."""
    options, positional = [], []
    for parameter in parametersOf(description):
        name, default = parameter.findtext("name"), (parameter.findtext("default") or "").strip()
        if parameter.find("index") is not None:
            value = values.get(name) or os.path.join(outputFolder, name + extensionOf(parameter))
            positional.append((int(parameter.findtext("index")), value))
        elif name in values:
            options += [f"--{name}", values[name]]
        elif parameter.find("longflag") is None or parameter.tag in (*nodeTags, "point", "region"):
            continue  # a value that is returned, or no node
        elif parameter.tag == "boolean":
            options += [f"--{name}"] * (default == "true")
        elif parameter.tag == "directory":
            options += [f"--{name}", default or "."]
        elif default or not (parameter.tag in ("file", "string") or parameter.tag.endswith("-vector")):
            options += [f"--{name}", default]
    return options + ["--returnparameterfile", os.path.join(outputFolder, "returned")] + [value for _, value in sorted(positional)]
