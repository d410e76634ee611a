#include "shapetonEmbeddingCertificate.h"
#include "shapetonFileBytes.h"
#include "shapetonJson.h"
#include "shapetonExceptions.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>

namespace shapeton
{
namespace
{
/** Maps key paths of the file, such as "graph.edges", to the destination of each entry. */
struct EntryTables
{
  std::map<std::string, std::vector<int>>              integers;
  std::map<std::string, std::vector<double>>           numbers;
  std::map<std::string, std::vector<std::string>>      texts;
  std::map<std::string, std::vector<std::vector<int>>> words;
  std::map<std::string, int>                           integer;
  std::map<std::string, std::string>                   text;
  std::vector<std::pair<std::string, std::string>>     provenance;
  std::vector<std::pair<std::string, double>>          statistics;

  EntryTables()
  {
    for (const char * key :
         { "graph.edges", "graph.rotation", "packed.edges", "packed.rotation", "tree", "word", "generators.halfEdges" })
    {
      integers[key];
    }
    for (const char * key : { "nodeRadii",
                              "nodePositions",
                              "faceRadii",
                              "facePositions",
                              "nodeAngles",
                              "periods",
                              "generators.a",
                              "generators.b" })
    {
      numbers[key];
    }
    texts["warnings"];
    texts["graph.names"];
    words["packed.subdivided"];
    words["canonicalWords"];
  }
};

/** Fills the tables during parsing; unknown entries are skipped. */
class EntryHandler : public nlohmann::json_sax<Json>
{
public:
  EntryHandler(const std::string & path, const std::string & bytes, EntryTables & tables)
    : m_FilePath(path), m_Bytes(bytes), m_Tables(tables)
  {}

  bool
  null() override
  {
    this->Refuse("is null");
  }
  bool
  boolean(bool) override
  {
    this->RefuseIfKnown("a truth value");
    return true;
  }
  bool
  number_integer(number_integer_t value) override
  {
    if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    {
      return this->number_float(static_cast<double>(value), {});
    }
    return this->Integer(static_cast<int>(value));
  }
  bool
  number_unsigned(number_unsigned_t value) override
  {
    if (value > static_cast<number_unsigned_t>(std::numeric_limits<int>::max()))
    {
      return this->number_float(static_cast<double>(value), {});
    }
    return this->Integer(static_cast<int>(value));
  }
  bool
  number_float(number_float_t value, const string_t &) override
  {
    if (const auto list = m_Tables.numbers.find(m_Path); list != m_Tables.numbers.end() && m_Depth == 1)
    {
      list->second.push_back(value);
    }
    else if (IsIn("statistics"))
    {
      m_Tables.statistics.emplace_back(m_Key, value);
    }
    else
    {
      this->RefuseIfKnown("a number that is not an index");
    }
    return true;
  }
  bool
  string(string_t & value) override
  {
    if (const auto list = m_Tables.texts.find(m_Path); list != m_Tables.texts.end() && m_Depth == 1)
    {
      list->second.push_back(value);
    }
    else if (IsIn("provenance"))
    {
      m_Tables.provenance.emplace_back(m_Key, value);
    }
    else
    {
      this->RefuseIfKnown("a string");
      m_Tables.text[m_Path] = value;
    }
    return true;
  }
  bool
  binary(binary_t &) override
  {
    return false;
  }
  bool
  start_object(std::size_t) override
  {
    if (m_Depth > 0)
    {
      this->RefuseIfKnown("an object");
    }
    constexpr std::size_t mostDepth = 16; // limits the length of key paths
    if (m_Objects.size() >= mostDepth)
    {
      this->Refuse("has too many nested objects");
    }
    m_Objects.push_back(m_Path);
    return true;
  }
  bool
  key(string_t & value) override
  {
    m_Key = value;
    m_Path = m_Objects.back().empty() ? value : m_Objects.back() + '.' + value;
    if (!m_Seen.insert(m_Path).second)
    {
      this->Refuse("is repeated");
    }
    return true;
  }
  bool
  end_object() override
  {
    m_Path = m_Objects.back();
    m_Objects.pop_back();
    return true;
  }
  bool
  start_array(std::size_t) override
  {
    ++m_Depth;
    if (const auto list = m_Tables.words.find(m_Path); list != m_Tables.words.end() && m_Depth == 2)
    {
      list->second.emplace_back();
    }
    else if (m_Depth > 1)
    {
      this->RefuseIfKnown("a list in a list");
    }
    return true;
  }
  bool
  end_array() override
  {
    --m_Depth;
    return true;
  }
  bool
  parse_error(std::size_t position, const std::string &, const nlohmann::detail::exception & error) override
  {
    if (dynamic_cast<const nlohmann::detail::out_of_range *>(&error) != nullptr) // e.g. 1e999
    {
      this->Refuse("contains a number that is too large");
    }
    throw InputError('"' + m_FilePath + "\" is not valid JSON at " + PlaceInText(m_Bytes, position) +
                     "; compute the certificate again");
  }

private:
  bool
  IsIn(const std::string & object) const
  {
    return m_Depth == 0 && !m_Objects.empty() && m_Objects.back() == object;
  }

