#include "shapetonTransferFunctionChoice.h"

#include "shapetonCommandLine.h"
#include "shapetonExceptions.h"
#include "shapetonSavedTransferFunction.h"
#include "shapetonSeedFiles.h"
#include "shapetonSha256.h"
#include "shapetonVolumeReader.h"

namespace shapeton
{
namespace
{
/** Colored objects require their labels. */
void
RequireObjects(CommandLine & commandLine, const TransferFunctionChoice & choice)
{
  const bool isGiven = commandLine.IsGiven("objects");
  RequireParameter(choice.objects.empty() || isGiven,
                   commandLine.GetString("from") +
                     " colors objects: state their labels, written by HeatObjects, with --objects");
  RequireParameter(!choice.objects.empty() || !isGiven, "--objects requires a file with colored objects for --from");
  if (isGiven)
  {
    commandLine.AddProvenance("chosen.objects", TextOf(choice.objects));
  }
}
} // namespace

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
    choice = { saved.lines, saved.timeStep, saved.quantity, saved.objects };
  }
  RequireObjects(commandLine, choice);
  if (choice.lines)
  {
    return choice;
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

ColoredClasses
ColorChoice(CommandLine &                  commandLine,
            const TransferFunctionChoice & choice,
            const itk::Image<float, 3> *   values,
            const ShapeTransferFunction &  lines)
{
  if (choice.objects.empty())
  {
    return { values, lines };
  }
  commandLine.Warn("the volume property shows heat ranges only, not the objects");
  const std::string path = commandLine.GetString("objects");
  const Volume      volume = ReadVolume(path);
  commandLine.AddInput("objects", volume.identity);
  return ColorObjects(values, lines, LabelsOfVolume(volume, path, values), choice.objects, path);
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
