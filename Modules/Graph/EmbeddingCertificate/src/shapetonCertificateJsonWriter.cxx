#include "shapetonEmbeddingCertificate.h"
#include "shapetonJson.h"
#include "shapetonFileErrors.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** A file written in blocks; any failure throws OutputError. */
class BlockFile
{
public:
  explicit BlockFile(const std::string & path) : m_Path(path), m_File(std::fopen(path.c_str(), "wbe"))
  {
    if (!m_File)
    {
      this->Fail();
    }
    m_Block.reserve(2 * BlockSize);
  }
  BlockFile(const BlockFile &) = delete;
  BlockFile &
  operator=(const BlockFile &) = delete;
  ~BlockFile()
  {
    if (m_File)
    {
      std::fclose(m_File);
    }
  }

  void
  Put(std::string_view text)
  {
    m_Block += text;
    if (m_Block.size() >= BlockSize)
    {
      this->Flush();
    }
  }

  void
  Close()
  {
    this->Flush();
    const int status = std::fclose(m_File);
    m_File = nullptr;
    if (status != 0)
    {
      this->Fail();
    }
  }

private:
  static constexpr std::size_t BlockSize = 1 << 20; // bytes written at once; chosen

  void
  Flush()
  {
    if (std::fwrite(m_Block.data(), 1, m_Block.size(), m_File) != m_Block.size() || std::fflush(m_File) != 0)
    {
      this->Fail();
    }
    m_Block.clear();
  }

  [[noreturn]] void
  Fail() const
  {
    ThrowCannotWrite(m_Path, errno);
  }

  std::string m_Path;
  std::FILE * m_File;
  std::string m_Block;
};

/** JSON writer with one entry per line; the caller opens and closes objects. */
class EntryWriter
{
public:
  explicit EntryWriter(BlockFile & file) : m_File(file) {}

  void
  Open(const std::string & key = {})
  {
    this->Begin(key);
    m_File.Put("{");
    m_Depth += 2;
    m_IsFirst = true;
  }

  void
  Close()
  {
    m_Depth -= 2;
    m_File.Put("\n" + std::string(m_Depth, ' ') + "}");
    m_IsFirst = false;
  }

  void
  Add(const std::string & key, const std::string & value)
  {
    this->Begin(key);
    this->Value(value);
  }

  template <typename T>
  void
  Add(const std::string & key, const T & value)
  {
    this->Begin(key);
    this->Value(value);
  }

private:
  void
  Begin(const std::string & key)
  {
    if (!key.empty())
    {
      m_File.Put((m_IsFirst ? "\n" : ",\n") + std::string(m_Depth, ' '));
      this->Value(key);
      m_File.Put(": ");
    }
    m_IsFirst = false;
  }

  template <typename T>
  void
  Number(T value)
  {
    char       text[40];
    const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
    m_File.Put({ text, static_cast<std::size_t>(end - text) });
  }

  void
  Value(int value)
  {
    this->Number(value);
  }

  void
  Value(double value)
  {
    if (!std::isfinite(value))
    {
      throw std::invalid_argument("a certificate must contain finite numbers only");
    }
    this->Number(value);
  }

  void
  Value(const std::string & value)
  {
    m_File.Put(Json(value).dump(-1, ' ', false, Json::error_handler_t::replace));
  }

  void
  Value(const std::array<int, 2> & value)
  {
    this->Number(value[0]);
    m_File.Put(",");
    this->Number(value[1]);
  }

  template <typename T>
  void
  Value(const std::vector<T> & values)
  {
    m_File.Put("[");
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      if (i > 0)
      {
        m_File.Put(",");
      }
      this->Value(values[i]);
    }
    m_File.Put("]");
  }

  BlockFile & m_File;
  std::size_t m_Depth{ 0 };
  bool        m_IsFirst{ true };
};

void
AddGraph(EntryWriter & entries, const EmbeddingCertificate & certificate)
{
  entries.Open("graph");
  entries.Add("nodes", certificate.graph.nodes);
  entries.Add("edges", certificate.graph.edges);
  if (!certificate.graph.names.empty())
  {
    entries.Add("names", certificate.graph.names);
  }
  entries.Add("rotation", certificate.rotation);
  entries.Close();
}

bool
HasDummies(const EmbeddingCertificate & certificate)
{
  return certificate.packed.nodes != certificate.graph.nodes || certificate.packed.edges != certificate.graph.edges ||
         certificate.packedRotation != certificate.rotation;
}

void
AddPackedMap(EntryWriter & entries, const EmbeddingCertificate & certificate)
{
  entries.Open("packed");
  entries.Add("nodes", certificate.packed.nodes);
  entries.Add("edges", certificate.packed.edges);
  entries.Add("rotation", certificate.packedRotation);
  entries.Add("subdivided", certificate.subdivided);
  entries.Close();
}

void
AddDeckTransformations(EntryWriter & entries, const EmbeddingCertificate & certificate)
{
  std::vector<int>    halfEdges;
  std::vector<double> a;
  std::vector<double> b;
  for (const DeckTransformation & generator : certificate.generators)
  {
    halfEdges.push_back(generator.halfEdge);
    a.insert(a.end(), { generator.a.real(), generator.a.imag() });
    b.insert(b.end(), { generator.b.real(), generator.b.imag() });
  }
  entries.Open("generators");
  entries.Add("halfEdges", halfEdges);
  entries.Add("a", a);
  entries.Add("b", b);
  entries.Close();
  entries.Add("word", certificate.word);
  if (!certificate.canonicalWords.empty())
  {
    entries.Add("canonicalWords", certificate.canonicalWords);
  }
  if (certificate.geometry == EmbeddingGeometry::Euclidean)
  {
    entries.Add("periods", certificate.periods);
  }
}

void
AddCircles(EntryWriter & entries, const EmbeddingCertificate & certificate)
{
  entries.Add("nodeRadii", certificate.nodeRadii);
  entries.Add("nodePositions", certificate.nodePositions);
  entries.Add("faceRadii", certificate.faceRadii);
  entries.Add("facePositions", certificate.facePositions);
  if (certificate.geometry != EmbeddingGeometry::Spherical)
  {
    entries.Add("nodeAngles", certificate.nodeAngles);
    entries.Add("tree", certificate.tree);
    AddDeckTransformations(entries, certificate);
  }
}

template <typename T>
void
AddFacts(EntryWriter & entries, const std::string & key, const std::vector<std::pair<std::string, T>> & facts)
{
  entries.Open(key);
  for (const auto & [name, value] : facts)
  {
    entries.Add(name, value);
  }
  entries.Close();
}
} // namespace

void
WriteEmbeddingCertificate(const EmbeddingCertificate & certificate, const std::string & path)
{
  BlockFile   file(path);
  EntryWriter entries(file);
  entries.Open();
  entries.Add("format", std::string("Shapeton embedding certificate"));
  entries.Add("version", 1);
  AddFacts(entries, "provenance", certificate.provenance);
  entries.Add("warnings", certificate.warnings);
  AddFacts(entries, "statistics", certificate.statistics);
  entries.Add("geometry", NameOf(certificate.geometry));
  entries.Add("genus", certificate.genus);
  AddGraph(entries, certificate);
  if (HasDummies(certificate))
  {
    AddPackedMap(entries, certificate);
  }
  AddCircles(entries, certificate);
  entries.Close();
  file.Put("\n");
  file.Close();
}
} // namespace shapeton
