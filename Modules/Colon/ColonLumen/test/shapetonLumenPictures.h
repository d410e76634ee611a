#ifndef shapetonLumenPictures_h
#define shapetonLumenPictures_h

#include "shapetonElectronicCleansing.h"

#include "itkImageFileWriter.h"
#include "itkPNGImageIO.h"
#include "itkRGBPixel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace shapeton
{
using ColonPicture = itk::Image<itk::RGBPixel<unsigned char>, 2>;

/** Draws slices of a CT next to the segmentation. Window -1100..1000 HU. */
class ColonSlices
{
public:
  ColonSlices(const itk::Image<float, 3> * ct,
              const ColonLumen &           lumen,
              const CleansedColon &        cleansed,
              const itk::Image<float, 3> * truth)
    : m_CT(ct)
    , m_Lumen(lumen)
    , m_Cleansed(cleansed)
    , m_Truth(truth)
    , m_Shift(ct->TransformPhysicalPointToIndex(cleansed.occupancy->GetOrigin()))
  {}

  /** Part of one slice perpendicular to index axis `axis`. From left to right: the CT; the CT with outlines of gas
   * (red) and fluid (green); the CT with the outline of the truth, if given; the cleansed CT with the 0.5 level of the
   * occupancy. */
  ColonPicture::Pointer
  Draw(int axis, const itk::Index<3> & middle, int reach, int scale) const
  {
    const int     u = axis == 0 ? 1 : 0;
    const int     w = axis == 2 ? 1 : 2;
    itk::Index<3> low = middle;
    itk::Index<3> high = middle;
    for (const int a : { u, w })
    {
      const int last = static_cast<int>(m_CT->GetLargestPossibleRegion().GetSize(a)) - 2;
      low[a] = std::max<itk::IndexValueType>(0, middle[a] - reach);
      high[a] = std::min<itk::IndexValueType>(last, middle[a] + reach);
    }
    const auto nu = (high[u] - low[u] + 1) * scale;
    const auto nw = (high[w] - low[w] + 1) * scale;
    auto       picture = ColonPicture::New();
    picture->SetRegions(
      ColonPicture::SizeType{ { static_cast<itk::SizeValueType>(4 * nu), static_cast<itk::SizeValueType>(nw) } });
    picture->Allocate(true);
    for (itk::IndexValueType y = 0; y < nw; ++y)
    {
      for (itk::IndexValueType x = 0; x < nu; ++x)
      {
        itk::Index<3> i = middle;
        i[u] = low[u] + x / scale;
        i[w] = low[w] + y / scale;
        this->DrawVoxel(*picture, i, u, w, { { x, y } }, nu);
      }
    }
    return picture;
  }

private:
  using Color = std::array<int, 3>;

  static void
  Set(ColonPicture & picture, itk::Index<2> at, itk::IndexValueType shift, const Color & c)
  {
    itk::RGBPixel<unsigned char> p;
    for (int a = 0; a < 3; ++a)
    {
      p[a] = static_cast<unsigned char>(std::clamp(c[a], 0, 255));
    }
    at[0] += shift;
    picture.SetPixel(at, p);
  }

  bool
  IsIn(itk::Index<3> i) const
  {
    for (int a = 0; a < 3; ++a)
    {
      i[a] -= m_Shift[a];
    }
    return m_Cleansed.occupancy->GetLargestPossibleRegion().IsInside(i) && m_Cleansed.occupancy->GetPixel(i) > 0.5F;
  }

  void
  DrawVoxel(ColonPicture &        picture,
            const itk::Index<3> & i,
            int                   u,
            int                   w,
            const itk::Index<2> & at,
            itk::IndexValueType   width) const
  {
    const auto    gray = [](float v) { return static_cast<int>((v + 1100.0F) / 2100.0F * 255.0F); };
    itk::Index<3> right = i;
    itk::Index<3> down = i;
    ++right[u];
    ++down[w];
    const int  v = gray(m_CT->GetPixel(i));
    const int  c = gray(m_Cleansed.ct->GetPixel(i));
    const auto label = [this](const itk::Index<3> & q) { return m_Lumen.labels->GetPixel(q); };
    Set(picture, at, 0, { v, v, v });
    const bool isEdge = label(i) != label(right) || label(i) != label(down);
    Set(picture,
        at,
        width,
        isEdge ? Color{ label(i) == 1 ? 255 : 60, label(i) == 2 ? 255 : 60, 60 }
               : Color{ v + (label(i) == 1 ? 60 : 0), v, label(i) == 2 ? v / 2 : v });
    const auto truth = [this](const itk::Index<3> & q) { return m_Truth ? m_Truth->GetPixel(q) : 0.0F; };
    Set(picture,
        at,
        2 * width,
        truth(i) != truth(right) || truth(i) != truth(down) ? Color{ 60, 255, 255 } : Color{ v, v, v });
    Set(picture,
        at,
        3 * width,
        IsIn(i) != IsIn(right) || IsIn(i) != IsIn(down) ? Color{ 255, 230, 0 } : Color{ c, c, c });
  }

  const itk::Image<float, 3> * m_CT;
  const ColonLumen &           m_Lumen;
  const CleansedColon &        m_Cleansed;
  const itk::Image<float, 3> * m_Truth;
  itk::Index<3>                m_Shift;
};

inline void
WriteColonPicture(ColonPicture * picture, const std::string & path)
{
  auto writer = itk::ImageFileWriter<ColonPicture>::New();
  writer->SetImageIO(itk::PNGImageIO::New());
  writer->SetInput(picture);
  writer->SetFileName(path);
  writer->Update();
}
} // namespace shapeton

#endif
