"""A volume: voxels with their position in the patient."""

from __future__ import annotations

from typing import Any, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from ._shapeton import InputError, ParameterError

#: From LPS to RAS and back: x to the right instead of to the left, y to the front instead of to the back.
_RAS = np.diag([-1.0, -1.0, 1.0, 1.0])

_PERPENDICULAR = 1e-3  # tolerance for rounded headers

#: Facts on which automatic values depend, and their keys in the headers of ITK and SimpleITK.
_DICOM_FIELDS = {"modality": "0008|0060", "patient_position": "0018|5100", "slice_thickness": "0018|0050"}

#: Units of lengths of NIfTI.
_MILLIMETERS = {"meter": 1000.0, "mm": 1.0, "micron": 0.001}

Triple = Union[Sequence[float], NDArray[Any]]


class Image:
    """Voxels of a volume and their position in the patient.

    array
        Voxels, indexed ``[z, y, x]``; real numbers. The array is not copied. Functions of this package use it
        without a copy if it is C-contiguous and of the type they use (float32 for intensities, uint8 for masks), and
        convert it otherwise.
    spacing
        Voxel spacing along x, y, z; mm.
    origin
        Center of voxel ``[0, 0, 0]``; LPS (x to the left, y to the back, z to the head), mm.
    direction
        3 x 3; the columns are the unit vectors of the axes x, y, z of the array in LPS. They are perpendicular.
    facts
        Further information of an image read by `read_volume`: ``modality``, ``patient_position`` and
        ``slice_thickness`` (mm; 0: unknown), on which automatic values depend; ``series_uid``, ``identity``,
        ``repairs``, ``notes``.
    """

    __slots__ = ("_array", "_spacing", "_origin", "_direction", "facts")

    def __init__(
        self,
        array: Any,
        spacing: Triple = (1.0, 1.0, 1.0),
        origin: Triple = (0.0, 0.0, 0.0),
        direction: Any = None,
        facts: Optional[Mapping[str, Any]] = None,
    ) -> None:
        self._array = _volume(array)
        self._spacing = _triple("spacing", spacing)
        self._origin = _triple("origin", origin)
        self._direction = _axes(np.eye(3) if direction is None else direction)
        if facts is not None and not isinstance(facts, Mapping):
            raise ParameterError(f"the parameter \"facts\" must be a dictionary, not {type(facts).__name__}")
        self.facts = dict(facts or {})
        if not all(s > 0.0 for s in self._spacing):
            raise ParameterError(f"the parameter \"spacing\" = {self._spacing}: the spacing must be positive")

    @property
    def array(self) -> NDArray[Any]:
        """Voxels, indexed ``[z, y, x]``."""
        return self._array

    @property
    def spacing(self) -> tuple[float, float, float]:
        """Voxel spacing along x, y, z; mm."""
        return self._spacing

    @property
    def origin(self) -> tuple[float, float, float]:
        """Center of voxel ``[0, 0, 0]``; LPS, mm."""
        return self._origin

    @property
    def direction(self) -> NDArray[Any]:
        """3 x 3; the columns are the axes x, y, z of the array in LPS."""
        return self._direction

    @property
    def affine(self) -> NDArray[Any]:
        """4 x 4: maps the index (x, y, z, 1) of a voxel to its position in LPS, mm."""
        matrix = np.eye(4)
        matrix[:3, :3] = self._direction * np.asarray(self._spacing)
        matrix[:3, 3] = self._origin
        return matrix

    def like(self, array: Any) -> Image:
        """Returns an image with other voxels on the same grid, such as a filtered one or a mask.

        Of the facts it keeps those on which automatic values depend: modality, patient position and slice thickness.
        """
        voxels = _volume(array.array if isinstance(array, Image) else array)
        if voxels.shape != self._array.shape or (isinstance(array, Image) and not np.allclose(array.affine, self.affine)):
            raise ParameterError(
                f"the parameter \"array\" is on another grid than the {self._array.shape} voxels of the image; use "
                "Image(array, spacing, image.point(first_voxel), image.direction)"
            )
        facts = {name: self.facts[name] for name in _DICOM_FIELDS if name in self.facts}
        return Image(voxels, self._spacing, self._origin, self._direction, facts)

    def dicom_metadata(self) -> list[tuple[str, str]]:
        """The known facts on which automatic values depend, as keys and values of DICOM."""
        return [(key, str(self.facts[name])) for name, key in _DICOM_FIELDS.items() if self.facts.get(name)]

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        """The voxels, for numpy functions."""
        return np.asarray(self._array, dtype=dtype)

    def point(self, index: Any) -> NDArray[Any]:
        """Returns the position (LPS, mm) of a voxel ``[z, y, x]``, or of each row of such indices."""
        xyz = _rows("index", index)[..., ::-1]
        return np.asarray(xyz @ self.affine[:3, :3].T + self.affine[:3, 3])

    def index(self, point: Any) -> NDArray[Any]:
        """Returns the continuous index ``[z, y, x]`` of a position (LPS, mm), or of each row of such positions."""
        xyz = (_rows("point", point) - self.affine[:3, 3]) @ np.linalg.inv(self.affine[:3, :3]).T
        return np.asarray(xyz[..., ::-1])

    def __repr__(self) -> str:
        x, y, z = (f"{n} x {s:g} mm" for n, s in zip(reversed(self._array.shape), self._spacing))
        return f"<shapeton.Image x: {x}, y: {y}, z: {z}, {self._array.dtype}>"

    # ---- other packages, imported on first use ----

    @classmethod
    def of(cls, image: Any) -> Image:
        """From an image of nibabel, SimpleITK, itk, VTK or xarray, which is recognized by its attributes.

        All functions that take an image do this.
        """
        if isinstance(image, cls):
            return image
        for attributes, convert in (
            (("dataobj", "affine"), cls.from_nibabel),
            (("GetDirectionMatrix", "GetPointData"), cls.from_vtk),
            (("GetPixelIDTypeAsString", "GetDirection"), cls.from_sitk),
            (("GetLargestPossibleRegion", "GetDirection"), cls.from_itk),
            (("dims", "coords", "attrs"), cls.from_xarray),
        ):
            if all(hasattr(image, name) for name in attributes):
                return convert(image)
        raise TypeError(f"{type(image).__name__} is not an image of nibabel, SimpleITK, itk, VTK or xarray")

    @classmethod
    def from_affine(cls, array: Any, affine: Any, facts: Optional[Mapping[str, Any]] = None) -> Image:
        """From voxels ``[z, y, x]`` and a 4 x 4 matrix that maps the index (x, y, z, 1) to LPS, mm."""
        matrix = np.asarray(affine, dtype=np.float64)
        if matrix.shape != (4, 4) or not np.array_equal(matrix[3], (0.0, 0.0, 0.0, 1.0)):
            raise ParameterError("the parameter \"affine\" must be a 4 x 4 matrix with the last row 0, 0, 0, 1")
        spacing = np.linalg.norm(matrix[:3, :3], axis=0)
        if not np.all(spacing > 0.0):
            raise ParameterError("the parameter \"affine\" has a column of length 0: an axis has no direction")
        return cls(array, spacing, matrix[:3, 3], matrix[:3, :3] / spacing, facts)

    @classmethod
    def from_nibabel(cls, image: Any) -> Image:
        """From a nibabel image: voxels [x, y, z] are transposed (a view), RAS becomes LPS, other units mm.

        Without an orientation (sform and qform codes 0), the axes are left, posterior and superior, as in `read_volume`.
        """
        if image.affine is None:
            raise InputError("the nibabel image has no affine; use nibabel.Nifti1Image(voxels, affine)")
        voxels = np.asanyarray(image.dataobj)
        affine = np.asarray(image.affine)
        if "sform_code" in image.header and image.header["sform_code"] == 0 and image.header["qform_code"] == 0:
            affine = _RAS @ np.diag([*image.header.get_zooms()[:3], 1.0])
        units = image.header.get_xyzt_units()[0] if hasattr(image.header, "get_xyzt_units") else "mm"
        millimeters = np.diag([_MILLIMETERS.get(units, 1.0)] * 3 + [1.0])
        if voxels.ndim == 4 and voxels.shape[3] == 1:
            voxels = voxels[..., 0]
        try:
            return cls.from_affine(voxels.T, _RAS @ millimeters @ affine)
        except ParameterError as error:
            if "direction" not in str(error):
                raise
            raise InputError("the axes of the nibabel image are not perpendicular; resample it to a grid whose axes are") from None

    def to_nibabel(self) -> Any:
        """A nibabel.Nifti1Image; its voxels are a view."""
        import nibabel

        voxels = self._array.astype(np.uint8) if self._array.dtype == bool else self._array
        if voxels.dtype in (np.int64, np.uint64, np.float16):
            raise ParameterError(f"NIfTI images of {voxels.dtype} are not portable; convert it, for example by array.astype(\"i4\")")
        image = nibabel.Nifti1Image(voxels.T, _RAS @ self.affine)
        image.header.set_xyzt_units("mm")
        return image

    @classmethod
    def from_sitk(cls, image: Any) -> Image:
        """From a three-dimensional SimpleITK image; its voxels are a view if SimpleITK provides one."""
        import SimpleITK

        return cls(
            SimpleITK.GetArrayViewFromImage(image),
            image.GetSpacing(),
            image.GetOrigin(),
            np.reshape(image.GetDirection(), (3, 3)) if image.GetDimension() == 3 else None,
            {name: image.GetMetaData(key).strip() for name, key in _DICOM_FIELDS.items() if image.HasMetaDataKey(key)},
        )

    def to_sitk(self) -> Any:
        """A SimpleITK image; the voxels are copied."""
        import SimpleITK

        image = SimpleITK.GetImageFromArray(self._array)
        image.SetSpacing(self._spacing)
        image.SetOrigin(self._origin)
        image.SetDirection(self._direction.ravel().tolist())
        for name, key in _DICOM_FIELDS.items():
            if self.facts.get(name):
                image.SetMetaData(key, str(self.facts[name]))
        return image

    @classmethod
    def from_itk(cls, image: Any) -> Image:
        """From an image of the package itk; its voxels are a view."""
        import itk

        header = image.GetMetaDataDictionary()
        return cls(
            itk.array_view_from_image(image),
            tuple(image.GetSpacing()),
            tuple(image.GetOrigin()),
            itk.array_from_matrix(image.GetDirection()),
            {name: str(header[key]).strip() for name, key in _DICOM_FIELDS.items() if header.HasKey(key)},
        )

    def to_itk(self) -> Any:
        """An image of the package itk; its voxels are a view if they are C-contiguous."""
        import itk

        image = itk.image_view_from_array(np.ascontiguousarray(self._array))
        image.SetSpacing(self._spacing)
        image.SetOrigin(self._origin)
        image.SetDirection(itk.matrix_from_array(self._direction))
        return image

    @classmethod
    def from_xarray(cls, array: Any) -> Image:
        """From an xarray.DataArray such as that of `itk.xarray_from_image`; its voxels are a view.

        It has the axes x, y, z in any order with coordinates in mm, and may have an attribute "direction": the matrix of
        directions with reversed rows and columns.
        """
        if sorted(map(str, array.dims)) != ["x", "y", "z"]:
            raise InputError(f"the axes of the DataArray must be z, y, x, got {', '.join(map(str, array.dims))}")
        axes = [np.asarray(array.coords[name], dtype=np.float64) if name in array.coords else np.empty(0) for name in "xyz"]
        steps = [_step(name, axis) for name, axis in zip("xyz", axes)]
        affine = np.eye(4)
        affine[:3, :3] = np.flip(np.asarray(array.attrs.get("direction", np.eye(3)))) * steps
        affine[:3, 3] = [axis[0] for axis in axes]
        return cls.from_affine(array.transpose("z", "y", "x").values, affine)

    @classmethod
    def from_vtk(cls, image: Any) -> Image:
        """From a vtkImageData in LPS with one scalar per point; its voxels are a view."""
        from vtkmodules.util.numpy_support import vtk_to_numpy

        x, y, z = image.GetDimensions()
        scalars = image.GetPointData().GetScalars()
        if scalars is None or scalars.GetNumberOfComponents() != 1:
            raise InputError("the vtkImageData must have point scalars with one component")
        matrix = np.array([[image.GetDirectionMatrix().GetElement(i, j) for j in range(3)] for i in range(3)])
        extent = np.array(image.GetExtent()[::2], dtype=np.float64)
        spacing = np.array(image.GetSpacing())
        origin = np.array(image.GetOrigin()) + matrix @ (extent * spacing)
        return cls(vtk_to_numpy(scalars).reshape(z, y, x), spacing, origin, matrix)

    def to_vtk(self) -> Any:
        """A vtkImageData in LPS; its scalars are a view if the voxels are C-contiguous."""
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonDataModel import vtkImageData

        voxels = for_vtk(self._array)
        image = vtkImageData()
        image.SetDimensions(*reversed(self._array.shape))
        image.SetSpacing(self._spacing)
        image.SetOrigin(self._origin)
        image.SetDirectionMatrix(self._direction.ravel().tolist())
        image.GetPointData().SetScalars(numpy_to_vtk(voxels.ravel()))
        return image


