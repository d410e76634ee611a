"""Files of volumes."""

from __future__ import annotations

from typing import List, Optional, Sequence, Tuple

from . import _shapeton
from ._arguments import Path, Progress
from ._calls import public
from ._shapeton import DicomSeries
from .image import Image


@public
def list_series(path: Path, *, progress: Optional[Progress] = None) -> List[DicomSeries]:
    """The DICOM series in a folder, searched recursively, or in a file. Reads headers.

    progress: called with (share, stage), share from 0 to 1; returning False, an exception or Ctrl-C aborts.
    """
    return _shapeton.list_series(path, progress)


@public
def read_volume(
    path: Path,
    *,
    series_uid: str = "",
    resample_gaps: bool = False,
    deshear: bool = False,
    drop_duplicates: bool = False,
    allow_single_slice: bool = False,
    progress: Optional[Progress] = None,
) -> Image:
    """Reads a folder of DICOM slices, a DICOM file, or a NRRD, NIfTI or MetaImage file.

    An irregular series raises InputError with the name of the defect, unless its repair is allowed:

    series_uid: selects a series if the folder contains several (`DicomSeries.selector`).
    resample_gaps: fills gaps and uneven spacing by interpolation between slices.
    deshear: resamples a tilted volume onto perpendicular axes.
    drop_duplicates: keeps the first of several slices at one position.
    allow_single_slice: accepts a single slice as a volume.
    progress: for DICOM slices, called with (share, stage); returning False, an exception or Ctrl-C aborts.

    The image holds float32, rescaled: Hounsfield units for CT. Its `facts` hold modality, patient_position, series_uid,
    identity, repairs, notes. Files of other formats are read in one piece, for which Ctrl-C waits.
    """
    return _shapeton.read_volume(path, series_uid, resample_gaps, deshear, drop_duplicates, allow_single_slice, progress)


@public
def write_volume(image: Image, path: Path, metadata: Sequence[Tuple[str, str]] = ()) -> None:
    """Writes NRRD (.nrrd), NIfTI (.nii, .nii.gz) or MetaImage (.mha), as the tools do.

    metadata: pairs of texts for the header of NRRD and MetaImage.

    float32, int16, uint8, uint16 and uint32 are written unchanged, bool as uint8, float64 as float32 if that rounds no
    voxel; otherwise, and for other types, ParameterError is raised, so that a file always holds the values of the image.
    """
    _shapeton.write_volume(image, path, metadata)
