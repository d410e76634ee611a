#ifndef shapetonDicomReportReader_h
#define shapetonDicomReportReader_h

#include "shapetonDicomCode.h"
#include "shapetonDicomSource.h"

#include "itkPoint.h"

#include <limits>
#include <string>
#include <vector>

namespace shapeton
{
/** A graphic of a report: its points, and the statements of its measurement group. \ingroup ShapetonDicomResults */
struct DicomReportPoints
{
  /** The tracking identifier of the measurement that contains the points, or else their concept name. */
  std::string name;
  /** LPS, mm. */
  std::vector<itk::Point<double, 3>> places;
  /** DICOM Graphic Type: POINT, MULTIPOINT, POLYLINE, POLYGON, CIRCLE, ELLIPSE or ELLIPSOID. */
  std::string type;
  /** The value of the number that contains the points, if its unit is mm; otherwise NaN. */
  double length{ std::numeric_limits<double>::quiet_NaN() };
  /** Finding sites of the group, and its first comment, which viewers show as its label. */
  std::vector<DicomCode> sites{};
  std::string            comment{};
};

/** Reads the points of a Structured Report of any template: spatial points (SCOORD3D) and pixel positions in slices of
 * the source (SCOORD). A pixel position is skipped if the same container holds a spatial point with the same concept,
 * because both are the same point. Positions of text labels (OHIF) are also skipped. Circles, ellipses and ellipsoids
 * are represented by their centers, lines and polygons by their vertices.
 *
 * Throws InputError for a file that is not a report or contains no points, for points in another frame of reference,
 * and for points in images other than the slices of the source. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT std::vector<DicomReportPoints>
                            ReadDicomReportPoints(const std::string & path, const DicomSource & source);
} // namespace shapeton

#endif
