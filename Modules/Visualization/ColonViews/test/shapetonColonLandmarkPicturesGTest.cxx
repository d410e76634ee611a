#include "shapetonColonLandmarkPictures.h"

#include "shapetonLandmarkTubes.h"

#include "itkImageRegionConstIterator.h"

#include <gtest/gtest.h>

namespace
{
struct Colon
{
  SchematicColon           line{ MakeSchematicColon() };
  shapeton::FlatColon      flat{ landmarktubes::TubeAlong(line.centerline, 15.0) };
  shapeton::ColonLandmarks landmarks{ shapeton::FindColonLandmarks(flat, line.centerline) };

  shapeton::ColonLandmarkParts
  Parts() const
  {
    return { &flat, &landmarks };
  }
};

/** Number of pixels with the hue of a color, independent of shading. */
int
PixelsLike(const shapeton::Picture * picture, const shapeton::RGBColor & color)
{
  int                                              count = 0;
  itk::ImageRegionConstIterator<shapeton::Picture> it(picture, picture->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    const shapeton::RGBColor p = it.Get();
    const double             light = (p[0] + p[1] + p[2]) / (1.0 * color[0] + color[1] + color[2]);
    bool                     isLike = light > 0.4;
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
  const Colon                      colon;
  const shapeton::Picture::Pointer picture =
    shapeton::DrawColonLandmarks(colon.Parts(), shapeton::PatientSide::Anterior);
  for (int segment = 1; segment <= 6; ++segment)
  {
    EXPECT_GT(PixelsLike(picture, shapeton::ColorOfSegment(segment)), 300) << shapeton::NameOfSegment(segment);
  }
}

TEST(ColonLandmarkPictures, OfTheFlatColonShowTaeniae)
{
  Colon                 colon;
  shapeton::ColonTaenia taenia;
  for (double u = 5.0; u < 1000.0; u += 5.0)
  {
    taenia.uv.emplace_back(u, 40.0);
    taenia.points.emplace_back(Eigen::Vector3d::Zero());
    taenia.arcLength.push_back(u);
    taenia.confidence.push_back(1.0);
  }
  const int before = PixelsLike(shapeton::DrawFlatLandmarks(colon.Parts()), shapeton::ColorOfTaenia(2));
  colon.landmarks.taeniae.taeniae = { shapeton::ColonTaenia{}, taenia, shapeton::ColonTaenia{} };
  const int after = PixelsLike(shapeton::DrawFlatLandmarks(colon.Parts()), shapeton::ColorOfTaenia(2));
  EXPECT_GT(after, before + 1000);
}
