#ifndef shapetonColonPictures_h
#define shapetonColonPictures_h

#include "ColonViewsExport.h"

#include "shapetonCurveSet.h"
#include "shapetonPatientView.h"
#include "shapetonPicture.h"
#include "shapetonSliceView.h"
#include "shapetonSurfaceMesh.h"

#include <string>
#include <vector>

namespace shapeton
{
/** What a colon is made of. Nothing is owned.
 *
 * Only the lumen is needed. The centreline is one curve from the anal verge on with the point arrays arcLength and
 * radius (mm) and, where there are gaps, gap (1 on a bridge over one, else 0). The wall may have a cell array bridged
 * (1: made up over a gap).
 * \ingroup ColonViews */
struct ColonParts
{
  /** Hounsfield units, on the grid of the lumen. */
  const itk::Image<float, 3> * ct{ nullptr };
  /** 1 gas, 2 fluid, 0 neither. */
  const itk::Image<unsigned char, 3> * lumen{ nullptr };
  const CurveSet *                     centreline{ nullptr };
  const SurfaceMesh *                  wall{ nullptr };
};

/** A part of the colon between two distances from the anal verge, mm. \ingroup ColonViews */
struct ColonSegment
{
  std::string name;
  double      begin{ 0.0 };
  double      end{ 0.0 };
  /** Share of its centreline with a calibre of at least 10 mm; below 0 where not known. */
  double distendedShare{ -1.0 };
};

/** The slices that show most of the lumen: the one with the largest area, and others evenly between the ends of the
 * lumen. Ascending indices along the axis through the plane; all slices of the lumen where these are fewer.
 * \ingroup ColonViews */
ColonViews_EXPORT std::vector<itk::IndexValueType>
                  ChooseSlices(const itk::Image<unsigned char, 3> * lumen, SlicePlane plane, int number);

/** Some slices side by side with the outlines of gas and fluid and the cut through the wall; without a CT the lumen is
 * painted flat. The window is that of CT colonography, -1100 to 500 HU by default.
 *
 * Throws std::invalid_argument where there is no lumen, or the CT lies on another grid. \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawColonSlices(const ColonParts &      colon,
                                  SlicePlane              plane,
                                  int                     number = 3,
                                  const IntensityWindow & window = { -1100.0, 500.0 });

/** Looks through the colon along the volume's axis of a coronal or sagittal plane: how many mm of lumen lie behind each
 * other, in grey, and the centreline coloured by the distance from the anal verge. Throws the same.
 * \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawColonProjection(const ColonParts & colon, SlicePlane plane);

/** The wall from a side: solid, or see-through with the centreline inside. Bridges have a colour of their own, the ends
 * of the centreline are named. Throws std::invalid_argument where there is no wall, or no centreline to see.
 * \ingroup ColonViews */
ColonViews_EXPORT Picture::Pointer
                  DrawColonWall(const ColonParts & colon, PatientSide side, bool isSolid);
} // namespace shapeton

#endif
