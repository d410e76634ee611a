#include "shapetonPicture.h"
#include "shapetonPictureTestUtilities.h"

#include "shapetonExceptions.h"

#include <csignal>
#include <stdexcept>

#include <sys/resource.h>

namespace
{
const shapeton::RGBColor white = shapeton::MakeColor(255, 255, 255);
const shapeton::RGBColor black = shapeton::MakeColor(0, 0, 0);
const shapeton::RGBColor red = shapeton::MakeColor(200, 10, 20);

/** Bounding box of all pixels that are not white: left, top, right, bottom; right < left if there are none. */
struct Ink
{
  int left{ 1 << 20 };
  int top{ 1 << 20 };
  int right{ -1 };
  int bottom{ -1 };
};

Ink
InkOf(const shapeton::Picture * picture)
{
  Ink        ink;
  const auto size = picture->GetBufferedRegion().GetSize();
  for (int y = 0; y < static_cast<int>(size[1]); ++y)
  {
    for (int x = 0; x < static_cast<int>(size[0]); ++x)
    {
      if (shapeton::At(picture, x, y) != white)
      {
        ink = { std::min(ink.left, x), std::min(ink.top, y), std::max(ink.right, x), std::max(ink.bottom, y) };
      }
    }
  }
  return ink;
}
} // namespace

TEST(Picture, PngKeepsEveryPixel)
{
  auto         picture = shapeton::NewPicture(37, 23, white);
  unsigned int state = 1;
  for (itk::SizeValueType i = 0; i < 37 * 23; ++i)
  {
    for (unsigned int channel = 0; channel < 3; ++channel)
    {
      state = state * 1664525U + 1013904223U;
      picture->GetBufferPointer()[i][channel] = static_cast<unsigned char>(state >> 24);
    }
  }
  const std::string folder = shapeton::TemporaryFolder("png");
  shapeton::WritePng(picture, folder + "/a.png");
  shapeton::WritePng(picture, folder + "/no-extension");
  EXPECT_EQ(shapeton::GreatestDifference(picture, shapeton::ReadPng(folder + "/a.png")), 0);
  EXPECT_EQ(shapeton::ReadFileBytes(folder + "/a.png"), shapeton::ReadFileBytes(folder + "/no-extension"));
}

TEST(Picture, AFullDiskIsAnOutputErrorAtEverySize)
{
  const auto picture = shapeton::NewPicture(300, 200, shapeton::MakeColor(1, 2, 3));
  for (unsigned int i = 0; i < 300 * 200; ++i) // incompressible
  {
    picture->GetBufferPointer()[i] = shapeton::MakeColor(i * 7919 >> 3, i * 104729 >> 5, i * 1299709 >> 7);
  }
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const rlim_t bytes : { 1, 100, 2000, 5000, 20000 })
  {
    rlimit small = before;
    small.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(shapeton::WritePng(picture, SHAPETON_TEST_TEMPORARY_DIR "/full.png"), shapeton::OutputError) << bytes;
    setrlimit(RLIMIT_FSIZE, &before);
  }
  std::signal(SIGXFSZ, handler);
}

TEST(Picture, FailuresToWriteAreOutputErrors)
{
  const auto picture = shapeton::NewPicture(8, 8, white);
  EXPECT_THROW(shapeton::WritePng(picture, "/nonexistent-folder/a.png"), shapeton::OutputError);
  if (std::filesystem::exists("/dev/full"))
  {
    EXPECT_THROW(shapeton::WritePng(picture, "/dev/full"), shapeton::OutputError);
  }
  EXPECT_THROW(shapeton::NewPicture(0, 5, white), std::invalid_argument);
}

TEST(Picture, RectanglesCoverTheirPixelsAndAreClipped)
{
  auto picture = shapeton::NewPicture(10, 10, white);
  shapeton::FillRectangle(picture, 2, 3, 4, 2, black);
  const Ink ink = InkOf(picture);
  EXPECT_EQ(ink.left, 2);
  EXPECT_EQ(ink.right, 5);
  EXPECT_EQ(ink.top, 3);
  EXPECT_EQ(ink.bottom, 4);
  shapeton::FillRectangle(picture, -5, -5, 100, 100, red, 0.5);
  EXPECT_EQ(shapeton::At(picture, 2, 3), shapeton::MakeColor(100, 5, 10));
  EXPECT_EQ(shapeton::At(picture, 9, 9), shapeton::MakeColor(228, 133, 138));

  auto frame = shapeton::NewPicture(10, 10, white);
  shapeton::DrawRectangle(frame, 1, 1, 6, 5, black, 2);
  int inked = 0;
  for (int i = 0; i < 100; ++i)
  {
    inked += shapeton::At(frame, i % 10, i / 10) == black ? 1 : 0;
  }
  EXPECT_EQ(inked, 6 * 5 - 2 * 1);
}

