#include "shapetonDicomPictures.h"

#include "shapetonDicomFrames.h"
#include "shapetonDicomResultObject.h"
#include "shapetonExceptions.h"
#include "shapetonImageGrid.h"

#include <algorithm>

namespace shapeton
{
namespace
{
constexpr const char * frameType = "DERIVED\\PRIMARY\\VOLUME\\NONE";

/** Identity: slope 1, intercept 0. */
void
PutMapping(DicomItem shared, const DicomMapMeaning & meaning, float least, float greatest)
{
  DicomItem mapping = shared.Add(DCM_RealWorldValueMappingSequence)
                        .Double(DCM_DoubleFloatRealWorldValueFirstValueMapped, least)
                        .Double(DCM_DoubleFloatRealWorldValueLastValueMapped, greatest)
                        .Double(DCM_RealWorldValueSlope, 1.0)
                        .Double(DCM_RealWorldValueIntercept, 0.0)
                        .Text(DCM_LUTExplanation, meaning.explanation)
                        .Text(DCM_LUTLabel, meaning.label)
                        .Code(DCM_MeasurementUnitsCodeSequence, meaning.unit);
  mapping.Add(DCM_QuantityDefinitionSequence)
    .Text(DCM_ValueType, "CODE")
    .Code(DCM_ConceptNameCodeSequence, { "246205007", "SCT", "Quantity" })
    .Code(DCM_ConceptCodeSequence, meaning.quantity);
}

void
PutShared(DicomItem shared, const DicomMapMeaning & meaning)
{
  shared.Add(DCM_FrameAnatomySequence).Text(DCM_FrameLaterality, "U").Code(DCM_AnatomicRegionSequence, meaning.region);
  shared.Add(DCM_ParametricMapFrameTypeSequence).Text(DCM_FrameType, frameType);
  shared.Add(DCM_PixelValueTransformationSequence)
    .Text(DCM_RescaleIntercept, "0")
    .Text(DCM_RescaleSlope, "1")
    .Text(DCM_RescaleType, "US");
}

void
PutImage(DicomItem root, const DicomSource & source)
{
  root.Text(DCM_ImageType, frameType)
    .Integers(DCM_SamplesPerPixel, { 1 })
    .Text(DCM_PhotometricInterpretation, "MONOCHROME2")
    .Integers(DCM_Rows, { source.series.size[1] })
    .Integers(DCM_Columns, { source.series.size[0] })
    .Integers(DCM_BitsAllocated, { 32 })
    .Text(DCM_PresentationLUTShape, "IDENTITY")
    .Text(DCM_BurnedInAnnotation, "NO")
    .Text(DCM_RecognizableVisualFeatures, "NO")
    .Text(DCM_ContentDescription, DicomResearchNote)
    .Text(DCM_ContentCreatorName, "")
    .Text(DCM_NumberOfFrames, std::to_string(source.series.slices.size()));
}
} // namespace

DicomInstance
WriteDicomMap(const DicomSource &          source,
              const itk::Image<float, 3> * image,
              const DicomMapMeaning &      meaning,
              const DicomResultHeader &    header,
              const std::string &          path)
{
  if (!HaveSameGrid(image, source.grid))
  {
    throw InputError("the map for \"" + path + "\" is not on the grid of the series " + source.series.uid +
                     "; only results of this series without a repair can be written");
  }
  const float * const      first = image->GetBufferPointer();
  const std::vector<float> values(first, first + image->GetBufferedRegion().GetNumberOfPixels());
  const auto               range = std::minmax_element(values.begin(), values.end());
  DicomResultObject        object(source, UID_ParametricMapStorage, source.series.modality, header);
  object.PutFrameOfReference();
  object.PutContentQualification();
  object.PutLossiness();
  object.PutReferencedSeries();
  PutImage(object.Root(), source);
  object.Root().NoItems(DCM_AcquisitionContextSequence);
  object.Root().Text(DCM_ContentLabel, meaning.label);
  DicomItem shared = object.PutSharedPlane();
  PutShared(shared, meaning);
  PutMapping(shared, meaning, *range.first, *range.second);
  PutDimensions(object.Root(), source.series, {});
  for (std::size_t slice = 0; slice < source.series.slices.size(); ++slice)
  {
    DicomItem frame = object.Root().Add(DCM_PerFrameFunctionalGroupsSequence);
    PutFramePlace(frame, source.series.slices[slice], slice, {});
    PutDerivation(frame, source.series.slices[slice], meaning.quantity);
  }
  object.Root().Floats(DCM_FloatPixelData, values);
  return object.Save(path);
}
} // namespace shapeton
