"""A tool, its functions in Python and the library have the same defaults."""

import inspect
import os
import re
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import shapeton
from shapeton import colon, flattening, graphs, shapes, surfaces

import test_colon_tools
import test_same_as_tools
from support import TOOLS as FOLDER, TestCase, needs_tools

REPOSITORY = Path(__file__).parents[3]

#: The functions equivalent to a tool. Options are searched among their parameters.
TOOLS = {
    "ColonFlattening": [flattening.flatten_tube, colon.FlatColon, surfaces.read_surface, shapeton.read_volume],
    "ColonFolds": [colon.find_folds, colon.FlatColon, surfaces.read_surface],
    "ColonLandmarks": [colon.find_landmarks, surfaces.read_surface, shapeton.read_volume],
    "ColonPhantom": [colon.colon_phantom],
    "ColonPolyps": [colon.find_candidates],
    "ColonRegistration": [colon.register_positions],
    "ColonSegmentation": [colon.build_colon, shapeton.read_volume],
    "ConformalMap": [flattening.conformal_map, surfaces.heat_diffusion_metric, surfaces.read_surface],
    "CumulativeHeatDiffusion": [shapeton.diffuse_heat, shapeton.recorded_steps, shapeton.read_volume],
    "DicomSeriesInspector": [shapeton.list_series],
    "DicomSeriesToImage": [shapeton.read_volume],
    "GraphCompare": [graphs.compare_graphs],
    "GraphConformalType": [graphs.conformal_type],
    "GraphCurvature": [graphs.ricci_curvature, graphs.embed_graph],
    "GraphEmbedding": [graphs.embed_graph, surfaces.read_surface],
    "GraphEmbeddingVerifier": [graphs.verify_embedding],
    "HeatObjects": [shapeton.find_objects, shapeton.read_volume],
    "SeededHeatSegmentation": [shapes.SeededHeat, shapeton.read_volume],
    "ShapeSearch": [shapes.find_shape],
    "ShapeSignature": [shapes.describe_shapes, shapeton.read_volume],
    "ShapetonDiffusion": [shapeton.diffuse_shapetons, shapeton.read_volume],
    "SurfaceInspector": [surfaces.inspect_surface, surfaces.read_surface],
    "SurfaceRicciFlow": [flattening.flow_surface, surfaces.read_surface],
    "SurfaceSpectrum": [surfaces.spectrum, surfaces.read_surface],
}

#: Tools without a function in the package.
TOOLS_ALONE = {"ColonResultsToDicom", "ColonViewer", "DicomResultsToColon", "DynamicGraph", "HeatTransferFunction",
               "SensorNetworkSimulator", "ShapePhantom", "ShapetonSession", "VirtualColonoscopy"}

#: Options with a parameter that differs from the option name in snake case.
NAMES = {
    ("ConformalMap", "metric"): "edge_lengths",
}

#: Keywords and special values of tools, and their equivalents in Python.
MEANINGS = {
    ("ColonFlattening", "eigenpairs"): {50: None},
    ("ConformalMap", "metric"): {"euclidean": None},
    ("ConformalMap", "time"): {0: None},
    ("GraphConformalType", "maximumRadius"): {"auto": None},
    ("GraphEmbedding", "genus"): {"auto": None},
    ("CumulativeHeatDiffusion", "p"): {"auto": None},
    ("CumulativeHeatDiffusion", "smoothing"): {"auto": None},
    ("CumulativeHeatDiffusion", "timeSteps"): {"auto": None},
    ("ShapetonDiffusion", "featureSize"): {0: None},
    ("ShapetonDiffusion", "directionSampling"): {"preset": None},
    ("ShapetonDiffusion", "distance"): {"auto": None},
    ("ShapetonDiffusion", "p"): {"auto": None},
    ("ShapetonDiffusion", "pathRule"): {"preset": None},
    ("ShapetonDiffusion", "placement"): {"preset": None},
    ("ShapetonDiffusion", "shapetons"): {"auto": None},
    ("ShapetonDiffusion", "smoothing"): {"auto": None},
    ("ShapetonDiffusion", "timeSteps"): {"auto": None},
}

