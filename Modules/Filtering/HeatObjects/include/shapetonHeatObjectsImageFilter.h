#ifndef shapetonHeatObjectsImageFilter_h
#define shapetonHeatObjectsImageFilter_h

#include "shapetonFilterInput.h"
#include "shapetonFilterOptions.h"
#include "shapetonHeatObjectOptionsMethods.h"
#include "shapetonHeatObjects.h"

#include "itkImageToImageFilter.h"
#include "shapetonITKCompatibility.h"

namespace shapeton
{
/** \class HeatObjectsImageFilter
 * \brief HeatObjectTree::List() as a filter: the input is a heat volume, and the output is the number of the smallest
 * object at each voxel.
 *
 * Update() throws InputError or ParameterError, both derived from itk::ExceptionObject.
 *
 * \ingroup ShapetonHeatObjects */
class ShapetonHeatObjects_EXPORT HeatObjectsImageFilter
  : public HeatObjectOptionsMethods<
      FilterWithOptions<HeatObjectOptions, itk::ImageToImageFilter<itk::Image<float, 3>, HeatObjectList::LabelImage>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(HeatObjectsImageFilter);

  using Self = HeatObjectsImageFilter;
  using Superclass = HeatObjectsImageFilter::HeatObjectOptionsMethods;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  shapetonNewMacro(Self);
  itkOverrideGetNameOfClassMacro(HeatObjectsImageFilter);

  /** See HeatObjectTree; optional. */
  shapetonInputMacro(Domain, HeatObjectTree::MaskImage);

  /** The objects, by descending volume; valid after Update(). */
  const std::vector<HeatObject> &
  GetObjects() const
  {
    return m_List.objects;
  }

  /** MaskOfObject() for one of them, numbered from 1; valid after Update(). Throws ParameterError. */
  itk::Image<unsigned char, 3>::Pointer
  GetMask(int object) const;

protected:
  HeatObjectsImageFilter() { this->AddOptionalInputName("Domain"); }
  ~HeatObjectsImageFilter() override = default;

  /** Does nothing: HeatObjectTree compares the grids of heat and domain, see HaveSameGrid(). */
  void
  VerifyInputInformation() const override
  {}
  void
  GenerateInputRequestedRegion() override;
  void
  EnlargeOutputRequestedRegion(itk::DataObject * output) override;
  void
  GenerateData() override;

private:
  HeatObjectList m_List;
};
} // namespace shapeton

#endif
