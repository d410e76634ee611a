#include "shapetonVolumeRendering.h"

#include "shapetonClassifiedVolume.h"
#include "shapetonDeviceRays.h"
#include "shapetonLighting.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "shapetonParallelFor.h"
#include "shapetonPictureAnnotation.h"

#include <algorithm>
#include <stdexcept>

namespace shapeton
{
namespace
{
// Dark background, because every color of the heat map is light.
const RGBColor background = MakeColor(18, 19, 25);
const RGBColor annotation = MakeColor(214, 218, 226);

using Vector3 = itk::Vector<double, 3>;

void
CopyVector(const double * from, double to[3])
{
  std::copy(from, from + 3, to);
}

/** Sets up the geometry of a picture's rays in the volume. */
RayView
MakeRayView(const itk::ImageBase<3> * volume, const PatientView & view)
{
  RayView                              rays{};
  const itk::Matrix<double, 3, 3>      inverse(volume->GetDirection().GetInverse());
  const itk::ImageBase<3>::SpacingType spacing = volume->GetSpacing();
  itk::ImageBase<3>::PointType         first;
  volume->TransformIndexToPhysicalPoint(volume->GetLargestPossibleRegion().GetIndex(), first);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    CopyVector(inverse[axis], rays.inverse[axis]);
  }
  CopyVector(spacing.GetDataPointer(), rays.spacing);
  CopyVector(first.GetDataPointer(), rays.first);
  CopyVector(view.GetCenter().GetDataPointer(), rays.center);
  CopyVector(view.GetRight().GetDataPointer(), rays.right);
  CopyVector(view.GetUp().GetDataPointer(), rays.up);
  rays.millimetersPerPixel = view.GetMillimetersPerPixel();
  rays.middleX = view.GetMiddleX();
  rays.middleY = view.GetMiddleY();
  // Two samples per smallest spacing, so the transmittance of a sample is the square root of a voxel's.
  const Vector3 step = view.GetForward() * (0.5 * std::min({ spacing[0], spacing[1], spacing[2] }));
  RayArithmetic::ToIndexVector(rays, step.GetDataPointer(), rays.step);
  const Vector3 toLight = Lighting::DirectionToLight(view.GetRight(), view.GetUp(), view.GetForward());
  Vector3       halfway = toLight - view.GetForward();
  halfway.Normalize();
  CopyVector(toLight.GetDataPointer(), rays.toLight);
  CopyVector(halfway.GetDataPointer(), rays.halfway);
  std::copy(background.Begin(), background.End(), rays.background);
  return rays;
}

void
Annotate(Picture * picture, const PatientView & view)
{
  constexpr int           edge = 12;
  const int               width = static_cast<int>(picture->GetBufferedRegion().GetSize(0));
  const int               height = static_cast<int>(picture->GetBufferedRegion().GetSize(1));
  OrientationLettersStyle style;
  style.color = annotation;
  DrawOrientationLetters(picture, view.GetRight(), view.GetUp(), style);
  DrawScaleBar(picture, edge, height - edge, width / 4, view.GetMillimetersPerPixel(), annotation);
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

struct VolumeRenderer::Impl
{
  explicit Impl(const itk::Image<float, 3> * image, const ShapeTransferFunction & transferFunction)
    : heat(image), volume(image, transferFunction)
  {}

  void
  RenderOnCpu(const RayView & view, Picture * picture) const
  {
    const auto            width = picture->GetBufferedRegion().GetSize(0);
    const auto            height = picture->GetBufferedRegion().GetSize(1);
    const RayVolume       rays = volume.GetRayVolume();
    unsigned char * const pixels = picture->GetBufferPointer()->GetDataPointer();
    ParallelFor(height, [&](std::size_t y) {
      for (std::size_t x = 0; x < width; ++x)
      {
        RayArithmetic::ColorOfPixel(
          rays, view, static_cast<double>(x), static_cast<double>(y), pixels + 3 * (y * width + x));
      }
    });
  }

  itk::Image<float, 3>::ConstPointer heat;
  ClassifiedVolume                   volume;
  DeviceUse                          use;
  std::unique_ptr<DeviceRays>        device; ///< null on the CPU
};

VolumeRenderer::VolumeRenderer(const itk::Image<float, 3> *  heat,
                               const ShapeTransferFunction & transferFunction,
                               Device                        device)
{
  if (!heat || heat->GetBufferedRegion().GetNumberOfPixels() == 0)
  {
    throw std::invalid_argument("the volume to render is empty");
  }
  constexpr std::size_t bytesOfVoxel = 4; // lines, opacity and content
  constexpr std::size_t more = std::size_t{ 1 } << 26;
  const DeviceUse       use = ChooseDevice(device, heat->GetBufferedRegion().GetNumberOfPixels() * bytesOfVoxel + more);
  m_Impl = std::make_unique<Impl>(heat, transferFunction);
  m_Impl->use = use;
  if (use.gpu)
  {
    const auto make = reinterpret_cast<MakeDeviceRaysFunction *>(FindDeviceFunction("ShapetonMakeRays"));
    m_Impl->device.reset(make(m_Impl->volume.GetRayVolume(), m_Impl->volume.GetNumberOfSamples()));
  }
}

VolumeRenderer::~VolumeRenderer() = default;

const DeviceUse &
VolumeRenderer::GetDeviceUse() const
{
  return m_Impl->use;
}

Picture::Pointer
VolumeRenderer::Render(const VolumeRenderingOptions & options) const
{
  static_assert(sizeof(RGBColor) == 3, "pixels are written as bytes");
  const PatientView view = ViewOfVolume(m_Impl->heat, options);
  const RayView     rays = MakeRayView(m_Impl->heat, view);
  auto              picture = NewPicture(options.width, options.height, background);
  if (m_Impl->device)
  {
    m_Impl->device->Render(rays, options.width, options.height, picture->GetBufferPointer()->GetDataPointer());
  }
  else
  {
    m_Impl->RenderOnCpu(rays, picture);
  }
  if (options.annotations)
  {
    Annotate(picture, view);
  }
  return picture;
}

Picture::Pointer
RenderVolume(const itk::Image<float, 3> *   heat,
             const ShapeTransferFunction &  transferFunction,
             const VolumeRenderingOptions & options)
{
  return VolumeRenderer(heat, transferFunction, Device::Cpu).Render(options);
}
} // namespace shapeton
