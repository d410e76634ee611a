#ifndef shapetonShapePhantomImageSource_h
#define shapetonShapePhantomImageSource_h

#include "shapetonFilterOptions.h"
#include "shapetonPhantomImageSource.h"
#include "shapetonShapePhantomOptionsMethods.h"
#include "shapetonShapeScene.h"

#include <string>
#include <vector>

namespace shapeton
{
/** \class ShapePhantomImageSource
 * \brief Samples a ShapeScene as an image in Hounsfield units and a label image.
 *
 * The scene is defined in physical space, independent of the grid.
 *
 * Consecutive objects of equal intensity form one body, their union; bodies are painted in order, each over the
 * previous ones. If a body covers the fraction a of a voxel, the value v becomes v + a (intensity - v). Without blur, a
 * is 1 if the voxel center is in the body or on its surface, else 0. With blur, a = Phi(-d / blur), where d is the
 * signed distance of the center and Phi the normal distribution function; for a plane face this equals convolution with
 * a Gaussian. Then noise is added, and the value is rounded to integer HU and clamped to [-1024, 31743], the range of a
 * written CT series.
 *
 * The label of a voxel is the label of the last object that contains its center (signed distance <= 0), or 0,
 * independent of blur and noise.
 *
 * Each voxel depends only on its index and physical position, so the result does not depend on the number of threads or
 * pieces.
 *
 * \par Inputs and Outputs
 * No input. Output 0 is the image, output 1 the labels.
 *
 * \par Parameters
 * Size (default 64 each), Spacing, Origin and Direction are inherited from GenerateImageSource; CenterOutput() centers
 * the volume at (0, 0, 0), the center of the scene. ShapePhantomOptions declares the others.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT ShapePhantomImageSource
  : public ShapePhantomOptionsMethods<FilterWithOptions<ShapePhantomOptions, PhantomImageSource>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ShapePhantomImageSource);

  using Self = ShapePhantomImageSource;
  using Superclass = ShapePhantomOptionsMethods<FilterWithOptions<ShapePhantomOptions, PhantomImageSource>>;
  using Pointer = itk::SmartPointer<Self>;
  using ConstPointer = itk::SmartPointer<const Self>;

  shapetonNewMacro(Self);
  itkOverrideGetNameOfClassMacro(ShapePhantomImageSource);

  /** The scene to sample. A relative scene is scaled to the shortest extent (size * spacing) of the output. */
  void
  SetScene(const ShapeScene & scene);
  const ShapeScene &
  GetScene() const
  {
    return m_Scene;
  }

  LabelImageType *
  GetLabelOutput()
  {
    return this->LabelOutput(1);
  }
  const LabelImageType *
  GetLabelOutput() const
  {
    return this->LabelOutput(1);
  }

  /** Names of the objects that are not completely inside the volume: those with voxels in the border layer, or outside.
   * Call after UpdateOutputInformation(). */
  std::vector<std::string>
  FindIncompleteObjects() const;

protected:
  ShapePhantomImageSource();
  ~ShapePhantomImageSource() override = default;
  void
  PrintSelf(std::ostream & os, itk::Indent indent) const override;

  void
  BeforeThreadedGenerateData() override;
  void
  DynamicThreadedGenerateData(const RegionType & region) override;

private:
  /** Consecutive objects of equal intensity. */
  struct Body
  {
    double                   intensity;
    std::vector<std::size_t> objects;
  };

  ShapeScene
  GetScaledScene() const;
  std::vector<Body>
  FindBodiesNear(const PointType & lineStart, const PointType & lineEnd) const;

  double
  SampleBodies(const std::vector<Body> & bodies, const PointType & point, unsigned char & label) const;

  ShapeScene m_Scene;

  // The scene scaled to the current output.
  ShapeScene                      m_ScaledScene;
  std::vector<ShapeScene::Object> m_Objects;
};
} // namespace shapeton

#endif
