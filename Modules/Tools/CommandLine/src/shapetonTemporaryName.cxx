#include "shapetonTemporaryName.h"

#include "shapetonOperatingSystem.h"
#include "shapetonPrintable.h"

#include <charconv>
#include <cstdint>

namespace fs = std::filesystem;

namespace shapeton
{
namespace
{
const std::string mark = ".part"; // in the names of unfinished files

// Process numbers are only unique within one process namespace of one host. The state of a run on another host that
// shares the folder is unknown.
std::string
ComputeMachineTag()
{
  std::error_code         error;
  std::uint32_t           hash = 2166136261u; // FNV-1a
  constexpr std::uint32_t prime = 16777619u;
  for (const char c : HostName() + fs::read_symlink("/proc/self/ns/pid", error).string())
  {
    hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  }
  std::string tag;
  for (int shift = 28; shift >= 0; shift -= 4)
  {
    tag += "0123456789abcdef"[hash >> shift & 15];
  }
  return tag;
}

const std::string &
MachineTag()
{
  static const std::string tag = ComputeMachineTag();
  return tag;
}

// Position of the extension of a file name; ".nii.gz" and ".mrk.json" are one extension.
std::size_t
ExtensionStart(const std::string & name)
{
  const std::size_t last = name.rfind('.');
  if (last == std::string::npos || last == 0)
  {
    return name.size();
  }
  const std::size_t before = name.rfind('.', last - 1);
  const std::string extension = LowerCase(name.substr(before == std::string::npos ? last : before));
  const bool        isDouble = extension == ".mrk.json" || extension.substr(extension.rfind('.')) == ".gz";
  return isDouble && before != std::string::npos ? before : last;
}

// At most `size` bytes, without splitting a UTF-8 character.
std::string
Shortened(const std::string & text, std::size_t size)
{
  if (text.size() <= size)
  {
    return text;
  }
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80)
  {
    --size;
  }
  return text.substr(0, size);
}

// Parses a number and advances past it; returns -1 if there is none.
long
TakeNumber(const char *& position, const char * end)
{
  long       number = -1;
  const auto result = std::from_chars(position, end, number);
  position = result.ptr;
  return result.ec == std::errc() ? number : -1;
}
} // namespace

fs::path
TemporaryNameFor(const fs::path & target, std::size_t number)
{
  constexpr std::size_t longest = 255; // maximum name length in Linux file systems
  const std::string     name = target.filename().string();
  const std::size_t     extension = ExtensionStart(name);
  const std::string end = '.' + MachineTag() + '-' + std::to_string(ProcessNumber()) + '-' + std::to_string(number) +
                          mark + name.substr(extension);
  const std::size_t room = end.size() + 1 < longest ? longest - end.size() - 1 : 0;
  return target.parent_path() / ('.' + Shortened(name.substr(0, extension), room) + end);
}

bool
IsLeftover(const std::string & name)
{
  const std::string start = '.' + MachineTag() + '-';
  const std::size_t tag = name.rfind(start);
  if (tag == std::string::npos || name[0] != '.')
  {
    return false;
  }
  const char *       position = name.data() + tag + start.size();
  const char * const end = name.data() + name.size();
  const long         process = TakeNumber(position, end);
  if (process <= 0 || position == end || *position++ != '-' || TakeNumber(position, end) < 0 ||
      name.compare(position - name.data(), mark.size(), mark) != 0)
  {
    return false;
  }
  // An earlier process with the same number as this one has also ended.
  return process == ProcessNumber() || !IsProcessAlive(process);
}
} // namespace shapeton
