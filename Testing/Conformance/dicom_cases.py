"""DICOM series of single-frame images. License: CC0 1.0."""
import base64
import shutil

import numpy as np
import pydicom
from case_files import BRIGHT, PLACES, REFUSAL, Grid, case, oblique, phantom
from dicom_files import CT, MR, compress, decimals, encapsulated, image, plain, save, save_all, set_pixels, set_plane, slices
from pydicom.tag import Tag

POSITION = "PS3.3 C.7.6.2.1.1"
MODALITY_LUT = "PS3.3 C.11.1"
PIXELS = "PS3.5 8.1.1"
NUMBERS = [4, 1, 6, 2, 5, 3]  # a permutation of six slices

# ---- order and geometry ----


@case("ct-plain", "DICOM", "six slices", POSITION)
def _(folder):
    return plain(folder, "ct-plain")


@case("ct-random-order", "DICOM", "file names and instance numbers are unrelated to positions", POSITION)
def _(folder):
    grid, voxels = Grid(), phantom()
    files = slices("ct-random-order", grid, voxels)
    for ds, number in zip(files, NUMBERS):
        ds.InstanceNumber = 7 * number % 11
    save_all(files, folder, names=[f"{number}.dcm" for number in NUMBERS])
    return grid, voxels


@case("ct-slice-location-wrong", "DICOM", "Slice Location and Slice Thickness contradict the positions", "PS3.3 C.7.6.2.1.2")
def _(folder):
    grid, voxels = Grid(), phantom()
    files = slices("ct-slice-location-wrong", grid, voxels)
    for k, ds in enumerate(files):
        ds.SliceLocation, ds.SliceThickness = decimals([100 - 7 * k, 9])
    save_all(files, folder)
    return grid, voxels


@case("mr-spacing-between-slices-wrong", "DICOM", "Spacing Between Slices contradicts the positions", POSITION)
def _(folder):
    grid, voxels = Grid(), phantom()
    files = slices("mr-spacing-between-slices-wrong", grid, voxels, sop_class=MR, rescale=None)
    for ds in files:
        ds.SpacingBetweenSlices = "1"
    save_all(files, folder)
    return grid, voxels


@case("ct-oblique", "DICOM", "oblique slices of anisotropic pixels", POSITION)
def _(folder):
    return plain(folder, "ct-oblique", Grid(direction=oblique()))


@case("ct-sagittal", "DICOM", "sagittal slices", POSITION)
def _(folder):
    return plain(folder, "ct-sagittal", Grid(direction=np.array([[0.0, 0, -1], [1, 0, 0], [0, -1, 0]])))


@case("ct-decubitus", "DICOM", "a patient on the left side: the rows point to the feet of the table", POSITION)
def _(folder):
    grid, voxels = Grid(direction=np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]])), phantom()
    files = slices("ct-decubitus", grid, voxels)
    for ds in files:
        ds.PatientPosition = "HFDL"
    save_all(files, folder)
    return grid, voxels


@case("ct-rows-to-the-head", "DICOM", "columns run upward: the axes are mirrored against the usual order", POSITION)
def _(folder):
    return plain(folder, "ct-rows-to-the-head", Grid(direction=np.array([[1.0, 0, 0], [0, -1, 0], [0, 0, -1]])))


def box_in_space(place):
    """1,000 in a box, of which each slice takes its part."""
    center, half = np.array([-14.0, 40.0, -83.0]), np.array([4.5, 6.5, 3.9])
    return 1000 * np.all(np.abs(place - center) <= half, axis=-1), center, half


def save_places(folder, name, origins):
    """Axial slices at these origins; returns the box as center (origin) and standard deviations (spacing)."""
    grid = Grid(size=(24, 40, len(origins)), spacing=(1.0, 1.0, 2.0))
    rows, columns = np.mgrid[0:40, 0:24]
    files = []
    inside = []
    for k, origin in enumerate(origins):
        places = np.stack([origin[0] + columns, origin[1] + rows, np.full(rows.shape, origin[2])], axis=-1)
        pixels, _, _ = box_in_space(places)
        inside.append(places[pixels > BRIGHT])
        ds = image(name, CT, k + 1)
        set_plane(ds, grid, origin)
        set_pixels(ds, pixels)
        ds.RescaleSlope, ds.RescaleIntercept = "1", "0"
        files.append(ds)
    save_all(files, folder)
    inside = np.concatenate(inside)
    return Grid(grid.size, tuple(inside.std(axis=0)), tuple(inside.mean(axis=0))), np.zeros(0)


