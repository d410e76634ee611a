#ifndef shapetonFilterWithDomain_h
#define shapetonFilterWithDomain_h

#include "shapetonFilterInput.h"
#include "shapetonImageGrid.h"
#include "shapetonVolumeView.h"

#include "itkImage.h"

namespace shapeton
{
/** \class FilterWithDomain
 * \brief Mixin for filters of volumes whose heat may be limited to a part of the volume, the domain.
 *
 * \ingroup ShapetonHeat */
template <typename TSuperclass>
class FilterWithDomain : public TSuperclass
{
public:
  using DomainImageType = itk::Image<unsigned char, 3>;

  itkOverrideGetNameOfClassMacro(FilterWithDomain);

  /** 0 for each voxel that heat neither enters nor leaves, on the grid of the volume; not set or null: heat flows in
   * the whole volume. */
  shapetonInputMacro(Domain, DomainImageType);

  /** The input with its domain, of the buffered regions. Throws InputError if they differ in size, or without input. */
  VolumeView
  GetVolume() const
  {
    if (!this->GetInput())
    {
      throw InputError("the filter has no input; set it before its volume is asked for");
    }
    VolumeView                    volume(this->GetInput());
    const DomainImageType * const domain = this->GetDomain();
    if (domain)
    {
      RequirePixels(domain, "the domain");
      if (domain->GetBufferedRegion().GetSize() != this->GetInput()->GetBufferedRegion().GetSize())
      {
        throw InputError("the domain has another size than the volume; use a mask on the grid of the volume");
      }
      const unsigned char * const first = domain->GetBufferPointer();
      volume.domain = std::make_shared<const std::vector<unsigned char>>(first, first + volume.NumberOfVoxels());
    }
    return volume;
  }

protected:
  FilterWithDomain() { this->AddOptionalInputName("Domain"); }
  ~FilterWithDomain() override = default;
};
} // namespace shapeton

#endif
