#include "itkColonAnatomy.h"

#include <gtest/gtest.h>

TEST(ColonAnatomy, LengthIsThatOfAColon)
{
  const itk::ColonAnatomy anatomy(itk::ColonPhantomPreset("standard"));
  EXPECT_GT(anatomy.Length(), 1000.0);
  EXPECT_LT(anatomy.Length(), 2000.0);
}
