#include "shapetonFileBytes.h"
#include "shapetonGraphReader.h"

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
} // namespace

void
WriteGraphML(const Graph & graph, const std::string & path)
{
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
