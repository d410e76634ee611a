"""The progress of each function increases to 1, which is reported once at the end."""

import inspect
import unittest

import numpy as np

import shapeton
from shapeton import _shapeton, colon, flattening, graphs, shapes, surfaces

from support import DATA, TestCase, balls, cylinder, public_functions

SERIES = DATA / "PhantomSeries"


def seeds_of(image):
    seeds = np.zeros(image.array.shape, np.uint16)
    seeds[0, 0, 0], seeds[np.unravel_index(image.array.argmax(), seeds.shape)] = 1, 2
    return image.like(seeds)


class Position:
    """The stages of a small synthetic patient needed by later ones."""

    def __init__(self, name):
        self.phantom = colon.colon_phantom(position=name, size=(120, 120, 112), spacing=(3.0, 3.0, 3.0))
        self.model = colon.build_colon_of_lumen(self.phantom.lumen, faces=20000)
        self.line, self.wall = self.model.centerline.curve, self.model.wall.simplified
        self.flat = colon.FlatColon(flattening.flatten_tube(self.wall, self.line, metric="euclidean").flat)
        self.folds = colon.find_folds(self.flat)
        self.landmarks = colon.find_landmarks(self.flat, self.line)
        self.position = colon.ColonPosition(name, self.landmarks, self.line, self.folds)


