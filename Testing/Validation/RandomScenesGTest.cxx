#include "RandomScenes.h"

#include "shapetonTestImages.h"
#include "shapetonTestThreads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

TEST(RandomScenes, TheNumberOfThreadsDoesNotChangeAScene)
{
  const SceneVolume many = RandomScene(3);
  const SceneVolume one = [] {
    const basetest::ThreadNumber single(1);
    return RandomScene(3);
  }();
  EXPECT_EQ(basetest::BytesOf(one.image), basetest::BytesOf(many.image));
  EXPECT_EQ(basetest::BytesOf(one.labels), basetest::BytesOf(many.labels));
}

TEST(RandomScenes, OddSeedsFitIntoAByte)
{
  const SceneVolume   scene = RandomScene(5);
  const float * const first = scene.image->GetBufferPointer();
  const float * const last = first + scene.image->GetBufferedRegion().GetNumberOfPixels();
  EXPECT_EQ(*std::min_element(first, last), 0.0F);
  EXPECT_LE(*std::max_element(first, last), 255.0F);
  EXPECT_TRUE(std::all_of(first, last, [](float value) { return value == std::round(value); }));
}
