#include "shapetonBase64Text.h"

#include <gtest/gtest.h>

TEST(Base64Text, ReadsBackBytes)
{
  std::string bytes;
  for (int length = 0; length < 300; ++length)
  {
    EXPECT_EQ(shapeton::BytesOfBase64(shapeton::Base64(bytes)), bytes) << length;
    bytes += static_cast<char>(7 * length);
  }
}

TEST(Base64Text, RefusesMalformedText)
{
  for (const char * const text : { "QQ=", "Q", "QQ=Q", "Q===", "====", "QQ Q", "QQ\nQ", "QQ-_" })
  {
    EXPECT_FALSE(shapeton::BytesOfBase64(text)) << text;
  }
}
