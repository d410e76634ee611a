#ifndef shapetonGraphReader_h
#define shapetonGraphReader_h

#include "GraphModelExport.h"
#include "shapetonRemarks.h"
#include "shapetonGraph.h"

#include <string>
#include <vector>

namespace shapeton
{
/** A graph and what its file said besides.
 * \ingroup GraphModel */
struct GraphFile
{
  Graph graph;
  /** "GraphML", "GML", "DOT", "edge list", "METIS", "MATPOWER", "PACE", "graph6" or "sparse6". */
  std::string format;
  /** "sha256:...", of the bytes. */
  std::string identity;
  /** What a user may want to know, for example that branches out of service were left out. */
  Remarks notes;
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
 * \ingroup GraphModel */
GraphModel_EXPORT GraphFile
ReadGraph(const std::string & path);

/** The files of a folder that holds one graph for each step, in the order of their names; hidden files and .json are
 * left out. Throws InputError when the folder cannot be read or has no such file. \ingroup GraphModel */
GraphModel_EXPORT std::vector<std::string>
                  GraphFilesOf(const std::string & folder);

/** Writes GraphML that ReadGraph reads back to the same graph; nodes without names are called n0, n1, ... Throws
 * OutputError.
 * \ingroup GraphModel */
GraphModel_EXPORT void
WriteGraphML(const Graph & graph, const std::string & path);
} // namespace shapeton

#endif
