#ifndef shapetonGraphFormat_h
#define shapetonGraphFormat_h

#include "shapetonGraphReader.h"
#include "shapetonGraphText.h"

#include <string>

namespace shapeton
{
/** A format: its name and its reader. */
struct GraphFormat
{
  const char * name;
  Graph (*read)(const GraphText & text, std::vector<std::string> & notes);
};

/** Detects the format of a file by content or extension; rejects unknown formats. */
GraphFormat
FormatOf(const GraphText & text);

/** \name Readers. They append to `notes` and throw InputError. */
///@{
Graph
ReadGraphML(const GraphText & text, std::vector<std::string> & notes);
Graph
ReadGml(const GraphText & text, std::vector<std::string> & notes);
Graph
ReadDot(const GraphText & text, std::vector<std::string> & notes);
Graph
ReadEdgeList(const GraphText & text, std::vector<std::string> & notes);
Graph
ReadMetis(const GraphText & text, std::vector<std::string> & notes);
Graph
ReadMatpower(const GraphText & text, std::vector<std::string> & notes);
Graph
ReadPace(const GraphText & text, std::vector<std::string> & notes);
Graph
ReadGraph6(const GraphText & text, std::vector<std::string> & notes);
Graph
ReadSparse6(const GraphText & text, std::vector<std::string> & notes);
///@}
} // namespace shapeton

#endif
