import unittest

import numpy as np

import shapeton
from shapeton import Curves, Mesh, flattening, surfaces

from support import DATA, TestCase, cylinder, needs_tools, run_tool

TORUS = DATA / "Torus.off"


def icosphere(radius, divisions=3):
    """A sphere of 20 * 4^divisions faces."""
    g = (1.0 + 5.0**0.5) / 2.0
    corners = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g)]
    vertices = [np.array(c, float) for c in corners + [(g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6)]
    faces += [(7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10)]
    faces += [(8, 6, 7), (9, 8, 1)]
    for _ in range(divisions):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(vertices)
                vertices.append(0.5 * (vertices[a] + vertices[b]))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    directions = np.array([v / np.linalg.norm(v) for v in vertices])
    return Mesh(radius * directions, faces)


class MeshTest(TestCase):
    def test_arrays_are_checked_and_kept(self):
        vertices, faces = np.eye(3), np.array([[0, 1, 2]], np.int32)
        mesh = Mesh(vertices, faces, {"a": [1, 2, 3]}, {"b": [0.5]}, {"c": [[1.0, 2.0]]}, [("name", "value")])
        self.assertTrue(np.shares_memory(mesh.vertices, vertices) and np.shares_memory(mesh.faces, faces))
        for wrong in (
            lambda: Mesh(vertices[:, :2], faces),
            lambda: Mesh(vertices, [[0, 1]]),
            lambda: Mesh(vertices, [[0.0, 1.0, 2.0]]),
            lambda: Mesh(vertices, [[0, 1, -1]]),
            lambda: Mesh(vertices, [[0, 1, 2**31]]),
            lambda: Mesh(vertices.astype(complex), faces),
            lambda: Curves(vertices, [[0.5]]),
        ):
            with self.assertRaises(shapeton.ParameterError):
                wrong()
        for values in ([1, 2, 2**31], ["a", "b", "c"], [1j, 2j, 3j], np.zeros((3, 2, 2))):
            with self.assertRaisesRegex(shapeton.ParameterError, '"a"'):
                surfaces.inspect_surface(Mesh(vertices, faces, {"a": values}))

    def test_what_the_library_cannot_use_is_refused(self):
        for words, mesh in (
            ("refers to vertex 3", Mesh(np.eye(3), [[0, 1, 3]])),
            ("finite", Mesh([[0, 0, np.nan], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])),
            ("no face", Mesh(np.eye(3), np.empty((0, 3), int))),
            ("short", Mesh(np.eye(3), [[0, 1, 2]], {"short": [1.0]})),
        ):
            with self.assertRaisesRegex(shapeton.InputError, words):
                surfaces.inspect_surface(mesh)

    def test_all_of_a_surface_goes_through_a_file(self):
        mesh = icosphere(30.0, 1)
        numbers = np.arange(len(mesh.vertices))
        mesh.point_arrays.update(whole=numbers, real=numbers * 0.1, two=np.c_[numbers, -numbers] * 0.1)
        mesh.cell_arrays["part"] = np.arange(len(mesh.faces)) % 3
        mesh.field_arrays["list"] = np.array([3, 1, 4])
        mesh.facts.append(("maker", "a test"))
        path = str(self.folder / "mesh.vtp")
        surfaces.write_surface(mesh, path)
        read = surfaces.read_surface(path)
        np.testing.assert_array_equal(read.vertices, mesh.vertices)
        np.testing.assert_array_equal(read.faces, mesh.faces)
        for name, kind in (("whole", "i"), ("real", "f"), ("two", "f")):
            np.testing.assert_array_equal(read.point_arrays[name], mesh.point_arrays[name])
            self.assertEqual(read.point_arrays[name].dtype.kind, kind)
        np.testing.assert_array_equal(read.cell_arrays["part"], mesh.cell_arrays["part"])
        np.testing.assert_array_equal(read.field_arrays["list"], [3, 1, 4])
        self.assertIn(("maker", "a test"), read.facts)
        with self.assertRaisesRegex(OSError, "cannot write"):
            surfaces.write_surface(mesh, self.folder / "missing" / "mesh.vtp")

    def test_what_a_file_cannot_hold_is_refused(self):
        for words, arrays, facts in (
            ("in its name", {'a"b': [1.0, 2.0, 3.0]}, ()),
            ("in its name", {"a\0b": [1.0, 2.0, 3.0]}, ()),
            ("no column", {"a": np.zeros((3, 0))}, ()),
            ("zero byte", {}, [("fact", "a\0b")]),
        ):
            with self.assertRaisesRegex(shapeton.InputError, words):
                surfaces.write_surface(Mesh(np.eye(3), [[0, 1, 2]], arrays, facts=facts), self.folder / "none.vtp")
        self.assertFalse((self.folder / "none.vtp").exists())

    def test_curves_go_through_a_file(self):
        curves = Curves([[0, 0, 0], [1, 0, 0], [2, 0, 1], [5, 5, 5]], [[3], [0, 1, 2]], {"arcLength": [0, 1, 2.5, 9]})
        path = str(self.folder / "curves.vtp")
        surfaces.write_curves(curves, path)
        read = surfaces.read_curves(path)
        np.testing.assert_array_equal(read.points(1), curves.points(1))
        np.testing.assert_array_equal(read.point_arrays["arcLength"], curves.point_arrays["arcLength"])
        with self.assertRaisesRegex(shapeton.ParameterError, r"as \[\[0, 1, 2\]\]"):
            Curves(np.eye(3), [0, 1, 2])


class ShapeTest(TestCase):
    def test_a_sphere_has_its_area_and_volume(self):
        sphere = icosphere(20.0, 4)
        self.assertAlmostEqual(surfaces.surface_area(sphere), 4.0 * np.pi * 20.0**2, delta=0.01 * 4.0 * np.pi * 400.0)
        self.assertAlmostEqual(surfaces.enclosed_volume(sphere) / (4.0 / 3.0 * np.pi * 8000.0), 1.0, delta=0.01)
        opened = surfaces.enclosed_volume(Mesh(sphere.vertices, sphere.faces[1:]))
        self.assertAlmostEqual(opened / surfaces.enclosed_volume(sphere), 1.0, delta=0.001)
        facts = surfaces.inspect_surface(sphere)
        self.assertEqual((facts["genus"], facts["closed"], facts["faces"]), (0, True, 5120))

    def test_topology_stays_when_a_torus_is_simplified_and_remeshed(self):
        torus = surfaces.read_surface(str(TORUS))
        fewer = surfaces.simplify_surface(torus, 600)
        self.assertIn(len(fewer.faces), (599, 600))
        even = surfaces.remesh_surface(torus, 4.0)
        for mesh in (torus, fewer, even):
            self.assertEqual(surfaces.inspect_surface(mesh)["genus"], 1)
        lengths = surfaces.edge_lengths(even)
        self.assertAlmostEqual(float(lengths.mean()), 4.0, delta=0.5)
        with self.assertRaises(shapeton.Aborted):
            surfaces.simplify_surface(icosphere(20.0, 5), 600, progress=lambda *_: False)

    def test_repair_turns_faces_and_merges_vertices(self):
        sphere = icosphere(20.0, 1)
        corners = sphere.vertices[sphere.faces].reshape(-1, 3)
        soup = np.arange(len(corners)).reshape(-1, 3)
        soup[::2] = soup[::2, ::-1]
        repaired, words = surfaces.repair_surface(Mesh(corners, soup))
        self.assertEqual(len(words), 2)
        self.assertEqual(len(repaired.vertices), len(sphere.vertices))
        self.assertAlmostEqual(surfaces.enclosed_volume(repaired), surfaces.enclosed_volume(sphere), places=6)


class MetricTest(TestCase):
    def test_the_spectrum_of_a_sphere(self):
        # l (l + 1) / r^2, 2 l + 1 times
        spectrum = surfaces.spectrum(icosphere(10.0, 4), 9)
        expected = np.array([0] + 3 * [2] + 5 * [6]) / 100.0
        np.testing.assert_allclose(spectrum.eigenvalues, expected, rtol=0.01, atol=1e-9)
        time = 20.0
        kernel = [spectrum.heat_kernel(v, v, time) for v in (0, 5)]
        np.testing.assert_allclose(spectrum.signature(time)[[0, 5]], kernel)
        distances = spectrum.diffusion_distances(3, time)
        self.assertAlmostEqual(distances[7], spectrum.diffusion_distance(3, 7, time))
        self.assertEqual(distances[3], 0.0)

    def test_the_metric_is_the_distance_of_its_edges(self):
        mesh, time = icosphere(10.0, 2), 30.0
        edges = surfaces.surface_edges(mesh)
        straight = np.linalg.norm(mesh.vertices[edges[:, 0]] - mesh.vertices[edges[:, 1]], axis=1)
        np.testing.assert_allclose(surfaces.edge_lengths(mesh), straight)
        metric = surfaces.heat_diffusion_metric(mesh, time)
        spectrum = surfaces.spectrum(mesh, 40)
        expected = [spectrum.diffusion_distance(a, b, time) for a, b in edges]
        np.testing.assert_allclose(metric.edge_lengths, expected, rtol=1e-4)
        truncated = surfaces.heat_diffusion_metric(mesh, time, eigenpairs=40)
        np.testing.assert_allclose(truncated.edge_lengths, expected, rtol=1e-6)

    def test_heat_over_a_surface_keeps_its_sum(self):
        mesh = icosphere(10.0, 2)
        values = np.zeros((len(mesh.vertices), 2))
        values[0, 0], values[:, 1] = 1.0, 3.0
        smooth = surfaces.diffuse_over_surface(mesh, values, 5.0)
        np.testing.assert_allclose(smooth[:, 1], 3.0)
        self.assertLess(smooth[0, 0], 0.5)
        self.assertEqual(values[0, 0], 1.0)
        np.testing.assert_array_equal(surfaces.diffuse_over_surface(mesh, values[:, 0], 5.0), smooth[:, 0])

    def test_heat_over_a_surface_goes_in_two_implicit_steps(self):
        mesh = icosphere(50.0, 4)
        height = mesh.vertices[:, 2]  # an eigenfunction for the eigenvalue 2 / r^2
        for time in (500.0, 2500.0):
            share = surfaces.diffuse_over_surface(mesh, height, time) @ height / (height @ height)
            self.assertAlmostEqual(share, (1.0 + time / 2500.0) ** -2, places=3)


class FlatteningTest(TestCase):
    def test_a_cylinder_becomes_a_rectangle(self):
        radius, height = 15.0, 80.0
        flattened = flattening.flatten_tube(cylinder(radius, height), metric="euclidean")
        self.assertAlmostEqual(flattened.circumference / (2.0 * np.pi * radius), 1.0, delta=0.01)
        self.assertAlmostEqual(flattened.length / height, 1.0, delta=0.01)
        self.assertEqual((flattened.statistics["flips"], flattened.genus_before, flattened.handles), (0, 0, []))
        flat = flattened.flat
        source = flat.point_arrays["sourcePointId"]
        self.assertEqual(flat.point_arrays["uv"].shape, (len(flat.vertices), 2))
        np.testing.assert_array_equal(cylinder(radius, height).vertices[source], flat.vertices)

    def test_the_modulus_of_a_cylinder(self):
        tube = cylinder(15.0, 80.0)
        result = flattening.conformal_map(tube, domain="annulus")
        self.assertAlmostEqual(result.modulus_u, 2.0 * np.pi * 15.0 / 80.0, delta=0.02)
        self.assertGreaterEqual(result.modulus_u, result.modulus_v - 1e-9)
        self.assertEqual(result.statistics["flips"], result.flips)
        # All multiples of the metric have the same conformal structure.
        scaled = flattening.conformal_map(tube, domain="annulus", edge_lengths=3.0 * surfaces.edge_lengths(tube))
        self.assertAlmostEqual(scaled.modulus_u, result.modulus_u, places=9)

    def test_what_is_no_tube_is_refused(self):
        with self.assertRaises(shapeton.InputError):
            flattening.flatten_tube(icosphere(10.0, 1))
        with self.assertRaisesRegex(shapeton.ParameterError, "euclidean"):
            flattening.flatten_tube(cylinder(15.0, 80.0), metric="flat")
        with self.assertRaisesRegex(shapeton.ParameterError, "\"time\" applies"):
            flattening.flatten_tube(cylinder(15.0, 80.0), metric="euclidean", time=5.0)
        with self.assertRaisesRegex(shapeton.ParameterError, "\"eigenpairs\" requires"):
            flattening.flatten_tube(cylinder(15.0, 80.0), eigenpairs=20)
        elsewhere = np.array([[500.0, 0.0, 0.0], [500.0, 0.0, 80.0]])
        with self.assertRaisesRegex(shapeton.InputError, "farther from both ends"):
            flattening.flatten_tube(cylinder(15.0, 80.0), elsewhere, metric="euclidean")


@needs_tools
class SameAsToolsTest(TestCase):
    def test_spectrum_and_signature(self):
        signature = self.folder / "signature.vtp"
        options = ["--eigenpairs", 20, "--heatKernelSignature", signature]
        run_tool("SurfaceSpectrum", TORUS, self.folder / "eigenvalues.csv", *options)
        spectrum = surfaces.spectrum(surfaces.read_surface(str(TORUS)), 20)
        written = surfaces.read_surface(str(signature))
        self.assertSame(written.field_arrays["eigenvalues"], spectrum.eigenvalues)
        times = spectrum.signature_times(4)
        self.assertEqual(list(written.field_arrays["times"]), times)
        arrays = [a for n, a in written.point_arrays.items() if n.startswith("heatKernelSignature_")]
        for values, time in zip(arrays, times):
            self.assertSame(values, spectrum.signature(time))

    def test_flattening(self):
        tube, path = cylinder(15.0, 80.0), str(self.folder / "tube.vtp")
        surfaces.write_surface(tube, path)
        run_tool("ColonFlattening", path, self.folder / "flat.vtp", "--metric", "euclidean")
        flat = flattening.flatten_tube(tube, metric="euclidean").flat
        written = surfaces.read_surface(str(self.folder / "flat.vtp"))
        self.assertSame(written.vertices, flat.vertices)
        self.assertSame(written.point_arrays["uv"], flat.point_arrays["uv"])

    def test_a_conformal_map(self):
        tube, path = cylinder(15.0, 80.0), str(self.folder / "tube.vtp")
        surfaces.write_surface(tube, path)
        run_tool("ConformalMap", path, self.folder / "flat.vtp", "--domain", "annulus")
        flat = flattening.conformal_map(tube, domain="annulus").flat
        self.assertSame(surfaces.read_surface(str(self.folder / "flat.vtp")).point_arrays["uv"], flat.point_arrays["uv"])


if __name__ == "__main__":
    unittest.main()
