#ifndef shapetonHeatHistogramFilter_h
#define shapetonHeatHistogramFilter_h

#include "shapetonHeatHistogram.h"
#include "shapetonITKCompatibility.h"

#include "itkImage.h"
#include "itkProcessObject.h"
#include "itkSimpleDataObjectDecorator.h"

#include <cstdint>
#include <vector>

namespace shapeton
{
/** \class HeatHistogramFilter
 * \brief Computes the heat histogram of existing heat volumes, one row per volume.
 *
 * If the heat volumes are not stored, CumulativeHeatDiffusionImageFilter computes the same histogram while it runs.
 *
 * \par Inputs and Outputs
 * Inputs: heat volumes in [0, 1] in the order of ascending time steps, by AddHeat(). Output: a HeatHistogram in a
 * SimpleDataObjectDecorator.
 *
 * \ingroup ShapetonHeat */
class ShapetonHeat_EXPORT HeatHistogramFilter : public itk::ProcessObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(HeatHistogramFilter);

  using Self = HeatHistogramFilter;
  using Superclass = itk::ProcessObject;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using HeatImageType = itk::Image<float, 3>;
  using OutputType = itk::SimpleDataObjectDecorator<HeatHistogram>;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(HeatHistogramFilter);

  /** Adds the heat after `timeStep`, which must not be less than in the previous call. */
  void
  AddHeat(const HeatImageType * heat, std::uint64_t timeStep);

  const OutputType *
  GetOutput() const;

  /** The histogram; valid after Update(). */
  const HeatHistogram &
  GetHistogram() const
  {
    return this->GetOutput()->Get();
  }

protected:
  HeatHistogramFilter();
  ~HeatHistogramFilter() override;

  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;
  void
  GenerateData() override;

private:
  std::vector<std::uint64_t> m_TimeSteps;
};
} // namespace shapeton

#endif
