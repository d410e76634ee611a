"""DICOM segmentations, label maps and reports on a series of CT. License: CC0 1.0."""
import numpy as np
from case_files import PLACES, REFUSAL, Grid, case, oblique, phantom
from dicom_files import CT, decimals, image, save, save_all, slices, uid
from pydicom.dataset import Dataset
from pydicom.uid import ExplicitVRLittleEndian, RLELossless

SEGMENTATION = "1.2.840.10008.5.1.4.1.1.66.4"
LABEL_MAP = "1.2.840.10008.5.1.4.1.1.66.7"
REPORT = "1.2.840.10008.5.1.4.1.1.88.34"
FRAMES = "PS3.3 C.8.20.2, C.7.6.16.2.3"
OVERLAP = "PS3.3 C.8.20.2.4"
POINTS = "PS3.3 C.18.6"
SEGMENTS = ("one", "two")


def code(value, scheme, meaning):
    ds = Dataset()
    ds.CodeValue, ds.CodingSchemeDesignator, ds.CodeMeaning = value, scheme, meaning
    return ds


def item(**values):
    ds = Dataset()
    for keyword, value in values.items():
        setattr(ds, keyword, value)
    return ds


def masks(grid):
    """Two boxes that touch: labels 1 and 2, indexed z, y, x."""
    z, y, x = np.indices(grid.size[::-1])
    is_high = (y >= 3) & (y < 8) & (z >= 1) & (z < 5)
    return 1 * ((x >= 2) & (x < 6) & is_high) + 2 * ((x >= 6) & (x < 11) & is_high & (y > 4))


def series(folder, name, grid):
    """Writes the series to its own folder."""
    (folder / "series").mkdir()
    files = slices(name, grid, phantom(grid))
    save_all(files, folder / "series")
    return files


def header(name, sop_class, modality, files, number):
    """A result of the series."""
    ds = image(name, sop_class, number)
    ds.SOPInstanceUID, ds.SeriesInstanceUID = uid(name, modality, number), uid(name, modality, "series")
    ds.Modality, ds.SeriesNumber, ds.SeriesDescription = modality, 2, modality + " of " + name
    ds.ManufacturerModelName, ds.DeviceSerialNumber, ds.SoftwareVersions = "pack", "1", "1"
    for keyword in ("KVP", "PatientPosition", "AcquisitionNumber"):
        if keyword in ds:
            delattr(ds, keyword)
    references = [item(ReferencedSOPClassUID=CT, ReferencedSOPInstanceUID=one.SOPInstanceUID) for one in files]
    ds.ReferencedSeriesSequence = [item(SeriesInstanceUID=files[0].SeriesInstanceUID, ReferencedInstanceSequence=references)]
    return ds


def segments(names=SEGMENTS):
    tissue = code("85756007", "SCT", "Tissue")
    colors = ([43000, 48000, 47000], [34000, 20000, 30000])
    return [
        item(
            SegmentNumber=i + 1,
            SegmentLabel=name,
            SegmentAlgorithmType="MANUAL",
            SegmentedPropertyCategoryCodeSequence=[tissue],
            SegmentedPropertyTypeCodeSequence=[tissue],
            RecommendedDisplayCIELabValue=colors[i % 2],
        )
        for i, name in enumerate(names)
    ]


