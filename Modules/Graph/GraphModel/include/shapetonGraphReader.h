#ifndef shapetonGraphReader_h
#define shapetonGraphReader_h

#include "ShapetonGraphModelExport.h"
#include "shapetonRemarks.h"
#include "shapetonGraph.h"

#include <string>
#include <vector>

namespace shapeton
{
/** A graph with metadata from its file. \ingroup ShapetonGraphModel */
struct GraphFile
{
  Graph graph;
  /** "GraphML", "GML", "DOT", "edge list", "METIS", "MATPOWER", "PACE", "graph6" or "sparse6". */
  std::string format;
  /** "sha256:...", of the bytes. */
  std::string identity;
  /** Remarks for the user, for example that branches out of service were skipped. */
  Remarks notes;
};

/** Reads an undirected graph. The format is detected from the content if unambiguous (XML, DOT, GML, MATPOWER, a line
 * "p ...", the header of graph6), else from the extension:
 * .graphml .xml, .gml, .dot .gv, .txt .edges .edgelist .el .csv .tsv, .graph .metis, .m, .gr .col, .g6, .s6.
 *
 * Nodes and edges keep their order in the file. Node names are the ids in the file. Loops and multiple
 * edges are kept. Weights, labels and attributes are ignored.
 *
 * Throws InputError with the file, the line and the remedy if a file is empty, binary, malformed or truncated, or
 * contains more than one graph; if a node is declared twice or an edge uses an undeclared node; and for a directed
 * graph (embeddings are undirected; convert it to an undirected graph first). \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT GraphFile
ReadGraph(const std::string & path);

/** Files in a folder with one graph per step, sorted by name; hidden files and .json are skipped. Throws InputError if
 * the folder cannot be read or does not contain graph files. \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT std::vector<std::string>
                          GraphFilesOf(const std::string & folder);

/** Writes GraphML from which ReadGraph restores the same graph; unnamed nodes are called n0, n1, ... Throws
 * ParameterError for names that are not unique, empty or have control characters, and OutputError.
 * \ingroup ShapetonGraphModel */
ShapetonGraphModel_EXPORT void
WriteGraphML(const Graph & graph, const std::string & path);
} // namespace shapeton

#endif
