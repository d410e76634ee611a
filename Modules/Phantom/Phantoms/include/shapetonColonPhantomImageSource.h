#ifndef shapetonColonPhantomImageSource_h
#define shapetonColonPhantomImageSource_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"
#include "shapetonColonStructures.h"
#include "shapetonPhantomImageSource.h"
#include "shapetonProgress.h"

#include <memory>
#include <vector>

namespace shapeton
{
/** \class ColonPhantomImageSource
 * \brief CT colonography volume of a synthetic patient, with its ground truth.
 *
 * The patient is defined in physical space (LPS, mm), with the center of the abdomen at (0, 0, 0), independent of the
 * grid. Each voxel is the mean of its content (BodySampler), with scanner blur and correlated noise (CorrelatedNoise),
 * rounded to integer HU and clamped to [-1024, 31743].
 *
 * The ground truth of the lumen is evaluated at voxel centers, without blur or noise. The catheter is part of the
 * lumen.
 *
 * Each voxel depends only on its index and position, so the result does not depend on the number of threads. The whole
 * volume is generated at once.
 *
 * \par Inputs and Outputs
 * No input. Output 0 is the image in HU; output 1 the lumen (1 gas, 2 fluid); output 2 the segments of the lumen (see
 * ColonAnatomy); output 3 other structures (ColonStructure).
 *
 * \par Parameters Size (default 256, 256, 240), Spacing (default 1.4 mm), Origin (default: such that the volume's
 * center is at the patient's (0, 0, 0)) and Direction are those of GenerateImageSource; CenterOutput() moves the origin
 * after a change. The diaphragm rises to about z = 160, and the lungs extend up to about z = 345.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT ColonPhantomImageSource : public PhantomImageSource
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ColonPhantomImageSource);

  using Self = ColonPhantomImageSource;
  using Superclass = PhantomImageSource;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  shapetonNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ColonPhantomImageSource);

  /** The patient and the position; default: the preset standard. Throws ParameterError if a parameter is out of
   * range. */
  void
  SetParameters(const ColonPhantomParameters & parameters);
  const ColonPhantomParameters &
  GetParameters() const
  {
    return m_Parameters;
  }

  /** Standard deviation (mm) of the edge profile including voxel width, in [0, 3]; default 0.75. Scaled by 1.2 for a
   * soft kernel and by 0.75 for a sharp one; the slice thickness is added along the third axis. */
  itkSetClampMacro(Blur, double, 0.0, 3.0);
  itkGetConstMacro(Blur, double);

  /** Generate only outputs 1 to 3, which is much faster; output 0 is then empty. Default off. */
  itkSetMacro(TruthOnly, bool);
  itkGetConstMacro(TruthOnly, bool);
  itkBooleanMacro(TruthOnly);

  /** The ground truth; computed on first use. Valid until the parameters change. */
  const ColonAnatomy &
  GetAnatomy();
  const ColonFluid &
  GetFluid();
  const ColonStructures &
  GetStructures();

  /** 1 gas, 2 fluid, 0 elsewhere. */
  LabelImageType *
  GetLumenOutput()
  {
    return this->LabelOutput(1);
  }

  /** 1 to 6 in the lumen, 0 elsewhere. */
  LabelImageType *
  GetSegmentOutput()
  {
    return this->LabelOutput(2);
  }

  /** A ColonStructure for each voxel. */
  LabelImageType *
  GetStructureOutput()
  {
    return this->LabelOutput(3);
  }

protected:
  ColonPhantomImageSource();
  ~ColonPhantomImageSource() override = default;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

  /** Requires positive spacings. */
  void
  VerifyPreconditions() const override;
  void
  EnlargeOutputRequestedRegion(itk::DataObject * output) override;
  void
  GenerateData() override;

private:
  Progress
  Reporter();
  void
  PaintImage(const std::vector<OutputImageRegionType> & tiles);

  ColonPhantomParameters                 m_Parameters;
  double                                 m_Blur{ 0.75 };
  bool                                   m_TruthOnly{ false };
  std::unique_ptr<const ColonAnatomy>    m_Anatomy;
  std::unique_ptr<const ColonFluid>      m_Fluid;
  std::unique_ptr<const ColonStructures> m_Structures;
};
} // namespace shapeton

#endif