#: Options without a parameter: replaced by a separate function or a value of another parameter, or about
#: files that only the tool writes.
OPTIONS_ALONE = {
    "threads": "set_threads",
    "device": "equal bytes on every device",
    "autoParameters": "p=None",
    "resume": "checkpoints of the tool",
    "labelMap": "a DICOM file of the tool",
    "surfaceFormat": "files of the tool",
    ("ColonFlattening", "coloring"): "a picture",
    ("ColonFolds", "publishedHigh"): "scheme \"published\" with fixed values",
    ("ColonFolds", "publishedLow"): "scheme \"published\" with fixed values",
    ("ColonLandmarks", "split"): "split_colon",
    ("ColonPhantom", "anatomicalTaeniae"): "a parameter of the tool",
    ("ColonPhantom", "center"): "the field of view of the tool",
    ("ColonPhantom", "contents"): "organs of the tool",
    ("ColonPhantom", "direction"): "Image.from_affine",
    ("ColonPhantom", "lungs"): "organs of the tool",
    ("ColonSegmentation", "inputIsLumen"): "build_colon_of_lumen",
    ("CumulativeHeatDiffusion", "histogramScale"): "a picture",
    ("CumulativeHeatDiffusion", "snapshots"): "the number of recorded_steps",
    ("GraphCompare", "labels"): "a picture",
    ("GraphConformalType", "planarPart"): "planar_part",
    ("GraphCurvature", "labels"): "a picture",
    ("GraphEmbedding", "disk"): "a picture",
    ("HeatObjects", "climb"): "HeatObject.parent",
    ("SeededHeatSegmentation", "automaticSeeds"): "seeds_of_classes",
    ("SeededHeatSegmentation", "components"): "seeds_of_classes, which does not separate components by default",
    ("ShapetonDiffusion", "previewEvery"): "progress",
}

def options_of(tool):
    """Yields (name, default) of each option with a default: a number, a list of numbers, True, False or a keyword."""
    for element in ElementTree.parse(os.path.join(FOLDER, f"{tool}.xml")).iterfind("parameters/*"):
        text = element.findtext("default") or ""
        if element.find("longflag") is None or not text:
            continue
        if element.tag == "boolean":
            yield element.findtext("name"), text == "true"
        elif element.tag.endswith("-vector"):
            read = str if element.tag == "string-vector" else float
            yield element.findtext("name"), [read(n) for n in text.split(",")]
        else:
            is_number = re.fullmatch(r"[-+0-9.eE]+", text)
            yield element.findtext("name"), float(text) if is_number else text


def defaults_of(function):
    """Returns the defaults of a function by parameter, tuples as lists."""
    parameters = inspect.signature(function).parameters.values()
    defaults = {p.name: p.default for p in parameters if p.default is not inspect.Parameter.empty}
    return {name: list(default) if isinstance(default, tuple) else default for name, default in defaults.items()}


def small(name):
    """Converts seriesUID to series_uid."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()


def is_left_to_the_preset(tool, default):
    return tool == "ColonPhantom" and default in (-1.0, "preset")


class DefaultsTest(TestCase):
    def test_each_tool_has_functions_or_none(self):
        tools = {path.stem for path in (REPOSITORY / "Applications").glob("*/*.xml")}
        self.assertEqual(set(TOOLS) | TOOLS_ALONE, tools)
        self.assertFalse(set(TOOLS) & TOOLS_ALONE)

    @needs_tools
    def test_each_option_of_a_tool_has_the_default_of_its_parameter(self):
        for tool, functions in TOOLS.items():
            defaults = {}
            for function in reversed(functions):
                defaults.update(defaults_of(function))
            for option, default in options_of(tool):
                key = (tool, option)
                if is_left_to_the_preset(tool, default) or key in OPTIONS_ALONE or option in OPTIONS_ALONE:
                    continue
                with self.subTest(tool, option=option):
                    parameter = NAMES.get(key, small(option))
                    self.assertIn(parameter, defaults, "not a parameter: add it to NAMES or OPTIONS_ALONE")
                    if not isinstance(default, list):
                        default = MEANINGS.get(key, MEANINGS.get(option, {})).get(default, default)
                    self.assertEqual(defaults[parameter], default)

    @needs_tools
    def test_the_time_step_is_exactly_a_twelfth(self):
        self.assertEqual(dict(options_of("CumulativeHeatDiffusion"))["timeStepLength"], 1.0 / 12.0)

    def test_the_bytes_of_each_tool_are_compared(self):
        methods = [*vars(test_same_as_tools.SameAsToolsTest), *vars(test_colon_tools.SameAsToolsTest)]
        self.assertLessEqual({f"test_{tool}" for tool in TOOLS}, set(methods))


if __name__ == "__main__":
    unittest.main()
