#include "shapetonPageBlocks.h"

#include "shapetonBase64Text.h"
#include "shapetonFileBytes.h"
#include "shapetonParallelFor.h"

#include "itk_zlib.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Compresses without time and name, so the output is deterministic. */
std::string
Gzip(const std::string & bytes)
{
  constexpr int gzipWindow = 15 + 16;
  // Differences of voxels are small random numbers, for which Z_FILTERED is intended. Level 6 takes three times as long
  // and saves 1 %.
  z_stream stream{};
  if (deflateInit2(&stream, 4, Z_DEFLATED, gzipWindow, 9, Z_FILTERED) != Z_OK)
  {
    throw std::runtime_error("zlib cannot start");
  }
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef *>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END)
  {
    throw std::runtime_error("zlib cannot compress a block of " + std::to_string(bytes.size()) + " bytes");
  }
  return packed;
}

/** Little-endian on every machine. */
template <typename TValue>
std::string
BytesOfDifferences(const std::vector<TValue> & values, std::size_t delta)
{
  std::string bytes;
  bytes.reserve(values.size() * sizeof(TValue));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const TValue before = delta > 0 && i >= delta ? values[i - delta] : TValue{ 0 };
    const auto   difference = static_cast<TValue>(values[i] - before);
    for (std::size_t byte = 0; byte < sizeof(TValue); ++byte)
    {
      bytes += static_cast<char>(difference >> (8 * byte) & 0xff);
    }
  }
  return bytes;
}

std::string
FileNameOf(std::string block)
{
  std::replace(block.begin(), block.end(), '/', '-');
  return block + ".js";
}
} // namespace

std::string
ScriptText(const Json & value)
{
  std::string text;
  for (const char c : value.dump(-1, ' ', false, Json::error_handler_t::replace))
  {
    text += c == '<' ? "\\u003c" : c == '>' ? "\\u003e" : c == '&' ? "\\u0026" : std::string(1, c);
  }
  return text;
}

PageBlocks::PageBlocks(std::string folder, bool isSingle, OutputPath outputPath)
  : m_Folder(std::move(folder)), m_IsSingle(isSingle), m_OutputPath(std::move(outputPath))
{}

template <typename TValue>
void
PageBlocks::Put(const std::string & name, const std::vector<TValue> & values, std::size_t delta, Json header)
{
  header["type"] = "u" + std::to_string(8 * sizeof(TValue));
  header["count"] = values.size();
  header["delta"] = delta;
  this->PutBytes(name, header, BytesOfDifferences(values, delta));
}

template void
PageBlocks::Put(const std::string &, const std::vector<std::uint8_t> &, std::size_t, Json);
template void
PageBlocks::Put(const std::string &, const std::vector<std::uint16_t> &, std::size_t, Json);
template void
PageBlocks::Put(const std::string &, const std::vector<std::uint32_t> &, std::size_t, Json);

template <typename TValue>
void
PageBlocks::PutReals(const std::string & name, const std::vector<double> & reals, std::size_t columns)
{
  constexpr double    greatest = std::numeric_limits<TValue>::max();
  std::vector<TValue> values(reals.size());
  Json                header{ { "offset", Json::array() }, { "step", Json::array() } };
  for (std::size_t column = 0; column < columns; ++column)
  {
    double least = INFINITY;
    double most = -INFINITY;
    for (std::size_t i = column; i < reals.size(); i += columns)
    {
      least = std::isfinite(reals[i]) ? std::min(least, reals[i]) : least;
      most = std::isfinite(reals[i]) ? std::max(most, reals[i]) : most;
    }
    const double step = most > least ? (most - least) / greatest : 1.0;
    header["offset"].push_back(std::isfinite(least) ? least : 0.0);
    header["step"].push_back(step);
    for (std::size_t i = column; i < reals.size(); i += columns)
    {
      values[i] =
        std::isfinite(reals[i]) ? static_cast<TValue>(std::min(std::round((reals[i] - least) / step), greatest)) : 0;
    }
  }
  this->Put(name, values, columns, std::move(header));
}

template void
PageBlocks::PutReals<std::uint16_t>(const std::string &, const std::vector<double> &, std::size_t);
template void
PageBlocks::PutReals<std::uint32_t>(const std::string &, const std::vector<double> &, std::size_t);

void
PageBlocks::PutJson(const std::string & name, const Json & value)
{
  this->PutScript(name, "block(" + ScriptText(name) + ",null," + ScriptText(value) + ");\n");
}

std::string
PageBlocks::Inline() const
{
  std::string elements;
  for (const std::string & script : m_Scripts)
  {
    elements += "<script>" + script + "</script>\n";
  }
  return elements;
}

std::string
PageBlocks::Script() const
{
  return std::accumulate(m_Scripts.begin(), m_Scripts.end(), std::string());
}

void
PageBlocks::PutBytes(const std::string & name, Json header, const std::string & bytes)
{
  // Bytes before compression. A browser reads 21 MB as eight scripts in 1.0 s, as one script in 2.4 s.
  constexpr std::size_t    partSize = std::size_t{ 8 } << 20;
  std::vector<std::string> parts(std::max<std::size_t>(1, (bytes.size() + partSize - 1) / partSize));
  ParallelFor(parts.size(),
              [&](std::size_t part) { parts[part] = Base64(Gzip(bytes.substr(part * partSize, partSize))); });
  const bool isSplit = parts.size() > 1;
  header["parts"] = isSplit ? parts.size() : 0;
  this->PutScript(
    name, "block(" + ScriptText(name) + "," + ScriptText(header) + ",\"" + (isSplit ? "" : parts.front()) + "\");\n");
  for (std::size_t part = 1; isSplit && part <= parts.size(); ++part)
  {
    const std::string nameOfPart = name + '.' + std::to_string(part);
    this->PutScript(nameOfPart, "block(" + ScriptText(nameOfPart) + ",null,\"" + parts[part - 1] + "\");\n");
  }
}

void
PageBlocks::PutScript(const std::string & name, const std::string & script)
{
  if (m_IsSingle)
  {
    m_Scripts.push_back(script);
  }
  else
  {
    WriteFileBytes(m_OutputPath(m_Folder + "/" + FileNameOf(name)), script);
  }
}
} // namespace shapeton
