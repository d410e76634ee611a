"""Run by 3D Slicer (InSlicer.cmake) with all command-line modules and both scripted modules; the argument is the folder for
results and screenshots. Prints a line for each check; the exit status is 0 if all pass."""

import json
import os
import sys
import time
import traceback

import numpy
import qt
import slicer
import vtk

here = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [here, os.path.join(os.path.dirname(here), "Examples")]
from find_objects import findObjects  # noqa: E402
from ShapetonLib.sampledata import registerSampleData  # noqa: E402
from toolinputs import Tools, extensionOf, makeInputs, nodeTags, parametersOf  # noqa: E402

work, tools = sys.argv[-1], os.environ["SHAPETON_TOOLS"]
nodeClasses = {"image": "vtkMRMLScalarVolumeNode", "geometry": "vtkMRMLModelNode", "table": "vtkMRMLTableNode"}
pointClasses = {"point": "vtkMRMLMarkupsFiducialNode", "curve": "vtkMRMLMarkupsCurveNode"}
failures = []


def check(condition, message):
    if not condition:
        raise AssertionError(message)


def report(name, test, *arguments):
    begin = time.monotonic()
    try:
        detail = test(*arguments) or ""
        print(f"ok {name}: {detail} ({time.monotonic() - begin:.1f} s)", flush=True)
    except Exception as error:
        traceback.print_exc()
        failures.append(name)
        print(f"FAILED {name}: {error}", flush=True)


def waitFor(condition, seconds, what):
    end = time.monotonic() + seconds
    while not condition():
        check(time.monotonic() < end, f"{what} took more than {seconds} s")
        slicer.app.processEvents()
        time.sleep(0.01)


def clearScene():
    """Closes the scene; pending requests for its nodes come first."""
    slicer.app.processEvents()
    slicer.mrmlScene.Clear(0)


def screenshot(name):
    for _ in range(5):
        slicer.app.processEvents()
        slicer.app.layoutManager().threeDWidget(0).threeDView().forceRender()
    slicer.util.mainWindow().grab().save(os.path.join(work, name + ".png"))


# ---- command-line modules ----


def classOf(parameter):
    if parameter.tag == "pointfile":
        return pointClasses[parameter.get("type")]
    if parameter.tag == "image" and parameter.get("type") == "label":
        isSegmentation = (parameter.get("fileExtensions") or "").startswith(".seg.nrrd")
        return "vtkMRMLSegmentationNode" if isSegmentation else "vtkMRMLLabelMapVolumeNode"
    return "vtkMRMLVectorVolumeNode" if parameter.get("type") == "vector" else nodeClasses[parameter.tag]


def loaded(parameter, path):
    """The node of an input; a DICOM series is converted."""
    if os.path.isdir(path):
        converted = os.path.join(work, "inputs", "patient.nrrd")
        if not os.path.isfile(converted):
            Tools(tools).run("DicomSeriesToImage", path, converted)
        path = converted
    load = {"vtkMRMLScalarVolumeNode": slicer.util.loadVolume, "vtkMRMLLabelMapVolumeNode": slicer.util.loadLabelVolume,
            "vtkMRMLModelNode": slicer.util.loadModel}
    return load[classOf(parameter)](path)


def parametersFor(name, values):
    """Nodes for the inputs that were chosen and for all outputs that are nodes; paths for files."""
    parameters, outputs = {}, []
    for parameter in parametersOf(os.path.join(tools, name + ".xml")):
        key, isOutput = parameter.findtext("name"), parameter.findtext("channel") == "output"
        isPositional = parameter.find("index") is not None
        if parameter.tag in nodeTags and isOutput:
            parameters[key] = slicer.mrmlScene.AddNewNodeByClass(classOf(parameter), f"{name} {key}")
            outputs.append((parameter, parameters[key]))
        elif key in values:
            parameters[key] = loaded(parameter, values[key]) if parameter.tag in nodeTags else values[key]
        elif isPositional:
            parameters[key] = os.path.join(work, "outputs", f"{name}-{key}" + extensionOf(parameter))
    return parameters, outputs


