#ifndef shapetonPolypShapeDiffusion_h
#define shapetonPolypShapeDiffusion_h

#include "shapetonPolypCandidates.h"

#include "itkImage.h"

#include <cstdint>

namespace shapeton
{
/** Lumen mask: nonzero voxels are gas or fluid in the colon; any grid. \ingroup ShapetonPolypCandidates */
using PolypLumenImage = itk::Image<unsigned char, 3>;

/** Sets the features heat and shapetonDensity of candidates: cumulative heat diffusion (10 mm^2) and 4,000 shapetons
 * (200 steps of 1.8 mm), both with p = 15, in a box that extends 12 mm around each head, with 1 in tissue and 0 in the
 * lumen. The features are sampled at points below the surface of the head. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
MeasureShapeDiffusion(const SurfaceMesh &           wall,
                      const PolypLumenImage *       lumen,
                      std::vector<PolypCandidate> & candidates,
                      const Progress &              progress = {});

/** The part of the wall that FindPublishedPolypCandidates() searches. \ingroup ShapetonPolypCandidates */
enum class VisitedWall
{
  /** Few visits: the color of the polyp in Figure 3.10, which is blue according to dissertation 3.4. */
  Least,
  /** Many visits: the other end of the color scale; not published. */
  Most
};

/** Settings of dissertation 3.5.2. \ingroup ShapetonPolypCandidates */
struct PublishedPolypOptions : PolypSensitivityOptions
{
  std::uint32_t shapetons{ 65000 };
  double        distance{ 0.005 };
  double        p{ 15.0 };
  std::uint64_t steps{ 4000 };
  VisitedWall   visited{ VisitedWall::Least };
  /** May throw to abort. */
  Progress progress;
};

/** Finds candidates by shapeton diffusion (dissertation 3.5.2). Shapetons start in the tissue within 8 mm of the lumen
 * and perform random walks in the volume. Wall vertices are ranked by the smoothed density in the tissue below; by
 * default, those with the fewest visits rank highest (see VisitedWall). Candidates are parts of the top 4 % of the
 * wall, 3 to 40 mm wide; the score is the mean rank, scaled from (0.96, 1) to (0, 1), times the roundness.
 *
 * The dissertation only displays the density with a manual transfer function; ranks and limits are original work.
 * \param ct cleansed CT in HU; if null, tissue is 1 and lumen is 0. Throws the exceptions of FindPolypCandidates(). The
 * result does not depend on the number of threads.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT std::vector<PolypCandidate>
                               FindPublishedPolypCandidates(const SurfaceMesh &           wall,
                                                            const PolypLumenImage *       lumen,
                                                            const itk::Image<float, 3> *  ct,
                                                            const PublishedPolypOptions & options = {});
} // namespace shapeton

#endif
