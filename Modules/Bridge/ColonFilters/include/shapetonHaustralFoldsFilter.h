#ifndef shapetonHaustralFoldsFilter_h
#define shapetonHaustralFoldsFilter_h

#include "ShapetonColonFiltersExport.h"

#include "shapetonHaustralFolds.h"
#include "shapetonStageFilter.h"

#include "itkImageSource.h"

namespace shapeton
{
/** \class HaustralFoldsFilter
 * \brief Pipeline filter of FindHaustralFolds(): the haustral folds on the flat map of a colon.
 *
 * \par Inputs and Outputs
 * Input FlatColon. Optional input Taeniae, curves on the wall that split folds. Output 0: labels on the grid of the
 * flat colon. The grid size is known only once the flat colon exists, so UpdateOutputInformation() updates the input.
 * Output 1: HaustralFolds.
 *
 * \ingroup ShapetonColonFilters */
class ShapetonColonFilters_EXPORT HaustralFoldsFilter
  : public StageFilter<itk::ImageSource<itk::Image<unsigned short, 2>>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(HaustralFoldsFilter);

  using Self = HaustralFoldsFilter;
  using Superclass = StageFilter<itk::ImageSource<itk::Image<unsigned short, 2>>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using OptionsType = HaustralFoldOptions;

  itkNewMacro(Self);
  itkOverrideGetNameOfClassMacro(HaustralFoldsFilter);

  itkSetInputMacro(FlatColon, ResultObject<FlatColon>);
  itkGetInputMacro(FlatColon, ResultObject<FlatColon>);
  itkSetInputMacro(Taeniae, ResultObject<CurveSet>);
  itkGetInputMacro(Taeniae, ResultObject<CurveSet>);

  /** \name See HaustralFoldOptions for units, ranges and defaults */
  ///@{
  shapetonOptionMacro(Scheme, scheme);
  shapetonOptionMacro(MinimumLength, minimumLength);
  shapetonOptionMacro(MinimumArea, minimumArea);
  shapetonOptionMacro(MinimumElongation, minimumElongation);
  shapetonOptionMacro(MinimumAngle, minimumAngle);
  shapetonOptionMacro(SmoothingTime, smoothingTime);
  shapetonOptionMacro(Smoothness, smoothness);
  shapetonOptionMacro(Contrast, contrast);
  shapetonOptionMacro(PublishedLow, publishedLow);
  shapetonOptionMacro(PublishedHigh, publishedHigh);
  ///@}

  ResultObject<HaustralFolds> *
  GetFoldsOutput();

  using Superclass::MakeOutput;
  itk::DataObject::Pointer
  MakeOutput(DataObjectPointerArraySizeType index) override;

protected:
  HaustralFoldsFilter();
  ~HaustralFoldsFilter() override = default;

  void
  GenerateOutputInformation() override;
  void
  Compute() override;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

private:
  OptionsType m_Options;
};
} // namespace shapeton

#endif
