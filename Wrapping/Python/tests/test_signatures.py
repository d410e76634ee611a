"""Signatures of the public functions, and messages about wrong arguments."""

import importlib.util
import inspect
import os
import pickle
import subprocess
import sys
import typing
import unittest
from pathlib import Path

import numpy as np

import shapeton
from shapeton import colon, flattening, graphs, shapes, surfaces

from support import TestCase, balls, cylinder, public_functions

#: A program with each kind of argument and result.
PROGRAM = """
from pathlib import Path
from typing import List, Optional, Tuple

import numpy as np

import shapeton
from shapeton import colon, flattening, graphs, shapes, surfaces


def tell(share: float, stage: str) -> bool:
    return share < 1.0


ct: shapeton.Image = shapeton.read_volume(Path("ct"), series_uid="1.2", progress=tell)
heat: shapeton.HeatResult = shapeton.diffuse_heat(ct, p=None, intensity_window=(0.0, 1.0), histogram_steps=[1, 2])
classes: Tuple[shapeton.Image, List[shapeton.HeatClass]] = shapeton.classify_heat(heat.heat, heat.components)
labels: shapeton.Image = shapes.SeededHeat(ct).segment(ct).labels
model: colon.ColonModel = colon.build_colon(ct, position="supine", seed_point=[(1.0, 2.0, 3.0)], progress=tell)
line: shapeton.Curves = colon.trace_centerline(ct, start=np.zeros(3), seed_point=np.zeros((2, 3))).curve
flat: colon.FlatColon = colon.FlatColon(flattening.flatten_tube(model.wall.simplified, line).flat, pixel_size=2)
valve: Optional[colon.IleocecalValve] = colon.find_valve(ct, line)[0]
graph = graphs.Graph(2, [(0, 1)])
certificate: graphs.EmbeddingCertificate = graphs.embed_graph(graph, genus=0)
times: List[float] = surfaces.spectrum(model.wall.simplified).signature_times(5)
surfaces.write_surface(model.wall.simplified, "wall.vtp")
"""


class SignatureTest(TestCase):
    def test_each_parameter_is_named_and_annotated(self):
        for name, function in public_functions().items():
            with self.subTest(name):
                signature = inspect.signature(function)
                hints = typing.get_type_hints(function)
                for parameter in signature.parameters.values():
                    self.assertNotIn(parameter.kind, (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD))
                    self.assertIn(parameter.name, {*hints, "self"})
                self.assertIn("return", hints)

    def test_classes_have_the_signature_of_their_constructor(self):
        for kind, names in (
            (colon.ColonPosition, ["name", "landmarks", "centerline", "folds"]),
            (colon.FlatColon, ["surface", "pixel_size"]),
            (graphs.Graph, ["nodes", "edges", "names"]),
            (shapes.NamedShape, ["name", "signature"]),
            (shapes.SeededHeat, ["image", "domain", "p", "intensity_window", "least_weight", "tolerance"]),
        ):
            self.assertEqual(list(inspect.signature(kind).parameters), names)

    def test_functions_can_be_pickled(self):
        for name, function in public_functions().items():
            if "." not in name:
                self.assertIs(pickle.loads(pickle.dumps(function)), function)

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
    def test_a_type_checker_accepts_a_program_and_finds_its_errors(self):
        path = self.folder / "program.py"
        options = ["--strict", "--follow-imports=silent", "--cache-dir", str(self.folder / "cache")]
        environment = {**os.environ, "MYPYPATH": str(Path(shapeton.__file__).parents[1])}
        for wrong, result in (("", "^Success"), ("shapeton.diffuse_heat(ct, time_step=3)\nheat.heat + 1\n", "call-arg.*operator")):
            path.write_text(PROGRAM + wrong)
            command = [sys.executable, "-m", "mypy", *options, str(path)]
            done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
            self.assertRegex(done.stdout.replace("\n", " "), result)


