#ifndef shapetonSeededHeatSegmentationImageFilter_h
#define shapetonSeededHeatSegmentationImageFilter_h

#include "shapetonExceptions.h"
#include "shapetonFilterWithDomain.h"
#include "shapetonITKCompatibility.h"
#include "shapetonSeededHeatOptionsMethods.h"
#include "shapetonSeededHeatSegmentationOptionsMethods.h"
#include "shapetonSeededHeatSolver.h"
#include "shapetonVolumeGradientImageFilter.h"

#include <memory>
#include <optional>

namespace shapeton
{
/** \class SeededHeatSegmentationImageFilter
 * \brief Labels each voxel by the seeds with the greatest heat there, using SeededHeatSolver.
 *
 * Inputs: a volume, Seeds, a label map on the same grid (0: no seed), and optionally a Domain (FilterWithDomain),
 * outside of which the label is 0. Outputs: labels and their uncertainty (SeededHeatResult). If only the seeds have
 * changed since the last Update() and probabilities are kept, the solver starts from the last solution, for interactive
 * use. Update() throws InputError (fewer than two labels have seeds) or ParameterError, both derived from
 * itk::ExceptionObject.
 *
 * \ingroup ShapetonHeat */
template <typename TInputImage>
class ITK_TEMPLATE_EXPORT SeededHeatSegmentationImageFilter
  : public SeededHeatSegmentationOptionsMethods<SeededHeatOptionsMethods<FilterWithDomain<
      VolumeGradientImageFilter<TInputImage, itk::Image<unsigned short, 3>, SeededHeatSegmentationOptions>>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SeededHeatSegmentationImageFilter);

  using LabelImageType = itk::Image<unsigned short, 3>;
  using HeatImageType = itk::Image<float, 3>;
  using Self = SeededHeatSegmentationImageFilter;
  using Superclass = typename SeededHeatSegmentationImageFilter::SeededHeatSegmentationOptionsMethods;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  shapetonNewMacro(Self);
  itkOverrideGetNameOfClassMacro(SeededHeatSegmentationImageFilter);

  /** Seed label of each voxel, 0 for none. */
  shapetonInputMacro(Seeds, LabelImageType);

  /** Labels that the seeds correct, 0 for none, on the grid of the volume; optional: see SeededHeatSolver::Solve(). */
  shapetonInputMacro(LabelsBefore, LabelImageType);

  /** SeededHeatResult::uncertainty. */
  HeatImageType *
  GetUncertaintyOutput()
  {
    return static_cast<HeatImageType *>(this->ProcessObject::GetOutput(1));
  }

  /** The labels that have seeds, ascending; valid after Update(). */
  const std::vector<unsigned short> &
  GetLabelValues() const
  {
    return m_LabelValues;
  }

  /** The probability of a label in each voxel, as a new image; valid after Update(). Throws ParameterError. */
  typename HeatImageType::Pointer
  GetProbabilities(unsigned short label) const;

  /** Number of iterations of the last solution. */
  itkGetConstMacro(Iterations, unsigned int);

  /** SeededHeatResult::remarks; valid after Update(). */
  const Remarks &
  GetRemarks() const
  {
    return m_Remarks;
  }

protected:
  SeededHeatSegmentationImageFilter();
  ~SeededHeatSegmentationImageFilter() override = default;

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType index) override;
  void
  GenerateData() override;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

private:
  /** The input and parameters of the current operator. */
  struct Origin
  {
    const void *                  pixels;
    itk::ModifiedTimeType         time;
    itk::ModifiedTimeType         timeOfDomain; ///< 0 without a domain
    SeededHeatSegmentationOptions options;

    bool
    operator==(const Origin & other) const;
  };

  void
  PrepareSolver();

  unsigned int                                  m_Iterations{ 0 };
  std::vector<unsigned short>                   m_LabelValues;
  Remarks                                       m_Remarks;
  Remarks                                       m_RemarksOnWindow;
  std::optional<Origin>                         m_Origin;
  std::unique_ptr<const VolumeGradientOperator> m_Operator;
  std::unique_ptr<SeededHeatSolver>             m_Solver;
  HeatImageType::Pointer                        m_Grid; ///< geometry of the last solution; has no pixel buffer
};
} // namespace shapeton

#ifndef ITK_MANUAL_INSTANTIATION
#  include "shapetonSeededHeatSegmentationImageFilter.hxx"
#endif

#endif