def for_vtk(values: NDArray[Any]) -> NDArray[Any]:
    """Returns a C-contiguous array in native byte order, bool as uint8; copies only if necessary."""
    if values.dtype == np.float16:
        raise ParameterError("VTK has no float16; convert the array to float32")
    native = values.astype(np.uint8) if values.dtype == bool else values.astype(values.dtype.newbyteorder("="), copy=False)
    return np.ascontiguousarray(native)


def _volume(array: Any) -> NDArray[Any]:
    if isinstance(array, Image):
        raise ParameterError("the parameter \"array\" is an Image; use image.array, image.like(array) or the image itself")
    if np.ma.is_masked(array):
        raise ParameterError("the parameter \"array\" is masked; fill it, and give the mask as domain or mask of the function")
    voxels: NDArray[Any] = np.asarray(array)
    if voxels.dtype.kind not in "buif":
        advice = "; use shapeton.Image.of(image) for an image of another package" if voxels.dtype == object else ""
        raise ParameterError(f"the parameter \"array\" has the type {voxels.dtype}; an image requires real numbers{advice}")
    if voxels.ndim != 3 or voxels.size == 0:
        raise ParameterError(
            f"the parameter \"array\" has the shape {voxels.shape}; an image requires three non-empty axes z, y, x"
        )
    return voxels


