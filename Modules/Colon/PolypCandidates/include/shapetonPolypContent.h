#ifndef shapetonPolypContent_h
#define shapetonPolypContent_h

#include "shapetonPolypCandidates.h"
#include "shapetonPolypShapeDiffusion.h"

namespace shapeton
{
/** Likelihood that a head with this attenuation (HU) is tissue, 0 to 1; MeasureContent() multiplies scores by it. It is
 * near 1 from -200 to 150 HU, below 0.05 for gas (-400 HU and less), 0.25 for tagged stool (300 HU and more), since
 * polyps can be coated, and 1 if unknown. Logistic steps at -300 HU (width 35 HU) and 225 HU (25 HU). Blur by a
 * Gaussian of 1 mm reduces the contrast of a 3.5 mm ball in gas to six tenths (-320 HU), which halves the score; on a
 * wall, the reduction is smaller. Heads under fluid are not darkened by blur; there the first step is at -130 HU (20
 * HU), below fat, which excludes 3 mm bubbles. Values for partly covered heads are interpolated. \param submergedShare
 * 0 to 1, or NaN if unknown. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
TissueLikelihood(double hounsfield, double submergedShare = 0.0);

/** Sets attenuation, tissue, submergedShare and filmShare of the candidates, and adds a remark about gas, tagged
 * matter, fluid or a film of contrast. Multiplies the scores by TissueLikelihood(), then sorts and renumbers the
 * candidates.
 *
 * The attenuation is the median HU of points on the lines from the surface of the head to its center that are at least
 * 1.2 mm from the lumen, to exclude partial volume. In small heads with too few such points, the deepest quarter is
 * used. If these points are tagged, but those at least 1.8 mm from the lumen are soft tissue, the median of the latter
 * is used: contrast often coats polyps (Kim et al., Eur Radiol 2014) and pervades tagged stool. Heads with films
 * thicker than a third of the radius are taken for stool, and stool with an untagged core is taken for a coated polyp.
 *
 * \param ct HU, cleansed or not.
 * \param lumen 0 outside, 2 tagged fluid, other values gas; on any grid.
 *
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
MeasureContent(const SurfaceMesh &           wall,
               const itk::Image<float, 3> *  ct,
               const PolypLumenImage *       lumen,
               std::vector<PolypCandidate> & candidates);

/** Recognizes residue of electronic cleansing: heads that are tagged (more than 300 HU) in the CT before cleansing, but
 * not after it, and heads at a fluid level that cleansing darkened by at least 120 HU, since these are mixtures of gas
 * and fluid. Adds a remark; scores are unchanged. MeasureContent() must come first. \param original HU, before
 * cleansing. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
NoteResidue(const SurfaceMesh &           wall,
            const itk::Image<float, 3> *  original,
            const PolypLumenImage *       lumen,
            std::vector<PolypCandidate> & candidates);

/** Labels the voxels of the heads with their candidate numbers, 0 elsewhere; shared voxels are assigned to the first. A
 * head consists of the lines from its surface to its center used by MeasureContent(), excluding the lumen.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT itk::Image<unsigned short, 3>::Pointer
                               LabelPolypHeads(const SurfaceMesh &                 wall,
                                               const PolypLumenImage *             lumen,
                                               const std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
