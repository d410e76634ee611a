#ifndef shapetonCylinderPicture_h
#define shapetonCylinderPicture_h

#include "shapetonColonCylinder.h"
#include "shapetonColonPosition.h"

#include <functional>

namespace shapeton
{
/** Picture of the fold probability on a cylinder: rows at equal steps along the colon, columns at equal angles.
 * Normalized to mean 0 and standard deviation 1 over valid rows; excluded rows are 0. */
struct CylinderPicture
{
  Eigen::MatrixXd   values;
  std::vector<char> isExcluded;
  /** Picture of bands along the taeniae with mean 0 and standard deviation 1 in each row; empty if unknown. */
  Eigen::MatrixXd taeniae;
  /** Center of the first row, and row spacing along the colon, mm. */
  double begin{ 0.0 };
  double step{ 1.0 };

  int
  Rows() const
  {
    return static_cast<int>(values.rows());
  }
  int
  Angles() const
  {
    return static_cast<int>(values.cols());
  }
};

struct CylinderPictureForm
{
  double begin{ 0.0 };
  double step{ 3.0 };
  int    rows{ 1 };
  int    angles{ 48 };
  /** Standard deviations of the smoothing, in rows and angles. */
  double smoothRows{ 1.0 };
  double smoothAngles{ 1.0 };
  /** Maps the distance along the centerline (mm) to the row coordinate; must be increasing. */
  std::function<double(double)> coordinate;
};

CylinderPicture
MakeCylinderPicture(const ColonPosition &       position,
                    const ColonCylinder &       cylinder,
                    const std::vector<float> &  probability,
                    const CylinderPictureForm & form);

/** Interpolates between pixels; end rows are repeated. The center of the first angle is at half a pixel. */
double
SampleOf(const CylinderPicture & picture, double s, double turn);

/** Gaussian smoothing over rows (end rows repeated) and angles (periodic). */
Eigen::MatrixXd
SmoothedOnCylinder(const Eigen::MatrixXd & values, double rows, double angles);
} // namespace shapeton

#endif