class ArgumentTest(TestCase):
    def setUp(self):
        super().setUp()
        self.image, self.tube = balls((8, 8, 8)), cylinder(15.0, 80.0)

    def assertRefused(self, message, call, *arguments, **options):
        with self.assertRaises(TypeError) as caught:
            call(*arguments, **options)
        self.assertEqual(str(caught.exception), message)

    def test_a_near_name_is_suggested(self):
        self.assertRefused(
            'diffuse_heat() has no argument "time_step"; did you mean "time_steps"?',
            shapeton.diffuse_heat, self.image, time_step=5)  # fmt: skip
        self.assertRefused(
            'SeededHeat() has no argument "leastweight"; did you mean "least_weight"?',
            shapes.SeededHeat, self.image, leastweight=0.1)  # fmt: skip
        self.assertRefused(
            'FlatColon() has no argument "pixelSize"; did you mean "pixel_size"?',
            colon.FlatColon, self.tube, pixelSize=1.0)  # fmt: skip
        self.assertRefused(
            'complete_graph() has no argument "xyz"; it has nodes', graphs.complete_graph, xyz=3)  # fmt: skip

    def test_missing_and_surplus_arguments_are_named(self):
        self.assertRefused("diffuse_heat(): missing a required argument: 'image'", shapeton.diffuse_heat)
        self.assertRefused("threads(): too many positional arguments", shapeton.threads, 3)
        self.assertRefused(
            "diffuse_heat(): too many positional arguments; give it by name, for example preset='published'",
            shapeton.diffuse_heat, self.image, "published")  # fmt: skip

    def test_a_wrong_type_is_named(self):
        for words, call, wrong in (
            ('"time_steps" must be a whole number or None, not float 5.0', shapeton.diffuse_heat, {"time_steps": 5.0}),
            ('"time_steps" must be a whole number or None, not bool True', shapeton.diffuse_heat, {"time_steps": True}),
            ('"p" must be a number or None, not str \'7\'', shapeton.diffuse_heat, {"p": "7"}),
            ('"solver" must be a str, not None', shapeton.diffuse_heat, {"solver": None}),
            ('"until_steady" must be True or False, not int 1', shapeton.diffuse_heat, {"until_steady": 1}),
            ('"intensity_window" must be (a number, a number) or None, not list [1.0, 2.0, 3.0]',
             shapeton.diffuse_heat, {"intensity_window": [1.0, 2.0, 3.0]}),
            ('"histogram_steps" must be a sequence, each a whole number, not list [1.5]',
             shapeton.diffuse_heat, {"histogram_steps": [1.5]}),
            ('"progress" must be a function or None, not int 3', shapeton.diffuse_heat, {"progress": 3}),
            ('"mask" must be a shapeton.Image or None, not an array of shape (2, 2, 2); wrap it in shapeton.Image(array, spacing)',
             shapeton.diffuse_shapetons, {"mask": np.zeros((2, 2, 2))}),
            ('"seed_point" must be k x 3 numbers, not list [1.0, 2.0, 3.0]', colon.segment_lumen, {"seed_point": [1.0, 2.0, 3.0]}),
            ('"start" must be three numbers or None, not list [1.0, 2.0]', colon.trace_centerline, {"start": [1.0, 2.0]}),
        ):  # fmt: skip
            self.assertRefused(f"{call.__name__}(): the argument {words}", call, self.image, **wrong)
        self.assertRefused(
            'flatten_tube(): the argument "cut" must be a shapeton.Curves or an array of n x 3 numbers or None, not str \'x\'',
            flattening.flatten_tube, self.tube, cut="x")  # fmt: skip
        self.assertRefused('read_volume(): the argument "path" must be a path, not int 3', shapeton.read_volume, 3)
        self.assertRefused(
            'verify_embedding(): the argument "certificate" must be a shapeton.graphs.EmbeddingCertificate, not None',
            graphs.verify_embedding, None)  # fmt: skip

    def test_an_array_without_geometry_is_wrapped(self):
        self.assertRefused(
            'diffuse_heat(): the argument "image" must be a shapeton.Image, not an array of shape (3, 3, 3); '
            "wrap it in shapeton.Image(array, spacing)",
            shapeton.diffuse_heat, np.zeros((3, 3, 3)))  # fmt: skip
        self.assertRefused(
            'spectrum(): the argument "mesh" must be a shapeton.Mesh, not an array of shape (3, 3); '
            "wrap it in shapeton.Mesh(vertices, faces)",
            surfaces.spectrum, np.zeros((3, 3)))  # fmt: skip

    def test_numbers_of_numpy_are_numbers(self):
        result = shapeton.diffuse_heat(
            self.image,
            p=np.float32(7.0),
            time_steps=np.int64(4),
            intensity_window=np.array([0.0, 500.0]),
            histogram_steps=np.arange(5),
            until_steady=np.bool_(False),
        )
        self.assertEqual(result.histogram.time_steps, [0, 1, 2, 3, 4])

    def test_a_missing_file_is_a_file_not_found_error(self):
        missing = self.folder / "missing"
        for read in (
            shapeton.read_volume,
            shapeton.list_series,
            surfaces.read_surface,
            surfaces.read_curves,
            graphs.read_graph,
            graphs.read_certificate,
            shapes.read_shape_table,
            shapes.read_shape_database,
            lambda path: colon.read_position(path, "supine"),
        ):
            with self.assertRaisesRegex(FileNotFoundError, "missing") as caught:
                read(missing)
            self.assertIsInstance(caught.exception, shapeton.MissingFileError)
        path = self.folder / "text.nrrd"
        path.write_text("no volume")
        with self.assertRaises(shapeton.InputError) as caught:
            shapeton.read_volume(path)
        self.assertNotIsInstance(caught.exception, FileNotFoundError)

    def test_messages_name_parameters_as_python_does(self):
        for words, wrong in (
            ('the parameter "time_step_length"', {"time_step_length": 0.2}),
            ('the histogram steps must be ascending and at most the parameter "time_steps"', {"histogram_steps": [5, 3]}),
            ('the parameter "snapshot_steps"', {"snapshot_steps": [5, 3], "snapshot": print}),
            ('the parameter "time_steps"', {"time_steps": 0}),
            ('the parameter "time_steps".*is out of range', {"time_steps": -1}),
            ('the parameter "intensity_window"', {"intensity_window": (3.0, 1.0)}),
            ('the parameter "solver": "fast" is not one of chebyshev, explicit', {"solver": "fast"}),
        ):  # fmt: skip
            with self.assertRaisesRegex(shapeton.ParameterError, words):
                shapeton.diffuse_heat(self.image, **wrong)
        with self.assertRaisesRegex(shapeton.ParameterError, 'the parameter "direction_sampling"'):
            shapeton.diffuse_shapetons(self.image, direction_sampling="any")
        with self.assertRaisesRegex(shapeton.ParameterError, 'the histogram steps .* the parameter "time_steps"'):
            shapeton.diffuse_shapetons(self.image, histogram_steps=[0])
        with self.assertRaisesRegex(shapeton.ParameterError, 'the parameter "least_weight"'):
            shapes.SeededHeat(self.image, least_weight=2.0).segment(self.image.like(np.arange(512).reshape(8, 8, 8) % 3))
        with self.assertRaisesRegex(shapeton.ParameterError, '"metric": "x" is not one of euclidean, heatDiffusion'):
            flattening.flatten_tube(self.tube, metric="x")
        with self.assertRaisesRegex(shapeton.ParameterError, '"snapshot_spacing": "x" is not one of linear, logarithmic'):
            shapeton.recorded_steps(10, 5, "x")


if __name__ == "__main__":
    unittest.main()
