#ifndef shapetonDicomMosaic_h
#define shapetonDicomMosaic_h

#include <string>

class DcmItem;

namespace shapeton
{
/** True for a Siemens mosaic: one image whose tiles are the slices of a volume. Image Type contains MOSAIC, or a
 * private Siemens attribute states at least two images: (0019,xx0A) of the block "SIEMENS MR HEADER", or
 * NumberOfImagesInMosaic of the CSA image header. De-identification may have removed any of the three. */
bool
IsSiemensMosaic(DcmItem & dataset);

/** The tiles of a mosaic, row by row: a square of them, of which the last ones may be empty. */
struct DicomMosaic
{
  unsigned int tiles{ 0 };
  unsigned int tilesPerRow{ 0 };
  /** From each slice to the next one, LPS; its sign decides the order of slices. */
  double normal[3]{};
};

/** Reads number of tiles and SliceNormalVector from the attributes above or the CSA image header. Returns what they
 * lack, or an empty text. */
std::string
ReadSiemensMosaic(DcmItem & dataset, DicomMosaic & mosaic);
} // namespace shapeton

#endif
