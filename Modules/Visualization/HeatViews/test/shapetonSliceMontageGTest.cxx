#include "shapetonSliceChoice.h"
#include "shapetonSliceMontage.h"
#include "shapetonColorMap.h"
#include "shapetonPictureTestUtilities.h"

#include "shapetonColorMap.h"

#include <array>
#include <stdexcept>

namespace
{
using ImageType = itk::Image<float, 3>;

/** A grid of 45 x 45 x 45 mm centered at 0, with the given spacing along the patient's axes, stored with permuted and
 * reversed axes: index axis i runs along the patient's axis order[i]. */
ImageType::Pointer
MakeGrid(const std::array<double, 3> &       spacing,
         const std::array<unsigned int, 3> & order,
         const std::array<bool, 3> &         isReversed)
{
  auto                     image = ImageType::New();
  ImageType::DirectionType direction;
  direction.Fill(0.0);
  ImageType::SizeType    size;
  ImageType::SpacingType steps;
  ImageType::PointType   origin;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const unsigned int patient = order[axis];
    steps[axis] = spacing[patient];
    size[axis] = static_cast<itk::SizeValueType>(45.0 / spacing[patient] + 0.5);
    direction[patient][axis] = isReversed[patient] ? -1.0 : 1.0;
    origin[patient] = (isReversed[patient] ? 0.5 : -0.5) * (size[axis] - 1.0) * spacing[patient];
  }
  image->SetRegions(size);
  image->SetSpacing(steps);
  image->SetDirection(direction);
  image->SetOrigin(origin);
  image->Allocate();
  image->FillBuffer(0.0F);
  return image;
}

template <typename TFunction>
void
Fill(ImageType * image, const TFunction & valueAt)
{
  for (itk::SizeValueType i = 0; i < image->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    ImageType::PointType point;
    image->TransformIndexToPhysicalPoint(image->ComputeIndex(static_cast<itk::OffsetValueType>(i)), point);
    image->GetBufferPointer()[i] = static_cast<float>(valueAt(point));
  }
}

double
GrayAt(const ImageType::PointType & point)
{
  return 3.0 * point[0] + 2.0 * point[1] + point[2];
}

/** Heat 0.5 in a block to the left of, behind and above the center. */
double
HeatAt(const ImageType::PointType & point)
{
  return point[0] > 2.0 && point[0] < 18.0 && point[1] > 2.0 && point[1] < 18.0 && point[2] > 2.0 && point[2] < 18.0
           ? 0.5
           : 0.0;
}

const auto block = shapeton::ShapeTransferFunction::Parse("0.4-0.6:magenta:1");
const auto coloring = shapeton::ColorByLine(block);

shapeton::SliceMontageOptions
OpaqueOptions(const itk::Index<3> & cut)
{
  shapeton::SliceMontageOptions options;
  options.opacity = 1.0;
  options.cut = cut;
  return options;
}

/** Left, top, right, bottom of the colored pixels between two columns. */
std::array<int, 4>
ColoredBox(const shapeton::Picture * picture, int firstColumn, int endColumn)
{
  std::array<int, 4> box{ { 1 << 20, 1 << 20, -1, -1 } };
  for (int y = 0; y < static_cast<int>(picture->GetBufferedRegion().GetSize(1)); ++y)
  {
    for (int x = firstColumn; x < endColumn; ++x)
    {
      if (shapeton::At(picture, x, y) == shapeton::MakeColor(255, 0, 255))
      {
        box = { { std::min(box[0], x), std::min(box[1], y), std::max(box[2], x), std::max(box[3], y) } };
      }
    }
  }
  return box;
}
} // namespace

TEST(SliceMontage, SlicesHaveTheRightShapeAndSide)
{
  const auto gray = MakeGrid({ { 1.0, 1.0, 3.0 } }, { { 0, 1, 2 } }, { { false, false, false } });
  auto       heat = MakeGrid({ { 1.0, 1.0, 3.0 } }, { { 0, 1, 2 } }, { { false, false, false } });
  Fill(heat, HeatAt);
  const auto picture = shapeton::DrawSliceMontage(gray, heat, coloring, OpaqueOptions({ { 32, 32, 10 } }));
  // Three panels of 45 mm side by side with margins of 16 and gaps of 14: 380 pixels each.
  constexpr int panel = 380;
  for (int i = 0; i < 3; ++i)
  {
    const int  left = 16 + i * (panel + 14);
    const auto box = ColoredBox(picture, left, left + panel);
    const int  width = box[2] - box[0] + 1;
    const int  height = box[3] - box[1] + 1;
    // Voxels at 3, 4, ... 17 mm, slices at 3, 6, ... 15 mm: both 15 mm long.
    EXPECT_NEAR(width * 45.0 / panel, 15.0, 0.4) << i;
    EXPECT_NEAR(height * 45.0 / panel, 15.0, 0.4) << i;
    // The block is left of the patient's center (right half of axial and coronal) and posterior (right half of
    // sagittal).
    EXPECT_GT(box[0], left + panel / 2) << i;
  }
  const int top = static_cast<int>(picture->GetBufferedRegion().GetSize(1)) - panel - 16 - 24;
  // Posterior is at the bottom of the axial slice; the head is on top in the other two.
  EXPECT_GT(ColoredBox(picture, 16, 396)[1], top + panel / 2 - 1);
  EXPECT_LT(ColoredBox(picture, 410, 790)[3], top + panel / 2);
  EXPECT_LT(ColoredBox(picture, 804, 1184)[3], top + panel / 2);
}