  bool
  Integer(int value)
  {
    if (const auto list = m_Tables.integers.find(m_Path); list != m_Tables.integers.end() && m_Depth == 1)
    {
      list->second.push_back(value);
    }
    else if (const auto words = m_Tables.words.find(m_Path); words != m_Tables.words.end() && m_Depth == 2)
    {
      words->second.back().push_back(value);
    }
    else if (m_Tables.numbers.count(m_Path) > 0 || IsIn("statistics"))
    {
      return this->number_float(value, {});
    }
    else
    {
      this->RefuseIfKnown("a number");
      m_Tables.integer[m_Path] = value;
    }
    return true;
  }

  void
  RefuseIfKnown(const std::string & what) const
  {
    if (m_Tables.integers.count(m_Path) > 0 || m_Tables.numbers.count(m_Path) > 0 || m_Tables.texts.count(m_Path) > 0 ||
        m_Tables.words.count(m_Path) > 0 || IsIn("statistics") || IsIn("provenance"))
    {
      this->Refuse("holds " + what + ", which is not allowed there");
    }
  }

  [[noreturn]] void
  Refuse(const std::string & what) const
  {
    throw InputError('"' + m_FilePath + "\": the entry \"" + m_Path + "\" " + what + "; compute the certificate again");
  }

  const std::string &      m_FilePath;
  const std::string &      m_Bytes;
  EntryTables &            m_Tables;
  std::string              m_Path;
  std::string              m_Key;
  std::vector<std::string> m_Objects;
  std::set<std::string>    m_Seen;
  int                      m_Depth{ 0 }; // list nesting depth
};

/** Moves entries out of the tables and checks their sizes. */
class EntryReader
{
public:
  EntryReader(const std::string & path, EntryTables & tables) : m_Path(path), m_Tables(tables) {}

  std::string
  Text(const std::string & key) const
  {
    const auto found = m_Tables.text.find(key);
    Require(found != m_Tables.text.end(), key, "is missing or not a string");
    return found->second;
  }

  int
  Integer(const std::string & key, int least) const
  {
    const auto found = m_Tables.integer.find(key);
    Require(found != m_Tables.integer.end(), key, "is missing or not an integer");
    Require(found->second >= least, key, "is less than " + std::to_string(least));
    return found->second;
  }

  std::vector<double>
  Numbers(const std::string & key, std::size_t size)
  {
    std::vector<double> values = std::move(m_Tables.numbers[key]);
    RequireSize(key, values.size(), size);
    return values;
  }

