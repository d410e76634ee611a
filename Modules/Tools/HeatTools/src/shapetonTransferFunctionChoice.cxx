#include "shapetonTransferFunctionChoice.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonSavedTransferFunction.h"
#include "shapetonSha256.h"

namespace shapeton
{
TransferFunctionChoice
ReadTransferFunctionChoice(CommandLine & commandLine)
{
  TransferFunctionChoice choice;
  if (const std::string path = commandLine.GetString("from"); !path.empty())
  {
    RequireParameter(!commandLine.IsGiven("lines") && !commandLine.IsGiven("timeStep"),
                     "--from sets lines and time step; remove --lines and --timeStep");
    const SavedTransferFunction saved = ReadTransferFunction(path);
    commandLine.AddInput("from", "sha256:" + Sha256OfFile(path));
    commandLine.AddProvenance("chosen.lines", saved.lines.ToText());
    commandLine.AddProvenance("chosen.timeStep", std::to_string(saved.timeStep));
    return { saved.lines, saved.timeStep, saved.quantity };
  }
  if (const std::string lines = commandLine.GetString("lines"); !lines.empty())
  {
    choice.lines = ShapeTransferFunction::Parse(lines);
  }
  if (const int timeStep = commandLine.GetInteger("timeStep"); timeStep >= 0)
  {
    choice.timeStep = timeStep;
  }
  return choice;
}

void
RequireQuantity(const TransferFunctionChoice & choice, const ShapeQuantity & found, const std::string & path)
{
  if (!choice.quantity.empty() && choice.quantity != found.name)
  {
    throw InputError("the lines were picked on " + choice.quantity + ", but " + path + " contains " + found.name +
                     ": use the volume they were picked on");
  }
}
} // namespace shapeton
