import unittest

import numpy as np

import shapeton
from shapeton import shapes

from support import TestCase, balls, error_of_tool, needs_tools, oblique, run_tool


def two_halves(shape=(20, 24, 28)):
    """Two plateaus in noise with a seed in each."""
    voxels = np.random.default_rng(3).normal(0.0, 10.0, shape)
    voxels[:, :, shape[2] // 2 :] += 300.0
    image = shapeton.Image(voxels.astype(np.float32), (0.8, 0.9, 1.5), (-10.0, 20.0, 5.0), oblique())
    seeds = np.zeros(shape, np.uint16)
    seeds[10, 12, 3], seeds[10, 12, -3] = 4, 9
    return image, image.like(seeds)


def ball(radius, shape=(48, 48, 48), spacing=(1.0, 1.0, 1.0)):
    """A ball of label 1, radius in mm."""
    axes = np.ogrid[tuple(slice(n) for n in shape)]
    square = sum(((a - n / 2) * s) ** 2 for a, n, s in zip(axes, shape, spacing[::-1]))
    return shapeton.Image((square < radius**2).astype(np.uint8), spacing)


class SeedsTest(TestCase):
    def test_a_label_without_seed_in_the_domain_is_named(self):
        image, seeds = two_halves()
        left = np.ones(seeds.array.shape, np.uint8)
        seeds.array[10, 12, 5] = 7
        left[:, :, 20:] = 0
        result = shapes.SeededHeat(image, domain=image.like(left)).segment(seeds)
        self.assertEqual(np.unique(result.labels.array).tolist(), [0, 4, 7])
        self.assertIn("label 9 has no seed in the domain", "; ".join(result.warnings))

    def test_wrong_parameters_are_refused_at_once(self):
        image, seeds = two_halves()
        with self.assertRaisesRegex(shapeton.ParameterError, "the parameter \"p\""):
            shapes.SeededHeat(image, p=-1.0)
        with self.assertRaisesRegex(shapeton.InputError, "grids of the domain and of the image differ"):
            shapes.SeededHeat(image, domain=shapeton.Image(seeds.array))

    def test_a_boundary_lies_at_the_edge_and_probabilities_sum_to_one(self):
        image, seeds = two_halves()
        found = shapes.SeededHeat(image).segment(seeds, probabilities=True)
        expected = np.where(np.arange(28) < 14, 4, 9) + np.zeros((20, 24, 1), int)
        np.testing.assert_array_equal(found.labels.array, expected)
        self.assertEqual(found.labels.array.dtype, np.uint16)
        np.testing.assert_allclose(found.labels.direction, image.direction)
        self.assertEqual(sorted(found.probabilities), [4, 9])
        one, other = found.probabilities[4].array, found.probabilities[9].array
        self.assertLess(np.abs(one + other - 1.0).max(), 1e-5)
        np.testing.assert_array_equal(one > other, expected == 4)
        self.assertLess(np.abs(found.uncertainty.array - (1.0 - np.abs(one - other))).max(), 2e-5)

    def test_a_label_that_hardly_leaves_its_seeds_is_warned_of(self):
        image, seeds = two_halves()
        self.assertEqual(shapes.SeededHeat(image).segment(seeds).warnings, [])
        voxels = np.zeros(seeds.array.shape, np.uint16)
        voxels[:, :, -1], voxels[10, 12, 3] = 9, 4  # a plane and a point
        (warning,) = shapes.SeededHeat(image, p=0.0).segment(image.like(voxels)).warnings  # no edges
        self.assertRegex(warning, "^label 4 has 1 seed and gains only [0-9] voxels; ")

    def test_a_changed_seed_starts_from_the_last_solution(self):
        image, seeds = two_halves()
        heat = shapes.SeededHeat(image, p=15.0)
        first = heat.segment(seeds)
        kept = first.labels.array.copy()
        self.assertEqual(first.probabilities, {})
        again = heat.segment(seeds)
        self.assertLess(again.iterations, first.iterations)
        changed = seeds.array.copy()
        changed[5, 5, -2] = 4
        after = heat.segment(image.like(changed))
        self.assertEqual(after.labels.array[5, 5, -2], 4)
        self.assertSame(first.labels.array, kept)  # later calls do not change earlier results

    @needs_tools
    def test_labels_are_those_of_the_tool(self):
        image, seeds = two_halves()
        files = [str(self.folder / name) for name in ("image.nrrd", "seeds.nrrd", "labels.nrrd")]
        shapeton.write_volume(image, files[0])
        shapeton.write_volume(seeds, files[1])
        run_tool("SeededHeatSegmentation", *files, "--p", 12, "--intensityWindow", "0,300")
        found = shapes.SeededHeat(image, p=12.0, intensity_window=(0.0, 300.0)).segment(seeds)
        np.testing.assert_array_equal(shapeton.read_volume(files[2]).array, found.labels.array)

    def test_seeds_of_classes_keep_off_the_borders(self):
        labels, _ = shapeton.classify_heat(shapeton.diffuse_heat(balls(), time_steps=2000).heat)
        seeds = shapes.seeds_of_classes(labels, classes=[1])
        self.assertTrue(np.all(labels.array[seeds.array > 0] == 1))
        self.assertLess(np.count_nonzero(seeds.array), np.count_nonzero(labels.array == 1))

    def test_wrong_seeds_are_value_errors(self):
        image, seeds = two_halves()
        heat = shapes.SeededHeat(image)
        with self.assertRaisesRegex(shapeton.InputError, "labels"):
            heat.segment(seeds.like(np.zeros_like(seeds.array)))
        with self.assertRaisesRegex(shapeton.InputError, "grids of the seeds and of the image differ"):
            heat.segment(shapeton.Image(seeds.array))
        with self.assertRaisesRegex(shapeton.InputError, "values not representable in uint16"):
            heat.segment(seeds.like(np.full(seeds.array.shape, 0.5, np.float32)))
        with self.assertRaisesRegex(shapeton.ParameterError, "(?i)tolerance"):
            shapes.SeededHeat(image, tolerance=3.0).segment(seeds)
        with self.assertRaises(shapeton.Aborted):
            heat.segment(seeds, progress=lambda share, stage: False)
        with self.assertRaisesRegex(shapeton.ParameterError, "create another SeededHeat"):
            heat.segment(seeds, progress=lambda share, stage: heat.segment(seeds))
        self.assertTrue(heat.segment(seeds).labels.array.any())


class SignaturesTest(TestCase):
    def signature(self, labels):
        (row,) = shapes.describe_shapes(labels, labels).rows
        return row.signature

    def test_a_ball_has_the_numbers_of_a_sphere(self):
        s = self.signature(ball(15.0))
        self.assertAlmostEqual(s.volume / (4.0 / 3.0 * np.pi * 15.0**3), 1.0, delta=0.01)
        self.assertAlmostEqual(s.surface / (4.0 * np.pi * 15.0**2), 1.0, delta=0.03)
        self.assertAlmostEqual(s.elongation, 1.0, delta=0.01)
        np.testing.assert_allclose(s.spectrum[:3], 8.0 * np.pi, rtol=0.03)
        self.assertEqual((len(s.times), len(s.remaining_heat), len(s.displacement)), (25, 25, 25))
        self.assertTrue(np.all(np.diff(s.remaining_heat) <= 0.0))

    def test_size_and_sampling_change_little(self):
        one, other = self.signature(ball(15.0)), self.signature(ball(24.0, (40, 56, 60), (1.2, 1.0, 1.6)))
        egg = ball(15.0)
        egg = shapeton.Image(egg.array, (1.0, 1.0, 1.9))
        self.assertLess(shapes.signature_distance(one, other), 3.0)
        self.assertGreater(shapes.signature_distance(one, self.signature(egg)), 10.0)

    @needs_tools
    def test_tables_and_databases_are_those_of_the_tools(self):
        files = [str(self.folder / name) for name in ("a.nrrd", "b.nrrd", "c.csv", "d.sqlite")]
        run_tool("ShapePhantom", files[0], "--shape", "figure3.4", "--size", "80,80,80", "--labels", files[1])
        run_tool("ShapeSignature", *files[:3])
        run_tool("ShapeSearch", files[2], files[3], "--add", "figure")
        table = shapes.describe_shapes(shapeton.read_volume(files[0]), shapeton.read_volume(files[1]))
        own = self.folder / "own.csv"
        shapes.write_shape_table(table, str(own))
        with open(files[2], "rb") as written:
            self.assertEqual(own.read_bytes(), written.read())
        entries = shapes.read_shape_database(files[3])
        self.assertEqual([e.name for e in entries], ["figure:1", "figure:2", "figure:3", "figure:4"])
        for index, row in enumerate(shapes.read_shape_table(files[2]).rows):
            self.assertEqual(row.name, str(index + 1))
            found = shapes.find_shape(row.signature, entries, nearest=2)
            self.assertEqual([n.distance for n in found.neighbors][0], 0.0)
            self.assertEqual(len(found.neighbors), 2)
            self.assertEqual(found.unknown, found.probability < 0.5)
        missing = str(self.folder / "none.sqlite")
        with self.assertRaises(shapeton.InputError) as caught:
            shapes.read_shape_database(missing)
        self.assertEqual(error_of_tool("ShapeSearch", files[2], missing).split(": ", 1)[1], str(caught.exception))

    def test_wrong_input_is_a_value_error(self):
        labels = ball(10.0)
        signature = self.signature(labels)
        with self.assertRaisesRegex(shapeton.InputError, "grids of the image and of the labels differ"):
            shapes.describe_shapes(shapeton.Image(labels.array, (2.0, 1.0, 1.0)), labels)
        with self.assertRaisesRegex(shapeton.ParameterError, '"entries" is empty'):
            shapes.find_shape(signature, [])
        with self.assertRaisesRegex(shapeton.ParameterError, '"nearest": 0 is less than the minimum 1'):
            shapes.find_shape(signature, [shapes.NamedShape("ball", signature)], 0)
        with self.assertRaises(shapeton.Aborted):
            shapes.describe_shapes(labels, labels, progress=lambda share, stage: False)


if __name__ == "__main__":
    unittest.main()