  /** `size` integers in [least, end). */
  std::vector<int>
  Integers(const std::string & key, std::size_t size, int least, std::size_t end)
  {
    std::vector<int> values = std::move(m_Tables.integers[key]);
    RequireSize(key, values.size(), size);
    RequireRange(key, values, least, end);
    return values;
  }

  std::vector<std::array<int, 2>>
  Edges(const std::string & key, int nodes)
  {
    const std::vector<int> ends = std::move(m_Tables.integers[key]);
    Require(ends.size() % 2 == 0, key, "has an odd number of nodes");
    RequireRange(key, ends, 0, nodes);
    std::vector<std::array<int, 2>> edges(ends.size() / 2);
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      edges[i / 2][i % 2] = ends[i];
    }
    return edges;
  }

  std::vector<std::vector<int>>
  Words(const std::string & key, int least, std::size_t end)
  {
    std::vector<std::vector<int>> words = std::move(m_Tables.words[key]);
    for (const std::vector<int> & word : words)
    {
      RequireRange(key, word, least, end);
    }
    return words;
  }

  std::vector<std::string>
  Texts(const std::string & key)
  {
    return std::move(m_Tables.texts[key]);
  }

  void
  Require(bool condition, const std::string & key, const std::string & fault) const
  {
    if (!condition)
    {
      throw InputError('"' + m_Path + "\": the entry \"" + key + "\" " + fault + "; compute the certificate again");
    }
  }

private:
  void
  RequireSize(const std::string & key, std::size_t size, std::size_t wanted) const
  {
    Require(size == wanted, key, "has " + std::to_string(size) + " entries instead of " + std::to_string(wanted));
  }

  void
  RequireRange(const std::string & key, const std::vector<int> & values, int least, std::size_t end) const
  {
    for (const int value : values)
    {
      Require(value >= least && (value < 0 || static_cast<std::size_t>(value) < end),
              key,
              "holds " + std::to_string(value) + ", which is out of range");
    }
  }

