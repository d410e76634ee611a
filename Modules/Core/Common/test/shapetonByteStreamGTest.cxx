#include "shapetonByteStream.h"

#include "gtest/gtest.h"

#include <limits>

namespace
{
/** Number of elements in the received lists; -1 if the message is refused. */
int
SizeOfLists(const std::vector<std::uint64_t> & stated)
{
  shapeton::ByteWriter writer;
  for (const std::uint64_t size : stated)
  {
    writer & size;
  }
  shapeton::ByteReader reader(writer.GetBytes());
  std::size_t          sum = 0;
  try
  {
    for (std::size_t i = 0; i < stated.size(); ++i)
    {
      std::vector<char> list;
      reader.SizeOf(list);
      sum += list.size();
    }
  }
  catch (const std::runtime_error &)
  {
    return -1;
  }
  return static_cast<int>(sum);
}
} // namespace

TEST(ByteStream, RoundTrip)
{
  const std::vector<int> list{ 3, -4 };
  shapeton::ByteWriter   writer;
  writer.SizeOf(list) & list[0] & list[1] & std::string("text") & 2.5;
  shapeton::ByteReader reader(writer.GetBytes());
  std::vector<int>     copy;
  std::string          text;
  double               number = 0.0;
  reader.SizeOf(copy);
  reader & copy.at(0) & copy.at(1) & text & number;
  EXPECT_EQ(list, copy);
  EXPECT_EQ("text", text);
  EXPECT_EQ(2.5, number);
}

TEST(ByteStream, SizesThatExceedTheMessageAreRefused)
{
  constexpr std::uint64_t half = std::uint64_t(1) << 63; // twice this is 0
  EXPECT_EQ(0, SizeOfLists({ 0 }));
  EXPECT_EQ(8, SizeOfLists({ 8, 0 }));
  EXPECT_EQ(-1, SizeOfLists({ 9, 0 }));
  EXPECT_EQ(-1, SizeOfLists({ half, half }));
  EXPECT_EQ(-1, SizeOfLists({ 0, std::numeric_limits<std::uint64_t>::max(), 1 }));
}
