"""Images and surfaces of other packages.

nibabel and VTK are Debian packages. SimpleITK, itk, pyvista and xarray are replaced by small stand-ins, which only verify
the calls of the converters.
"""

import gc
import sys
import types
import unittest
from unittest import mock

import numpy as np

import shapeton
from shapeton import Image, Mesh, surfaces

from support import DATA, TestCase, balls

TORUS = DATA / "Torus.off"


class NibabelTest(TestCase):
    def test_a_file_is_read_as_the_library_reads_it(self):
        import nibabel

        path = str(self.folder / "volume.nii.gz")
        image = balls()
        shapeton.write_volume(image, path)
        expected = shapeton.read_volume(path)
        converted = Image.from_nibabel(nibabel.load(path))
        np.testing.assert_array_equal(converted.array, expected.array)
        np.testing.assert_allclose(converted.affine, expected.affine, atol=1e-5)

    def test_ras_becomes_lps(self):
        import nibabel

        voxels = np.zeros((3, 4, 5), np.float32)
        voxels[2, 1, 3] = 1.0
        affine = np.array([[-2.0, 0, 0, 30], [0, 1.5, 0, -20], [0, 0, 3, 5], [0, 0, 0, 1]])
        image = Image.from_nibabel(nibabel.Nifti1Image(voxels, affine))
        ras = affine @ [2, 1, 3, 1]
        np.testing.assert_allclose(image.point(np.argwhere(image.array)[0]), [-ras[0], -ras[1], ras[2]])
        self.assertTrue(np.shares_memory(image.array, voxels))

    def test_other_units_become_millimeters(self):
        import nibabel

        for unit, factor in (("meter", 1000.0), ("mm", 1.0), ("micron", 0.001), ("unknown", 1.0)):
            nifti = nibabel.Nifti1Image(np.zeros((2, 2, 2), np.int16), np.diag([2.0, 3.0, 4.0, 1.0]))
            nifti.header.set_xyzt_units(unit)
            np.testing.assert_allclose(Image.from_nibabel(nifti).spacing, np.array([2.0, 3.0, 4.0]) * factor)

    def test_without_an_orientation(self):
        import nibabel

        nifti = nibabel.Nifti1Image(np.zeros((3, 4, 5), np.float32), np.diag([2.0, 3.0, 4.0, 1.0]))
        nifti.set_sform(None, 0)
        nifti.set_qform(None, 0)
        path = str(self.folder / "volume.nii")
        nibabel.save(nifti, path)
        for image in (nifti, nibabel.load(path)):
            np.testing.assert_array_equal(Image.of(image).affine, shapeton.read_volume(path).affine)
        with self.assertRaisesRegex(shapeton.InputError, "has no affine"):
            Image.of(nibabel.Nifti1Image(np.zeros((3, 4, 5), np.float32), None))

    def test_there_and_back(self):
        image = balls()
        self.assertEqual(image.to_nibabel().header.get_xyzt_units()[0], "mm")
        back = Image.from_nibabel(image.to_nibabel())
        self.assertSame(back.array, image.array)
        self.assertTrue(np.shares_memory(back.array, image.array))
        np.testing.assert_allclose(back.affine, image.affine, atol=1e-12)


    def test_a_function_takes_images_of_other_packages(self):
        image = balls((12, 14, 16))
        domain = image.like((image.array > 0.0).astype(np.uint8))
        expected = shapeton.diffuse_heat(image, domain=domain, time_steps=10)
        for other, mask in ((image.to_nibabel(), domain.to_vtk()), (image.to_vtk(), domain.to_nibabel())):
            self.assertSame(shapeton.diffuse_heat(other, domain=mask, time_steps=10).heat.array, expected.heat.array)
        histogram = shapeton.heat_histogram([expected.heat.to_nibabel()], [10])
        self.assertSame(histogram.counts, shapeton.heat_histogram([expected.heat], [10]).counts)
        with self.assertRaisesRegex(TypeError, "dict is not an image of nibabel, SimpleITK, itk, VTK or xarray"):
            Image.of({})


