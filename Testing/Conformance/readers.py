#!/usr/bin/env python3
"""readers.py READER FOLDER RESULT.npz

Reads the case in a folder as a user of READER would, and writes pieces (arrays indexed z, y, x with 4 x 4 matrices from x, y, z to
LPS, mm): one volume, or slices that a library leaves to its user. Ends with status 3 if the reader refuses the case.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).parent
RAS = np.diag([-1.0, -1.0, 1.0, 1.0])
MILLIMETERS = {"meter": 1000.0, "mm": 1.0, "micron": 0.001, "unknown": 1.0}


class RefusalError(Exception):
    """The reader gives no volume."""


def only_file(folder):
    """The header, or the only file, of a case that is not DICOM."""
    for ending in (".nhdr", ".hdr"):
        for path in folder.glob("*" + ending):
            return path
    return next(path for path in folder.iterdir() if path.suffix != ".raw")


def is_dicom(folder):
    return not any(path.suffix in (".nii", ".gz", ".hdr", ".nrrd", ".nhdr") for path in folder.iterdir())


def affine(orientation, spacing, position, distance=1.0):
    """From column, row, slice to LPS; spacing in the order of DICOM, rows first."""
    row, column = np.array(orientation, float).reshape(2, 3)
    matrix = np.eye(4)
    matrix[:3, 0], matrix[:3, 1] = row * float(spacing[1]), column * float(spacing[0])
    matrix[:3, 2] = np.cross(row, column) * distance
    matrix[:3, 3] = np.array(position, float)
    return matrix


# ---- libraries of Python ----


def nibabel(folder):
    import nibabel as library

    image = library.load(only_file(folder))
    scale = MILLIMETERS[image.header.get_xyzt_units()[0]]
    array = np.asanyarray(image.dataobj, dtype=float)
    array = array.reshape(array.shape[:3])
    return [(array.T, RAS @ np.diag([scale, scale, scale, 1.0]) @ image.affine)]


def grid_of(files):
    """Size and matrix of a regular series, from its positions."""
    import pydicom as library

    slices = [library.dcmread(path, stop_before_pixels=True) for path in files]
    first = slices[0]
    normal = np.cross(first.ImageOrientationPatient[:3], first.ImageOrientationPatient[3:])
    slices.sort(key=lambda ds: np.dot(ds.ImagePositionPatient, normal))
    distance = np.dot(np.subtract(slices[1].ImagePositionPatient, slices[0].ImagePositionPatient), normal)
    matrix = affine(first.ImageOrientationPatient, first.PixelSpacing, slices[0].ImagePositionPatient, distance)
    return (len(slices), first.Rows, first.Columns), matrix, first


def segments_by_pydicom(folder):
    """The segment number of each voxel of the series: pixels of pixel_array, at the Image Position (Patient) of their frame."""
    import pydicom as library

    size, matrix, first = grid_of(dicom_files(folder / "series"))
    ds = library.dcmread(folder / "seg.dcm")
    if ds.FrameOfReferenceUID != first.FrameOfReferenceUID:
        raise RefusalError("another frame of reference")
    labels = np.zeros(size)
    shared = ds.SharedFunctionalGroupsSequence[0]
    half = ds.get("MaximumFractionalValue", 1) / 2
    for frame, pixels in zip(ds.PerFrameFunctionalGroupsSequence, ds.pixel_array):
        orientation = shared.PlaneOrientationSequence[0].ImageOrientationPatient
        spacing = shared.PixelMeasuresSequence[0].PixelSpacing
        own = affine(orientation, spacing, frame.PlanePositionSequence[0].ImagePositionPatient)
        is_map = "SegmentIdentificationSequence" not in frame
        number = None if is_map else frame.SegmentIdentificationSequence[0].ReferencedSegmentNumber
        row, column = np.nonzero(pixels if is_map else pixels >= half)
        index = np.linalg.inv(matrix) @ own @ np.stack([column, row, 0 * row, 0 * row + 1])
        i, j, k = np.rint(index[:3]).astype(int)
        labels[k, j, i] = pixels[row, column] if is_map else number
    return [(labels, matrix)]


def places(points):
    """Bright voxels at points."""
    pieces = []
    for point in points:
        matrix = np.eye(4)
        matrix[:3, 3] = point
        pieces.append((np.full((1, 1, 1), 1000.0), matrix))
    return pieces


def dicom_files(folder):
    return sorted(path for path in folder.rglob("*") if path.is_file())


def pydicom(folder):
    """pixel_array and apply_modality_lut of each slice or frame, at its Image Position (Patient)."""
    import pydicom as library
    from pydicom.pixel_data_handlers.util import apply_modality_lut

    if (folder / "seg.dcm").exists():
        return segments_by_pydicom(folder)
    pieces = []
    for path in dicom_files(folder):
        try:
            ds = library.dcmread(path)
        except library.errors.InvalidDicomError:
            continue
        groups = ds.get("PerFrameFunctionalGroupsSequence")
        if groups is None:
            values = apply_modality_lut(ds.pixel_array, ds)
            pieces.append((values[None], affine(ds.ImageOrientationPatient, ds.PixelSpacing, ds.ImagePositionPatient)))
            continue
        shared = ds.SharedFunctionalGroupsSequence[0]
        for frame, pixels in zip(groups, ds.pixel_array):
            plane = (frame if "PlaneOrientationSequence" in frame else shared).PlaneOrientationSequence[0]
            measures = (frame if "PixelMeasuresSequence" in frame else shared).PixelMeasuresSequence[0]
            values = apply_modality_lut(pixels, frame.PixelValueTransformationSequence[0])
            position = frame.PlanePositionSequence[0].ImagePositionPatient
            pieces.append((values[None], affine(plane.ImageOrientationPatient, measures.PixelSpacing, position)))
    if not pieces:
        raise RefusalError("no file is DICOM")
    return pieces


def gdcm(folder):
    """ImageReader: origin, direction, spacing and rescaling of each file."""
    import gdcm as library

    kinds = {"INT8": "i1", "UINT8": "u1", "INT16": "<i2", "UINT16": "<u2", "INT12": "<i2", "UINT12": "<u2"}
    pieces = []
    for path in dicom_files(folder):
        reader = library.ImageReader()
        reader.SetFileName(str(path))
        if not reader.Read():
            if path.suffix == ".dcm":
                raise RefusalError(f"cannot read {path.name}")
            continue
        image = reader.GetImage()
        data = image.GetBuffer().encode("utf-8", errors="surrogateescape")
        kind = kinds[image.GetPixelFormat().GetScalarTypeAsString()]
        size = [image.GetDimension(i) for i in range(image.GetNumberOfDimensions())][::-1]
        array = np.frombuffer(data, kind).reshape(size).astype(float) * image.GetSlope() + image.GetIntercept()
        spacing = [image.GetSpacing(i) for i in range(3)]
        orientation = [image.GetDirectionCosines(i) for i in range(6)]
        origin = [image.GetOrigin(i) for i in range(3)]
        array = array.reshape((-1,) + array.shape[-2:])
        pieces.append((array, affine(orientation, spacing[1::-1], origin, spacing[2])))
    if not pieces:
        raise RefusalError("no file is DICOM")
    return pieces


# ---- programs ----


def run(command, **options):
    """The output of a program; it is also shown, because warnings count."""
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=100, errors="replace", **options)
    print(done.stdout + done.stderr)
    if done.returncode != 0:
        raise RefusalError(f"status {done.returncode}")
    return done.stdout + done.stderr


def volumes_in(folder, pattern="*.nii"):
    import nibabel as library

    found = sorted(folder.glob(pattern))
    if not found:
        raise RefusalError("no volume was written")
    pieces = []
    for path in found:
        image = library.load(path)
        array = np.asanyarray(image.dataobj, dtype=float)
        pieces.append((array.reshape(array.shape[:3]).T, RAS @ image.affine))
    return pieces


def results_by_shapeton(folder):
    """Labels of a segmentation, or points of a report."""
    with tempfile.TemporaryDirectory() as result:
        tool = pathlib.Path(os.environ["SHAPETON_TOOLS"]) / "DicomResultsToColon"
        if (folder / "seg.dcm").exists():
            run([tool, folder / "seg.dcm", folder / "series", "--labels", result + "/labels.nii", "--quiet"])
            return volumes_in(pathlib.Path(result))
        markers = pathlib.Path(result) / "points.mrk.json"
        run([tool, folder / "sr.dcm", folder / "series", "--markers", markers, "--quiet"])
        markups = json.loads(markers.read_text())["markups"]
        sign = {"LPS": (1, 1, 1), "RAS": (-1, -1, 1)}
        return places(np.multiply(point["position"], sign[one["coordinateSystem"]]) for one in markups for point in one["controlPoints"])


def shapeton(folder):
    if (folder / "series").exists():
        return results_by_shapeton(folder)
    with tempfile.TemporaryDirectory() as result:
        source = folder if is_dicom(folder) else only_file(folder)
        tool = pathlib.Path(os.environ["SHAPETON_TOOLS"]) / "DicomSeriesToImage"
        run([tool, source, result + "/volume.nii", "--quiet"])
        return volumes_in(pathlib.Path(result))


def itk(folder):
    with tempfile.TemporaryDirectory() as result:
        source = folder if is_dicom(folder) else only_file(folder)
        run([pathlib.Path(os.environ["SHAPETON_TOOLS"]) / "ItkVolumeReader", source, result + "/volume.nii"])
        return volumes_in(pathlib.Path(result))


def plastimatch(folder):
    with tempfile.TemporaryDirectory() as result:
        source = folder if is_dicom(folder) else only_file(folder)
        run(["plastimatch", "convert", "--input", source, "--output-img", result + "/volume.nii", "--output-type", "float"])
        return volumes_in(pathlib.Path(result))


def dcm2niix(folder):
    """Where it writes a volume of equal distances too (_Eq), that one; where it writes a corrected tilt (_Tilt), that one."""
    with tempfile.TemporaryDirectory() as result:
        run(["dcm2niix", "-o", result, "-f", "volume", folder])
        folder = pathlib.Path(result)
        for pattern in ("*_Eq*.nii", "*_Tilt*.nii"):
            if any(folder.glob(pattern)):
                return volumes_in(folder, pattern)
        return volumes_in(folder)


def dcmjs(folder):
    """The pixels of uncompressed files, with slope, intercept and plane of each file."""
    text = run(["node", HERE / "read-dcmjs.mjs", *dicom_files(folder)], cwd=os.environ["SHAPETON_NODE_MODULES"])
    pieces = planes(json.loads(text.splitlines()[-1]))
    if not pieces:
        raise RefusalError("no file is DICOM")
    return pieces


def planes(images):
    pieces = []
    for image in images:
        array = np.array(image["pixels"], float).reshape(1, image["rows"], image["columns"])
        pieces.append((array * image["slope"] + image["intercept"], affine(image["orientation"], image["spacing"], image["position"])))
    return pieces


def ohif(folder):
    """The pixels, labels or points that the viewer holds in Chromium, after Orthanc took the files."""
    with tempfile.TemporaryDirectory() as work:
        package = os.environ["SHAPETON_NODE_MODULES"] + "/ohif"
        text = run(["node", HERE / "read-ohif.mjs", package, work + "/orthanc", folder])
    found = json.loads(next(line for line in text.splitlines() if line.startswith('{"p')))
    return places(found["points"]) if "points" in found else planes(found["planes"])


READERS = {
    "shapeton": (shapeton, ("DICOM", "NIfTI", "NRRD", "SEG", "SR")),
    "itk": (itk, ("DICOM", "NIfTI", "NRRD")),
    "plastimatch": (plastimatch, ("DICOM", "NIfTI", "NRRD")),
    "dcm2niix": (dcm2niix, ("DICOM",)),
    "gdcm": (gdcm, ("DICOM",)),
    "pydicom": (pydicom, ("DICOM", "SEG")),
    "dcmjs": (dcmjs, ("DICOM",)),
    "ohif": (ohif, ("DICOM", "SEG", "SR")),
    "nibabel": (nibabel, ("NIfTI",)),
}


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    read, _ = READERS[sys.argv[1]]
    try:
        pieces = read(pathlib.Path(sys.argv[2]))
    except Exception as error:  # whatever a library throws is its refusal
        print(f"refused: {type(error).__name__}: {error}")
        sys.exit(3)
    arrays = {f"array{i}": array for i, (array, _) in enumerate(pieces)}
    matrices = {f"matrix{i}": matrix for i, (_, matrix) in enumerate(pieces)}
    np.savez(sys.argv[3], **arrays, **matrices)


if __name__ == "__main__":
    main()