def segmentation(name, files, planes, frame_grid, kind="BINARY"):
    """planes: (segment number, or 0 in a label map; place of the first pixel; pixels; source slice or None for all)."""
    is_map = kind == "LABELMAP"
    ds = header(name, LABEL_MAP if is_map else SEGMENTATION, "SEG", files, 1)
    ds.ImageType, ds.LossyImageCompression = ["DERIVED", "PRIMARY"], "00"
    ds.ContentLabel, ds.ContentDescription, ds.ContentCreatorName = "SEGMENTS", "", ""
    ds.SegmentationType, ds.SegmentSequence = kind, segments()
    if kind == "FRACTIONAL":
        ds.SegmentationFractionalType, ds.MaximumFractionalValue = "OCCUPANCY", 200
    if not is_map:
        ds.SegmentsOverlap = "NO"
    ds.InstanceNumber, ds.NumberOfFrames = 1, len(planes)
    pixels = np.stack([plane[2] for plane in planes])
    ds.Rows, ds.Columns = pixels.shape[1:]
    bits = 1 if kind == "BINARY" else 8
    ds.SamplesPerPixel, ds.PhotometricInterpretation, ds.PixelRepresentation = 1, "MONOCHROME2", 0
    ds.BitsAllocated = ds.BitsStored = bits
    ds.HighBit = bits - 1
    data = (np.packbits(pixels.ravel() > 0, bitorder="little") if bits == 1 else pixels.astype("u1")).tobytes()
    ds.PixelData = data + b"\0" * (len(data) % 2)
    ds["PixelData"].VR = "OB"
    if is_map:
        ds.PixelPaddingValue = 0
        ds["PixelPaddingValue"].VR = "US"
    dimension = uid(name, "dimensions")
    ds.DimensionOrganizationSequence = [item(DimensionOrganizationUID=dimension)]
    pointers = [] if is_map else [(0x0062000B, 0x0062000A, "Segment")]
    pointers += [(0x00200032, 0x00209113, "Position")]
    ds.DimensionIndexSequence = [
        item(DimensionOrganizationUID=dimension, DimensionIndexPointer=tag, FunctionalGroupPointer=group, DimensionDescriptionLabel=text)
        for tag, group, text in pointers
    ]
    axes = frame_grid.direction
    measures = item(
        PixelSpacing=decimals([frame_grid.spacing[1], frame_grid.spacing[0]]),
        SliceThickness=decimals([frame_grid.spacing[2]])[0],
        SpacingBetweenSlices=decimals([frame_grid.spacing[2]])[0],
    )
    orientation = item(ImageOrientationPatient=decimals([*axes[:, 0], *axes[:, 1]]))
    ds.SharedFunctionalGroupsSequence = [item(PixelMeasuresSequence=[measures], PlaneOrientationSequence=[orientation])]
    places = sorted({tuple(decimals(plane[1])) for plane in planes}, key=lambda p: np.dot(np.array(p, float), axes[:, 2]))
    ds.PerFrameFunctionalGroupsSequence = []
    for number, place, _, source in planes:
        index = places.index(tuple(decimals(place))) + 1
        frame = item(
            PlanePositionSequence=[item(ImagePositionPatient=decimals(place))],
            FrameContentSequence=[item(DimensionIndexValues=[index] if is_map else [number, index])],
        )
        if not is_map:
            frame.SegmentIdentificationSequence = [item(ReferencedSegmentNumber=number)]
        purpose = code("121322", "DCM", "Source image for image processing operation")
        references = [
            item(ReferencedSOPClassUID=CT, ReferencedSOPInstanceUID=one.SOPInstanceUID, PurposeOfReferenceCodeSequence=[purpose])
            for one in (files if source is None else [files[source]])
        ]
        derivation = item(SourceImageSequence=references, DerivationCodeSequence=[code("113076", "DCM", "Segmentation")])
        frame.DerivationImageSequence = [derivation]
        ds.PerFrameFunctionalGroupsSequence.append(frame)
    return ds


def planes_of(grid, labels, order=None):
    """One frame per segment and slice with voxels, by segment."""
    found = [
        (number, grid.place(0, 0, z), labels[z] == number, z)
        for number in (1, 2)
        for z in range(grid.size[2])
        if (labels[z] == number).any()
    ]
    return [found[i] for i in order(len(found))] if order else found


def make(folder, name, planes, grid=None, frame_grid=None, syntax=ExplicitVRLittleEndian, change=None, **options):
    """Writes series and segmentation, and returns the grid and the expected labels."""
    grid = grid or Grid()
    labels = masks(grid)
    files = series(folder, name, grid)
    ds = segmentation(name, files, planes(grid, labels), frame_grid or grid, **options)
    if change:
        change(ds, files)
    if syntax == RLELossless:
        ds.file_meta = Dataset()
        ds.is_little_endian, ds.is_implicit_VR = True, False
        ds.file_meta.TransferSyntaxUID = ExplicitVRLittleEndian
        ds.compress(RLELossless)
        save(ds, folder / "seg.dcm", RLELossless)
    else:
        save(ds, folder / "seg.dcm", syntax)
    return grid, labels


@case("seg-binary", "SEG", "two segments, a frame for each slice that has voxels", FRAMES)
def _(folder):
    return make(folder, "seg-binary", planes_of)


@case("seg-oblique", "SEG", "oblique slices of anisotropic pixels", FRAMES)
def _(folder):
    return make(folder, "seg-oblique", planes_of, Grid(direction=oblique()))


@case("seg-random-order", "SEG", "frames in any order; only position and segment identify them", FRAMES)
def _(folder):
    def shuffled(count):
        return [(5 * i + 3) % count for i in range(count)] if count % 5 else list(range(count))[::-1]

    return make(folder, "seg-random-order", lambda grid, labels: planes_of(grid, labels, shuffled))


