#include "shapetonToolSurfaces.h"

#include "shapetonReadOptions.h"
#include "shapetonSha256.h"

namespace shapeton
{
namespace
{
SurfaceReadOptions
OptionsOf(const CommandLine & commandLine, SurfaceReadOptions options)
{
  ReadOptions(commandLine, options);
  return options;
}

void
AddFile(CommandLine & commandLine, const std::string & parameter)
{
  commandLine.AddInput(parameter, "sha256:" + Sha256OfFile(commandLine.GetString(parameter)));
}

Surface
ReadFile(CommandLine & commandLine, const std::string & parameter, const SurfaceReadOptions & options)
{
  Surface surface = ReadSurface(commandLine.GetString(parameter), OptionsOf(commandLine, options));
  commandLine.AddInput(parameter, surface.identity);
  return surface;
}
} // namespace

Surface
ReadSurface(CommandLine & commandLine, const std::string & parameter)
{
  SurfaceReadOptions options;
  options.takesOneComponent = true;
  Surface surface = ReadFile(commandLine, parameter, options);
  commandLine.Warn(surface.notes);
  return surface;
}

Surface
ReadSurfaceToInspect(CommandLine & commandLine, const std::string & parameter)
{
  return ReadFile(commandLine, parameter, {});
}

Surface
ReadRepairedSurface(CommandLine & commandLine, const std::string & parameter, const SurfaceReadOptions & options)
{
  Surface surface = ReadRepairedSurface(commandLine.GetString(parameter), OptionsOf(commandLine, options));
  commandLine.AddInput(parameter, surface.identity);
  commandLine.Warn(surface.notes);
  commandLine.Warn(surface.repairs);
  std::string repairs;
  for (const std::string & words : surface.repairs)
  {
    repairs += (repairs.empty() ? "" : "; ") + words;
  }
  if (!repairs.empty())
  {
    commandLine.AddProvenance("repairs", repairs);
  }
  return surface;
}

CurveSet
ReadCurves(CommandLine & commandLine, const std::string & parameter)
{
  CurveSet curves = ReadCurves(commandLine.GetString(parameter));
  RequireSound(curves, '"' + commandLine.GetString(parameter) + '"');
  AddFile(commandLine, parameter);
  return curves;
}

std::vector<Markup>
ReadMarkups(CommandLine & commandLine, const std::string & parameter)
{
  std::vector<Markup> markups = ReadMarkups(commandLine.GetString(parameter));
  AddFile(commandLine, parameter);
  return markups;
}
} // namespace shapeton
