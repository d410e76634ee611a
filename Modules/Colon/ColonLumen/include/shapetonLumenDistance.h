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

/** The bounding box of the lumen, padded by `margin` voxels and clipped to the image. Throws InputError if the lumen is
 * empty.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT itk::ImageRegion<3>
                          LumenRegion(const LumenMask * lumen, unsigned int margin = 1);

/** Distance (mm) from each lumen voxel of `region` to the wall; 0 outside the lumen. The image covers only `region`, in
 * the physical space of `lumen`.
 *
 * The distance is the exact Euclidean distance from the center of the voxel to that of the nearest voxel outside the
 * lumen, minus a quarter of the smallest spacing. This is a compromise: a flat wall is half a voxel nearer than the
 * center of the first voxel outside, while the wall of a round lumen is hardly nearer to the axis than that center. On
 * the axis of a tube, the distance equals the radius to about half a voxel. Voxels outside the region are treated as
 * lumen to preserve the caliber at the image border; elsewhere, use a region with a margin. Linear time in voxels; the
 * result does not depend on the number of threads.
 *
 * Throws InputError if all voxels of the region are lumen.
 * \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT LumenDistanceImage::Pointer
                          LumenDistance(const LumenMask * lumen, const itk::ImageRegion<3> & region);

/** A face-connected component. \ingroup ShapetonColonLumen */
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
  /** Largest first; components of equal size are in the order of their first voxels. */
  std::vector<LumenComponent> components;
};

/** Finds the components of the lumen within `region`. Linear time in voxels. \ingroup ShapetonColonLumen */
ShapetonColonLumen_EXPORT LumenComponents
FindLumenComponents(const LumenMask * lumen, const itk::ImageRegion<3> & region);
} // namespace shapeton

#endif