def matrixOf(volume):
    matrix = vtk.vtkMatrix4x4()
    volume.GetIJKToRASMatrix(matrix)
    return slicer.util.arrayFromVTKMatrix(matrix)


def boundsOf(node):
    bounds = numpy.zeros(6)
    node.GetRASBounds(bounds)
    return bounds.reshape(3, 2)


def checkOutput(parameter, node, parameters):
    """The node has content, on the grid of its reference, or within its bounds."""
    reference = parameters.get(parameter.get("reference")) if parameter.get("reference") else None
    if node.IsA("vtkMRMLVolumeNode"):
        check(node.GetImageData() is not None, "no voxels")
        if reference is not None:
            check(numpy.allclose(matrixOf(node), matrixOf(reference), atol=1e-4), "another grid than its reference")
            check(node.GetImageData().GetDimensions() == reference.GetImageData().GetDimensions(), "another size")
    elif node.IsA("vtkMRMLSegmentationNode"):
        segmentation = node.GetSegmentation()
        check(segmentation.GetNumberOfSegments() > 0, "no segments")
        names = [segmentation.GetNthSegment(i).GetName() for i in range(segmentation.GetNumberOfSegments())]
        check(all(name.startswith(("object ", "class ")) for name in names), f"segments {names}")
    elif node.IsA("vtkMRMLModelNode"):
        check(node.GetPolyData() is not None and node.GetPolyData().GetNumberOfCells() > 0, "no faces")
    elif node.IsA("vtkMRMLTableNode"):
        check(node.GetNumberOfColumns() > 0, "no columns")
    else:
        check(node.GetNumberOfControlPoints() > 0, "no points")
    inPatient = [value for value in parameters.values() if hasattr(value, "GetRASBounds") and value is not node]
    isFlat = node.IsA("vtkMRMLVolumeNode") and reference is None  # a map has its own plane
    if inPatient and hasattr(node, "GetRASBounds") and not isFlat:
        inner, outer = boundsOf(node), boundsOf(inPatient[0])
        check((inner[:, 0] > outer[:, 0] - 5).all() and (inner[:, 1] < outer[:, 1] + 5).all(), f"{inner} is not in {outer}")


def runTool(name, values):
    module = getattr(slicer.modules, name.lower(), None)
    check(module is not None, "is not registered")
    clearScene()
    parameters, outputs = parametersFor(name, values)
    if name == "ShapetonSession":  # serves until it is canceled
        node = slicer.cli.run(module, None, parameters)
        end = time.monotonic() + 3.0
        waitFor(lambda: time.monotonic() > end, 10, "the wait")
        check(node.IsBusy(), node.GetErrorText())
        node.Cancel()
        waitFor(lambda: not node.IsBusy(), 10, "the end")
        return "served, canceled"
    node = slicer.cli.runSync(module, None, parameters)
    check(node.GetStatusString() == "Completed", f"{node.GetStatusString()}: {node.GetErrorText()}")
    check(not node.GetErrorText(), node.GetErrorText())
    for parameter, output in outputs:
        try:
            checkOutput(parameter, output, parameters)
        except AssertionError as error:
            raise AssertionError(f"{parameter.findtext('name')}: {error}") from None
    return ", ".join(parameter.findtext("name") for parameter, _ in outputs)


# ---- scripted modules ----


def widgetOf(name):
    slicer.util.selectModule(name)
    slicer.app.processEvents()
    return getattr(slicer.modules, name.lower()).widgetRepresentation().self()


def start(widget, volume, folder):
    widget.volume.setCurrentNode(volume)
    widget.panel.outputFolder.currentPath = os.path.join(work, folder)
    widget.panel.toolsFolder.currentPath = tools