TEST(Picture, LinesHaveTheirLengthAndThickness)
{
  auto picture = shapeton::NewPicture(40, 40, white);
  shapeton::DrawLine(picture, 5, 20, 30, 20, black, 3);
  for (int x = 5; x <= 30; ++x)
  {
    EXPECT_EQ(shapeton::At(picture, x, 19), black);
    EXPECT_EQ(shapeton::At(picture, x, 20), black);
    EXPECT_EQ(shapeton::At(picture, x, 21), black);
    EXPECT_EQ(shapeton::At(picture, x, 23), white);
  }
  // The ink of a slanted line of thickness 2 equals its area.
  auto slanted = shapeton::NewPicture(60, 60, white);
  shapeton::DrawLine(slanted, 10, 10, 40, 50, black, 2);
  double ink = 0.0;
  for (int i = 0; i < 3600; ++i)
  {
    ink += 1.0 - shapeton::At(slanted, i % 60, i / 60)[0] / 255.0;
  }
  EXPECT_NEAR(ink, 2.0 * 50.0 + 3.14, 3.0);
  shapeton::DrawLine(slanted, -500, -500, 900, 700, red); // clipped
}

TEST(Picture, TextHasInkInItsPlace)
{
  shapeton::TextStyle style;
  style.size = 20;
  const shapeton::TextExtent extent = shapeton::MeasureText("Heat 0.25", style);
  EXPECT_GT(extent.width, 4 * extent.height / 2);
  EXPECT_GE(extent.height, 14);
  EXPECT_LE(extent.height, 40);
  auto picture = shapeton::NewPicture(300, 100, white);
  shapeton::DrawText(picture, "Heat 0.25", 50, 30, style);
  const Ink ink = InkOf(picture);
  EXPECT_GE(ink.left, 50);
  EXPECT_LT(ink.right, 50 + extent.width);
  EXPECT_GE(ink.top, 30);
  EXPECT_LT(ink.bottom, 30 + extent.height);
  EXPECT_GE(ink.right - ink.left, extent.width - 6);

  // Anchors only shift the text; the ink is equal.
  style.horizontal = shapeton::HorizontalAnchor::Right;
  style.vertical = shapeton::VerticalAnchor::Bottom;
  auto other = shapeton::NewPicture(300, 100, white);
  shapeton::DrawText(other, "Heat 0.25", 50 + extent.width, 30 + extent.height, style);
  EXPECT_EQ(shapeton::GreatestDifference(picture, other), 0);
  EXPECT_EQ(shapeton::MeasureText("Ag", style).height, shapeton::MeasureText("xx", style).height);
}

TEST(Picture, UprightTextTurnsByAQuarter)
{
  shapeton::TextStyle style;
  style.size = 24;
  auto flat = shapeton::NewPicture(200, 200, white);
  shapeton::DrawText(flat, "time step", 10, 10, style);
  style.upwards = true;
  auto turned = shapeton::NewPicture(200, 200, white);
  shapeton::DrawText(turned, "time step", 10, 10, style);
  const Ink a = InkOf(flat);
  const Ink b = InkOf(turned);
  EXPECT_NEAR(a.right - a.left, b.bottom - b.top, 2);
  EXPECT_NEAR(a.bottom - a.top, b.right - b.left, 2);
  // Reading upwards: the wide "m" follows the narrow "ti", so the lower end has less ink than in text reading
  // downwards.
  EXPECT_GT(b.bottom - b.top, 3 * (b.right - b.left));
}

TEST(Picture, TextIsClippedAndEmptyTextIsNothing)
{
  auto                picture = shapeton::NewPicture(20, 10, white);
  shapeton::TextStyle style;
  shapeton::DrawText(picture, "much too long for this picture", -30, -4, style);
  auto empty = shapeton::NewPicture(20, 10, white);
  shapeton::DrawText(empty, "", 5, 5, style);
  EXPECT_LT(InkOf(empty).right, 0);
  EXPECT_EQ(shapeton::MeasureText("", style).width, 0);
}

TEST(Picture, FittedTextIsNoWiderThanItsPlace)
{
  shapeton::TextStyle style;
  const std::string   text = "brightness: number of voxels";
  style.size = 30;
  EXPECT_EQ(shapeton::FitText(text, style, 10000).size, 30);
  const shapeton::TextStyle fitted = shapeton::FitText(text, style, 200);
  EXPECT_LT(fitted.size, 30);
  EXPECT_LE(shapeton::MeasureText(text, fitted).width, 200);
  EXPECT_EQ(shapeton::FitText(text, style, 1).size, 8);
}

TEST(Picture, PasteCopiesAndClips)
{
  auto picture = shapeton::NewPicture(10, 10, white);
  auto source = shapeton::NewPicture(4, 4, black);
  shapeton::PastePicture(picture, source, 8, -2);
  const Ink ink = InkOf(picture);
  EXPECT_EQ(ink.left, 8);
  EXPECT_EQ(ink.right, 9);
  EXPECT_EQ(ink.top, 0);
  EXPECT_EQ(ink.bottom, 1);
}