@case("ct-gantry-tilt", "DICOM", "positions move by 0.73 mm along the columns from slice to slice", POSITION, PLACES)
def _(folder):
    return save_places(folder, "ct-gantry-tilt", [(-26.0, 15.0 + 0.73 * k, -105.0 + 2 * k) for k in range(16)])


@case("ct-gap", "DICOM", "three slices are missing", POSITION, PLACES)
def _(folder):
    return save_places(folder, "ct-gap", [(-26.0, 20.0, -105.0 + 2 * k) for k in range(16) if k not in (4, 5, 6)])


@case("ct-variable-spacing", "DICOM", "the first slices are 5 mm apart, the last ones 2 mm", POSITION, PLACES)
def _(folder):
    places = [-125.0 + 5 * k for k in range(6)] + [-98.0 + 2 * k for k in range(11)]
    return save_places(folder, "ct-variable-spacing", [(-26.0, 20.0, z) for z in places])


# ---- intensities ----


@case("ct-slope-per-slice", "DICOM", "each slice has its own slope and intercept", MODALITY_LUT)
def _(folder):
    grid, voxels = Grid(), phantom()
    files = slices("ct-slope-per-slice", grid, voxels)
    expected = voxels.astype(float)
    for k, ds in enumerate(files):
        ds.RescaleSlope, ds.RescaleIntercept = decimals([0.5 + 0.25 * k, -10 * k])
        expected[k] = voxels[k] * (0.5 + 0.25 * k) - 10 * k
    save_all(files, folder)
    return grid, expected


@case("ct-signed-12-bits", "DICOM", "signed numbers of 12 bits in words of 16: the sign is bit 11", PIXELS)
def _(folder):
    grid, voxels = Grid(), phantom() - 300
    files = slices("ct-signed-12-bits", grid, voxels, signed=True, bits_stored=12)
    for ds in files:
        ds.PixelData = (np.frombuffer(ds.PixelData, "<u2") & 0x0FFF).astype("<u2").tobytes()
    save_all(files, folder)
    return grid, voxels


@case("ct-overlay-in-high-bits", "DICOM", "an overlay in bit 12 beside pixels of 12 bits", PIXELS)
def _(folder):
    grid = Grid(size=(16, 10, 6))  # GDCM 3.0 ends the process unless an overlay fills whole bytes
    voxels = phantom(grid)
    files = slices("ct-overlay-in-high-bits", grid, voxels, bits_stored=12)
    for ds in files:
        words = np.frombuffer(ds.PixelData, "<u2").copy()
        words[::3] |= 0x1000
        ds.PixelData = words.tobytes()
        ds.add_new(Tag(0x6000, 0x0010), "US", ds.Rows)
        ds.add_new(Tag(0x6000, 0x0011), "US", ds.Columns)
        ds.add_new(Tag(0x6000, 0x0040), "CS", "G")
        ds.add_new(Tag(0x6000, 0x0050), "SS", [1, 1])
        ds.add_new(Tag(0x6000, 0x0100), "US", 16)
        ds.add_new(Tag(0x6000, 0x0102), "US", 12)
    save_all(files, folder)
    return grid, voxels


@case("ct-8-bits", "DICOM", "bytes, an odd number of them per slice", PIXELS)
def _(folder):
    grid = Grid(size=(13, 9, 6))
    voxels = phantom(grid) // 4
    save_all(slices("ct-8-bits", grid, voxels, bits=8), folder)
    return grid, voxels


@case("ct-monochrome1", "DICOM", "MONOCHROME1 concerns the display, not the numbers", "PS3.3 C.7.6.3.1.2")
def _(folder):
    grid, voxels = Grid(), phantom()
    files = slices("ct-monochrome1", grid, voxels, rescale=(1, -1024))
    for ds in files:
        ds.PhotometricInterpretation = "MONOCHROME1"
    save_all(files, folder)
    return grid, voxels - 1024


