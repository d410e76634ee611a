#ifndef itkColonPictures_h
#define itkColonPictures_h

#include "itkElectronicCleansing.h"

#include "itkImageFileWriter.h"
#include "itkPNGImageIO.h"
#include "itkRGBPixel.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace itk
{
using ColonPicture = Image<RGBPixel<unsigned char>, 2>;

/** One slice across index axis `axis`: left the CT, middle the CT with gas outlined red and fluid green, right the
 * cleansed CT with the half-level of the occupancy in yellow. Window -1100..1000 HU. */
inline ColonPicture::Pointer
ColonSlice(const Image<float, 3> * ct,
           const ColonLumen &      lumen,
           const CleansedColon &   cleansed,
           int                     axis,
           int                     slice,
           int                     scale)
{
  const int  u = axis == 0 ? 1 : 0;
  const int  w = axis == 2 ? 1 : 2;
  const auto size = ct->GetLargestPossibleRegion().GetSize();
  const int  nu = static_cast<int>(size[u]) * scale;
  const int  nw = static_cast<int>(size[w]) * scale;
  auto       picture = ColonPicture::New();
  picture->SetRegions(ColonPicture::SizeType{ { static_cast<SizeValueType>(3 * nu), static_cast<SizeValueType>(nw) } });
  picture->Allocate();
  Image<float, 3>::PointType corner = cleansed.occupancy->GetOrigin();
  const auto                 shift = ct->TransformPhysicalPointToIndex(corner);
  const auto                 occupancyAt = [&](Index<3> i) {
    for (int a = 0; a < 3; ++a)
    {
      i[a] -= shift[a];
    }
    return cleansed.occupancy->GetLargestPossibleRegion().IsInside(i) ? cleansed.occupancy->GetPixel(i) : 0.0F;
  };
  const auto grey = [](float v) {
    return static_cast<unsigned char>(std::clamp((v + 1100.0F) / 2100.0F * 255.0F, 0.0F, 255.0F));
  };
  for (int y = 0; y < nw; ++y)
  {
    for (int x = 0; x < nu; ++x)
    {
      Index<3> i;
      i[axis] = slice;
      i[u] = x / scale;
      i[w] = y / scale;
      Index<3> right = i;
      right[u] = std::min<IndexValueType>(i[u] + 1, size[u] - 1);
      Index<3> down = i;
      down[w] = std::min<IndexValueType>(i[w] + 1, size[w] - 1);
      const auto v = grey(ct->GetPixel(i));
      const auto c = grey(cleansed.ct->GetPixel(i));
      const auto label = lumen.labels->GetPixel(i);
      const bool isEdge = label != lumen.labels->GetPixel(right) || label != lumen.labels->GetPixel(down);
      const bool isHalf =
        (occupancyAt(i) > 0.5F) != (occupancyAt(right) > 0.5F) || (occupancyAt(i) > 0.5F) != (occupancyAt(down) > 0.5F);
      RGBPixel<unsigned char> p;
      const auto              set = [&](int column, unsigned char r, unsigned char g, unsigned char b) {
        p[0] = r;
        p[1] = g;
        p[2] = b;
        picture->SetPixel(Index<2>{ { column * nu + x, y } }, p);
      };
      set(0, v, v, v);
      isEdge ? set(1, label == 1 ? 255 : 60, label == 2 ? 255 : 60, 60)
             : set(1,
                   std::min(255, v + (label == 1 ? 60 : 0)),
                   std::min(255, v + (label == 2 ? 40 : 0)),
                   label == 2 ? v / 2 : v);
      isHalf ? set(2, 255, 230, 0) : set(2, c, c, c);
    }
  }
  return picture;
}

/** Slices at a quarter, half and three quarters of each axis: PREFIX-<axis>-<slice>.png. */
inline void
WriteColonPictures(const Image<float, 3> * ct,
                   const ColonLumen &      lumen,
                   const CleansedColon &   cleansed,
                   const std::string &     prefix)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const int n = static_cast<int>(ct->GetLargestPossibleRegion().GetSize(axis));
    for (const int slice : { n / 4, n / 2, 3 * n / 4 })
    {
      const int scale = n <= 150 ? 4 : 2;
      auto      writer = ImageFileWriter<ColonPicture>::New();
      writer->SetImageIO(PNGImageIO::New());
      writer->SetInput(ColonSlice(ct, lumen, cleansed, axis, slice, scale));
      writer->SetFileName(prefix + "-" + std::string(1, "xyz"[axis]) + std::to_string(slice) + ".png");
      writer->Update();
    }
  }
}
} // namespace itk

#endif
