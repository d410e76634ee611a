#ifndef SampledScenes_h
#define SampledScenes_h

#include "shapetonPhiloxStream.h"
#include "shapetonPi.h"
#include "shapetonShapePhantomImageSource.h"

#include "itkCastImageFilter.h"

#include <nlohmann/json.hpp>

#include <cmath>

inline itk::Image<float, 3>::Pointer
ToFloat(const itk::Image<short, 3> * image)
{
  const auto cast = itk::CastImageFilter<itk::Image<short, 3>, itk::Image<float, 3>>::New();
  cast->SetInput(image);
  cast->Update();
  return cast->GetOutput();
}

/** A scene in a volume around its center. */
inline shapeton::ShapePhantomImageSource::Pointer
SampledScene(const shapeton::ShapeScene &          scene,
             const itk::Size<3> &                  size,
             const shapeton::ShapePhantomOptions & options = {})
{
  const auto source = shapeton::ShapePhantomImageSource::New();
  source->SetScene(scene);
  source->SetSize(size);
  source->SetOptions(options);
  source->CenterOutput();
  source->Update();
  return source;
}

/** \class SceneDice
 * \brief Random numbers of scenes in the format of ShapeScene. */
class SceneDice
{
public:
  SceneDice(unsigned int seed, std::uint32_t purpose) : m_Stream(seed, 0, purpose) {}

  double
  Between(double low, double high)
  {
    return low + (high - low) * m_Stream.Unit();
  }
  int
  Count(int low, int high)
  {
    return low + m_Stream.Below(high - low + 1);
  }
  bool
  IsTrue(double probability)
  {
    return m_Stream.Unit() < probability;
  }
  /** Standard normal (Box, Muller 1958). */
  double
  Normal()
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - m_Stream.Unit()));
    return radius * std::cos(2.0 * shapeton::Pi * m_Stream.Unit());
  }
  /** Point in a box around the middle. */
  nlohmann::ordered_json
  Place(double reach)
  {
    return { this->Between(-reach, reach), this->Between(-reach, reach), this->Between(-reach, reach) };
  }
  nlohmann::ordered_json
  Turn()
  {
    const nlohmann::ordered_json axis{ this->Between(-1.0, 1.0), this->Between(-1.0, 1.0), this->Between(0.1, 1.0) };
    return { { "axis", axis }, { "angle", this->Between(0.0, 180.0) } };
  }

private:
  shapeton::PhiloxStream m_Stream;
};

#endif
