#ifndef shapetonColonPictures_h
#define shapetonColonPictures_h

#include "ShapetonColonViewsExport.h"

#include "shapetonCurveSet.h"
#include "shapetonPatientView.h"
#include "shapetonPicture.h"
#include "shapetonSliceView.h"
#include "shapetonSurfaceMesh.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Inputs of pictures of a colon. Not owned.
 *
 * Only the lumen is required. The centerline is one curve starting at the anal verge, with the point arrays arcLength
 * and radius (mm) and, if there are gaps, gap (1 on a bridge over a gap, else 0). The wall may have a cell array
 * bridged (1: interpolated over a gap). \ingroup ShapetonColonViews */
struct ColonParts
{
  /** Hounsfield units, on the grid of the lumen. */
  const itk::Image<float, 3> * ct{ nullptr };
  /** 1 gas, 2 fluid, 0 neither. */
  const itk::Image<unsigned char, 3> * lumen{ nullptr };
  const CurveSet *                     centerline{ nullptr };
  const SurfaceMesh *                  wall{ nullptr };
};

/** A part of the colon between two distances from the anal verge, mm. \ingroup ShapetonColonViews */
struct ColonSegment
{
  std::string name;
  double      begin{ 0.0 };
  double      end{ 0.0 };
};

/** Indices of the slices that show most of the lumen, ascending: the slice with the largest lumen area, and others
 * evenly spaced over the extent of the lumen. All slices of the lumen if it has fewer than requested.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT std::vector<itk::IndexValueType>
                          ChooseSlices(const itk::Image<unsigned char, 3> * lumen, SlicePlane plane, int number);

/** The usual intensity window for CT colonography, HU. \ingroup ShapetonColonViews */
constexpr IntensityWindow ColonographyWindow{ -1100.0, 500.0 };

/** Draws slices side by side, with the outlines of gas and fluid and the section of the wall; without a CT, the lumen
 * is filled.
 *
 * Throws std::invalid_argument if there is no lumen or the CT has a different grid. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawColonSlices(const ColonParts &      colon,
                                          SlicePlane              plane,
                                          int                     number = 3,
                                          const IntensityWindow & window = ColonographyWindow);

/** Projects the colon along the volume axis perpendicular to a coronal or sagittal plane: the lumen thickness (mm) in
 * gray, and the centerline colored by the distance from the anal verge. Throws the same exceptions.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawColonProjection(const ColonParts & colon, SlicePlane plane);

/** The wall from one side: opaque, or transparent with the centerline inside. Bridges have a separate color; the ends
 * of the centerline are labeled. Throws std::invalid_argument if there is no wall, or no centerline for a transparent
 * view.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT Picture::Pointer
                          DrawColonWall(const ColonParts & colon, PatientSide side, bool isSolid);
} // namespace shapeton

#endif
