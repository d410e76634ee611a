#ifndef shapetonCylinderPicture_h
#define shapetonCylinderPicture_h

#include "shapetonColonCylinder.h"
#include "shapetonColonPosition.h"

#include <functional>

namespace shapeton
{
/** How much of a fold the wall shows, on a cylinder: rows are even steps along the colon, columns are angles. Mean 0
 * and deviation 1 over what is not excluded; excluded rows are 0. */
struct CylinderPicture
{
  Eigen::MatrixXd   values;
  std::vector<char> isExcluded;
  /** The same of bands along the taeniae, mean 0 and deviation 1 of each row; empty where they are not known. */
  Eigen::MatrixXd taeniae;
  /** Of the middle of the first row, and from row to row, in the unit of the coordinate along the colon, mm. */
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
  /** Standard deviations of smoothing, in rows and angles. */
  double smoothRows{ 1.0 };
  double smoothAngles{ 1.0 };
  /** From the distance along the centreline, mm, to the coordinate of the rows; must ascend. */
  std::function<double(double)> coordinate;
};

CylinderPicture
MakeCylinderPicture(const ColonPosition &       position,
                    const ColonCylinder &       cylinder,
                    const std::vector<float> &  probability,
                    const CylinderPictureForm & form);

/** Between its pixels; the ends repeat. The middle of the first angle lies at half a pixel. */
double
SampleOf(const CylinderPicture & picture, double s, double turn);

/** Gaussian mean over rows (ends repeat) and over angles (periodic). */
Eigen::MatrixXd
SmoothedOnCylinder(const Eigen::MatrixXd & values, double rows, double angles);
} // namespace shapeton

#endif
