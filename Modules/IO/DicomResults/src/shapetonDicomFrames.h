#ifndef shapetonDicomFrames_h
#define shapetonDicomFrames_h

#include "shapetonDicomItem.h"
#include "shapetonDicomSeriesScan.h"

#include <optional>

namespace shapeton
{
/** An attribute by which frames are ordered before their place. */
struct FrameDimension
{
  DcmTagKey    attribute;
  DcmTagKey    group;
  const char * name;
};

/** How frames are ordered: by `first`, where it is given, then along the normal. */
void
PutDimensions(DicomItem root, const DicomSeries & series, const std::optional<FrameDimension> & first);

/** The place of a frame: that of slice number `place`, from 0; `first` as PutDimensions() has it. */
void
PutFramePlace(DicomItem frame, const DicomSlice & slice, std::size_t place, std::vector<Uint32> first);
} // namespace shapeton

#endif