TEST(SliceMontage, TheStorageOfTheVolumeDoesNotMatter)
{
  const std::array<double, 3> spacing{ { 1.0, 1.8, 3.0 } }; // 45, 25 and 15 voxels: the center is a voxel
  const auto draw = [&](const std::array<unsigned int, 3> & order, const std::array<bool, 3> & isReversed) {
    const auto gray = MakeGrid(spacing, order, isReversed);
    const auto heat = MakeGrid(spacing, order, isReversed);
    Fill(gray, GrayAt);
    Fill(heat, HeatAt);
    itk::Index<3> middle;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      middle[axis] = static_cast<itk::IndexValueType>(gray->GetBufferedRegion().GetSize(axis) / 2);
    }
    shapeton::SliceMontageOptions options = OpaqueOptions(middle);
    options.window = { -150.0, 150.0 };
    return shapeton::DrawSliceMontage(gray, heat, coloring, options);
  };
  const auto reference = draw({ { 0, 1, 2 } }, { { false, false, false } });
  EXPECT_LE(shapeton::GreatestDifference(reference, draw({ { 0, 1, 2 } }, { { true, false, false } })), 1);
  EXPECT_LE(shapeton::GreatestDifference(reference, draw({ { 0, 1, 2 } }, { { true, true, true } })), 1);
  EXPECT_LE(shapeton::GreatestDifference(reference, draw({ { 2, 0, 1 } }, { { false, true, false } })), 1);
  EXPECT_LE(shapeton::GreatestDifference(reference, draw({ { 1, 0, 2 } }, { { false, false, true } })), 1);
}

TEST(SliceMontage, ColoringsAgreeWithTheirSource)
{
  shapeton::HeatHistogram histogram({ 0 });
  histogram.AddToRow(0, std::vector<float>(10, 0.25F).data(), 10);
  histogram.AddToRow(0, std::vector<float>(10, 0.75F).data(), 10);
  const shapeton::HeatAxis axis(histogram);
  EXPECT_FALSE(shapeton::ColorByHeat(axis)(0.0F));
  EXPECT_EQ(*shapeton::ColorByHeat(axis)(0.25F), axis.ColorOf(0.25));
}

TEST(SliceMontage, TheLegendNamesTheClassesInTheirColors)
{
  std::vector<shapeton::HeatClass> classes(4);
  for (unsigned int label = 0; label < 4; ++label)
  {
    classes[label].label = label;
    classes[label].lowerHeat = 0.25 * label;
    classes[label].upperHeat = 0.25 * label + 0.25;
  }
  classes[1].isSurroundings = true;
  classes[3].coherence = 0.1;
  const auto legend = shapeton::LegendOf(classes);
  ASSERT_EQ(legend.size(), 3U);
  EXPECT_EQ(legend[0].text, "class 1: surroundings");
  EXPECT_EQ(legend[0].color, shapeton::MakeColor(128, 128, 128));
  EXPECT_EQ(legend[1].text, "class 2: 0.5 to 0.75");
  EXPECT_EQ(legend[1].color, shapeton::ClassColor(2));
  EXPECT_EQ(legend[2].text, "class 3: incoherent");
  EXPECT_EQ(legend[2].color, shapeton::MakeColor(255, 255, 255)) << "transparent";
}

TEST(SliceMontage, RefusesWhatCannotBeDrawn)
{
  const auto gray = MakeGrid({ { 1.0, 1.0, 1.0 } }, { { 0, 1, 2 } }, { { false, false, false } });
  const auto other = MakeGrid({ { 1.0, 1.0, 3.0 } }, { { 0, 1, 2 } }, { { false, false, false } });
  EXPECT_THROW(shapeton::DrawSliceMontage(gray, other, coloring), std::invalid_argument);
  EXPECT_THROW(shapeton::DrawSliceMontage(gray, gray, coloring, OpaqueOptions({ { 0, 0, 45 } })),
               std::invalid_argument);
  shapeton::SliceMontageOptions options;
  options.width = 500;
  EXPECT_THROW(shapeton::DrawSliceMontage(gray, gray, coloring, options), std::invalid_argument);
}

TEST(SliceMontage, Baseline)
{
  const auto gray = MakeGrid({ { 1.0, 1.8, 3.0 } }, { { 0, 1, 2 } }, { { true, false, false } });
  const auto heat = MakeGrid({ { 1.0, 1.8, 3.0 } }, { { 0, 1, 2 } }, { { true, false, false } });
  Fill(gray, GrayAt);
  Fill(heat, HeatAt);
  shapeton::SliceMontageOptions options;
  options.title = "Slices";
  options.width = 800;
  options.cut = shapeton::CutThroughParts(heat, block);
  options.legend = { { shapeton::MakeColor(255, 0, 255), "block" } };
  shapeton::ExpectBaseline(shapeton::DrawSliceMontage(gray, heat, coloring, options), "shapetonSliceMontage.png");
}
