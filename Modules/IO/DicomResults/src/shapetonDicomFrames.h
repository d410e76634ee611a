#ifndef shapetonDicomFrames_h
#define shapetonDicomFrames_h

#include "shapetonDicomItem.h"
#include "shapetonDicomSeriesScan.h"

#include <optional>

namespace shapeton
{
/** A sort attribute of frames with priority over the position. */
struct FrameDimension
{
  DcmTagKey    attribute;
  DcmTagKey    group;
  const char * name;
};

/** Frame order: by `first`, if given, then along the normal. */
void
PutDimensions(DicomItem root, const DicomSeries & series, const std::optional<FrameDimension> & first);

/** Dimension index of a frame: slice number `place`, counted from 0; `first` as in PutDimensions(). */
void
PutFramePlace(DicomItem frame, const DicomSlice & slice, std::size_t place, std::vector<Uint32> first);
} // namespace shapeton

#endif
