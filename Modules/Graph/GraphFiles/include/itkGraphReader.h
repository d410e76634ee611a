#ifndef itkGraphReader_h
#define itkGraphReader_h

#include "GraphFilesExport.h"
#include "itkGraph.h"

#include <string>
#include <vector>

namespace itk
{
class CommandLine;

/** A graph and what its file said besides.
 * \ingroup GraphFiles */
struct GraphFile
{
  Graph graph;
  /** "GraphML", "GML", "DOT", "edge list", "METIS", "MATPOWER", "PACE", "graph6" or "sparse6". */
  std::string format;
  /** "sha256:...", of the bytes. */
  std::string identity;
  /** What a user may want to know, for example that branches out of service were left out. */
  std::vector<std::string> notes;
};

/** Reads an undirected graph. The content decides the format where it is unmistakable (XML, DOT, GML, MATPOWER, a line
 * "p ...", the header of graph6), else the extension:
 * .graphml .xml, .gml, .dot .gv, .txt .edges .edgelist .el .csv .tsv, .graph .metis, .m, .gr .col, .g6, .s6.
 *
 * Nodes stand in the order of the file and are called by its ids: names has one entry for each node. Loops and multiple
 * edges are kept, edges stand in the order of the file. Weights, labels and attributes are passed over.
 *
 * Throws InputError that names the file, the line and what to do: for a file that is empty, binary, malformed,
 * truncated, or holds more than one graph, a node that is declared twice, an edge to a node that is not declared, and a
 * directed graph (an embedding has no directions; whoever wants it drawn states it as undirected).
 * \ingroup GraphFiles */
GraphFiles_EXPORT GraphFile
ReadGraph(const std::string & path);

/** The same for the input parameter of a tool; states its identity and tells the notes as warnings.
 * \ingroup GraphFiles */
GraphFiles_EXPORT Graph
ReadGraph(CommandLine & commandLine, const std::string & parameter);

/** The files of a folder that holds one graph for each step, in the order of their names; hidden files and .json are
 * left out. Throws InputError when the folder cannot be read or has no such file. \ingroup GraphFiles */
GraphFiles_EXPORT std::vector<std::string>
                  GraphFilesOf(const std::string & folder);

/** Writes GraphML that ReadGraph reads back to the same graph; nodes without names are called n0, n1, ... Throws
 * OutputError.
 * \ingroup GraphFiles */
GraphFiles_EXPORT void
WriteGraphML(const Graph & graph, const std::string & path);
} // namespace itk

#endif
