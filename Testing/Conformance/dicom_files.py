"""Writes DICOM slices. License: CC0 1.0."""
import hashlib
import subprocess

import numpy as np
import pydicom
from case_files import Grid, phantom
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.uid import ExplicitVRLittleEndian

CT = "1.2.840.10008.5.1.4.1.1.2"
MR = "1.2.840.10008.5.1.4.1.1.4"
ENHANCED_CT = "1.2.840.10008.5.1.4.1.1.2.1"


def uid(*words):
    """A UID (PS3.5 B.2) that is the same in each run."""
    return "2.25." + str(int(hashlib.sha256(repr(words).encode()).hexdigest()[:30], 16))


def decimals(values):
    return [format(float(v), ".10g") for v in values]


def image(case, sop_class, number):
    """Identification of an image."""
    ds = Dataset()
    ds.SpecificCharacterSet = "ISO_IR 192"
    ds.SOPClassUID = sop_class
    ds.SOPInstanceUID = uid(case, "instance", number)
    ds.StudyInstanceUID = uid(case, "study")
    ds.SeriesInstanceUID = uid(case, "series")
    ds.FrameOfReferenceUID = uid(case, "frame")
    ds.Modality = "MR" if sop_class == MR else "CT"
    ds.ImageType = ["ORIGINAL", "PRIMARY", "AXIAL"]
    ds.PatientName, ds.PatientID = "Conformance^Case", "CONFORMANCE"
    ds.PatientBirthDate = ds.PatientSex = ds.StudyID = ds.ReferringPhysicianName = ds.AccessionNumber = ""
    ds.PatientPosition, ds.PositionReferenceIndicator, ds.Manufacturer = "HFS", "", "Shapeton"
    ds.StudyDate = ds.SeriesDate = ds.AcquisitionDate = ds.ContentDate = "20260101"
    ds.StudyTime = ds.SeriesTime = ds.AcquisitionTime = ds.ContentTime = "120000"
    ds.SeriesNumber, ds.AcquisitionNumber, ds.InstanceNumber = 1, 1, number
    ds.SeriesDescription, ds.StudyDescription = case, "conformance"
    if ds.Modality == "MR":
        ds.ScanningSequence, ds.SequenceVariant, ds.ScanOptions, ds.MRAcquisitionType = "GR", "SP", "", "3D"
        ds.EchoTime, ds.RepetitionTime, ds.EchoTrainLength = 5, 20, 1
    else:
        ds.KVP = 120
    return ds


def set_pixels(ds, stored, bits=16, bits_stored=None, signed=False):
    """Stored integers of one image or of frames."""
    stored = np.asarray(stored)
    bits_stored = bits_stored or bits
    ds.Rows, ds.Columns = stored.shape[-2:]
    ds.SamplesPerPixel, ds.PhotometricInterpretation = 1, "MONOCHROME2"
    ds.BitsAllocated, ds.BitsStored, ds.HighBit, ds.PixelRepresentation = bits, bits_stored, bits_stored - 1, int(signed)
    words = stored.astype(np.int64) & (2**bits - 1)
    data = words.astype("<u2" if bits == 16 else "u1").tobytes()
    ds.PixelData = data + b"\0" * (len(data) % 2)
    ds["PixelData"].VR = "OW" if bits == 16 else "OB"


def set_plane(ds, grid, place):
    ds.ImagePositionPatient = decimals(place)
    ds.ImageOrientationPatient = decimals([*grid.direction[:, 0], *grid.direction[:, 1]])
    ds.PixelSpacing = decimals([grid.spacing[1], grid.spacing[0]])  # rows first (PS3.3 10.7.1.1)
    ds.SliceThickness = decimals([grid.spacing[2]])[0]


def slices(case, grid, stored, sop_class=CT, rescale=(1, 0), **pixels):
    """The slices of a volume; stored integers are indexed z, y, x."""
    files = []
    for k in range(grid.size[2]):
        ds = image(case, sop_class, k + 1)
        set_plane(ds, grid, grid.place(0, 0, k))
        set_pixels(ds, stored[k], **pixels)
        if rescale:
            ds.RescaleSlope, ds.RescaleIntercept = decimals(rescale)
            ds.RescaleType = "HU"
        files.append(ds)
    return files


def save(ds, path, syntax=ExplicitVRLittleEndian):
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID = ds.SOPClassUID, ds.SOPInstanceUID
    meta.TransferSyntaxUID = syntax
    meta.ImplementationClassUID = uid("Shapeton conformance")
    meta.ImplementationVersionName = "CONFORMANCE"
    file = FileDataset(str(path), ds, preamble=b"\0" * 128, file_meta=meta)
    file.is_little_endian = syntax != pydicom.uid.ExplicitVRBigEndian
    file.is_implicit_VR = syntax == pydicom.uid.ImplicitVRLittleEndian
    if not file.is_little_endian and file.BitsAllocated == 16:
        file.PixelData = np.frombuffer(ds.PixelData, "<u2").byteswap().tobytes()
    file.save_as(str(path), write_like_original=False)


def save_all(files, folder, syntax=ExplicitVRLittleEndian, names=None):
    for k, ds in enumerate(files):
        save(ds, folder / (names[k] if names else f"im{k + 1:04d}.dcm"), syntax)


def compress(folder, option):
    """Compresses all files without loss by gdcmconv."""
    for path in sorted(folder.iterdir()):
        subprocess.run(["gdcmconv", option, str(path), str(path)], check=True, capture_output=True)


def encapsulated(frames):
    """Pixel data of compressed frames, each a list of fragments, with an empty offset table (PS3.5 A.4); pydicom ends it."""
    items = [b""] + [fragment + b"\0" * (len(fragment) % 2) for frame in frames for fragment in frame]
    return b"".join(b"\xfe\xff\x00\xe0" + len(item).to_bytes(4, "little") + item for item in items)


def plain(folder, case, grid=None, syntax=ExplicitVRLittleEndian, **options):
    """Writes a plain series of CT and returns its grid and intensities."""
    grid = grid or Grid()
    voxels = phantom(grid)
    save_all(slices(case, grid, voxels, **options), folder, syntax)
    slope, intercept = options.get("rescale", (1, 0)) or (1, 0)
    return grid, voxels * slope + intercept
