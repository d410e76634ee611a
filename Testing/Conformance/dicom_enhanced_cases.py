"""Enhanced multi-frame DICOM. License: CC0 1.0."""
import numpy as np
from case_files import Grid, case, oblique, phantom
from dicom_files import ENHANCED_CT, decimals, image, save, set_pixels
from pydicom import Dataset, Sequence

POSITION = "PS3.3 C.7.6.16.2.3"
ORDER = [3, 0, 5, 1, 4, 2]  # stored frames


def sequence(**values):
    item = Dataset()
    for keyword, value in values.items():
        setattr(item, keyword, value)
    return Sequence([item])


def enhanced(name, grid, stored, order, rescale=lambda k: (1, 0), shares=True):
    """One file; frame i shows the slice order[i]."""
    ds = image(name, ENHANCED_CT, 1)
    ds.ImageType = ["ORIGINAL", "PRIMARY", "VOLUME", "NONE"]
    set_pixels(ds, stored[order])
    ds.NumberOfFrames = len(order)
    ds.PresentationLUTShape, ds.BurnedInAnnotation, ds.LossyImageCompression = "IDENTITY", "NO", "00"
    ds.ContentQualification, ds.AcquisitionDateTime, ds.VolumetricProperties = "RESEARCH", "20260101120000", "VOLUME"
    ds.PixelPresentation, ds.VolumeBasedCalculationTechnique = "MONOCHROME", "NONE"
    orientation = sequence(ImageOrientationPatient=decimals([*grid.direction[:, 0], *grid.direction[:, 1]]))
    measures = sequence(PixelSpacing=decimals(grid.spacing[1::-1]), SliceThickness=decimals(grid.spacing[2:])[0])
    shared = Dataset()
    frames = []
    for k in order:
        frame = Dataset()
        frame.FrameContentSequence = sequence(
            FrameAcquisitionNumber=1, StackID="1", InStackPositionNumber=int(k) + 1, DimensionIndexValues=[1, int(k) + 1]
        )
        frame.PlanePositionSequence = sequence(ImagePositionPatient=decimals(grid.place(0, 0, k)))
        slope, intercept = decimals(rescale(k))
        frame.PixelValueTransformationSequence = sequence(RescaleSlope=slope, RescaleIntercept=intercept, RescaleType="HU")
        item = shared if shares else frame
        item.PlaneOrientationSequence, item.PixelMeasuresSequence = orientation, measures
        frames.append(frame)
    shared.CTImageFrameTypeSequence = sequence(
        FrameType=ds.ImageType, PixelPresentation="MONOCHROME", VolumetricProperties="VOLUME", VolumeBasedCalculationTechnique="NONE"
    )
    ds.SharedFunctionalGroupsSequence, ds.PerFrameFunctionalGroupsSequence = Sequence([shared]), Sequence(frames)
    return ds


@case("enhanced-ct", "DICOM", "enhanced CT, frames in order", POSITION)
def _(folder):
    grid, voxels = Grid(), phantom()
    save(enhanced("enhanced-ct", grid, voxels, list(range(6))), folder / "image.dcm")
    return grid, voxels


@case("enhanced-ct-random-order", "DICOM", "enhanced CT, frames in random order", POSITION)
def _(folder):
    grid, voxels = Grid(), phantom()
    save(enhanced("enhanced-ct-random-order", grid, voxels, ORDER), folder / "image.dcm")
    return grid, voxels


@case("enhanced-ct-slope-per-frame", "DICOM", "each frame has its own slope and intercept", "PS3.3 C.7.6.16.2.9")
def _(folder):
    grid, voxels = Grid(), phantom()
    rescale = lambda k: (0.5 + 0.25 * k, -10 * k)  # noqa: E731
    save(enhanced("enhanced-ct-slope-per-frame", grid, voxels, list(range(6)), rescale), folder / "image.dcm")
    return grid, np.stack([voxels[k] * rescale(k)[0] + rescale(k)[1] for k in range(6)])


@case("enhanced-ct-own-groups", "DICOM", "oblique; orientation and spacing in the groups of each frame", "PS3.3 C.7.6.16.1.1")
def _(folder):
    grid, voxels = Grid(direction=oblique()), phantom()
    save(enhanced("enhanced-ct-own-groups", grid, voxels, list(range(6))[::-1], shares=False), folder / "image.dcm")
    return grid, voxels