class VtkTest(TestCase):
    def test_an_image_there_and_back(self):
        image = balls()
        back = Image.from_vtk(image.to_vtk())
        self.assertSame(back.array, image.array)
        np.testing.assert_allclose(back.affine, image.affine, atol=1e-12)

    def test_vtk_gets_numbers_in_the_order_of_the_machine(self):
        for dtype in (">i2", ">f4", ">f8", "<i2"):
            image = balls().like(np.round(balls().array).astype(dtype))
            np.testing.assert_array_equal(Image.from_vtk(image.to_vtk()).array, image.array)
        mesh = Mesh(np.eye(3), [[0, 1, 2]], {"a": np.array([1, 2, 3], ">f4"), "b": np.array([True, False, True])})
        arrays = Mesh.from_vtk(mesh.to_vtk()).point_arrays
        np.testing.assert_array_equal(arrays["a"], [1, 2, 3])
        np.testing.assert_array_equal(arrays["b"], [1, 0, 1])

    def test_vtk_places_voxels_where_we_do(self):
        image = balls()
        place = [0.0, 0.0, 0.0]
        image.to_vtk().TransformIndexToPhysicalPoint(3, 2, 1, place)
        np.testing.assert_allclose(place, image.point([1, 2, 3]))

    def test_an_extent_that_does_not_begin_at_0(self):
        data = balls().to_vtk()
        data.SetExtent(2, 33, 1, 36, 5, 44)
        place = [0.0, 0.0, 0.0]
        data.TransformIndexToPhysicalPoint(2, 1, 5, place)
        np.testing.assert_allclose(Image.from_vtk(data).point([0, 0, 0]), place)

    def test_views_outlive_their_owners(self):
        image = balls((12, 14, 16))
        expected = image.array.sum(dtype=float)
        data = image.to_vtk()
        del image
        gc.collect()
        self.assertAlmostEqual(Image.from_vtk(data).array.sum(dtype=float), expected)
        mesh = surfaces.read_surface(str(TORUS))
        area, poly_data = surfaces.surface_area(mesh), mesh.to_vtk()
        del mesh
        gc.collect()
        self.assertEqual(surfaces.surface_area(Mesh.from_vtk(poly_data)), area)

    def test_a_surface_there_and_back(self):
        mesh = surfaces.read_surface(str(TORUS))
        mesh.point_arrays["number"] = np.arange(len(mesh.vertices), dtype=np.int32)
        mesh.point_arrays["uv"] = mesh.vertices[:, :2] * 0.5
        mesh.cell_arrays["part"] = np.ones(len(mesh.faces))
        mesh.field_arrays["list"] = np.array([3, 1, 4], np.int32)
        back = Mesh.from_vtk(mesh.to_vtk())
        self.assertSame(back.vertices, mesh.vertices)
        self.assertSame(back.faces, mesh.faces)
        for kind in ("point_arrays", "cell_arrays", "field_arrays"):
            for name, values in getattr(mesh, kind).items():
                np.testing.assert_array_equal(getattr(back, kind)[name], values)

    def test_a_surface_of_a_filter(self):
        from vtkmodules.vtkFiltersCore import vtkCleanPolyData
        from vtkmodules.vtkFiltersSources import vtkSphereSource

        source, clean = vtkSphereSource(), vtkCleanPolyData()
        source.SetRadius(20.0)
        source.SetThetaResolution(40)
        source.SetPhiResolution(40)
        clean.SetInputConnection(source.GetOutputPort())
        clean.Update()
        facts = surfaces.inspect_surface(Mesh.from_vtk(clean.GetOutput()))
        self.assertEqual((facts["genus"], facts["closed"]), (0, True))

    def test_other_cells_are_refused(self):
        from vtkmodules.vtkCommonDataModel import vtkCellArray
        from vtkmodules.vtkFiltersSources import vtkCubeSource

        cube = vtkCubeSource()
        cube.Update()
        with self.assertRaisesRegex(shapeton.InputError, "cells other than triangles"):
            Mesh.from_vtk(cube.GetOutput())
        polys = vtkCellArray()
        for corners in ((0, 1, 2, 3), (2, 3)):
            polys.InsertNextCell(len(corners), corners)
        mixed = Mesh(np.eye(4)[:, :3], [[0, 1, 2]]).to_vtk()
        mixed.SetPolys(polys)  # as many corners as two triangles
        with self.assertRaisesRegex(shapeton.InputError, "cells other than triangles"):
            Mesh.from_vtk(mixed)
        with self.assertRaisesRegex(shapeton.InputError, "refers to vertex 9"):
            Mesh(np.eye(3), [[0, 1, 9]]).to_vtk()


