#ifndef shapetonLumenDistance_h
#define shapetonLumenDistance_h

#include "ColonLumenExport.h"

#include "itkImage.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** A lumen: voxels other than 0. \ingroup ColonLumen */
using LumenMask = itk::Image<unsigned char, 3>;
/** Millimetres. \ingroup ColonLumen */
using LumenDistanceImage = itk::Image<float, 3>;
/** Numbers of components, 0 outside. \ingroup ColonLumen */
using LumenLabelImage = itk::Image<std::int32_t, 3>;

/** The bounding box of the lumen, `margin` voxels wider on each side as far as the image goes. Throws InputError when
 * the lumen is empty. \ingroup ColonLumen */
ColonLumen_EXPORT itk::ImageRegion<3>
                  LumenRegion(const LumenMask * lumen, unsigned int margin = 1);

/** The distance of each lumen voxel of `region` to the wall, mm; 0 outside the lumen. The image covers `region` alone
 * and has the geometry of `lumen`.
 *
 * It is the exact Euclidean distance between the centres of the voxel and of the nearest voxel outside the lumen, less
 * a quarter of the smallest spacing: a flat wall lies half a voxel nearer than that centre, the wall of a round lumen
 * seen from its axis hardly nearer, because the nearest of many centres counts. So a tube of radius r measures r on its
 * axis, to about half a voxel. What lies beyond the region is not known and counts as lumen, so a lumen that the image
 * cuts keeps its calibre up to the cut; take a region with a margin where the image goes on. Time is linear
 * in voxels; threads do not change the values.
 *
 * Throws InputError when no voxel of the region lies outside the lumen.
 * \ingroup ColonLumen */
ColonLumen_EXPORT LumenDistanceImage::Pointer
                  LumenDistance(const LumenMask * lumen, const itk::ImageRegion<3> & region);

/** Connected components by faces of voxels. \ingroup ColonLumen */
struct LumenComponent
{
  std::int64_t voxels{ 0 };
  /** ml. */
  double volume{ 0.0 };
  /** Its bounding box. */
  itk::Index<3> first{};
  itk::Index<3> last{};
};

/** The connected components of a mask, labelled and measured. See FindLumenComponents(). \ingroup ColonLumen */
struct LumenComponents
{
  /** 1 for the first of `components`, and so on. Covers the region alone. */
  LumenLabelImage::Pointer labels;
  /** The largest one first; of equal ones that with the earlier voxel. */
  std::vector<LumenComponent> components;
};

/** The components of the lumen within `region`. Linear in voxels. \ingroup ColonLumen */
ColonLumen_EXPORT LumenComponents
FindLumenComponents(const LumenMask * lumen, const itk::ImageRegion<3> & region);
} // namespace shapeton

#endif
