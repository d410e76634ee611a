import gc
import pickle
import unittest

import numpy as np

import shapeton
from shapeton import Image

from support import TestCase, balls, oblique


class ImageTest(TestCase):
    def test_places_are_those_of_index_spacing_origin_and_direction(self):
        image = Image(np.zeros((4, 5, 6)), (1.0, 2.0, 3.0), (7.0, 8.0, 9.0), oblique())
        z, y, x = 3, 2, 1
        expected = np.array([7.0, 8.0, 9.0]) + oblique() @ np.array([x * 1.0, y * 2.0, z * 3.0])
        np.testing.assert_allclose(image.point([z, y, x]), expected, atol=1e-12)
        np.testing.assert_allclose(image.index(expected), [z, y, x], atol=1e-12)
        np.testing.assert_allclose(image.point([[0, 0, 0], [z, y, x]])[1], expected, atol=1e-12)

    def test_another_array_keeps_what_automatic_values_depend_on(self):
        image = Image(np.zeros((2, 3, 4)), facts={"modality": "CT", "series_uid": "1.2", "slice_thickness": 2.0})
        self.assertEqual(image.like(np.ones((2, 3, 4))).facts, {"modality": "CT", "slice_thickness": 2.0})

    def test_voxels_are_kept_as_they_are(self):
        voxels = np.zeros((4, 5, 6), np.float32)
        self.assertIs(Image(voxels).array, voxels)

    def test_pickles_keep_place_facts_and_voxels(self):
        image = Image(np.arange(24.0).reshape(2, 3, 4), (1.0, 2.0, 3.0), (7.0, 8.0, 9.0), oblique(), {"a": "b"})
        copy = pickle.loads(pickle.dumps(image))
        np.testing.assert_array_equal(copy.array, image.array)
        np.testing.assert_array_equal(copy.affine, image.affine)
        self.assertEqual(copy.facts, image.facts)
        mesh = shapeton.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], {"heat": [1.0, 2.0, 3.0]})
        copy = pickle.loads(pickle.dumps(mesh))
        np.testing.assert_array_equal(copy.faces, mesh.faces)
        np.testing.assert_array_equal(copy.point_arrays["heat"], [1.0, 2.0, 3.0])

    def test_refuses_what_is_no_image(self):
        volume = np.zeros((2, 2, 2))
        for wrong in (
            lambda: Image(volume[0]),
            lambda: Image(np.zeros((0, 2, 2))),
            lambda: Image(volume.astype(complex)),
            lambda: Image(np.full((2, 2, 2), "text")),
            lambda: Image(volume, spacing=(1.0, 0.0, 1.0)),
            lambda: Image(volume, spacing=(1.0, 1.0)),
            lambda: Image(volume, spacing=1),
            lambda: Image(volume, origin=(0.0, np.nan, 0.0)),
            lambda: Image(volume, direction=np.ones((3, 3))),
            lambda: Image.from_affine(volume, np.eye(3)),
            lambda: Image.from_affine(volume, [[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
        ):
            with self.assertRaises(ValueError) as caught:
                wrong()
            self.assertIsInstance(caught.exception, shapeton.ParameterError)


class LayoutTest(TestCase):
    """The heat is independent of the type and layout of an array."""

    def setUp(self):
        super().setUp()
        image = balls((12, 14, 16))
        self.image = image.like(np.rint(image.array).astype(np.float32))
        self.expected = self.heat(self.image)

    def heat(self, image):
        return shapeton.diffuse_heat(image, time_steps=100).heat.array

    def test_types_that_hold_the_same_numbers(self):
        for dtype in (np.float64, np.int16, np.int32, np.int64, ">f4", ">i2", np.longdouble):
            self.assertSame(self.heat(self.image.like(self.image.array.astype(dtype))), self.expected)
        bits = self.image.array > 100.0
        self.assertSame(self.heat(self.image.like(bits)), self.heat(self.image.like(bits.astype(np.float32))))

    def test_negative_strides_and_other_orders(self):
        voxels = self.image.array
        turned = np.ascontiguousarray(voxels[::-1, :, ::-1])[::-1, :, ::-1]
        self.assertLess(turned.strides[0], 0)
        self.assertSame(self.heat(self.image.like(turned)), self.expected)
        self.assertSame(self.heat(self.image.like(np.asfortranarray(voxels))), self.expected)
        wide = np.zeros((12, 14, 32), np.float32)
        wide[..., ::2] = voxels
        self.assertSame(self.heat(self.image.like(wide[..., ::2])), self.expected)

    def test_an_array_that_must_not_be_written(self):
        voxels = self.image.array.copy()
        voxels.flags.writeable = False
        self.assertSame(self.heat(self.image.like(voxels)), self.expected)

    def test_an_array_off_its_boundary(self):
        bytes_ = np.zeros(self.image.array.nbytes + 1, np.uint8)
        shifted = bytes_[1:].view(np.float32).reshape(self.image.array.shape)
        shifted[...] = self.image.array
        self.assertFalse(shifted.flags.aligned)
        self.assertSame(self.heat(self.image.like(shifted)), self.expected)

    def test_the_input_is_left_alone(self):
        before = self.image.array.copy()
        self.heat(self.image)
        self.assertSame(self.image.array, before)

    def test_another_grid_is_not_mistaken_for_this_one(self):
        image = self.image
        with self.assertRaisesRegex(shapeton.ParameterError, "is an Image"):
            shapeton.Image(image)
        moved = shapeton.Image(image.array, image.spacing, np.add(image.origin, 5.0), image.direction)
        for other in (image.array[2:], moved):
            with self.assertRaisesRegex(shapeton.ParameterError, "on another grid"):
                image.like(other)
        self.assertSame(image.like(image).array, image.array)

    def test_what_float32_would_lose_is_refused(self):
        with self.assertRaisesRegex(shapeton.InputError, "not representable in float32"):
            shapeton.diffuse_heat(shapeton.Image(np.arange(8).reshape(2, 2, 2) + 2**40))
        with self.assertRaisesRegex(shapeton.InputError, "not representable in float32"):
            shapeton.diffuse_heat(shapeton.Image(2**60 + 100 * np.arange(8).reshape(2, 2, 2)))
        with self.assertRaisesRegex(shapeton.InputError, r"use classify_heat\(\)"):
            shapeton.visit_density(shapeton.Image(np.full((2, 2, 2), 0.5)))
        with self.assertRaisesRegex(shapeton.InputError, r"beyond the range of float32, the first at .z, y, x. = .0, 0, 0."):
            shapeton.diffuse_heat(shapeton.Image(np.full((2, 2, 2), -1e300)))
        with self.assertRaisesRegex(shapeton.ParameterError, "masked"):
            shapeton.Image(np.ma.masked_less(np.arange(8.0).reshape(2, 2, 2), 3))
        self.assertEqual(shapeton.Image(np.ma.array(np.ones((2, 2, 2)))).array.sum(), 8)

    def test_values_that_are_not_finite_are_refused_with_their_place(self):
        for value in (np.nan, np.inf):
            voxels = self.image.array.astype(np.float64)
            voxels[3, 4, 5] = value
            with self.assertRaisesRegex(shapeton.InputError, r"not finite.*\[3, 4, 5\]"):
                self.heat(self.image.like(voxels))

    def test_a_mask_is_where_an_image_is_not_zero(self):
        inside = np.arange(16) % 3 > 0
        run = {"time_steps": 1, "shapetons": 100}
        visits = shapeton.diffuse_shapetons(self.image, mask=self.image.like(np.broadcast_to(inside, (12, 14, 16))), **run).visits
        for number in (256, 0.5, -1):
            mask = self.image.like(np.broadcast_to(number * inside, (12, 14, 16)))
            self.assertSame(shapeton.diffuse_shapetons(self.image, mask=mask, **run).visits.array, visits.array)
        with self.assertRaisesRegex(shapeton.InputError, "\"mask\" contains NaN"):
            shapeton.diffuse_shapetons(self.image, mask=self.image.like(np.full((12, 14, 16), np.nan)), **run)

    def test_a_numpy_array_alone_is_no_image(self):
        with self.assertRaises(TypeError):
            shapeton.diffuse_heat(self.image.array)


class ResultTest(TestCase):
    def test_numpy_reads_it(self):
        image = balls()
        self.assertEqual(np.mean(image), image.array.mean())
        self.assertIs(np.asarray(image), image.array)

    def test_a_result_outlives_what_it_came_with(self):
        image = balls((12, 14, 16))
        result = shapeton.diffuse_heat(image, time_steps=10)
        heat, copy = result.heat.array, result.heat.array.copy()
        counts = shapeton.heat_histogram([result.heat], [10]).counts
        del result
        gc.collect()
        self.assertSame(heat, copy)
        self.assertEqual(counts.sum(), heat.size)

    def test_a_result_is_no_copy(self):
        result = shapeton.diffuse_heat(balls((12, 14, 16)), time_steps=10)
        self.assertTrue(np.shares_memory(result.heat.array, result.heat.array))
        self.assertFalse(result.heat.array.flags.owndata)

    def test_a_result_lies_where_its_input_does(self):
        image = balls((12, 14, 16))
        heat = shapeton.diffuse_heat(image, time_steps=10).heat
        np.testing.assert_array_equal(heat.affine, image.affine)


if __name__ == "__main__":
    unittest.main()
