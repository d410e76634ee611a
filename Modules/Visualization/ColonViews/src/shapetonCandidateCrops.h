#ifndef shapetonCandidateCrops_h
#define shapetonCandidateCrops_h

#include "shapetonPicture.h"
#include "shapetonPolypSearch.h"
#include "shapetonSliceView.h"

#include <string>
#include <vector>

namespace shapeton
{
/** A square plane through the center of a candidate. */
struct CandidatePlane
{
  /** "Axial 51 of 232", "Along the axis". */
  std::string     title;
  Eigen::Vector3d center; ///< LPS, mm
  Eigen::Vector3d right;  ///< unit vectors, LPS
  Eigen::Vector3d up;
  double          width{ 0.0 }; ///< mm

  /** Picture position of a point, projected onto the plane, in pixels of a crop of this size. */
  Eigen::Vector2d
  PixelOf(const Eigen::Vector3d & point, unsigned int size) const;
};

/** Axial, coronal and sagittal plane along the axes of the volume, and an oblique one that contains the axis of the
 * candidate and the direction toward its foot. All show the whole head with its surroundings. */
std::vector<CandidatePlane>
PlanesOf(const SurfaceMesh & wall, const itk::ImageBase<3> * volume, const PolypCandidate & candidate);

/** The CT (HU) in a plane, linearly interpolated; size x size pixels; black outside the volume. */
Picture::Pointer
PaintPlane(const CandidatePlane &       plane,
           const itk::Image<float, 3> * ct,
           const IntensityWindow &      window,
           unsigned                     size);
} // namespace shapeton

#endif
