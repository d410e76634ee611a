#include "shapetonRotationFile.h"

#include "shapetonEmbeddingCertificate.h"
#include "shapetonFileBytes.h"
#include "shapetonExceptions.h"

#include <filesystem>
#include <map>
#include <sstream>
#include <unordered_map>

namespace shapeton
{
namespace
{
class RotationText
{
public:
  RotationText(const Graph & graph, const std::string & path) : m_Graph(graph), m_Path(path), m_Rotation(graph.nodes)
  {
    for (int node = 0; node < graph.nodes; ++node)
    {
      m_NodeOfName.emplace(NameOfNode(graph, node), node);
    }
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
    {
      const auto & [from, to] = graph.edges[e];
      const int h = static_cast<int>(2 * e);
      if (from == to || !m_HalfEdge.emplace(std::pair(from, to), h).second ||
          !m_HalfEdge.emplace(std::pair(to, from), h + 1).second)
      {
        throw InputError('"' + path + "\": a text rotation requires a graph without loops and multiple edges; use a " +
                         "certificate (.json) instead");
      }
    }
  }

  Rotation
  Read(std::istream & text)
  {
    std::string line;
    while (std::getline(text, line))
    {
      ++m_Line;
      this->ReadLine(line);
    }
    const CombinatorialMap check = this->Checked();
    return check.GetRotation();
  }

private:
  [[noreturn]] void
  Fail(const std::string & what) const
  {
    throw InputError('"' + m_Path + "\", line " + std::to_string(m_Line) + ": " + what);
  }

  int
  Node(const std::string & name) const
  {
    const auto found = m_NodeOfName.find(name);
    if (found == m_NodeOfName.end())
    {
      this->Fail("the graph has no node \"" + name.substr(0, LongestName) + '"');
    }
    return found->second;
  }

  void
  ReadLine(const std::string & line)
  {
    std::istringstream words(line);
    std::string        word;
    if (!(words >> word) || word[0] == '#')
    {
      return;
    }
    if (word.size() > 1 && word.back() == ':')
    {
      word.pop_back();
    }
    const int          node = this->Node(word);
    std::vector<int> & around = m_Rotation[node];
    if (!around.empty())
    {
      this->Fail("node \"" + word + "\" has two lines");
    }
    while (words >> word)
    {
      const auto found = m_HalfEdge.find(std::pair(node, this->Node(word)));
      if (found == m_HalfEdge.end())
      {
        this->Fail("the graph has no edge from this node to \"" + word.substr(0, LongestName) + '"');
      }
      around.push_back(found->second);
    }
  }

  CombinatorialMap
  Checked() const
  {
    try
    {
      return { m_Graph, m_Rotation };
    }
    catch (const InputError & error)
    {
      throw InputError('"' + m_Path + "\" is not a rotation system of the graph: " + error.what());
    }
  }

  const Graph &                        m_Graph;
  std::string                          m_Path;
  int                                  m_Line{ 0 };
  std::unordered_map<std::string, int> m_NodeOfName;
  std::map<std::pair<int, int>, int>   m_HalfEdge;
  Rotation                             m_Rotation;
};

CombinatorialMap
FromCertificate(const Graph & graph, const std::string & path)
{
  const EmbeddingCertificate certificate = ReadEmbeddingCertificate(path);
  if (certificate.graph.nodes != graph.nodes || certificate.graph.edges != graph.edges ||
      certificate.graph.names != graph.names)
  {
    throw InputError('"' + path +
                     "\" is the certificate of another graph; its nodes and edges must be the same and in the "
                     "same order");
  }
  return MapOfRotation(graph, certificate.rotation);
}
} // namespace

CombinatorialMap
ReadRotation(const Graph & graph, const std::string & path)
{
  if (std::filesystem::path(path).extension() == ".json")
  {
    return FromCertificate(graph, path);
  }
  std::istringstream text(ReadFileBytes(path));
  return { graph, RotationText(graph, path).Read(text) };
}
} // namespace shapeton
