#include "shapetonDicomFrames.h"

#include "shapetonDicomText.h"

namespace shapeton
{
namespace
{
void
PutIndex(DicomItem root, const std::string & uid, const FrameDimension & dimension)
{
  root.Add(DCM_DimensionIndexSequence)
    .Text(DCM_DimensionOrganizationUID, uid)
    .Tag(DCM_DimensionIndexPointer, dimension.attribute)
    .Tag(DCM_FunctionalGroupPointer, dimension.group)
    .Text(DCM_DimensionDescriptionLabel, dimension.name);
}
} // namespace

void
PutDimensions(DicomItem root, const DicomSeries & series, const std::optional<FrameDimension> & first)
{
  const std::string uid = MakeDicomUID("dimensions " + ConcatenateTexts({ series.uid, first ? first->name : "" }));
  root.Add(DCM_DimensionOrganizationSequence).Text(DCM_DimensionOrganizationUID, uid);
  if (first)
  {
    PutIndex(root, uid, *first);
  }
  PutIndex(root, uid, { DCM_ImagePositionPatient, DCM_PlanePositionSequence, "Position" });
}

void
PutFramePlace(DicomItem frame, const DicomSlice & slice, std::size_t place, std::vector<Uint32> first)
{
  first.push_back(static_cast<Uint32>(place + 1));
  frame.Add(DCM_FrameContentSequence)
    .Text(DCM_StackID, "1")
    .Integers(DCM_InStackPositionNumber, { first.back() })
    .Integers(DCM_DimensionIndexValues, first);
  const auto & origin = slice.imagePosition;
  frame.Add(DCM_PlanePositionSequence).Decimals(DCM_ImagePositionPatient, { origin[0], origin[1], origin[2] });
}
} // namespace shapeton