def testHeat(inputs):
    clearScene()
    volume = slicer.util.loadVolume(inputs["CumulativeHeatDiffusion"]["inputVolume"])
    widget = widgetOf("ShapetonHeat")
    screenshot("heat-before")
    start(widget, volume, "heat")
    widget.onApply()
    waitFor(lambda: widget.heat is not None, 120, "the objects")
    objects = slicer.util.getNode("Objects").GetSegmentation()
    names = [objects.GetNthSegment(i).GetName() for i in range(objects.GetNumberOfSegments())]
    check(names and all(name.startswith("object ") for name in names), f"segments {names}")
    colors = {objects.GetNthSegment(i).GetColor() for i in range(objects.GetNumberOfSegments())}
    check(len(colors) == len(names), "objects of the same color")
    hierarchy = slicer.mrmlScene.GetSubjectHierarchyNode()
    check(hierarchy.GetItemByName(f"Heat of {volume.GetName()}"), "no folder")
    lines = widget.lines._table
    lines.item(0, 0).setCheckState(qt.Qt.Checked)
    widget.onRender()
    waitFor(lambda: not widget.panel.isBusy, 60, "the rendering")
    display = slicer.modules.volumerendering.logic().GetFirstVolumeRenderingDisplayNode(widget.heat)
    check(display is not None and display.GetVisibility(), "no rendering")
    screenshot("heat-after")
    return f"{len(names)} objects, {lines.rowCount} classes"


def testScene():
    """The nodes of the heat module are the same after the scene was saved, closed and loaded."""
    before = describeScene()
    path = os.path.join(work, "scene", "scene.mrml")
    os.makedirs(os.path.dirname(path), exist_ok=True)
    check(slicer.util.saveScene(path), "not saved")
    clearScene()
    widget = widgetOf("ShapetonHeat")
    check(widget.heat is None and widget.lines._table.rowCount == 0, "results stay after the scene is closed")
    slicer.util.loadScene(path)
    after = describeScene()
    check(before == after, f"{before} became {after}")
    return f"{len(after)} nodes"


def describeScene():
    described = {}
    for node in slicer.util.getNodesByClass("vtkMRMLScalarVolumeNode"):
        described[node.GetName()] = (matrixOf(node).round(4).tolist(), node.GetImageData().GetDimensions())
    for node in slicer.util.getNodesByClass("vtkMRMLSegmentationNode"):
        parts = node.GetSegmentation()
        described[node.GetName()] = [parts.GetNthSegment(i).GetName() for i in range(parts.GetNumberOfSegments())]
    for node in slicer.util.getNodesByClass("vtkMRMLTableNode"):
        described[node.GetName()] = node.GetNumberOfRows()
    return described


def testSession(inputs):
    clearScene()
    volume = slicer.util.loadVolume(inputs["CumulativeHeatDiffusion"]["inputVolume"])
    widget = widgetOf("ShapetonHeat")
    start(widget, volume, "session")
    live = widget.live
    live.onStart()
    waitFor(lambda: live.session is not None and live.session.state is not None, 60, "the start")
    points = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLMarkupsFiducialNode", "Start")
    bounds = boundsOf(volume)
    points.AddControlPoint(vtk.vtkVector3d(*bounds.mean(axis=1)))
    live.region.setCurrentNode(points)
    before = live.status.text
    live._do(live._startThere)
    waitFor(lambda: live.status.text != before and "places" not in live.status.text, 20, "the new status")
    live._do(lambda session: session.ask("objects", choose=True))
    waitFor(lambda: live.session.objects, 60, "the objects")
    labels = live.session.nodes.find("Objects")
    check(numpy.allclose(matrixOf(labels), matrixOf(volume), atol=1e-3), "the labels have another grid")
    colors = live.session.nodes.find("Object colors")
    check(colors.GetColorName(1).startswith("object 1, "), f"the first object is named {colors.GetColorName(1)}")
    first = live.session.objects[0]
    live._do(lambda session: session.ask("select", object=first["number"]))
    waitFor(lambda: live.session.state["selected"] == first["number"], 20, "the selection")
    widget.sections[0].collapsed, widget.sections[2].collapsed = True, False
    screenshot("session")
    saved = []
    live._do(lambda session: session.save("kept", saved.extend))
    waitFor(lambda: saved, 20, "the files")
    live.onStop()
    waitFor(lambda: not live.isRunning, 20, "the end")
    return f"{live.status.text}; saved {len(saved)} files"


