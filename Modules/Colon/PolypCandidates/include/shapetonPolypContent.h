#ifndef shapetonPolypContent_h
#define shapetonPolypContent_h

#include "shapetonPolypCandidates.h"
#include "shapetonPolypShapeDiffusion.h"

namespace shapeton
{
/** Share of heads with this attenuation (HU) that may be tissue, 0 to 1; MeasureContent() multiplies scores by it. Near
 * 1 from -200 to 150 HU, below 0.05 for gas (-400 HU and less), 0.25 for tagged stool (300 HU and more), since polyps
 * can be coated, too; 1 if unknown. Logistic steps at -300 HU (width 35 HU) and 225 HU (25 HU). The center of a ball of
 * 3.5 mm in gas, blurred by a Gaussian of 1 mm, keeps six tenths of its contrast: -320 HU, which halves its score; on a
 * wall it keeps more. Blur does not darken heads under fluid: there the first step is at -130 HU (20 HU), below fat,
 * and bubbles of 3 mm are dark enough; heads partly covered by fluid are in between. \param submergedShare 0 to 1, or
 * NaN if unknown. \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT double
TissueLikelihood(double hounsfield, double submergedShare = 0.0);

/** Sets attenuation, tissue and submergedShare of the candidates, and a remark for those that are gas, tagged or in
 * fluid. Multiplies their scores by TissueLikelihood(), then sorts and renumbers them.
 *
 * The attenuation is the median HU of points on the lines from the surface of the head to its center that are more than
 * 1.2 mm from the lumen: inside the tissue, not across its surface. Small heads without such points use the deepest
 * quarter.
 *
 * \param ct HU, cleansed or not.
 * \param lumen 0 outside, 2 tagged fluid, else gas; on any grid.
 *
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT void
MeasureContent(const SurfaceMesh &           wall,
               const itk::Image<float, 3> *  ct,
               const PolypLumenImage *       lumen,
               std::vector<PolypCandidate> & candidates);

/** Labels the voxels of the heads with the numbers of their candidates, 0 elsewhere; a shared voxel gets the first one.
 * A head consists of the lines from its surface to its center, where MeasureContent() measures, without the lumen.
 * \ingroup ShapetonPolypCandidates */
ShapetonPolypCandidates_EXPORT itk::Image<unsigned short, 3>::Pointer
                       LabelPolypHeads(const SurfaceMesh &                 wall,
                                       const PolypLumenImage *             lumen,
                                       const std::vector<PolypCandidate> & candidates);
} // namespace shapeton

#endif