class FakeImage:
    """Common tests of SimpleITK and itk."""

    def __init__(self, array):
        self.array, self.spacing, self.origin, self.direction = array, (1.0,) * 3, (0.0,) * 3, tuple(np.eye(3).ravel())
        self.header = {}

    def SetSpacing(self, spacing):
        self.spacing = tuple(float(s) for s in spacing)

    def SetOrigin(self, origin):
        self.origin = tuple(float(o) for o in origin)

    def SetDirection(self, direction):
        self.direction = direction

    def GetSpacing(self):
        return self.spacing

    def GetOrigin(self):
        return self.origin

    def GetDirection(self):
        return self.direction


class FakeSimpleITKImage(FakeImage):
    def GetPixelIDTypeAsString(self):
        return "32-bit float"

    def GetDimension(self):
        return 3

    def HasMetaDataKey(self, key):
        return key in self.header

    def GetMetaData(self, key):
        return self.header[key]

    def SetMetaData(self, key, value):
        self.header[key] = value


class FakeITKHeader(dict):
    HasKey = dict.__contains__


class FakeITKImage(FakeImage):
    def GetLargestPossibleRegion(self):
        raise NotImplementedError

    def GetMetaDataDictionary(self):
        return FakeITKHeader(self.header)


class StandInTest(TestCase):
    def assertThereAndBack(self, image, back):
        self.assertSame(back.array, image.array)
        np.testing.assert_allclose(back.affine, image.affine)

    def test_simple_itk(self):
        fake = types.SimpleNamespace(
            GetImageFromArray=FakeSimpleITKImage, GetArrayViewFromImage=lambda image: image.array
        )
        with mock.patch.dict(sys.modules, SimpleITK=fake):
            image = balls()
            image.facts["modality"] = "CT"
            other = image.to_sitk()
            self.assertEqual(len(other.direction), 9)
            for convert in (Image.from_sitk, Image.of):
                self.assertThereAndBack(image, convert(other))
                self.assertEqual(convert(other).facts, {"modality": "CT"})

    def test_itk(self):
        fake = types.SimpleNamespace(
            image_view_from_array=FakeITKImage,
            array_view_from_image=lambda image: image.array,
            matrix_from_array=np.array,
            array_from_matrix=np.array,
        )
        with mock.patch.dict(sys.modules, itk=fake):
            image = balls()
            other = image.to_itk()
            other.header["0008|0060"] = "CT "
            for convert in (Image.from_itk, Image.of):
                self.assertThereAndBack(image, convert(other))
                self.assertEqual(convert(other).facts, {"modality": "CT"})

    def test_xarray(self):
        image = balls()
        axes = {
            name: origin + step * np.arange(n)
            for name, origin, step, n in zip("xyz", image.origin, image.spacing, reversed(image.array.shape))
        }
        other = types.SimpleNamespace(
            dims=("x", "y", "z"),
            coords=axes,
            attrs={"direction": np.flip(image.direction)},
            transpose=lambda *dims: types.SimpleNamespace(values={("z", "y", "x"): image.array}[dims]),
        )
        for convert in (Image.from_xarray, Image.of):
            self.assertThereAndBack(image, convert(other))
        other.attrs = {}
        np.testing.assert_array_equal(Image.of(other).direction, np.eye(3))
        for name, axis, error in (
            ("y", axes["y"] ** 2, "equally spaced coordinates along y"),
            ("z", axes["z"][:1], "equally spaced coordinates along z"),
        ):
            other.coords = {**axes, name: axis}
            with self.assertRaisesRegex(shapeton.InputError, error):
                Image.of(other)
        other.dims = ("t", "y", "x")
        with self.assertRaisesRegex(shapeton.InputError, "must be z, y, x, got t, y, x"):
            Image.of(other)

    def test_pyvista(self):
        with mock.patch.dict(sys.modules, pyvista=types.SimpleNamespace(wrap=lambda data: data)):
            mesh = surfaces.read_surface(str(TORUS))
            self.assertSame(Mesh.from_pyvista(mesh.to_pyvista()).vertices, mesh.vertices)


if __name__ == "__main__":
    unittest.main()
