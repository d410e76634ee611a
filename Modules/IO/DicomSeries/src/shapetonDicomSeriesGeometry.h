#ifndef shapetonDicomSeriesGeometry_h
#define shapetonDicomSeriesGeometry_h

#include <cstddef>
#include <vector>

namespace shapeton
{
/** Where a slice lies: along the normal, and displaced within the plane along rows and columns; mm. */
struct SlicePlace
{
  double position;
  double offset[2];
};

/** What is irregular about slices in ascending order of position. */
struct SlicesGeometry
{
  /** Usual distance of the slices, mm: the median; 0 for fewer than two positions. */
  double spacing{ 0.0 };
  /** Slices at one position: the first, and the number of them (two or more). */
  struct Duplicate
  {
    unsigned int first;
    unsigned int count;
  };
  std::vector<Duplicate> duplicates;
  /** A distance of more than one slice: the slices before and after it, and the number of slices that are missing. */
  struct Gap
  {
    unsigned int before;
    unsigned int after;
    unsigned int missing;
  };
  std::vector<Gap> gaps;
  /** The distances are no multiples of one distance, or change for good; the slices before the unusual distances. */
  bool                      isVariable{ false };
  std::vector<unsigned int> unusual;
  /** The slices are displaced within their planes by a constant step, or irregularly. */
  bool   isSheared{ false };
  bool   isLinearShear{ false };
  double tiltDegrees{ 0.0 };

  /** All slices lie on one grid along the normal, each at a place of its own; some may be missing. */
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

/** The distance that counts as none where slices or pixels are `spacing` apart; see ScanDicom. */
double
PositionTolerance(double spacing);

/** A repair may give at most this many times the slices or pixels that were measured, else it would invent most of the
 * volume. */
constexpr double LargestGrowth = 4;

/** Steps of the grid that covers slices `length` mm apart in distances of about `spacing`. */
double
ResampledSteps(double length, double spacing);

/** Whether that grid stays within LargestGrowth. */
bool
CanBeResampled(std::size_t slices, double length, double spacing);

/** Examines slices; `pixelSpacing` is the distance of columns and of rows. */
SlicesGeometry
ExamineSlices(const std::vector<SlicePlace> & slices, const double (&pixelSpacing)[2]);
} // namespace shapeton

#endif