@case("ct-padding-of-wrong-vr", "DICOM", "Pixel Padding Value is SS beside unsigned pixels", "PS3.3 C.7.5.1.1.2")
def _(folder):
    grid, voxels = Grid(), phantom()
    stored = voxels.copy()
    stored[:, :, :2] = 0xF830
    files = slices("ct-padding-of-wrong-vr", grid, stored)
    for ds in files:
        ds.add_new(Tag(0x0028, 0x0120), "SS", -2000)
    save_all(files, folder)
    return grid, np.where(stored == 0xF830, np.nan, voxels)


# ---- encodings ----


@case("ct-big-endian", "DICOM", "explicit big endian", "PS3.5 (2016) A.3")
def _(folder):
    return plain(folder, "ct-big-endian", syntax=pydicom.uid.ExplicitVRBigEndian)


@case("ct-deflated", "DICOM", "deflated data set", "PS3.5 A.5")
def _(folder):
    return plain(folder, "ct-deflated", syntax=pydicom.uid.DeflatedExplicitVRLittleEndian)


def compressed(name, title, option):
    @case(name, "DICOM", title, "PS3.5 A.4")
    def _(folder):
        result = plain(folder, name, rescale=(1, -100))
        compress(folder, option)
        return result


compressed("ct-rle", "RLE Lossless", "--rle")
compressed("ct-jpeg-lossless", "JPEG lossless", "--jpeg")
compressed("ct-jpeg-ls", "JPEG-LS lossless", "--jpegls")
compressed("ct-jpeg-2000", "JPEG 2000 lossless", "--j2k")

# One slice of the ramp with the box, without the step along z, encoded by OpenJPH 0.31.
HTJ2K = base64.b64decode(
    "/0//UQApQAAAAAAOAAAACgAAAAAAAAAAAAAADgAAAAoAAAAAAAAAAAABDwEB/1AACAACAAAACv9SAAwAAgABAAUEBEAB/1wAEyCIkJCQkJCQkJCQkJCQiIiI"
    "/2QAFwABT3BlbkpQSCBWZXIgMC4zMS4wLv+QAAoAAAAAANQAAf+TwAAlJQUHdAAAwAASwAASwAASgIgBh3QA9ACHdACSAQd0AMAAFRAABPAABMCcEP9SAMa0"
    "AA9o+QCCNADwjQCCNADAABaMAAFbAABWAGDiK9i85jcI+gDC3BCBvZgAYlML5AvkYlMCEAKVAMSnFYl4+gAAAH2WAMAALZgABb0AAK8xMgd3Be9KhpAACD/2"
    "AJHx+XiJ2e/wA9ABkcuRKwZ2fdwVBgEBAQEBARF2tnKQRSPGASEIv94Ax6PR+DAIHxBB4gfxA9sA/9k="
)


@case("ct-htj2k", "DICOM", "High-Throughput JPEG 2000 lossless", "PS3.5 A.4.4")
def _(folder):
    grid = Grid()
    voxels = np.repeat(phantom()[2:3] - 22, grid.size[2], axis=0)
    files = slices("ct-htj2k", grid, voxels)
    for ds in files:
        ds.PixelData = encapsulated([[HTJ2K]])
        ds["PixelData"].VR = "OB"
        ds["PixelData"].is_undefined_length = True
    known = b"1.2.840.10008.1.2.4.100"  # pydicom 2 writes no HTJ2K; another UID of this length takes its place
    save_all(files, folder, syntax=known.decode())
    for path in folder.iterdir():
        path.write_bytes(path.read_bytes().replace(known, b"1.2.840.10008.1.2.4.201"))
    return grid, voxels


@case("ct-fragments", "DICOM", "each frame of JPEG 2000 in three fragments", "PS3.5 A.4")
def _(folder):
    result = plain(folder, "ct-fragments")
    compress(folder, "--j2k")
    for path in folder.iterdir():
        ds = pydicom.dcmread(path)
        frame = next(pydicom.encaps.generate_pixel_data_frame(ds.PixelData))
        third = len(frame) // 6 * 2
        ds.PixelData = encapsulated([[frame[:third], frame[third : 2 * third], frame[2 * third :]]])
        ds.save_as(path)
    return result


@case("ct-vr-un", "DICOM", "position, orientation and spacing have VR UN", "PS3.5 6.2.2")
def _(folder):
    grid, voxels = Grid(), phantom()
    files = slices("ct-vr-un", grid, voxels)
    for ds in files:
        for keyword in ("ImagePositionPatient", "ImageOrientationPatient", "PixelSpacing", "RescaleIntercept"):
            value = ds[keyword].value
            text = "\\".join(map(str, value)) if isinstance(value, pydicom.multival.MultiValue) else str(value)
            ds[keyword] = pydicom.DataElement(ds[keyword].tag, "UN", (text + " " * (len(text) % 2)).encode())
    save_all(files, folder)
    return grid, voxels


