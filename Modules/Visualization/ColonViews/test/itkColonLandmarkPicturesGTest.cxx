#include "itkColonLandmarkPictures.h"

#include "itkLandmarkTubes.h"

#include "itkImageRegionConstIterator.h"

#include <gtest/gtest.h>

namespace
{
struct Colon
{
  SchematicColon      line{ MakeSchematicColon() };
  itk::SurfaceMesh    flat{ landmarktubes::TubeAlong(line.centreline, 15.0) };
  itk::ColonLandmarks landmarks{ itk::FindColonLandmarks(flat, line.centreline) };

  itk::ColonLandmarkParts
  Parts() const
  {
    return { &flat, &landmarks };
  }
};

/** Pixels with the hue of a colour: channels in its proportions, but for shading. */
int
PixelsLike(const itk::Picture * picture, const itk::RGBColor & color)
{
  int                                         count = 0;
  itk::ImageRegionConstIterator<itk::Picture> it(picture, picture->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    const itk::RGBColor p = it.Get();
    const double        light = (p[0] + p[1] + p[2]) / (1.0 * color[0] + color[1] + color[2]);
    bool                isLike = light > 0.4;
    for (int k = 0; k < 3; ++k)
    {
      isLike = isLike && std::abs(p[k] - light * color[k]) < 12.0;
    }
    count += isLike ? 1 : 0;
  }
  return count;
}
} // namespace

TEST(ColonLandmarkPictures, ShowEachSegmentInItsColor)
{
  const Colon                 colon;
  const itk::Picture::Pointer picture = itk::DrawColonLandmarks(colon.Parts(), itk::PatientSide::Anterior);
  for (int segment = 1; segment <= 6; ++segment)
  {
    EXPECT_GT(PixelsLike(picture, itk::ColorOfSegment(segment)), 300) << itk::NameOfSegment(segment);
  }
}

TEST(ColonLandmarkPictures, OfTheFlatColonShowTaeniae)
{
  Colon            colon;
  itk::ColonTaenia taenia;
  for (double u = 5.0; u < 1000.0; u += 5.0)
  {
    taenia.uv.emplace_back(u, 40.0);
    taenia.points.emplace_back(Eigen::Vector3d::Zero());
    taenia.arcLength.push_back(u);
    taenia.confidence.push_back(1.0);
  }
  const int before = PixelsLike(itk::DrawFlatLandmarks(colon.Parts()), itk::ColorOfTaenia(2));
  colon.landmarks.taeniae.taeniae = { itk::ColonTaenia{}, taenia, itk::ColonTaenia{} };
  const int after = PixelsLike(itk::DrawFlatLandmarks(colon.Parts()), itk::ColorOfTaenia(2));
  EXPECT_GT(after, before + 1000);
}
