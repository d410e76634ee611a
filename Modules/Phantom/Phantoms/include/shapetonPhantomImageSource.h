#ifndef shapetonPhantomImageSource_h
#define shapetonPhantomImageSource_h

#include "ShapetonPhantomsExport.h"
#include "shapetonITKCompatibility.h"
#include "shapetonIndexedOutputs.h"

#include "itkGenerateImageSource.h"
#include "itkImage.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
/** \class PhantomImageSource
 * \brief Base class of the phantoms: output 0 is an image in HU, the others are labels on the same grid.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT PhantomImageSource : public itk::GenerateImageSource<itk::Image<short, 3>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(PhantomImageSource);

  using Self = PhantomImageSource;
  using Superclass = itk::GenerateImageSource<itk::Image<short, 3>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;
  using ImageType = itk::Image<short, 3>;
  using LabelImageType = itk::Image<unsigned char, 3>;

  itkOverrideGetNameOfClassMacro(PhantomImageSource);

  /** Sets the origin from size, spacing and direction such that the center of the volume is at `center` (LPS, mm). */
  void
  CenterOutput(const PointType & center = PointType(0.0));

  shapetonIndexedOutputsMacro();
  itk::ProcessObject::DataObjectPointer
  MakeOutput(itk::ProcessObject::DataObjectPointerArraySizeType output) override;

protected:
  explicit PhantomImageSource(unsigned int outputs);
  ~PhantomImageSource() override = default;

  void
  GenerateOutputInformation() override;

  LabelImageType *
  LabelOutput(unsigned int output) const
  {
    return static_cast<LabelImageType *>(const_cast<itk::DataObject *>(this->ProcessObject::GetOutput(output)));
  }

  /** Rounds and clamps to [-1024, 31743], the range of a written CT series. */
  template <typename TValue>
  static short
  ToHounsfieldUnits(TValue value)
  {
    constexpr short lowest = -1024;
    constexpr short highest = 31743;
    return static_cast<short>(std::floor(std::clamp(value, TValue(lowest), TValue(highest)) + TValue(0.5)));
  }
};
} // namespace shapeton

#endif
