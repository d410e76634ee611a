#include "shapetonParticleState.h"
#include "shapetonPrintable.h"
#include "shapetonChecksum.h"

#include <algorithm>
#include <istream>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the state is written in memory layout");

namespace shapeton
{
namespace
{
constexpr char magic[] = "SHAPETON STATE 1";

std::string
HeaderOf(const ParticleState & state)
{
  std::ostringstream header;
  header.precision(std::numeric_limits<double>::max_digits10);
  header << magic << "\nstep: " << state.step << "\nchange: " << state.change
         << "\nsteadyHistory: " << state.steadyHistory << "\ntestedSteps: " << state.testedSteps
         << "\nshapetons: " << state.places[0].size() << "\nvoxels: " << state.visits.size() << '\n';
  for (const auto & [name, value] : state.identity)
  {
    header << "identity." << name << ": " << value << '\n';
  }
  header << '\n';
  return header.str();
}

template <typename TNumber>
void
Write(const std::vector<TNumber> & numbers, std::ostream & stream, Checksum & checksum)
{
  checksum.Add(numbers.data(), numbers.size() * sizeof(TNumber));
  stream.write(reinterpret_cast<const char *>(numbers.data()), numbers.size() * sizeof(TNumber));
}

/** Grows with the data read, so a damaged length cannot exhaust memory. */
template <typename TNumber>
void
Read(std::vector<TNumber> & numbers, std::uint64_t number, std::istream & stream, Checksum & checksum)
{
  constexpr std::uint64_t piece = std::uint64_t{ 1 } << 24;
  while (numbers.size() < number)
  {
    const auto begin = numbers.size();
    const auto more = std::min(piece, number - begin);
    numbers.resize(begin + more);
    if (!stream.read(reinterpret_cast<char *>(numbers.data() + begin), more * sizeof(TNumber)))
    {
      throw std::runtime_error("it is truncated");
    }
  }
  checksum.Add(numbers.data(), numbers.size() * sizeof(TNumber));
}

constexpr std::size_t longestHeader = 65536;

/** Limited to the size of a header, because another file may be a single long line. */
bool
GetLine(std::istream & stream, std::string & line)
{
  line.clear();
  char next = 0;
  while (line.size() < longestHeader && stream.get(next) && next != '\n')
  {
    line += next;
  }
  return static_cast<bool>(stream);
}

template <typename TNumber>
TNumber
Parse(const std::string & name, const std::string & value)
{
  std::istringstream stream(value);
  TNumber            number{};
  if (!(stream >> number) || !stream.eof())
  {
    throw std::runtime_error("\"" + name + "\" is not a number");
  }
  return number;
}
} // namespace

void
WriteParticleState(const ParticleState & state, std::ostream & stream)
{
  const std::string header = HeaderOf(state);
  Checksum          checksum;
  checksum.Add(header.data(), header.size());
  stream.write(header.data(), header.size());
  for (const auto & places : state.places)
  {
    Write(places, stream, checksum);
  }
  Write(state.visits, stream, checksum);
  const std::uint64_t sum = checksum.Get();
  stream.write(reinterpret_cast<const char *>(&sum), sizeof(sum));
}

ParticleState
ReadParticleState(std::istream & stream)
{
  std::string line;
  if (!GetLine(stream, line) || line != magic)
  {
    throw std::runtime_error("it does not begin with \"" + std::string(magic) + "\"");
  }
  ParticleState state;
  std::uint64_t shapetons = 0;
  std::uint64_t voxels = 0;
  std::string   header = line + '\n';
  while (GetLine(stream, line) && !line.empty() && header.size() < longestHeader)
  {
    header += line + '\n';
    const auto        colon = line.find(": ");
    const std::string name = line.substr(0, colon);
    const std::string value = colon == std::string::npos ? "" : line.substr(colon + 2);
    if (name == "step" || name == "steadyHistory" || name == "testedSteps" || name == "shapetons" || name == "voxels")
    {
      const auto number = Parse<std::uint64_t>(name, value);
      (name == "step"            ? state.step
       : name == "steadyHistory" ? state.steadyHistory
       : name == "testedSteps"   ? state.testedSteps
       : name == "shapetons"     ? shapetons
                                 : voxels) = number;
    }
    else if (name == "change")
    {
      state.change = Parse<double>(name, value);
    }
    else if (name.rfind("identity.", 0) == 0)
    {
      state.identity.emplace_back(name.substr(9), value);
    }
    else
    {
      throw std::runtime_error("its header contains the unknown entry \"" + name.substr(0, LongestExcerpt) + "\"");
    }
  }
  header += '\n';
  Checksum checksum;
  checksum.Add(header.data(), header.size());
  for (auto & places : state.places)
  {
    Read(places, shapetons, stream, checksum);
  }
  Read(state.visits, voxels, stream, checksum);
  std::uint64_t sum = 0;
  if (!stream.read(reinterpret_cast<char *>(&sum), sizeof(sum)))
  {
    throw std::runtime_error("it is truncated");
  }
  if (sum != checksum.Get())
  {
    throw std::runtime_error("it is damaged: its checksum is wrong");
  }
  return state;
}
} // namespace shapeton
