#ifndef shapetonLumenDistance_h
#define shapetonLumenDistance_h

#include "ShapetonColonLumenExport.h"

#include "itkImage.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** Lumen mask; nonzero voxels are lumen. \ingroup ShapetonColonLumen */
using LumenMask = itk::Image<unsigned char, 3>;
/** Distances in mm. \ingroup ShapetonColonLumen */
using LumenDistanceImage = itk::Image<float, 3>;
/** Component labels, 0 outside. \ingroup ShapetonColonLumen */
using LumenLabelImage = itk::Image<std::int32_t, 3>;

/** The bounding box of the lumen, padded by `margin` voxels within the image. Throws InputError when
 * the lumen is empty. \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT itk::ImageRegion<3>
                  LumenRegion(const LumenMask * lumen, unsigned int margin = 1);

/** Distance of each lumen voxel of `region` to the wall, mm; 0 outside the lumen. The image covers only `region` and
 * has the geometry of `lumen`.
 *
 * It is the exact Euclidean distance between the centers of the voxel and of the nearest voxel outside the lumen, minus
 * a quarter of the smallest spacing. A flat wall is half a voxel nearer than that center. The wall of a round lumen is
 * hardly nearer to its axis, because the nearest of many centers counts. So a tube of radius r measures r on its axis,
 * to about half a voxel. Voxels beyond the region count as lumen, so a lumen cut by the image keeps its caliber up to
 * the cut; use a region with a margin where the image continues. Linear time in voxels; the result is independent of
 * the number of threads.
 *
 * Throws InputError when the region contains no voxel outside the lumen.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT LumenDistanceImage::Pointer
                  LumenDistance(const LumenMask * lumen, const itk::ImageRegion<3> & region);

/** Connected components by faces of voxels. \ingroup ShapetonColonLumen */
struct LumenComponent
{
  std::int64_t voxels{ 0 };
  /** Volume, ml. */
  double volume{ 0.0 };
  /** Bounding box. */
  itk::Index<3> first{};
  itk::Index<3> last{};
};

/** The connected components of a mask, labeled and measured. See FindLumenComponents(). \ingroup ShapetonColonLumen */
struct LumenComponents
{
  /** Label 1 for the first of `components`, and so on. Covers only the region. */
  LumenLabelImage::Pointer labels;
  /** Largest first; of equal ones the one with the earlier voxel. */
  std::vector<LumenComponent> components;
};

/** Finds the components of the lumen within `region`. Linear time in voxels. \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT LumenComponents
FindLumenComponents(const LumenMask * lumen, const itk::ImageRegion<3> & region);
} // namespace shapeton

#endif
