#ifndef shapetonLumenLabels_h
#define shapetonLumenLabels_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"

#include "itkImage.h"

namespace shapeton
{
/** Labels voxels with centers in the lumen: gas (1) or fluid (2), and the segment. */
class LumenLabels
{
public:
  using LabelImageType = itk::Image<unsigned char, 3>;
  using RegionType = itk::ImageRegion<3>;

  LumenLabels(const ColonAnatomy & anatomy,
              const ColonFluid &   fluid,
              LabelImageType *     lumen,
              LabelImageType *     segments);

  /** Sets all labels of a region. */
  void
  Fill(const RegionType & region) const;

private:
  bool
  MissesLumen(const RegionType & block) const;
  void
  FillVoxels(const RegionType & block) const;

  const ColonAnatomy & m_Anatomy;
  const ColonFluid &   m_Fluid;
  LabelImageType *     m_Lumen;
  LabelImageType *     m_Segments;
};
} // namespace shapeton

#endif
