#include "shapetonVolumeRendering.h"

#include "shapetonClassifiedVolume.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "shapetonLighting.h"
#include "itkMultiThreaderBase.h"
#include "shapetonPictureAnnotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace shapeton
{
namespace
{
// Behind the volume: dark, because every colour of the heat map is light.
const RGBColor background = MakeColor(18, 19, 25);
const RGBColor annotation = MakeColor(214, 218, 226);

using Vector3 = itk::Vector<double, 3>;

/** A ray as continuous indices: start + t * step, t counting samples. */
struct Ray
{
  double start[3];
  double step[3];
};

/** Physical lengths and directions as the volume's indices see them. */
class IndexSpace
{
public:
  explicit IndexSpace(const itk::ImageBase<3> * volume)
    : m_Inverse(volume->GetDirection().GetInverse()), m_Spacing(volume->GetSpacing())
  {
    const itk::ImageRegion<3> region = volume->GetLargestPossibleRegion();
    volume->TransformIndexToPhysicalPoint(region.GetIndex(), m_First);
    m_SmallestSpacing = std::min({ m_Spacing[0], m_Spacing[1], m_Spacing[2] });
  }

  Vector3
  IndexVector(const Vector3 & physical) const
  {
    Vector3 index = m_Inverse * physical;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      index[axis] /= m_Spacing[axis];
    }
    return index;
  }

  Vector3
  IndexOf(const itk::ImageBase<3>::PointType & point) const
  {
    return this->IndexVector(point - m_First);
  }

  /** The physical direction, not normalised, of a gradient for each voxel along its axis. */
  Vector3
  PhysicalGradient(const std::array<float, 3> & perVoxel) const
  {
    Vector3 perMillimetre;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      perMillimetre[axis] = perVoxel[axis] / m_Spacing[axis];
    }
    // The inverse's transpose: direction cosines need not be exactly orthogonal.
    Vector3 gradient;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      gradient[axis] = m_Inverse[0][axis] * perMillimetre[0] + m_Inverse[1][axis] * perMillimetre[1] +
                       m_Inverse[2][axis] * perMillimetre[2];
    }
    return gradient;
  }

  double
  GetSmallestSpacing() const
  {
    return m_SmallestSpacing;
  }

private:
  itk::Matrix<double, 3, 3>      m_Inverse;
  itk::ImageBase<3>::SpacingType m_Spacing;
  itk::ImageBase<3>::PointType   m_First;
  double                         m_SmallestSpacing{ 1.0 };
};

/** \class RayCaster
 * \brief The colour seen through a pixel. */
class RayCaster
{
public:
  RayCaster(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction, const PatientView & view)
    : m_Volume(heat, transferFunction)
    , m_Space(heat)
    , m_View(view)
    // Two samples for each smallest voxel: the opacity of a sample is then a square root away from that of a voxel.
    , m_Step(m_Space.IndexVector(view.GetForward() * (0.5 * m_Space.GetSmallestSpacing())))
  {
    m_ToLight = Lighting::DirectionToLight(view.GetRight(), view.GetUp(), view.GetForward());
    m_Halfway = m_ToLight - view.GetForward();
    m_Halfway.Normalize();
  }

