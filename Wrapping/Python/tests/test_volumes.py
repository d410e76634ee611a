import unittest

import numpy as np

import shapeton

from support import DATA, TestCase, balls, error_of_tool, needs_tools, stored

SERIES = DATA / "PhantomSeries"


class FilesTest(TestCase):
    def test_what_is_written_reads_back(self):
        image = balls()
        for dtype in (np.float32, np.int16, np.uint8, np.uint16, np.uint32):
            for extension in (".nrrd", ".nii", ".nii.gz", ".mha"):
                written = image.like(np.clip(image.array, 0, 200).astype(dtype))
                path = self.folder / ("volume" + extension)
                shapeton.write_volume(written, path)
                read = shapeton.read_volume(path)
                np.testing.assert_array_equal(read.array, written.array)
                np.testing.assert_allclose(read.affine, written.affine, atol=1e-4)

    def test_a_file_holds_exactly_the_values_or_is_not_written(self):
        kept = {"bool", "uint8", "int16", "uint16", "uint32", "float32"}
        for code in np.typecodes["AllInteger"] + np.typecodes["Float"] + "?":
            for order in "<>":
                dtype = np.dtype(code).newbyteorder(order)
                extremes = np.iinfo(dtype) if dtype.kind in "iu" else None
                voxels = np.zeros((3, 4, 5), dtype)
                voxels[0, 0, :3] = (extremes.min, extremes.max, 1) if extremes else (1.0, dtype.type(1) / 3, 0.0)
                for extension in (".nrrd", ".nii", ".nii.gz", ".mha"):
                    path = self.folder / ("volume" + extension)
                    with self.subTest(dtype.str + extension):
                        if dtype.name in kept:
                            shapeton.write_volume(shapeton.Image(voxels), path)
                            np.testing.assert_array_equal(stored(path, voxels.shape), voxels)
                        else:
                            with self.assertRaisesRegex(shapeton.ParameterError, dtype.name):
                                shapeton.write_volume(shapeton.Image(voxels), path)
        with self.assertRaisesRegex(shapeton.ParameterError, "complex"):
            shapeton.Image(np.zeros((3, 4, 5), complex))

    def test_double_precision_is_written_where_single_precision_holds_it(self):
        path = self.folder / "volume.nrrd"
        image = balls()
        shapeton.write_volume(image.like(image.array.astype(np.float64)), path)
        np.testing.assert_array_equal(stored(path, image.array.shape), image.array)
        for value in (1.0 + 2.0**-24, 1e300, 1e-60):
            with self.assertRaisesRegex(shapeton.ParameterError, "would be rounded"):
                shapeton.write_volume(image.like(np.full(image.array.shape, value)), path)
        with self.assertRaisesRegex(shapeton.InputError, "not finite"):
            shapeton.write_volume(image.like(np.full(image.array.shape, np.nan)), path)

    def test_equal_images_give_equal_files(self):
        paths = [self.folder / name for name in ("a.nrrd", "b.nrrd")]
        for path in paths:
            shapeton.write_volume(balls(), str(path), [("maker", "a test")])
        self.assertEqual(paths[0].read_bytes(), paths[1].read_bytes())
        self.assertIn(b"maker:=a test", paths[0].read_bytes())

    def test_what_cannot_be_written_is_an_error(self):
        image = balls((8, 8, 8))
        with self.assertRaisesRegex(OSError, "cannot write.*No such file or directory") as caught:
            shapeton.write_volume(image, str(self.folder / "missing" / "volume.nrrd"))
        self.assertIsInstance(caught.exception, shapeton.OutputError)
        with self.assertRaisesRegex(shapeton.ParameterError, "extension"):
            shapeton.write_volume(image, str(self.folder / "volume.xyz"))
        with self.assertRaisesRegex(shapeton.ParameterError, "int64"):
            shapeton.write_volume(image.like(np.zeros(image.array.shape, np.int64)), str(self.folder / "volume.nrrd"))


    def test_nifti_with_numbers_that_are_not_finite_is_refused(self):
        import nibabel

        for name in ("volume.nii", "volume.nii.gz"):
            for dtype in ("<f4", ">f8"):
                for wrong in (np.nan, np.inf):
                    voxels = np.zeros((40, 40, 40), dtype)
                    voxels[[3, 39], [2, 39], [1, 39]] = wrong, -wrong
                    header = nibabel.Nifti1Header(endianness=dtype[0])
                    header.set_data_dtype(dtype)
                    nibabel.save(nibabel.Nifti1Image(voxels, np.eye(4), header), self.folder / name)
                    with self.assertRaisesRegex(shapeton.InputError, "2 of 64000 voxels are not finite"):
                        shapeton.read_volume(self.folder / name)


    def test_what_follows_the_voxels_of_nifti_does_not_matter(self):
        path = self.folder / "volume.nii"
        image = balls()
        shapeton.write_volume(image, path)
        path.write_bytes(path.read_bytes() + np.full(4, np.nan, np.float32).tobytes())
        np.testing.assert_array_equal(shapeton.read_volume(path).array, image.array)


