#include "itkGraphReader.h"
#include "itkCommandLine.h"
#include "itkFileBytes.h"
#include "itkGraphFormat.h"
#include "itkSha256.h"

namespace itk
{
GraphFile
ReadGraph(const std::string & path)
{
  GraphText text{ path, ReadFileBytes(path) };
  GraphFile file;
  file.identity = "sha256:" + Sha256OfBytes(text.bytes);
  if (text.bytes.compare(0, 3, "\xEF\xBB\xBF") == 0) // a byte order mark, as some editors write it
  {
    text.bytes.erase(0, 3);
  }
  const GraphFormat format = FormatOf(text);
  file.format = format.name;
  file.graph = format.read(text, file.notes);
  RequireSound(file.graph, '"' + path + '"');
  return file;
}

Graph
ReadGraph(CommandLine & commandLine, const std::string & parameter)
{
  GraphFile file = ReadGraph(commandLine.GetString(parameter));
  commandLine.AddInput(parameter, file.identity);
  for (const std::string & note : file.notes)
  {
    commandLine.Warn(note);
  }
  return std::move(file.graph);
}
} // namespace itk