  RGBColor
  ColorOfPixel(double x, double y) const
  {
    const Vector3 start = m_Space.IndexOf(m_View.PointOfPixel(x, y));
    double        first;
    double        last;
    if (!this->Clip(start, first, last))
    {
      return background;
    }
    float color[3] = { 0.0F, 0.0F, 0.0F };
    float visible = 1.0F;
    // Whole sample numbers, counted from the picture plane: neighbouring rays sample the same planes.
    for (double t = std::ceil(first); t <= last && visible > 0.004F; t += 1.0)
    {
      const double position[3] = { start[0] + t * m_Step[0], start[1] + t * m_Step[1], start[2] + t * m_Step[2] };
      const auto   content = m_Volume.ContentAt(position);
      if (content != ClassifiedVolume::Content::Transparent)
      {
        this->Accumulate(position, content, color, visible);
      }
    }
    RGBColor seen;
    for (unsigned int channel = 0; channel < 3; ++channel)
    {
      const float value = 255.0F * color[channel] + visible * background[channel];
      seen[channel] = static_cast<unsigned char>(std::min(value + 0.5F, 255.0F));
    }
    return seen;
  }

private:
  /** The samples between which the ray is inside the volume, whose voxels reach half a voxel beyond their centres. */
  bool
  Clip(const Vector3 & start, double & first, double & last) const
  {
    first = -std::numeric_limits<double>::max();
    last = std::numeric_limits<double>::max();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const double lower = -0.5 - start[axis];
      const double upper = m_Volume.GetSize()[axis] - 0.5 - start[axis];
      if (m_Step[axis] == 0.0)
      {
        if (lower > 0.0 || upper < 0.0)
        {
          return false;
        }
        continue;
      }
      const double a = lower / m_Step[axis];
      const double b = upper / m_Step[axis];
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    }
    return first <= last;
  }

  /** Adds a sample behind those that the ray has passed; `visible` is what they let through. \equation{1.3} */
  void
  Accumulate(const double position[3], ClassifiedVolume::Content content, float color[3], float & visible) const
  {
    const bool                     isUniform = content == ClassifiedVolume::Content::Uniform;
    const ClassifiedVolume::Sample sample =
      isUniform ? m_Volume.UniformSampleAt(position) : m_Volume.SampleAt(position);
    if (sample[3] <= 0.0F)
    {
      return;
    }
    const std::array<float, 3> perVoxel = isUniform ? std::array<float, 3>{} : m_Volume.GradientAt(position);
    const float                steepness = std::min(
      4.0F * std::sqrt(perVoxel[0] * perVoxel[0] + perVoxel[1] * perVoxel[1] + perVoxel[2] * perVoxel[2]), 1.0F);
    // What is opaque is so all through; of what is transparent little more than the surface is drawn.
    const float    power2 = sample[3] * sample[3];
    const float    inside = power2 * power2;
    const float    opacity = sample[3] * (inside + (1.0F - inside) * std::min(steepness / sample[3], 1.0F));
    const float    ofSample = visible * (1.0F - std::sqrt(1.0F - std::min(opacity, 1.0F)));
    const Lighting light = this->LightAt(perVoxel);
    for (unsigned int channel = 0; channel < 3; ++channel)
    {
      color[channel] += ofSample * std::min(light.brightness * sample[channel] / sample[3] + light.highlight, 1.0F);
    }
    visible -= ofSample;
  }

  Lighting
  LightAt(const std::array<float, 3> & perVoxel) const
  {
    const Vector3 gradient = m_Space.PhysicalGradient(perVoxel);
    const double  length = gradient.GetNorm();
    if (length < 1e-4)
    {
      return Lighting::Even();
    }
    // A surface is lit from both sides.
    return Lighting::Of(static_cast<float>(std::fabs(gradient * m_ToLight) / length),
                        static_cast<float>(std::fabs(gradient * m_Halfway) / length));
  }

  ClassifiedVolume    m_Volume;
  IndexSpace          m_Space;
  const PatientView & m_View;
  Vector3             m_Step;
  Vector3             m_ToLight;
  Vector3             m_Halfway;
};

void
Annotate(Picture * picture, const PatientView & view)
{
  const int               width = static_cast<int>(picture->GetBufferedRegion().GetSize(0));
  const int               height = static_cast<int>(picture->GetBufferedRegion().GetSize(1));
  OrientationLettersStyle style;
  style.color = annotation;
  DrawOrientationLetters(picture, view.GetRight(), view.GetUp(), style);
  DrawScaleBar(picture, 12, height - 12, width / 4, view.GetMillimetresPerPixel(), annotation);
}
} // namespace

PatientView
ViewOfVolume(const itk::ImageBase<3> * volume, const VolumeRenderingOptions & options)
{
  return { volume, options.focus.value_or(volume->GetLargestPossibleRegion()), options };
}

std::optional<itk::ImageRegion<3>>
VisibleRegion(const itk::Image<float, 3> * heat, const ShapeTransferFunction & transferFunction)
{
  const auto    region = heat->GetBufferedRegion();
  itk::Index<3> first = region.GetUpperIndex();
  itk::Index<3> last = region.GetIndex();
  bool          any = false;
  for (itk::ImageRegionConstIteratorWithIndex<itk::Image<float, 3>> it(heat, region); !it.IsAtEnd(); ++it)
  {
    if (transferFunction.LineOf(it.Get()) < 0)
    {
      continue;
    }
    any = true;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      first[axis] = std::min(first[axis], it.GetIndex()[axis]);
      last[axis] = std::max(last[axis], it.GetIndex()[axis]);
    }
  }
  if (!any)
  {
    return {};
  }
  itk::ImageRegion<3> visible;
  visible.SetIndex(first);
  visible.SetUpperIndex(last);
  return visible;
}

Picture::Pointer
RenderVolume(const itk::Image<float, 3> *   heat,
             const ShapeTransferFunction &  transferFunction,
             const VolumeRenderingOptions & options)
{
  if (!heat || heat->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    throw std::invalid_argument("there is no volume to render");
  }
  const PatientView view = ViewOfVolume(heat, options);
  const RayCaster   caster(heat, transferFunction, view);
  auto              picture = NewPicture(options.width, options.height, background);
  RGBColor * const  pixels = picture->GetBufferPointer();
  itk::MultiThreaderBase::New()->ParallelizeArray(
    0,
    options.height,
    [&](itk::SizeValueType y) {
      for (unsigned int x = 0; x < options.width; ++x)
      {
        pixels[y * options.width + x] = caster.ColorOfPixel(x, static_cast<double>(y));
      }
    },
    nullptr);
  if (options.annotations)
  {
    Annotate(picture, view);
  }
  return picture;
}
} // namespace shapeton
