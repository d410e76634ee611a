#include "shapetonHaustralFoldPicture.h"

#include "shapetonFoldTubes.h"

#include <gtest/gtest.h>

namespace
{
/** Number of pixels of approximately this color. */
int
Count(const shapeton::Picture * picture, int red, int green, int blue)
{
  int        count = 0;
  const auto pixels = picture->GetLargestPossibleRegion().GetNumberOfPixels();
  for (itk::SizeValueType i = 0; i < pixels; ++i)
  {
    const shapeton::RGBColor & color = picture->GetBufferPointer()[i];
    count += std::abs(color[0] - red) < 12 && std::abs(color[1] - green) < 12 && std::abs(color[2] - blue) < 12;
  }
  return count;
}
} // namespace

TEST(HaustralFoldPicture, ShowsOutlinesEndsAndTaeniae)
{
  const shapeton::FlatColon flat(foldtubes::MakeTube({ { 40.0, 2.0, 18.0, 6.0 }, { 100.0, 4.0, 20.0, 8.0 } }));
  shapeton::HaustralFolds   folds = shapeton::FindHaustralFolds(flat);
  ASSERT_EQ(folds.folds.size(), 2u);
  const shapeton::HaustralFoldPictureContent content{ &flat, &folds, nullptr, {} };
  const auto                                 picture = shapeton::DrawHaustralFolds(content, 0.5, "Folds");
  const int                                  green = Count(picture, 40, 220, 70);
  EXPECT_GT(green, 4 * 8);                    // four ends
  EXPECT_GT(Count(picture, 40, 90, 255), 60); // the outline of the second fold
  EXPECT_LT(Count(picture, 255, 214, 0), 5);  // no taeniae
  shapeton::CurveSet taenia;
  taenia.V.resize(2, 3);
  taenia.V.row(0) = flattubes::OnCylinder(20.0, 5.0, -1.0);
  taenia.V.row(1) = flattubes::OnCylinder(20.0, 150.0, -1.0);
  taenia.curves = { { 0, 1 } };
  const auto withTaenia = shapeton::DrawHaustralFolds({ &flat, &folds, &taenia, {} }, 0.5, "Folds");
  EXPECT_GT(Count(withTaenia, 255, 214, 0), 100);
  folds.folds.clear();
  folds.labels->FillBuffer(0);
  EXPECT_LT(Count(shapeton::DrawHaustralFolds(content, 0.5, "Folds"), 40, 220, 70), 5);
}
