#include "shapetonShapePhantomImageSource.h"
#include "shapetonCounterNoise.h"
#include "shapetonPhantomSolid.h"

#include "itkImageScanlineIterator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
using PointType = ShapePhantomImageSource::PointType;

// NormalDistribution is exactly 0 beyond this value.
constexpr double reachOfBlur = 8.0;

double
Square(double x)
{
  return x * x;
}

template <typename TVisitor>
void
VisitBorder(const itk::ImageBase<3> * image, const TVisitor & visit)
{
  const auto    region = image->GetLargestPossibleRegion();
  const auto    first = region.GetIndex();
  const auto    last = region.GetUpperIndex();
  itk::Index<3> index;
  for (index[2] = first[2]; index[2] <= last[2]; ++index[2])
  {
    for (index[1] = first[1]; index[1] <= last[1]; ++index[1])
    {
      const bool face = index[1] == first[1] || index[1] == last[1] || index[2] == first[2] || index[2] == last[2];
      const itk::IndexValueType step = face ? 1 : std::max<itk::IndexValueType>(last[0] - first[0], 1);
      for (index[0] = first[0]; index[0] <= last[0]; index[0] += step)
      {
        PointType point;
        image->TransformIndexToPhysicalPoint(index, point);
        visit(point);
      }
    }
  }
}
} // namespace

ShapePhantomImageSource::ShapePhantomImageSource() : Superclass(2)
{
  SizeType size;
  size.Fill(64);
  this->SetSize(size);
  this->DynamicMultiThreadingOn();
}

void
ShapePhantomImageSource::SetScene(const ShapeScene & scene)
{
  m_Scene = scene;
  this->Modified();
}

ShapeScene
ShapePhantomImageSource::GetScaledScene() const
{
  ShapeScene scene = m_Scene;
  if (scene.IsRelative())
  {
    const ImageType * const output = this->GetOutput();
    double                  shortest = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < 3; ++i)
    {
      shortest = std::min(shortest, output->GetLargestPossibleRegion().GetSize(i) * output->GetSpacing()[i]);
    }
    scene.SetUnitLength(shortest);
  }
  return scene;
}

void
ShapePhantomImageSource::BeforeThreadedGenerateData()
{
  m_ScaledScene = this->GetScaledScene();
  m_Objects.clear();
  for (std::size_t i = 0; i < m_ScaledScene.GetNumberOfObjects(); ++i)
  {
    m_Objects.push_back(m_ScaledScene.GetObject(i));
  }
}

std::vector<ShapePhantomImageSource::Body>
ShapePhantomImageSource::FindBodiesNear(const PointType & lineStart, const PointType & lineEnd) const
{
  std::vector<Body> bodies;
  bool              sameBody = false;
  for (std::size_t i = 0; i < m_Objects.size(); ++i)
  {
    const auto & object = m_Objects[i];
    sameBody = sameBody && i > 0 && object.intensity == m_Objects[i - 1].intensity;
    const double reach = object.boundingRadius + reachOfBlur * m_Options.blur;
    // The margin accounts for rounding relative to the per-voxel test.
    constexpr double forRounding = 1.001;
    if (Square(DistanceToSegment(object.boundingCenter, lineStart, lineEnd)) > forRounding * Square(reach))
    {
      continue;
    }
    if (!sameBody)
    {
      bodies.push_back({ object.intensity, {} });
      sameBody = true;
    }
    bodies.back().objects.push_back(i);
  }
  return bodies;
}

void
ShapePhantomImageSource::DynamicThreadedGenerateData(const RegionType & region)
{
  ImageType *      image = this->GetOutput();
  LabelImageType * labels = this->GetLabelOutput();
  const auto       largest = image->GetLargestPossibleRegion();

  itk::ImageScanlineIterator<ImageType>      imageIt(image, region);
  itk::ImageScanlineIterator<LabelImageType> labelIt(labels, region);
  for (; !imageIt.IsAtEnd(); imageIt.NextLine(), labelIt.NextLine())
  {
    auto      index = imageIt.GetIndex();
    PointType start;
    PointType end;
    image->TransformIndexToPhysicalPoint(index, start);
    auto last = index;
    last[0] += static_cast<itk::IndexValueType>(region.GetSize(0)) - 1;
    image->TransformIndexToPhysicalPoint(last, end);
    const auto bodies = this->FindBodiesNear(start, end);

    const auto    row = index - largest.GetIndex();
    std::uint64_t counter = row[0] + largest.GetSize(0) * (row[1] + largest.GetSize(1) * row[2]);
    for (; !imageIt.IsAtEndOfLine(); ++imageIt, ++labelIt, ++index[0], ++counter)
    {
      PointType point;
      image->TransformIndexToPhysicalPoint(index, point);
      unsigned char label = 0;
      double        value = this->SampleBodies(bodies, point, label);
      if (m_Options.noise > 0.0)
      {
        value += m_Options.noise * NormalNoise(m_Options.seed, counter);
      }
      imageIt.Set(ToHounsfieldUnits(value));
      labelIt.Set(label);
    }
  }
}

double
ShapePhantomImageSource::SampleBodies(const std::vector<Body> & bodies,
                                      const PointType &         point,
                                      unsigned char &           label) const
{
  double value = m_ScaledScene.GetBackground();
  for (const auto & body : bodies)
  {
    double least = std::numeric_limits<double>::max();
    for (const std::size_t i : body.objects)
    {
      const auto &     object = m_Objects[i];
      constexpr double forRounding = 1.000001;
      if ((point - object.boundingCenter).GetSquaredNorm() >
          Square(object.boundingRadius * forRounding + reachOfBlur * m_Options.blur))
      {
        continue;
      }
      const double distance = m_ScaledScene.SignedDistance(i, point);
      least = std::min(least, distance);
      label = distance <= 0.0 ? object.label : label;
    }
    const double covered =
      m_Options.blur > 0.0 ? NormalDistribution(-least / m_Options.blur) : (least <= 0.0 ? 1.0 : 0.0);
    value += covered * (body.intensity - value);
  }
  return value;
}

std::vector<std::string>
ShapePhantomImageSource::FindIncompleteObjects() const
{
  const ImageType *               image = this->GetOutput();
  const ShapeScene                scene = this->GetScaledScene();
  std::vector<bool>               incomplete(scene.GetNumberOfObjects(), false);
  std::vector<ShapeScene::Object> objects;
  for (std::size_t i = 0; i < incomplete.size(); ++i)
  {
    objects.push_back(scene.GetObject(i));
    itk::ContinuousIndex<double, 3> index;
    // An object that does not cross the border is completely inside or outside, as is this point.
    incomplete[i] = !image->TransformPhysicalPointToContinuousIndex(objects[i].boundingCenter, index);
  }
  VisitBorder(image, [&](const PointType & point) {
    for (std::size_t i = 0; i < incomplete.size(); ++i)
    {
      incomplete[i] =
        incomplete[i] || ((point - objects[i].boundingCenter).GetSquaredNorm() <= Square(objects[i].boundingRadius) &&
                          scene.SignedDistance(i, point) <= 0.0);
    }
  });
  std::vector<std::string> names;
  for (std::size_t i = 0; i < incomplete.size(); ++i)
  {
    if (incomplete[i])
    {
      names.push_back(objects[i].name);
    }
  }
  return names;
}

void
ShapePhantomImageSource::PrintSelf(std::ostream & os, itk::Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Objects: " << m_Scene.GetNumberOfObjects() << '\n';
}
} // namespace shapeton