class ProgressTest(TestCase):
    reporting = set()  # the tested functions

    @classmethod
    def setUpClass(cls):
        _shapeton._set_progress_period(0)  # receives every report
        cls.addClassCleanup(_shapeton._set_progress_period, 100)

    def check(self, function, *arguments, **options):
        self.reporting.add(function.__name__)
        with self.subTest(function.__name__, **{n: o for n, o in options.items() if isinstance(o, (str, int))}):
            reports = []
            function(*arguments, progress=lambda share, stage: reports.append((share, stage)), **options)
            shares = [share for share, _ in reports]
            self.assertEqual(shares, sorted(shares))
            self.assertGreaterEqual(shares[0], 0.0)
            self.assertEqual((shares[-1], shares.count(1.0)), (1.0, 1))
            self.assertTrue(all(stage for _, stage in reports), reports)

    def test_volumes(self):
        image = balls()
        path = self.folder / "volume.nrrd"
        shapeton.write_volume(image, path)
        self.check(shapeton.read_volume, SERIES)
        self.check(shapeton.read_volume, path)
        self.check(shapeton.list_series, SERIES)
        for solver in ("chebyshev", "explicit"):
            self.check(shapeton.diffuse_heat, image, preset="published", time_steps=100, solver=solver)
        self.check(shapeton.diffuse_heat, image, preset="published", time_steps=10**6, until_steady=True)
        self.check(shapeton.diffuse_heat, image, preset="published", time_steps=100, histogram_steps=[0, 50], components=True, initial_heat=True)
        self.check(shapeton.diffuse_heat, image.like(np.zeros_like(image.array)), preset="published", time_steps=100)
        self.check(shapeton.find_objects, shapeton.diffuse_heat(image).heat)
        self.check(shapeton.diffuse_shapetons, image, shapetons=100, time_steps=20)
        self.check(shapeton.diffuse_shapetons, image, time_steps=10**6, until_steady=True)

    def test_shapes(self):
        image = balls()
        heat = shapes.SeededHeat(image)
        seeds = seeds_of(image)
        self.check(heat.segment, seeds)
        self.check(heat.segment, seeds)  # starts from the solution
        many = seeds.array.copy()
        many[5, 5, 5:12] = range(3, 10)
        self.check(heat.segment, image.like(many))
        labels = image.like((image.array > 250.0).astype(np.uint8))
        for components in (False, True):
            self.check(shapes.describe_shapes, labels, labels, components=components)

    def test_graphs(self):
        grid, rotation = graphs.torus_grid(6, 5)
        for graph in (graphs.grid_graph(5, 4), graphs.complete_graph(7), graphs.complete_graph(8), graphs.Graph(1, [])):
            self.check(graphs.embed_graph, graph)
        self.check(graphs.embed_graph, grid, rotation=rotation)
        self.check(graphs.compare_graphs, grid, graphs.grid_graph(6, 5))
        self.check(graphs.compare_graphs, grid, grid)
        for method in ("ollivier", "forman"):
            self.check(graphs.ricci_curvature, grid, method=method)
        tilings = [graphs.regular_tiling_graph(3, 6, radius) for radius in (2, 4, 6)]
        self.check(graphs.conformal_type, tilings[-1])
        self.check(graphs.conformal_type_of_sequence, tilings, [0] * len(tilings))

    def test_surfaces(self):
        tube = cylinder(15.0, 80.0)
        self.check(surfaces.spectrum, tube)
        self.check(surfaces.heat_diffusion_metric, tube)
        self.check(surfaces.heat_diffusion_metric, tube, eigenpairs=20)
        self.check(surfaces.diffuse_over_surface, tube, np.ones((len(tube.vertices), 3)), 5.0)
        self.check(surfaces.simplify_surface, tube, 500)
        self.check(surfaces.simplify_surface, tube, 10**6)
        self.check(surfaces.remesh_surface, tube, 4.0)
        for domain in ("annulus", "slit"):
            self.check(flattening.conformal_map, tube, domain=domain)
        self.check(flattening.flow_surface, tube)
        for metric in ("heatDiffusion", "euclidean", "truncatedHeatDiffusion"):
            self.check(flattening.flatten_tube, tube, metric=metric)
        for topology in ("raw", "denoised", "published"):
            handled = surfaces.read_surface(DATA / "../Applications/ColonFlattening/Testing/Tube.off")
            self.check(flattening.flatten_tube, handled, topology=topology, metric="euclidean")

    def test_colon(self):
        self.check(colon.colon_phantom, size=(60, 60, 56), spacing=(6.0, 6.0, 6.0))
        self.check(colon.colon_phantom, size=(60, 60, 56), spacing=(6.0, 6.0, 6.0), truth_only=True)
        supine, prone = Position("supine"), Position("prone")
        ct, mask, line = supine.phantom.ct, supine.phantom.lumen, supine.line
        lumen = colon.segment_lumen(ct)
        self.check(colon.segment_lumen, ct)
        self.check(colon.cleanse, ct, lumen)
        self.check(colon.trace_centerline, mask)
        self.check(colon.build_wall, colon.cleanse(ct, lumen).occupancy, line)
        self.check(colon.build_wall_of_mask, mask, line)
        self.check(colon.build_colon, ct, faces=20000)
        self.check(colon.build_colon_of_lumen, mask, faces=20000)
        for scheme in ("graphCut", "published"):
            self.check(colon.find_folds, supine.flat, scheme=scheme)
        self.check(colon.find_landmarks, supine.flat, line)
        self.check(colon.split_colon, supine.landmarks)
        self.check(colon.find_candidates, supine.model.wall.repaired, mask)
        self.check(colon.find_candidates, supine.model.wall.repaired, mask, centerline=line, ct=ct, flat=supine.flat)
        for name in ("default", "published"):
            self.check(colon.register_positions, supine.position, prone.position, map=name)

    def test_what_fails_does_not_reach_the_end(self):
        shares = []
        with self.assertRaises(shapeton.Error):
            colon.trace_centerline(
                shapeton.Image(np.zeros((8, 8, 8), np.uint8)), progress=lambda share, _: shares.append(share)
            )
        self.assertNotIn(1.0, shares)

    def test_z_each_function_with_progress_was_checked(self):
        """Runs last by name."""
        reporting = {function.__name__ for function in public_functions().values()
                     if "progress" in inspect.signature(function).parameters}
        self.assertEqual(reporting - self.reporting, set(), "add them to the tests above")


if __name__ == "__main__":
    unittest.main()