class DicomTest(TestCase):
    def test_a_series_is_what_pydicom_reads(self):
        import pydicom

        slices = sorted(
            (pydicom.dcmread(path) for path in SERIES.glob("*.dcm")), key=lambda s: float(s.ImagePositionPatient[2])
        )
        stored = np.stack([s.pixel_array for s in slices]).astype(np.float32)
        expected = stored * float(slices[0].RescaleSlope) + float(slices[0].RescaleIntercept)
        image = shapeton.read_volume(str(SERIES))
        np.testing.assert_array_equal(image.array, expected)
        rows, columns = slices[0].PixelSpacing
        between = float(slices[1].ImagePositionPatient[2]) - float(slices[0].ImagePositionPatient[2])
        np.testing.assert_allclose(image.spacing, (float(columns), float(rows), between))
        np.testing.assert_allclose(image.origin, [float(v) for v in slices[0].ImagePositionPatient])
        self.assertEqual(image.facts["modality"], slices[0].Modality)
        self.assertEqual(image.facts["series_uid"], slices[0].SeriesInstanceUID)

    def test_series_are_listed(self):
        (series,) = shapeton.list_series(str(SERIES))
        image = shapeton.read_volume(str(SERIES), series_uid=series.selector)
        self.assertTrue(series.is_usable)
        self.assertEqual(series.size, tuple(reversed(image.array.shape)))
        np.testing.assert_allclose(series.spacing, image.spacing)
        self.assertEqual((series.modality, series.defects, series.refusal), ("CT", [], ""))

    def series_with_a_gap(self):
        folder = self.folder / "gap"
        folder.mkdir()
        for path in SERIES.glob("*.dcm"):
            if path.name != "IM0010.dcm":
                (folder / path.name).write_bytes(path.read_bytes())
        return str(folder)

    def test_a_gap_is_refused_and_repaired_on_request(self):
        folder = self.series_with_a_gap()
        (defect,) = shapeton.list_series(folder)[0].defects
        self.assertEqual(defect.name, "gap")
        with self.assertRaisesRegex(ValueError, 'gap.*the parameter "resample_gaps"') as caught:
            shapeton.read_volume(folder)
        self.assertIsInstance(caught.exception, shapeton.InputError)
        self.assertIn('the parameter "resample_gaps"', defect.advice)
        image = shapeton.read_volume(folder, resample_gaps=True)
        self.assertEqual(image.array.shape, shapeton.read_volume(str(SERIES)).array.shape)
        self.assertEqual(len(image.facts["repairs"]), 1)

    def test_messages_name_parameters_as_python_does(self):
        import pydicom

        folder = self.folder / "two"
        folder.mkdir()
        for path in SERIES.glob("*.dcm"):
            piece = pydicom.dcmread(path)
            piece.save_as(folder / path.name)
            piece.SeriesInstanceUID += ".2"
            piece.SOPInstanceUID = piece.file_meta.MediaStorageSOPInstanceUID = piece.SOPInstanceUID + ".2"
            piece.save_as(folder / ("other-" + path.name))
        with self.assertRaisesRegex(shapeton.InputError, 'the parameter "series_uid"'):
            shapeton.read_volume(folder)
        path = self.folder / "volume.nrrd"
        shapeton.write_volume(balls((8, 8, 8)), path)
        with self.assertRaisesRegex(shapeton.ParameterError, 'the parameter "series_uid" selects'):
            shapeton.read_volume(path, series_uid="1.2.3")

    @needs_tools
    def test_errors_have_the_words_of_the_tools(self):
        missing = str(self.folder / "missing")
        with self.assertRaises(shapeton.InputError) as caught:
            shapeton.read_volume(missing)
        self.assertIn(str(caught.exception), error_of_tool("DicomSeriesToImage", missing, self.folder / "volume.nrrd"))


if __name__ == "__main__":
    unittest.main()
