#include "shapetonEmbeddingCertificate.h"
#include "shapetonJson.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace shapeton
{
namespace
{
/** Checked access to the entries of a file by key path, such as "graph.edges". Unknown entries are ignored. */
class EntryReader
{
public:
  explicit EntryReader(const std::string & path) : m_Path(path), m_Document(ReadJson(path)) {}

  bool
  Has(const std::string & key) const
  {
    return this->Find(key) != nullptr;
  }

  std::string
  Text(const std::string & key) const
  {
    const Json * const value = this->Find(key);
    Require(value != nullptr && value->is_string(), key, "is missing or not a string");
    return value->get<std::string>();
  }

  int
  Integer(const std::string & key, int least) const
  {
    const Json * const value = this->Find(key);
    Require(value != nullptr && IsIndex(*value), key, "is missing or not an integer");
    Require(value->get<int>() >= least, key, "is less than " + std::to_string(least));
    return value->get<int>();
  }

  /** Empty if the entry is missing, as for all lists. */
  std::vector<double>
  Numbers(const std::string & key) const
  {
    return this->ListOf<double>(key, &Json::is_number, "a number");
  }

  std::vector<double>
  Numbers(const std::string & key, std::size_t size) const
  {
    std::vector<double> values = this->Numbers(key);
    RequireSize(key, values.size(), size);
    return values;
  }

  /** `size` integers in [least, end). */
  std::vector<int>
  Integers(const std::string & key, std::size_t size, int least, std::size_t end) const
  {
    std::vector<int> values = this->ListOf<int>(key, IsIndex, "an integer");
    RequireSize(key, values.size(), size);
    RequireRange(key, values, least, end);
    return values;
  }

  std::vector<std::array<int, 2>>
  Edges(const std::string & key, int nodes) const
  {
    const std::vector<int> ends = this->ListOf<int>(key, IsIndex, "an integer");
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
  Words(const std::string & key, int least, std::size_t end) const
  {
    const auto isWord = [](const Json & value) {
      return value.is_array() && std::all_of(value.begin(), value.end(), IsIndex);
    };
    std::vector<std::vector<int>> words = this->ListOf<std::vector<int>>(key, isWord, "a list of integers");
    for (const std::vector<int> & word : words)
    {
      RequireRange(key, word, least, end);
    }
    return words;
  }

  std::vector<std::string>
  Texts(const std::string & key) const
  {
    return this->ListOf<std::string>(key, &Json::is_string, "a string");
  }

  /** Names and values of an object, in file order. */
  template <typename TValue, typename TTest>
  std::vector<std::pair<std::string, TValue>>
  Facts(const std::string & key, const TTest & isValue) const
  {
    std::vector<std::pair<std::string, TValue>> facts;
    const Json * const                          object = this->Find(key);
    Require(object == nullptr || object->is_object(), key, "is not an object");
    if (object == nullptr)
    {
      return facts;
    }
    for (const auto & [name, value] : object->items())
    {
      Require(std::invoke(isValue, value), key + '.' + name, "holds a value of another type");
      facts.emplace_back(name, value.template get<TValue>());
    }
    return facts;
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
  static bool
  IsIndex(const Json & value)
  {
    return value.is_number_integer() && value.get<double>() >= std::numeric_limits<int>::min() &&
           value.get<double>() <= std::numeric_limits<int>::max();
  }

  /** Null if the file has no such entry. */
  const Json *
  Find(const std::string & key) const
  {
    const Json * value = &m_Document;
    for (std::size_t begin = 0, end = 0; end != std::string::npos && value != nullptr; begin = end + 1)
    {
      end = key.find('.', begin);
      const auto found = value->is_object() ? value->find(key.substr(begin, end - begin)) : value->end();
      value = found != value->end() ? &*found : nullptr;
    }
    return value;
  }

  template <typename TValue, typename TTest>
  std::vector<TValue>
  ListOf(const std::string & key, const TTest & isValue, const std::string & kind) const
  {
    const Json * const list = this->Find(key);
    if (list == nullptr)
    {
      return {};
    }
    Require(list->is_array(), key, "is not a list");
    const auto wrong = std::find_if_not(list->begin(), list->end(), std::cref(isValue));
    Require(wrong == list->end(), key, "holds " + (wrong == list->end() ? "" : wrong->dump()) + ", not " + kind);
    return list->get<std::vector<TValue>>();
  }

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

  std::string m_Path;
  Json        m_Document;
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
TakeGraph(const EntryReader & entries, EmbeddingCertificate & certificate)
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
TakePackedMap(const EntryReader & entries, EmbeddingCertificate & certificate)
{
  Graph & packed = certificate.packed;
  if (!entries.Has("packed"))
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
TakeDeckTransformations(const EntryReader & entries, EmbeddingCertificate & certificate)
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
TakeCircles(const EntryReader & entries, EmbeddingCertificate & certificate)
{
  const auto        nodes = static_cast<std::size_t>(certificate.packed.nodes);
  const std::size_t coordinates = CoordinatesOf(certificate.geometry);
  certificate.nodeRadii = entries.Numbers("nodeRadii", nodes);
  certificate.nodePositions = entries.Numbers("nodePositions", coordinates * nodes);
  certificate.faceRadii = entries.Numbers("faceRadii");
  certificate.facePositions = entries.Numbers("facePositions", coordinates * certificate.faceRadii.size());
  if (certificate.geometry != EmbeddingGeometry::Spherical)
  {
    certificate.nodeAngles = entries.Numbers("nodeAngles", nodes);
    certificate.tree = entries.Integers("tree", nodes, -1, 2 * certificate.packed.edges.size());
    TakeDeckTransformations(entries, certificate);
  }
}

} // namespace

EmbeddingCertificate
ReadEmbeddingCertificate(const std::string & path)
{
  const EntryReader    entries(path);
  EmbeddingCertificate certificate;
  entries.Require(entries.Text("format") == "Shapeton embedding certificate", "format", "is not supported");
  entries.Require(entries.Integer("version", 1) == 1, "version", "is not 1");
  certificate.provenance = entries.Facts<std::string>("provenance", &Json::is_string);
  certificate.statistics = entries.Facts<double>("statistics", &Json::is_number);
  certificate.warnings = entries.Texts("warnings");
  certificate.geometry = GeometryOf(entries);
  certificate.genus = entries.Integer("genus", 0);
  entries.Require(certificate.genus <= std::numeric_limits<int>::max() / 8, "genus", "is too large");
  TakeGraph(entries, certificate);
  TakePackedMap(entries, certificate);
  TakeCircles(entries, certificate);
  return certificate;
}
} // namespace shapeton
