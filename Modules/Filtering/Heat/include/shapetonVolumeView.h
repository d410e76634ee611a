#ifndef shapetonVolumeView_h
#define shapetonVolumeView_h

#include "shapetonDicomFields.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace shapeton
{
/** \class VolumeView
 * \brief The intensities of a volume as floats, x fastest, with size and spacing.
 *
 * Refers to values that must outlive it, or shares ownership of a copy. The volume may be limited to a domain: nothing
 * flows to or from the other voxels, and their intensities have no effect.
 *
 * \ingroup ShapetonHeat */
struct VolumeView
{
  VolumeView(const float *                      intensities,
             const std::array<std::size_t, 3> & sizeInVoxels,
             const std::array<double, 3> &      spacingInMm = { { 1.0, 1.0, 1.0 } })
    : values(intensities), size(sizeInVoxels), spacing(spacingInMm)
  {}

  VolumeView(std::vector<float>                 intensities,
             const std::array<std::size_t, 3> & sizeInVoxels,
             const std::array<double, 3> &      spacingInMm)
    : own(std::make_shared<const std::vector<float>>(std::move(intensities)))
    , values(own->data())
    , size(sizeInVoxels)
    , spacing(spacingInMm)
  {}

  /** The buffered region of an image, empty if it is null or its pixels were not allocated; pixels of types other than
   * float are copied. */
  template <typename TImage>
  explicit VolumeView(const TImage * image)
  {
    static_assert(TImage::ImageDimension == 3 && std::is_arithmetic_v<typename TImage::PixelType>,
                  "the image must be a volume with scalar pixels");
    const auto * const pixels = image ? image->GetBufferPointer() : nullptr;
    if (!pixels)
    {
      return;
    }
    std::copy_n(image->GetSpacing().Begin(), spacing.size(), spacing.begin());
    std::copy_n(image->GetBufferedRegion().GetSize().begin(), size.size(), size.begin());
    if constexpr (std::is_same_v<typename TImage::PixelType, float>)
    {
      values = pixels;
    }
    else
    {
      *this = VolumeView(std::vector<float>(pixels, pixels + this->NumberOfVoxels()), size, spacing);
    }
    modality = DicomField(image, DicomModality);
  }

  std::size_t
  NumberOfVoxels() const
  {
    return size[0] * size[1] * size[2];
  }
  bool
  IsInDomain(std::size_t voxel) const
  {
    return !domain || (*domain)[voxel] != 0;
  }
  const float *
  begin() const
  {
    return values;
  }
  const float *
  end() const
  {
    return values + this->NumberOfVoxels();
  }

  std::shared_ptr<const std::vector<float>> own; ///< null if the values belong to others
  const float *                             values{ nullptr };
  std::array<std::size_t, 3>                size{};
  std::array<double, 3>                     spacing{ { 1.0, 1.0, 1.0 } }; ///< mm
  /** 0 for each voxel outside the domain; null if all voxels are in it. */
  std::shared_ptr<const std::vector<unsigned char>> domain;
  std::string                                       modality; ///< of DICOM, such as "CT"; empty if unknown
};
} // namespace shapeton

#endif
