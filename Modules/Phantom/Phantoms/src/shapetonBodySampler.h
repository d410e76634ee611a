#ifndef shapetonBodySampler_h
#define shapetonBodySampler_h

#include "shapetonPhantomBody.h"

#include "itkImageBase.h"

#include <array>

namespace shapeton
{
/** \class BodySampler
 * \brief Computes the voxel intensities of a grid as measured by a scanner.
 *
 * Each voxel is split into up to three cells per axis, with a width of at most about 0.8 mm if possible. The value of a
 * cell is the mean intensity of the bodies in it, assuming plane faces over its width; cells far from all faces are
 * filled in blocks. The cells are then blurred by a Gaussian and averaged over the voxel. The standard deviation of the
 * edge profile is `blur`, or the standard deviation of the voxel width (spacing / sqrt(12)) if larger.
 *
 * The value of a voxel depends only on its position.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT BodySampler
{
public:
  using RegionType = itk::ImageRegion<3>;
  using PointType = PhantomBody::PointType;

  /** `blur` in mm along each axis of the grid, `background` in HU. The geometry of the grid is copied. */
  BodySampler(PhantomBodies                 bodies,
              const itk::ImageBase<3> *     grid,
              const std::array<double, 3> & blur,
              double                        background);

  /** The values of a region, first index fastest. */
  std::vector<float>
  Sample(const RegionType & region) const;

private:
  struct Axis
  {
    int                cells;  // per voxel
    int                margin; // cells of blur around the voxel
    double             width;  // mm
    std::vector<float> weights;
  };
  class Canvas;

  static Axis
  MakeAxis(double spacing, double blur);

  PhantomBodies                         m_Bodies;
  double                                m_Background;
  std::array<Axis, 3>                   m_Axes;
  PointType                             m_FirstCell;
  std::array<itk::Vector<double, 3>, 3> m_Steps;
};
} // namespace shapeton

#endif
