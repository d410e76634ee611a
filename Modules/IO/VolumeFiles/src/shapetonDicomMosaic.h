#ifndef shapetonDicomMosaic_h
#define shapetonDicomMosaic_h

class DcmItem;

namespace shapeton
{
/** True for a Siemens mosaic: one image whose tiles are the slices of a volume. Image Type contains MOSAIC, or a
 * private Siemens attribute states at least two images: (0019,xx0A) of the block "SIEMENS MR HEADER", or
 * NumberOfImagesInMosaic of the CSA image header. De-identification may have removed any of the three. */
bool
IsSiemensMosaic(DcmItem & dataset);
} // namespace shapeton

#endif