def _rows(name: str, values: Any) -> NDArray[Any]:
    rows = np.asarray(values, dtype=np.float64)
    if rows.ndim == 0 or rows.shape[-1] != 3:
        raise ParameterError(f"the parameter \"{name}\" has the shape {rows.shape}; three numbers or rows of three are required")
    return rows


def _step(name: str, axis: NDArray[Any]) -> float:
    """The distance of the coordinates along an axis, which must be constant; negative if they descend."""
    steps = np.diff(axis)
    if len(steps) == 0 or not np.allclose(steps, steps[0], rtol=_PERPENDICULAR, atol=0.0):
        raise InputError(f"the DataArray must have two or more equally spaced coordinates along {name}")
    return float((axis[-1] - axis[0]) / len(steps))


def _triple(name: str, values: Triple) -> tuple[float, float, float]:
    numbers = np.asarray(values)
    if numbers.shape != (3,) or numbers.dtype.kind not in "uif" or not np.all(np.isfinite(numbers)):
        raise ParameterError(
            f"the parameter \"{name}\" = {values}: three finite numbers for x, y, z are required, such as (1, 1, 1)"
        )
    return float(numbers[0]), float(numbers[1]), float(numbers[2])


def _axes(direction: Any) -> NDArray[Any]:
    matrix = np.array(direction, dtype=np.float64)
    if matrix.shape != (3, 3) or not np.allclose(matrix.T @ matrix, np.eye(3), rtol=0.0, atol=_PERPENDICULAR):
        raise ParameterError("the parameter \"direction\" must have three perpendicular unit vectors as columns")
    matrix.flags.writeable = False
    return matrix