  const std::string & m_Path;
  EntryTables &       m_Tables;
};

EmbeddingGeometry
GeometryOf(const EntryReader & entries)
{
  const std::string name = entries.Text("geometry");
  for (const auto geometry :
       { EmbeddingGeometry::Spherical, EmbeddingGeometry::Euclidean, EmbeddingGeometry::Hyperbolic })
  {
    if (name == NameOf(geometry))
    {
      return geometry;
    }
  }
  entries.Require(false, "geometry", "is \"" + name + "\"; expected spherical, euclidean or hyperbolic");
  return {};
}

void
TakeGraph(EntryReader & entries, EmbeddingCertificate & certificate)
{
  Graph & graph = certificate.graph;
  graph.nodes = entries.Integer("graph.nodes", 1);
  graph.edges = entries.Edges("graph.edges", graph.nodes);
  graph.names = entries.Texts("graph.names");
  entries.Require(graph.names.empty() || graph.names.size() == static_cast<std::size_t>(graph.nodes),
                  "graph.names",
                  "must have one name for each node");
  const std::size_t halfEdges = 2 * graph.edges.size();
  certificate.rotation = entries.Integers("graph.rotation", halfEdges, 0, halfEdges);
}

void
TakePackedMap(EntryReader & entries, bool hasPackedMap, EmbeddingCertificate & certificate)
{
  Graph & packed = certificate.packed;
  if (!hasPackedMap)
  {
    packed.nodes = certificate.graph.nodes;
    packed.edges = certificate.graph.edges;
    certificate.packedRotation = certificate.rotation;
    return;
  }
  packed.nodes = entries.Integer("packed.nodes", certificate.graph.nodes);
  packed.edges = entries.Edges("packed.edges", packed.nodes);
  const std::size_t halfEdges = 2 * packed.edges.size();
  entries.Require(packed.edges.size() >= certificate.graph.edges.size(), "packed.edges", "lacks edges of the graph");
  certificate.packedRotation = entries.Integers("packed.rotation", halfEdges, 0, halfEdges);
  certificate.subdivided = entries.Words("packed.subdivided", 0, halfEdges);
  for (const std::vector<int> & path : certificate.subdivided)
  {
    const bool isSound = path.size() >= 2 && path.front() % 2 == 0 &&
                         static_cast<std::size_t>(path.front()) < 2 * certificate.graph.edges.size();
    entries.Require(isSound, "packed.subdivided", "has a path that is not a subdivided edge of the graph");
  }
}

void
TakeDeckTransformations(EntryReader & entries, EmbeddingCertificate & certificate)
{
  const std::size_t         halfEdges = 2 * certificate.packed.edges.size();
  const std::size_t         sides = 2 * static_cast<std::size_t>(certificate.genus);
  const int                 letters = 2 * certificate.genus;
  const std::vector<int>    edges = entries.Integers("generators.halfEdges", sides, 0, halfEdges);
  const std::vector<double> a = entries.Numbers("generators.a", 2 * sides);
  const std::vector<double> b = entries.Numbers("generators.b", 2 * sides);
  for (std::size_t k = 0; k < sides; ++k)
  {
    certificate.generators.push_back({ edges[k], { a[2 * k], a[2 * k + 1] }, { b[2 * k], b[2 * k + 1] } });
  }
  certificate.word = entries.Integers("word", 2 * sides, -letters, sides + 1);
  certificate.canonicalWords = entries.Words("canonicalWords", -letters, sides + 1);
  if (certificate.geometry == EmbeddingGeometry::Euclidean)
  {
    certificate.periods = entries.Numbers("periods", 4);
  }
}

void
TakeCircles(EntryReader & entries, std::size_t faces, EmbeddingCertificate & certificate)
{
  const auto        nodes = static_cast<std::size_t>(certificate.packed.nodes);
  const std::size_t coordinates = CoordinatesOf(certificate.geometry);
  certificate.nodeRadii = entries.Numbers("nodeRadii", nodes);
  certificate.nodePositions = entries.Numbers("nodePositions", coordinates * nodes);
  certificate.faceRadii = entries.Numbers("faceRadii", faces);
  certificate.facePositions = entries.Numbers("facePositions", coordinates * faces);
  if (certificate.geometry != EmbeddingGeometry::Spherical)
  {
    certificate.nodeAngles = entries.Numbers("nodeAngles", nodes);
    certificate.tree = entries.Integers("tree", nodes, -1, 2 * certificate.packed.edges.size());
    TakeDeckTransformations(entries, certificate);
  }
}

EmbeddingCertificate
CertificateOf(const std::string & path, EntryTables & tables)
{
  EntryReader          entries(path, tables);
  EmbeddingCertificate certificate;
  entries.Require(entries.Text("format") == "Shapeton embedding certificate", "format", "is not supported");
  entries.Require(entries.Integer("version", 1) == 1, "version", "is not 1");
  certificate.provenance = std::move(tables.provenance);
  certificate.statistics = std::move(tables.statistics);
  certificate.warnings = entries.Texts("warnings");
  certificate.geometry = GeometryOf(entries);
  certificate.genus = entries.Integer("genus", 0);
  entries.Require(certificate.genus <= std::numeric_limits<int>::max() / 8, "genus", "is too large");
  TakeGraph(entries, certificate);
  TakePackedMap(entries, tables.integer.count("packed.nodes") > 0, certificate);
  TakeCircles(entries, tables.numbers["faceRadii"].size(), certificate);
  return certificate;
}
} // namespace

EmbeddingCertificate
ReadEmbeddingCertificate(const std::string & path)
{
  EntryTables tables;
  {
    const std::string bytes = ReadFileBytes(path);
    EntryHandler      handler(path, bytes, tables);
    Json::sax_parse(bytes, &handler);
  }
  return CertificateOf(path, tables);
}
} // namespace shapeton
