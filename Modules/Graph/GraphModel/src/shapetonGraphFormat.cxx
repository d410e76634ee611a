#include "shapetonGraphFormat.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

namespace shapeton
{
namespace
{
const GraphFormat GraphMLFormat{ "GraphML", ReadGraphML };
const GraphFormat GmlFormat{ "GML", ReadGml };
const GraphFormat DotFormat{ "DOT", ReadDot };
const GraphFormat EdgeListFormat{ "edge list", ReadEdgeList };
const GraphFormat MetisFormat{ "METIS", ReadMetis };
const GraphFormat MatpowerFormat{ "MATPOWER", ReadMatpower };
const GraphFormat PaceFormat{ "PACE", ReadPace };
const GraphFormat Graph6Format{ "graph6", ReadGraph6 };
const GraphFormat Sparse6Format{ "sparse6", ReadSparse6 };

const GraphFormat *
FormatOfExtension(const std::string & path)
{
  static const std::map<std::string, const GraphFormat *> formats = {
    { ".graphml", &GraphMLFormat }, { ".xml", &GraphMLFormat },    { ".gml", &GmlFormat },
    { ".dot", &DotFormat },         { ".gv", &DotFormat },         { ".txt", &EdgeListFormat },
    { ".edges", &EdgeListFormat },  { ".el", &EdgeListFormat },    { ".edgelist", &EdgeListFormat },
    { ".csv", &EdgeListFormat },    { ".tsv", &EdgeListFormat },   { ".graph", &MetisFormat },
    { ".metis", &MetisFormat },     { ".m", &MatpowerFormat },     { ".gr", &PaceFormat },
    { ".col", &PaceFormat },        { ".g6", &Graph6Format },      { ".graph6", &Graph6Format },
    { ".s6", &Sparse6Format },      { ".sparse6", &Sparse6Format }
  };
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  const auto found = formats.find(extension);
  return found != formats.end() ? found->second : nullptr;
}

/** The words of the first lines that are not comments in any format. */
std::vector<std::string_view>
FirstWords(std::string_view bytes)
{
  std::vector<std::string_view> words;
  LineReader                    lines(bytes);
  for (std::string_view line; words.size() < 4 && lines.Next(line);)
  {
    const std::vector<std::string_view> pieces = Words(line, "{");
    const bool isComment = pieces.empty() || pieces[0][0] == '%' || pieces[0][0] == '#' || pieces[0] == "c" ||
                           pieces[0].substr(0, 2) == "//" || pieces[0].substr(0, 2) == "/*" || pieces[0][0] == '*';
    if (!isComment)
    {
      words.insert(words.end(), pieces.begin(), pieces.end());
    }
  }
  return words;
}

bool
StartsWith(std::string_view text, std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

/** The format if the first words identify it unambiguously. */
const GraphFormat *
FormatOfContent(std::string_view bytes)
{
  const std::vector<std::string_view> words = FirstWords(bytes);
  const std::string_view              first = words.empty() ? std::string_view() : words[0];
  const std::string_view              second = words.size() < 2 ? std::string_view() : words[1];
  if (StartsWith(first, ">>graph6<<"))
  {
    return &Graph6Format;
  }
  if (StartsWith(first, ">>sparse6<<"))
  {
    return &Sparse6Format;
  }
  if (StartsWith(first, "<"))
  {
    return &GraphMLFormat;
  }
  if (first == "Creator" || first == "Version" || first == "graph[" || (first == "graph" && StartsWith(second, "[")))
  {
    return &GmlFormat;
  }
  if (EqualWithoutCase(first, "strict") || EqualWithoutCase(first, "graph") || EqualWithoutCase(first, "digraph"))
  {
    return &DotFormat;
  }
  if (first == "function" || StartsWith(first, "mpc.") || StartsWith(first, "mpc="))
  {
    return &MatpowerFormat;
  }
  return first == "p" ? &PaceFormat : nullptr;
}

/** A format that is recognized but not read. */
struct OtherFormat
{
  std::string_view start; ///< of the first word, in lower case
  std::string_view name;
  std::string_view advice;
};

void
RefuseOtherFormats(const GraphText & text)
{
  constexpr std::string_view networkx = "convert it to GraphML, for example with networkx (read_pajek, write_graphml)";
  constexpr std::string_view igraph = "convert it to GraphML, for example with igraph (read.graph, write.graph)";
  constexpr std::string_view edges = "write its edges without direction as an edge list, two node names per line";
  constexpr OtherFormat      others[]{ { "*vertices", "Pajek", networkx },
                                       { "*network", "Pajek", networkx },
                                       { "dl", "DL of UCINET", igraph },
                                       { "graph:", "VCG", "convert it to DOT, for example with graph-easy" },
                                       { ">>digraph6<<", "digraph6, whose graph is directed", edges },
                                       { "&", "digraph6, whose graph is directed", edges } };
  LineReader                 lines(text.bytes);
  std::string_view           line;
  while (lines.Next(line) && Words(line).empty())
  {}
  const std::vector<std::string_view> words = Words(line, ",=");
  const std::string_view              first = words.empty() ? std::string_view() : words[0];
  for (const OtherFormat & other : others)
  {
    const bool isAmbiguous = other.start == "dl" ? words.size() > 1 && !EqualWithoutCase(words[1], "n")
                                                 : other.start == "&" && words.size() > 1;
    const bool isWord = other.start != "dl" || first.size() == other.start.size();
    if (isWord && !isAmbiguous && EqualWithoutCase(first.substr(0, other.start.size()), other.start))
    {
      text.Refuse(0, "the format is " + std::string(other.name) + ", which is not read", std::string(other.advice));
    }
  }
}

void
RequireText(const GraphText & text)
{
  const std::pair<std::string_view, const char *> archives[]{ { "\x1F\x8B", "gunzip" },
                                                              { "BZh", "bunzip2" },
                                                              { "\xFD"
                                                                "7zXZ",
                                                                "unxz" },
                                                              { "PK\3\4", "unzip" } };
  for (const auto & [magic, program] : archives)
  {
    text.Require(!StartsWith(text.bytes, magic),
                 0,
                 "the file is compressed",
                 std::string("decompress it, for example with ") + program);
  }
  text.Require(text.bytes.find_first_not_of(" \t\r\n\f\v") != std::string::npos,
               0,
               "the file is empty",
               "use a file that contains a graph");
  const bool isBinary = std::any_of(text.bytes.begin(), text.bytes.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x09 || (byte > 0x0D && byte < 0x20 && byte != 0x1A && byte != 0x1B);
  });
  text.Require(!isBinary,
               0,
               "the file is binary, but all graph formats are text",
               "use GraphML, GML, DOT, an edge list, METIS, MATPOWER, PACE or graph6");
}
} // namespace

GraphFormat
FormatOf(const GraphText & text)
{
  RequireText(text);
  RefuseOtherFormats(text);
  if (const GraphFormat * const format = FormatOfContent(text.bytes))
  {
    return *format;
  }
  const GraphFormat * const format = FormatOfExtension(text.path);
  text.Require(format != nullptr,
               0,
               "the graph format is not recognized by extension or content",
               "name it .graphml, .gml, .dot, .edges, .graph (METIS), .m (MATPOWER), .gr (PACE) or .g6 (graph6)");
  return *format;
}
} // namespace shapeton
