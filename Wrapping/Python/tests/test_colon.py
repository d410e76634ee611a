import unittest

import numpy as np

import shapeton
from shapeton import colon, flattening, surfaces

from support import TestCase


def lumen_of(position):
    """The true lumen of a synthetic patient in voxels of 3 mm, and the ground truth."""
    return colon.colon_phantom(position=position, size=(120, 120, 112), spacing=(3.0, 3.0, 3.0), truth_only=True)


class Examination:
    """All stages of one position, starting with the true lumen."""

    def __init__(self, position):
        self.truth = lumen_of(position)
        self.model = colon.build_colon_of_lumen(self.truth.lumen, faces=20000)
        self.centerline = self.model.centerline.curve
        self.flattened = flattening.flatten_tube(self.model.wall.simplified, self.centerline, metric="euclidean")
        self.flat = colon.FlatColon(self.flattened.flat)
        self.folds = colon.find_folds(self.flat)
        self.landmarks = colon.find_landmarks(self.flat, self.centerline)
        self.position = colon.ColonPosition(position, self.landmarks, self.centerline, self.folds)


class ColonTest(TestCase):
    @classmethod
    def setUpClass(cls):
        cls.supine = Examination("supine")

    def test_the_centerline_is_near_the_true_one(self):
        line, truth = self.supine.model.centerline, self.supine.truth.centerline
        self.assertEqual((line.gaps, self.supine.model.failure), ([], ""))
        points, true_points = line.curve.points(), truth.points()
        distances = np.linalg.norm(points[:, None] - true_points[None], axis=2).min(axis=1)
        self.assertLess(distances.mean(), 4.0)
        self.assertAlmostEqual(line.length, line.curve.point_arrays["arcLength"].max(), delta=1e-6)
        steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        self.assertAlmostEqual(line.length, steps.sum(), delta=0.01 * line.length)

    def test_the_wall_is_a_tube_around_the_lumen(self):
        wall, lumen = self.supine.model.wall, self.supine.truth.lumen
        for mesh in (wall.repaired, wall.simplified):
            facts = surfaces.inspect_surface(mesh)
            self.assertEqual((facts["genus"], len(facts["boundaryLoops"]), facts["manifold"]), (0, 2, True))
        self.assertEqual(wall.genus_after, 0)
        volume = np.count_nonzero(lumen.array) * np.prod(lumen.spacing)
        self.assertAlmostEqual(surfaces.enclosed_volume(wall.repaired) / volume, 1.0, delta=0.1)

    def test_the_flat_map_leads_to_the_wall(self):
        flat, wall = self.supine.flat, self.supine.model.wall.simplified
        coordinates = flat.coordinates()
        self.assertEqual(coordinates.shape, flat.shape + (3,))
        row, column = flat.shape[0] // 3, flat.shape[1] // 2
        uv, distance = flat.find(coordinates[row, column][None].astype(float))
        self.assertLess(distance[0], 1e-4)
        np.testing.assert_array_equal(flat.pixels(uv), [[row, column]])
        self.assertEqual(self.supine.flattened.statistics["flips"], 0)
        self.assertGreater(flat.faces()[row, column], -1)
        self.assertEqual(flat.curvature().shape, flat.shape)
        self.assertEqual(flat.find(wall.vertices[:10])[1].max(), 0.0)

    def test_folds_are_what_the_labels_show(self):
        folds, labels = self.supine.folds.folds, self.supine.folds.labels
        self.assertGreater(len(folds), 50)
        self.assertEqual(labels.shape, self.supine.flat.shape)
        self.assertEqual(set(np.unique(labels)), {0} | {fold.label for fold in folds})
        for fold in folds[::20]:
            _, distance = self.supine.flat.find(np.array([fold.center, *fold.ends]))
            self.assertLess(distance.max(), 0.01)

    def test_landmarks_are_in_order_along_the_colon(self):
        landmarks = self.supine.landmarks
        places = [flexure.arc_length for flexure in landmarks.flexures if flexure.is_found]
        self.assertEqual(places, sorted(places))
        names = ["rectosigmoid", "descending-sigmoid", "splenic", "hepatic"]
        self.assertEqual([flexure.name for flexure in landmarks.flexures], names)
        segments = landmarks.segments.cell_arrays["segment"]
        self.assertEqual(segments.dtype, np.int32)
        self.assertTrue({2, 3, 4, 5} <= set(segments))
        self.assertEqual(len(landmarks.taeniae.curves), 3)
        self.assertEqual(len(landmarks.statistics["flexures"]), 4)
        pieces, _ = colon.split_colon(landmarks)
        areas = [piece.area for piece in pieces]
        self.assertLess(sum(areas), 1.01 * surfaces.surface_area(self.supine.flat.surface))

    def test_candidates_have_places_on_wall_and_map(self):
        supine = self.supine
        candidates = colon.find_candidates(
            supine.model.wall.repaired,
            supine.truth.lumen,
            centerline=supine.centerline,
            flat=supine.flat,
            segments=supine.landmarks.segments,
        )
        self.assertTrue(candidates)
        self.assertEqual([c.number for c in candidates], list(range(1, len(candidates) + 1)))
        self.assertTrue(all(np.isfinite(c.uv).all() and np.isnan(c.attenuation) for c in candidates))
        self.assertIn("If confirmed: ", colon.sizes_if_confirmed(candidates))

    def test_registration_takes_points_to_the_other_wall_and_back(self):
        prone = Examination("prone")
        registration = colon.register_positions(self.supine.position, prone.position)
        self.assertEqual(registration.flips, 0)
        self.assertGreater(registration.confidence, 0.5)
        self.assertGreater(len(registration.matches), 30)
        points = self.supine.model.wall.simplified.vertices[::500]
        mapped, confidence, excluded = registration.map_points(points)
        seen = ~excluded
        self.assertGreater(np.count_nonzero(seen), len(points) // 2)
        self.assertLess(prone.flat.find(mapped[seen])[1].max(), 1.0)  # a third of a voxel
        self.assertTrue(((confidence >= 0.0) & (confidence <= 1.0)).all())
        back, _, _ = registration.map_points(mapped[seen], inverse=True)
        self.assertLess(np.median(np.linalg.norm(back - points[seen], axis=1)), 1.0)
        arrays = registration.supine_to_prone.point_arrays
        self.assertEqual(arrays["mapped"].shape, registration.supine_to_prone.vertices.shape)

    def test_progress_aborts_a_model(self):
        calls = []

        def progress(share, stage):
            calls.append((share, stage))
            return len(calls) < 3

        with self.assertRaises(shapeton.Aborted):
            colon.build_colon_of_lumen(self.supine.truth.lumen, progress=progress)
        self.assertEqual(len(calls), 3)

    def test_wrong_input_is_refused(self):
        lumen = self.supine.truth.lumen
        with self.assertRaises(shapeton.InputError):
            colon.trace_centerline(lumen.like(np.zeros_like(lumen.array)))
        with self.assertRaisesRegex(shapeton.ParameterError, "sideways"):
            colon.segment_lumen(lumen, position="sideways")
        with self.assertRaisesRegex(shapeton.InputError, "uv"):
            colon.FlatColon(self.supine.model.wall.simplified)
        with self.assertRaisesRegex(shapeton.ParameterError, "cut"):
            colon.find_folds(self.supine.flat, scheme="cut")
        with self.assertRaisesRegex(shapeton.ParameterError, "preset"):
            colon.colon_phantom(preset="no such")
        for spacing in ((float("nan"), 3.0, 3.0), (-3.0, 3.0, 3.0)):
            with self.assertRaisesRegex(shapeton.ParameterError, "is not positive"):
                colon.colon_phantom(size=(40, 40, 40), spacing=spacing, truth_only=True)

    def test_places_are_finite_and_may_be_far(self):
        flat = self.supine.flat
        for wrong in (np.nan, np.inf, -np.inf):
            with self.assertRaisesRegex(ValueError, "position is not finite"):
                flat.find([[0.0, 0.0, 0.0], [wrong, 0.0, 0.0]])
            with self.assertRaisesRegex(shapeton.InputError, "point 0 is not finite"):
                colon.find_landmarks(flat, self.supine.model.centerline.curve, markers=[[wrong, 0.0, 0.0]])
        for far in (1e6, 1e100, 1e300):
            self.assertGreater(flat.find([[far, 0.0, 0.0]])[1][0], 0.9e6)
            with self.assertRaisesRegex(shapeton.InputError, "from the wall"):
                colon.find_landmarks(flat, self.supine.model.centerline.curve, markers=[[far, 0.0, 0.0]])


if __name__ == "__main__":
    unittest.main()
