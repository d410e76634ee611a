#ifndef shapetonSessionTestVolume_h
#define shapetonSessionTestVolume_h

#include "shapetonLiveSession.h"
#include "shapetonTestFolder.h"
#include "shapetonTestImages.h"
#include "shapetonVolumeReader.h"
#include "shapetonVolumeWriter.h"

#include <cstdint>
#include <string>

namespace basetest
{
/** A folder with the volume input.nrrd: a ball of 100 and a box of 60 in 0, with noise of 3 intensities, on an oblique
 * grid of 24 x 20 x 22 voxels of 1 x 1 x 1.5 mm, or `scale` times as many along each axis. */
class SessionInput
{
public:
  explicit SessionInput(int scale = 1)
  {
    using ImageType = itk::Image<float, 3>;
    constexpr double angle = 0.2;
    const auto       image = NewImage<ImageType>({ { 24U * scale, 20U * scale, 22U * scale } },
                                           { { 1.0, 1.0, 1.5 } },
                                           { { -5.0, 3.0, 10.0 } },
                                           Rotation(2, angle));
    ForVoxels(image, [&](const itk::Index<3> & index, const itk::Point<double, 3> &) {
      const itk::Index<3> i = { { index[0] / scale, index[1] / scale, index[2] / scale } };
      const bool          isBall = std::hypot(i[0] - 7.0, i[1] - 9.0, i[2] - 10.0) < 4.5;
      const bool          isBox = i[0] >= 15 && i[0] < 21 && i[1] >= 6 && i[1] < 14 && i[2] >= 7 && i[2] < 16;
      const auto          noise = static_cast<float>((index[0] * 7 + index[1] * 13 + index[2] * 29) % 4);
      image->SetPixel(index, (isBall ? 100.0F : isBox ? 60.0F : 0.0F) + noise);
    });
    shapeton::WriteVolume(image.GetPointer(), this->Path());
  }

  std::string
  Path() const
  {
    return m_Folder / "input.nrrd";
  }

  const Folder &
  GetFolder() const
  {
    return m_Folder;
  }

  shapeton::LiveSessionSettings
  Settings() const
  {
    shapeton::LiveSessionSettings settings;
    settings.input = this->Path();
    settings.folder = m_Folder / "";
    settings.walk.shapetons = 2000;
    settings.walk.distance = 0.05;
    settings.walk.timeSteps = 60;
    settings.walk.p = 4.0;
    settings.walk.device = shapeton::Device::Cpu;
    return settings;
  }

  shapeton::Volume
  Volume() const
  {
    return shapeton::ReadVolume(this->Path());
  }

  /** The point of a voxel. */
  itk::Point<double, 3>
  PointOf(const itk::Index<3> & index) const
  {
    itk::Point<double, 3> point;
    this->Volume().image->TransformIndexToPhysicalPoint(index, point);
    return point;
  }

private:
  Folder m_Folder;
};
} // namespace basetest

#endif
