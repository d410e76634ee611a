#include "ColonPhantomXML.h"

#include "shapetonToolSurfaces.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonColonPhantomOptions.h"
#include "shapetonColonTruthWriter.h"
#include "shapetonCommandLine.h"
#include "shapetonDicomSeriesWriter.h"
#include "shapetonOrthonormalDirection.h"
#include "shapetonPhantomGrid.h"
#include "shapetonPrintable.h"
#include "shapetonReadOptions.h"
#include "shapetonExceptions.h"

#include <map>

namespace
{
using namespace shapeton;

using Source = ColonPhantomImageSource;

Source::Pointer
MakeSource(CommandLine & commandLine)
{
  const double       extent[3] = { 358.4, 358.4, 336.0 }; // mm
  PhantomGridOptions gridOptions;
  ReadOptions(commandLine, gridOptions);
  const auto grid =
    MakePhantomGrid(gridOptions, sizeof(short) + 3 * sizeof(unsigned char), itk::Vector<double, 3>(extent));
  RequireParameter(!IsLeftHanded(grid.direction),
                   "--direction: a CT series cannot have left-handed axes; change the sign of one column");
  const auto source = Source::New();
  source->SetSize(grid.size);
  source->SetSpacing(grid.spacing);
  source->SetDirection(grid.direction);
  source->CenterOutput(ReadPhantomCenter(commandLine));
  source->SetParameters(ReadColonPhantomParameters(commandLine));
  return source;
}

// All positions of a patient are in one study.
DicomSeriesDescription
Describe(const CommandLine & commandLine)
{
  const std::map<std::string, std::pair<const char *, int>> positions{ { "supine", { "HFS", 1 } },
                                                                       { "prone", { "HFP", 2 } },
                                                                       { "leftDecubitus", { "HFDL", 3 } },
                                                                       { "rightDecubitus", { "HFDR", 4 } } };
  const std::string                                         position = commandLine.GetString("position");
  DicomSeriesDescription                                    description;
  description.patientName = "Phantom^Colon";
  description.patientID = "COLON-" + std::to_string(commandLine.GetInteger("seed"));
  description.studyDescription = "CT colonography phantom";
  description.seriesDescription = "Colon, " + position;
  description.patientPosition = positions.at(position).first;
  description.seriesNumber = positions.at(position).second;
  description.seed = static_cast<unsigned>(commandLine.GetInteger("seed"));
  description.comments = ProvenanceComment(commandLine.GetProvenance());
  return description;
}

// Correspondence of another position of this patient; empty without the option.
CurveSet
ReadOtherPosition(CommandLine & commandLine)
{
  if (!commandLine.IsGiven("pairWith"))
  {
    return {};
  }
  RequireParameter(commandLine.IsGiven("truth"), "--pairWith requires --truth, the folder where points.csv is written");
  CurveSet          other = ReadCurves(commandLine, "pairWith");
  const std::string seed = commandLine.GetString("seed");
  for (const auto & [name, value] : other.facts)
  {
    if (name == "Shapeton.option.seed" && value != seed)
    {
      throw InputError("--pairWith: the points of \"" + commandLine.GetString("pairWith") + "\" have the seed " +
                       value + ", not " + seed + "; both positions must show the same patient");
    }
  }
  return other;
}

void
MakePhantom(CommandLine & commandLine)
{
  const std::string folder = WithoutTrailingSlashes(commandLine.GetString("outputFolder"));
  const std::string truth = WithoutTrailingSlashes(commandLine.GetString("truth"));
  commandLine.RequireOutside("truth", folder);
  commandLine.LeaveOutOfProvenance("truth");
  const CurveSet other = ReadOtherPosition(commandLine);
  const auto     source = MakeSource(commandLine);
  RequireParameter(other.curves.empty() || Contains(source->GetParameters(), "colon"),
                   "--pairWith requires the colon; add colon to --contents");
  commandLine.MakeParentFolder(folder);
  CheckDicomSeriesFolder(folder);
  commandLine.Watch(source, "Scanning the phantom", 0.0, 0.9);
  source->Update();
  if (!truth.empty())
  {
    commandLine.MakeFolder(truth);
    WriteColonTruth(
      *source,
      commandLine.GetProvenance(),
      truth,
      [&](const std::string & path) { return commandLine.Output(path); },
      other.curves.empty() ? nullptr : &other);
  }
  WriteDicomSeriesFolder(source->GetOutput(), folder, Describe(commandLine));
  commandLine.RecordRun(folder + ".run.json");
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, MakePhantom);
}
