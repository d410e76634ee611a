#ifndef shapetonDicomSeriesGeometry_h
#define shapetonDicomSeriesGeometry_h

#include <cstddef>
#include <vector>

namespace shapeton
{
/** Position of a slice: along the normal, and displacement within the plane along rows and columns; mm. */
struct SlicePlace
{
  double position;
  double offset[2];
};

/** Irregularities of slices in ascending order of position. */
struct SlicesGeometry
{
  /** Typical distance between slices, mm: the median; 0 for fewer than two positions. */
  double spacing{ 0.0 };
  /** Slices at one position: the first, and their number (two or more). */
  struct Duplicate
  {
    unsigned int first;
    unsigned int count;
  };
  std::vector<Duplicate> duplicates;
  /** A distance of more than one slice: the slices before and after it, and the number of missing slices. */
  struct Gap
  {
    unsigned int before;
    unsigned int after;
    unsigned int missing;
  };
  std::vector<Gap> gaps;
  /** Whether the distances change permanently or are not multiples of one distance; if so, the slices that precede
   * unusual distances. */
  bool                      isVariable{ false };
  std::vector<unsigned int> unusual;
  /** The slices are displaced within their planes by a constant step, or irregularly. */
  bool   isSheared{ false };
  bool   isLinearShear{ false };
  double tiltDegrees{ 0.0 };

  /** All slices are at distinct positions of one grid along the normal; some may be missing. */
  bool
  IsGrid() const
  {
    return duplicates.empty() && !isVariable;
  }
  bool
  IsRegular() const
  {
    return IsGrid() && gaps.empty() && !isSheared;
  }
};

/** Largest distance that counts as 0 if slices or pixels are `spacing` apart; see ScanDicom. */
double
PositionTolerance(double spacing);

/** Largest factor by which a repair may increase the number of slices or pixels; beyond it, most of the volume would be
 * interpolated. */
constexpr double LargestGrowth = 4;

/** Number of grid steps that cover `length` mm at distances of about `spacing`. */
double
ResampledSteps(double length, double spacing);

/** Whether that grid is within LargestGrowth. */
bool
CanBeResampled(std::size_t slices, double length, double spacing);

/** Examines slices; `pixelSpacing` is the distance between columns and between rows. */
SlicesGeometry
ExamineSlices(const std::vector<SlicePlace> & slices, const double (&pixelSpacing)[2]);
} // namespace shapeton

#endif