def testColonoscopy():
    clearScene()
    volume = slicer.util.loadVolume(os.path.join(work, "inputs", "patient.nrrd"))
    widget = widgetOf("ShapetonColonoscopy")
    start(widget, volume, "colonoscopy")
    widget.onApply()
    waitFor(lambda: widget.results is not None, 600, "the examination")
    results = widget.results
    markups = 0
    for name in ("flexures", "taeniae"):
        with open(os.path.join(work, "colonoscopy", "colon", "landmarks", name + ".mrk.json")) as file:
            markups += len(json.load(file)["markups"])
    check(len(results.landmarks) == markups, f"{len(results.landmarks)} nodes of {markups} markups")
    check(results.centerline.GetNumberOfControlPoints() > 10, "no line")
    columns, rows = results.flatMap.size
    widget.onMapClick(columns // 2, rows // 2)
    screenshot("colonoscopy")
    clearScene()
    check(widget.results is None, "results stay after the scene is closed")
    return f"{len(results.landmarks)} landmarks"


def testSampleData():
    registerSampleData()  # otherwise when the startup of the application is completed
    sources = slicer.modules.sampleDataSources["Shapeton"]
    node = sources[0].customDownloader(sources[0])
    check(node is not None and node.GetImageData() is not None, "not made")
    return f"{node.GetName()} of {len(sources)}"


def testPanels(inputs):
    """Last, because Slicer may crash when a scene is closed whose command-line nodes panels refer to."""
    for name in inputs:
        slicer.util.selectModule(name)
        slicer.app.processEvents()
        check(getattr(slicer.modules, name.lower()).widgetRepresentation() is not None, f"{name} has no panel")
    return f"{len(inputs)} panels"


def testScript(inputs):
    clearScene()
    volume = slicer.util.loadVolume(inputs["CumulativeHeatDiffusion"]["inputVolume"])
    parts = findObjects(volume, os.path.join(work, "objects.csv")).GetSegmentation()
    check(parts.GetNumberOfSegments() > 0 and os.path.isfile(os.path.join(work, "objects.csv")), "no objects")
    return f"{parts.GetNumberOfSegments()} objects, the first: {parts.GetNthSegment(0).GetName()}"


def main():
    for folder in ("inputs", "outputs"):
        os.makedirs(os.path.join(work, folder), exist_ok=True)
    print(f"3D Slicer {slicer.app.applicationVersion}", flush=True)
    slicer.util.mainWindow().resize(1500, 950)
    inputs = makeInputs(Tools(tools), os.path.join(work, "inputs"), os.environ["SHAPETON_PATIENT"])
    inputs["ColonPhantom"]["size"] = "128,128,120"  # a minute less
    for name, values in sorted(inputs.items()):
        if name != "ColonRegistration":  # a second examination
            report(name, runTool, name, values)
    report("find_objects.py", testScript, inputs)
    report("Sample Data", testSampleData)
    report("Shapeton Heat", testHeat, inputs)
    report("the scene", testScene)
    report("live session", testSession, inputs)
    report("Shapeton Colonoscopy", testColonoscopy)
    report("panels", testPanels, inputs)
    print(f"failed: {', '.join(failures)}" if failures else "all tests passed in Slicer", flush=True)
    slicer.util.exit(1 if failures else 0)


main()