@case("seg-overlapping", "SEG", "segment 2 also covers voxels of segment 1; the expected label is the last one", OVERLAP)
def _(folder):
    grid, labels = Grid(), masks(Grid())
    both = (labels > 0) & (np.indices(labels.shape)[2] > 4)

    def planes(grid, labels):
        own = [(1, grid.place(0, 0, z), labels[z] == 1, z) for z in range(1, 5)]
        return own + [(2, grid.place(0, 0, z), both[z], z) for z in range(1, 5)]

    def change(ds, files):
        ds.SegmentsOverlap = "YES"

    make(folder, "seg-overlapping", planes, change=change)
    return grid, np.where(both, 2, labels)


@case("seg-cropped", "SEG", "frames are smaller than the slices", FRAMES)
def _(folder):
    def planes(grid, labels):
        return [
            (number, grid.place(2, 3, z), labels[z, 3:8, 2:11] == number, z) for number in (1, 2) for z in range(1, 5)
        ]

    return make(folder, "seg-cropped", planes)


@case("seg-mirrored", "SEG", "rows and columns run against those of the slices", FRAMES)
def _(folder):
    grid = Grid()
    mirrored = Grid(direction=np.diag([-1.0, -1, 1]))

    def planes(grid, labels):
        corner = (grid.size[0] - 1, grid.size[1] - 1)
        return [(number, grid.place(*corner, z), labels[z, ::-1, ::-1] == number, z) for number in (1, 2) for z in range(1, 5)]

    return make(folder, "seg-mirrored", planes, grid, mirrored)


@case("seg-sagittal", "SEG", "sagittal frames of a segmentation of axial slices", FRAMES)
def _(folder):
    grid = Grid()
    sagittal = Grid(spacing=(grid.spacing[1], grid.spacing[2], grid.spacing[0]), direction=np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]]))

    def planes(grid, labels):
        return [
            (number, grid.place(x, 0, 0), labels[:, :, x] == number, None)
            for number in (1, 2)
            for x in range(grid.size[0])
            if (labels[:, :, x] == number).any()
        ]

    return make(folder, "seg-sagittal", planes, grid, sagittal)


@case("seg-fractional", "SEG", "fractions of 200: half and more is in the segment", "PS3.3 C.8.20.2.3")
def _(folder):
    def planes(grid, labels):
        fractions = {1: (200, 99), 2: (100, 40)}  # inside, outside
        return [
            (number, grid.place(0, 0, z), np.where(labels[z] == number, *fractions[number]), z)
            for number in (1, 2)
            for z in range(grid.size[2])
        ]

    return make(folder, "seg-fractional", planes, kind="FRACTIONAL")


def map_planes(grid, labels):
    return [(0, grid.place(0, 0, z), labels[z], z) for z in range(grid.size[2])]


@case("labelmap-8-bits", "SEG", "a label map (Supplement 243)", "PS3.3 C.8.20.2")
def _(folder):
    return make(folder, "labelmap-8-bits", map_planes, kind="LABELMAP")


@case("labelmap-rle", "SEG", "a label map in RLE Lossless", "PS3.3 C.8.20.2, PS3.5 A.4.2")
def _(folder):
    return make(folder, "labelmap-rle", map_planes, kind="LABELMAP", syntax=RLELossless)


@case("seg-of-another-series", "SEG", "refers to another frame of reference with an equal grid", "PS3.3 C.7.4.1", REFUSAL)
def _(folder):
    def change(ds, files):
        ds.FrameOfReferenceUID = uid("another frame")
        ds.ReferencedSeriesSequence[0].SeriesInstanceUID = uid("another series")
        for frame in ds.PerFrameFunctionalGroupsSequence:
            frame.DerivationImageSequence[0].SourceImageSequence[0].ReferencedSOPInstanceUID = uid("another slice")

    return make(folder, "seg-of-another-series", planes_of, change=change)


# ---- reports: points, as centers with the extent of all points ----

PIXELS = [(3.5, 2.5, 1), (9.5, 6.5, 3), (5.5, 8.5, 4)]  # column, row (centers are halves; PS3.3 C.18.6.1.2), slice


def content(kind, relation, name, **values):
    ds = item(RelationshipType=relation, ValueType=kind, ConceptNameCodeSequence=[name] if name else [], **values)
    if not name:
        del ds.ConceptNameCodeSequence
    return ds