@case("ct-private-and-sequences", "DICOM", "private attributes and sequences of undefined length before the pixels", "PS3.5 7.5")
def _(folder):
    grid, voxels = Grid(), phantom()
    files = slices("ct-private-and-sequences", grid, voxels)
    for ds in files:
        item = pydicom.Dataset()
        item.CodeValue, item.CodingSchemeDesignator, item.CodeMeaning = "1", "99X", "x"
        ds.ProcedureCodeSequence = pydicom.Sequence([item])
        ds["ProcedureCodeSequence"].is_undefined_length = True
        ds.add_new(Tag(0x0029, 0x0010), "LO", "SHAPETON CONFORMANCE")
        ds.add_new(Tag(0x0029, 0x1001), "UN", b"\xfe\xff\x0d\xe0\0\0\0\0" * 3)
        icon = pydicom.Dataset()
        set_pixels(icon, np.zeros((2, 2)), bits=8)
        ds.IconImageSequence = pydicom.Sequence([icon])
    save_all(files, folder)
    return grid, voxels


@case("ct-character-sets", "DICOM", "names in ISO 2022 IR 87, a description in an undeclared set", "PS3.5 6.1")
def _(folder):
    grid, voxels = Grid(), phantom()
    files = slices("ct-character-sets", grid, voxels)
    for ds in files:
        ds.SpecificCharacterSet = ["", "ISO 2022 IR 87"]
        ds.PatientName = b"Yamada^Tarou=\x1b$B;3ED\x1b(B^\x1b$BB@O:\x1b(B"
        ds["SeriesDescription"] = pydicom.DataElement(Tag(0x0008, 0x103E), "UN", b"Sch\xe4del ")
    save_all(files, folder)
    return grid, voxels


# ---- folders ----


@case("ct-copies", "DICOM", "two files of the folder are exact copies of slices", "PS3.5 9.1")
def _(folder):
    result = plain(folder, "ct-copies")
    (folder / "copy").mkdir()
    for name in ("im0001.dcm", "im0004.dcm"):
        shutil.copy(folder / name, folder / "copy" / name)
    return result


@case("ct-other-files", "DICOM", "a text, an empty file and a file without extension beside the slices", "PS3.10 7.1")
def _(folder):
    result = plain(folder, "ct-other-files")
    (folder / "readme.txt").write_text("slices\n")
    (folder / "empty").write_bytes(b"")
    (folder / "im0003.dcm").rename(folder / "slice")
    return result


@case("ct-without-meta", "DICOM", "implicit little endian without preamble and file meta information", "PS3.10 7.1")
def _(folder):
    grid, voxels = Grid(), phantom()
    for k, ds in enumerate(slices("ct-without-meta", grid, voxels)):
        ds.is_little_endian, ds.is_implicit_VR = True, True
        pydicom.dcmwrite(str(folder / f"im{k}.dcm"), ds, write_like_original=True)
    return grid, voxels


@case("ct-group-length-wrong", "DICOM", "invalid: a wrong group length of the file meta information", "PS3.10 7.1")
def _(folder):
    result = plain(folder, "ct-group-length-wrong")
    for path in folder.iterdir():
        content = bytearray(path.read_bytes())
        content[140:144] = (int.from_bytes(content[140:144], "little") + 20).to_bytes(4, "little")
        path.write_bytes(content)
    return result


@case("ct-decimal-comma", "DICOM", "invalid: Pixel Spacing 0,75", "PS3.5 6.2 (DS)", REFUSAL)
def _(folder):
    grid, voxels = Grid(), phantom()
    save_all(slices("ct-decimal-comma", grid, voxels), folder)
    for path in folder.iterdir():
        content = path.read_bytes()
        path.write_bytes(content.replace(b"1.25\\0.75", b"1,25\\0,75"))
    return None, None


@case("ct-truncated", "DICOM", "invalid: a file ends within its pixels", PIXELS, REFUSAL)
def _(folder):
    plain(folder, "ct-truncated")
    path = folder / "im0003.dcm"
    path.write_bytes(path.read_bytes()[:-100])
    return None, None


