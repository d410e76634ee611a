#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonGraphReader.h"
#include "shapetonPrintable.h"

#include <algorithm>
#include <set>

namespace shapeton
{
namespace
{
std::string
Escaped(const std::string & text)
{
  std::string escaped;
  for (const char c : text)
  {
    switch (c)
    {
      case '<':
        escaped += "&lt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\t':
        escaped += "&#9;";
        break;
      case '\n':
        escaped += "&#10;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}
/** Names identify nodes, and XML 1.0 has no other control characters. */
void
RequireNames(const Graph & graph)
{
  RequireParameter(graph.names.empty() || graph.names.size() == static_cast<std::size_t>(graph.nodes),
                   "the graph has " + std::to_string(graph.nodes) + " nodes but " + std::to_string(graph.names.size()) +
                     " names");
  std::set<std::string> names;
  for (const std::string & name : graph.names)
  {
    const bool isText =
      std::none_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' && c != '\t' && c != '\n'; });
    RequireParameter(!name.empty() && isText, "a node has an empty name or one with control characters; rename it");
    RequireParameter(names.insert(name).second, "two nodes have the name " + Quoted(name) + "; rename one");
  }
}
} // namespace

void
WriteGraphML(const Graph & graph, const std::string & path)
{
  RequireEnds(graph, Quoted(path));
  RequireNames(graph);
  const auto idOf = [&](int node) {
    return graph.names.empty() ? 'n' + std::to_string(node) : Escaped(graph.names[node]);
  };
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                     "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
                     "<graph id=\"G\" edgedefault=\"undirected\">\n";
  for (int node = 0; node < graph.nodes; ++node)
  {
    text += "<node id=\"" + idOf(node) + "\"/>\n";
  }
  for (const auto & [first, second] : graph.edges)
  {
    text += "<edge source=\"" + idOf(first) + "\" target=\"" + idOf(second) + "\"/>\n";
  }
  WriteFileBytes(path, text + "</graph>\n</graphml>\n");
}
} // namespace shapeton
