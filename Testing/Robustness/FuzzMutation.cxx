#include "FuzzMutation.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace
{
using Mutation = void (*)(std::string & bytes, const std::string & other, FuzzRandom & random);

void
FlipBits(std::string & bytes, const std::string &, FuzzRandom & random)
{
  for (std::size_t i = 0, count = 1 + random.Below(8); i < count; ++i)
  {
    const std::size_t place = random.Below(bytes.size());
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << random.Below(8)));
  }
}

void
SetBytes(std::string & bytes, const std::string &, FuzzRandom & random)
{
  const char        values[] = { '\0', '\1', '\x7F', '\x80', '\xFF', '0', '-', '\\' };
  const std::size_t place = random.Below(bytes.size());
  const std::size_t count = std::min(1 + random.Below(8), bytes.size() - place);
  bytes.replace(place, count, count, values[random.Below(std::size(values))]);
}

/** Overwrites an integer of 16 or 32 bits in either byte order, as used for lengths, sizes and offsets. */
void
SetNumber(std::string & bytes, const std::string &, FuzzRandom & random)
{
  const std::uint32_t values[] = {
    0,      1,       2,          0x7F,       0xFF,       0x7FFF,     0x8000,
    0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF, static_cast<std::uint32_t>(bytes.size())
  };
  const std::uint32_t value = values[random.Below(std::size(values))];
  const std::size_t   width = random.Below(2) == 0 ? 2 : 4;
  if (bytes.size() < width)
  {
    return;
  }
  char number[4];
  std::memcpy(number, &value, sizeof(number));
  if (random.Below(3) == 0)
  {
    std::reverse(number, number + width);
  }
  bytes.replace(random.Below(bytes.size() - width + 1), width, number, width);
}

/** Replaces a number in text, such as DICOM's decimal strings and the text headers of NRRD and MetaImage. */
void
SetDigits(std::string & bytes, const std::string &, FuzzRandom & random)
{
  const char * const values[] = { "0", "-1", "1", "nan", "inf", "1e308", "-1e-308", "99999999", "4294967296", "" };
  const char * const digits = "0123456789";
  const std::size_t  start = bytes.find_first_of(digits, random.Below(bytes.size()));
  if (start == std::string::npos)
  {
    return;
  }
  const std::size_t end = std::min(bytes.find_first_not_of(digits, start), bytes.size());
  std::string       value = values[random.Below(std::size(values))];
  if (random.Below(2) == 0) // of equal length, so surrounding lengths remain valid
  {
    value.resize(end - start, ' ');
  }
  bytes.replace(start, end - start, value);
}

void
CutEnd(std::string & bytes, const std::string &, FuzzRandom & random)
{
  bytes.resize(1 + random.Below(bytes.size()));
}

void
CutPiece(std::string & bytes, const std::string &, FuzzRandom & random)
{
  const std::size_t start = random.Below(bytes.size());
  bytes.erase(start, 1 + random.Below(64));
}

void
DoublePiece(std::string & bytes, const std::string &, FuzzRandom & random)
{
  const std::size_t start = random.Below(bytes.size());
  const std::string piece = bytes.substr(start, 1 + random.Below(256));
  for (std::size_t i = 0, count = 1 + random.Below(4); i < count; ++i)
  {
    bytes.insert(start, piece);
  }
}

void
TakePiece(std::string & bytes, const std::string & other, FuzzRandom & random)
{
  const std::size_t start = random.Below(other.size());
  const std::string piece = other.substr(start, 1 + random.Below(256));
  const std::size_t place = random.Below(bytes.size());
  bytes.replace(place, random.Below(2) == 0 ? 0 : piece.size(), piece);
}
} // namespace

std::string
Mutate(std::string bytes, const std::string & other, FuzzRandom & random)
{
  const Mutation mutations[] = { FlipBits, SetBytes, SetNumber,   SetNumber, SetDigits,
                                 CutEnd,   CutPiece, DoublePiece, TakePiece };
  for (std::size_t i = 0, count = 1 + random.Below(4); i < count && !bytes.empty(); ++i)
  {
    mutations[random.Below(std::size(mutations))](bytes, other, random);
  }
  return bytes;
}
