#ifndef shapetonPolypContent_h
#define shapetonPolypContent_h

#include "shapetonPolypCandidates.h"
#include "shapetonPolypShapeDiffusion.h"

namespace shapeton
{
/** The share of heads of this attenuation (HU) that may be tissue, 0 to 1, by which MeasureContent() multiplies scores:
 * near 1 from -200 to 150 HU, below 0.05 for gas (-400 HU and less), 0.25 for what is tagged as stool (300 HU and
 * more), since polyps are coated, too; 1 where it is not known. Logistic steps at -300 HU (width 35 HU) and 225 HU (25
 * HU). The middle of a ball of 3.5 mm in gas, blurred by a Gaussian of 1 mm, keeps six tenths of its contrast: -320 HU,
 * and a half is left of its score; on a wall it keeps more. Blur does not darken what lies under fluid: there the first
 * step is at -130 HU (20 HU), below fat, and bubbles of 3 mm are dark enough; of a head that fluid covers in part, in
 * between. \param submergedShare 0 to 1, or not a number where it is not known. \ingroup PolypCandidates */
PolypCandidates_EXPORT double
TissueLikelihood(double hounsfield, double submergedShare = 0.0);

/** Sets attenuation, tissue and submergedShare of the candidates, and the remark where they are gas or tagged or lie
 * in fluid; multiplies their scores by TissueLikelihood() and sorts and numbers them again.
 *
 * The attenuation is the median HU of points on the ways from the surface of the head to its middle that no lumen is
 * near (1.2 mm; of small heads, where there are none, the deepest quarter of the points): inside the tissue, not across
 * its surface.
 *
 * \param ct HU, cleansed or not.
 * \param lumen 0 outside, 2 tagged fluid, else gas; on any grid.
 *
 * \ingroup PolypCandidates */
PolypCandidates_EXPORT void
MeasureContent(const SurfaceMesh &           wall,
               const itk::Image<float, 3> *  ct,
               const PolypLumenImage *       lumen,
               std::vector<PolypCandidate> & candidates);

/** The heads of candidates as voxels: the number of its candidate where the tissue of a head is, 0 elsewhere; of heads
 * that share a voxel, the first one has it. A head is what lies on the ways from its surface to its middle, the places
 * where MeasureContent() measures, without the voxels of the lumen. \ingroup PolypCandidates */
PolypCandidates_EXPORT itk::Image<unsigned short, 3>::Pointer
                       LabelPolypHeads(const SurfaceMesh &                 wall,
                                       const PolypLumenImage *             lumen,
                                       const std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