def report(name, files, measurements):
    ds = header(name, REPORT, "SR", files, 1)
    del ds.ImageType, ds.ReferencedSeriesSequence, ds.FrameOfReferenceUID, ds.PositionReferenceIndicator
    del ds.AcquisitionDate, ds.AcquisitionTime
    ds.InstanceNumber, ds.CompletionFlag, ds.VerificationFlag, ds.PreliminaryFlag = 1, "PARTIAL", "UNVERIFIED", "PRELIMINARY"
    ds.PerformedProcedureCodeSequence, ds.ReferencedPerformedProcedureStepSequence = [], []
    references = [item(ReferencedSOPClassUID=CT, ReferencedSOPInstanceUID=one.SOPInstanceUID) for one in files]
    of_series = item(SeriesInstanceUID=files[0].SeriesInstanceUID, ReferencedSOPSequence=references)
    ds.CurrentRequestedProcedureEvidenceSequence = [item(StudyInstanceUID=ds.StudyInstanceUID, ReferencedSeriesSequence=[of_series])]
    ds.ValueType, ds.ContinuityOfContent = "CONTAINER", "SEPARATE"
    ds.ConceptNameCodeSequence = [code("126000", "DCM", "Imaging Measurement Report")]
    ds.ContentTemplateSequence = [item(MappingResource="DCMR", TemplateIdentifier="1500")]
    groups = []
    for i, measurement in enumerate(measurements):
        group = content("CONTAINER", "CONTAINS", code("125007", "DCM", "Measurement Group"), ContinuityOfContent="SEPARATE")
        group.ContentTemplateSequence = [item(MappingResource="DCMR", TemplateIdentifier="1501")]
        identifier = content("TEXT", "HAS OBS CONTEXT", code("112039", "DCM", "Tracking Identifier"), TextValue=f"point {i + 1}")
        tracking = content("UIDREF", "HAS OBS CONTEXT", code("112040", "DCM", "Tracking Unique Identifier"), UID=uid(name, "point", i))
        finding = content("CODE", "CONTAINS", code("121071", "DCM", "Finding"))
        finding.ConceptCodeSequence = [code("4147007", "SCT", "Mass")]
        group.ContentSequence = [identifier, tracking, finding, measurement]
        groups.append(group)
    ds.ContentSequence = [content("CONTAINER", "CONTAINS", code("126010", "DCM", "Imaging Measurements"), ContinuityOfContent="SEPARATE")]
    ds.ContentSequence[0].ContentSequence = groups
    return ds


def number_with(graphic):
    units = code("mm", "UCUM", "millimeter")
    value = item(MeasurementUnitsCodeSequence=[units], NumericValue="5")
    number = content("NUM", "CONTAINS", code("410668003", "SCT", "Length"), MeasuredValueSequence=[value])
    number.ContentSequence = [graphic]
    return number


def statistics(grid, pixels):
    """Mean and standard deviation of the points, as the columns of origin and spacing."""
    points = np.array([grid.place(x - 0.5, y - 0.5, z) for x, y, z in pixels])
    return Grid(size=(len(pixels), 1, 1), spacing=tuple(points.std(axis=0)), origin=tuple(points.mean(axis=0))), np.zeros(0)


@case("sr-on-slices", "SR", "points as pixels of slices of anisotropic pixels", POINTS, PLACES)
def _(folder):
    grid = Grid()
    files = series(folder, "sr-on-slices", grid)
    graphics = []
    for x, y, z in PIXELS:
        reference = item(ReferencedSOPClassUID=CT, ReferencedSOPInstanceUID=files[z].SOPInstanceUID)
        selected = content("IMAGE", "SELECTED FROM", None, ReferencedSOPSequence=[reference])
        graphics.append(content("SCOORD", "INFERRED FROM", None, GraphicType="POINT", GraphicData=[x, y], ContentSequence=[selected]))
    save(report("sr-on-slices", files, [number_with(graphic) for graphic in graphics]), folder / "sr.dcm")
    return statistics(grid, PIXELS)


@case("sr-in-space", "SR", "points in the frame of reference of oblique slices", "PS3.3 C.18.9", PLACES)
def _(folder):
    grid = Grid(direction=oblique())
    files = series(folder, "sr-in-space", grid)
    graphics = []
    for x, y, z in PIXELS:
        graphic = content("SCOORD3D", "INFERRED FROM", None, GraphicType="POINT", GraphicData=list(map(float, grid.place(x - 0.5, y - 0.5, z))))
        graphic.ReferencedFrameOfReferenceUID = files[0].FrameOfReferenceUID
        graphics.append(graphic)
    save(report("sr-in-space", files, [number_with(graphic) for graphic in graphics]), folder / "sr.dcm")
    return statistics(grid, PIXELS)


@case("sr-of-another-series", "SR", "points in another frame of reference", "PS3.3 C.7.4.1", REFUSAL)
def _(folder):
    grid = Grid()
    files = series(folder, "sr-of-another-series", grid)
    graphic = content("SCOORD3D", "INFERRED FROM", None, GraphicType="POINT", GraphicData=[-20.0, 25.0, -100.0])
    graphic.ReferencedFrameOfReferenceUID = uid("another frame")
    save(report("sr-of-another-series", files, [number_with(graphic)]), folder / "sr.dcm")
    return grid, np.zeros(0)
