#ifndef shapetonDicomReportReader_h
#define shapetonDicomReportReader_h

#include "shapetonDicomSource.h"

#include "itkPoint.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Points that a report names in one place. \ingroup DicomResults */
struct DicomReportPoints
{
  /** The tracking identifier of the measurement that they belong to, else what they are. */
  std::string name;
  /** LPS, mm. */
  std::vector<itk::Point<double, 3>> places;
};

/** Reads the points of a Structured Report of any template: those in space (SCOORD3D) and those in pixels of slices of
 * the source (SCOORD). Of a circle, an ellipse or an ellipsoid its middle; of lines and polygons their vertices.
 *
 * Throws InputError for a file that is no report or has no point, and for points of another frame of reference or in
 * images that are no slices of the source. \ingroup DicomResults */
DicomResults_EXPORT std::vector<DicomReportPoints>
                    ReadDicomReportPoints(const std::string & path, const DicomSource & source);
} // namespace shapeton

#endif
