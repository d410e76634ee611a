#include "ColonPhantomXML.h"

#include "itkToolSurfaces.h"
#include "itkColonPhantomImageSource.h"
#include "itkColonTruthWriter.h"
#include "itkCommandLine.h"
#include "itkDicomSeriesWriter.h"
#include "itkOrthonormalDirection.h"
#include "itkPhantomGrid.h"
#include "itkExceptions.h"

#include <map>

namespace
{
using Source = itk::ColonPhantomImageSource;

template <typename TNumber>
void
Override(const itk::CommandLine & commandLine, const char * name, TNumber & value)
{
  if (commandLine.IsGiven(name))
  {
    value = static_cast<TNumber>(commandLine.GetDouble(name));
  }
}

void
OverrideCount(const itk::CommandLine & commandLine, const char * name, int & value)
{
  if (commandLine.IsGiven(name))
  {
    value = commandLine.GetInteger(name);
  }
}

// Options that are not given, or -1, have the value of the preset.
itk::ColonPhantomParameters
ReadParameters(const itk::CommandLine & commandLine)
{
  auto parameters = itk::ColonPhantomPreset(commandLine.GetString("preset"));
  parameters.position = commandLine.GetString("position");
  parameters.seed = static_cast<unsigned>(commandLine.GetInteger("seed"));
  OverrideCount(commandLine, "polyps", parameters.polyps);
  OverrideCount(commandLine, "collapsed", parameters.collapsed);
  OverrideCount(commandLine, "fakeHandles", parameters.fakeHandles);
  Override(commandLine, "fluid", parameters.fluid);
  Override(commandLine, "roughness", parameters.roughness);
  Override(commandLine, "flattenedFolds", parameters.flattenedFolds);
  Override(commandLine, "foldSlide", parameters.foldSlide);
  Override(commandLine, "distension", parameters.distension);
  Override(commandLine, "torsion", parameters.torsion);
  Override(commandLine, "noise", parameters.noise);
  itk::RequireValid(parameters);
  return parameters;
}

Source::Pointer
MakeSource(const itk::CommandLine & commandLine)
{
  const double extent[3] = { 358.4, 358.4, 336.0 }; // mm
  const auto   grid =
    itk::MakePhantomGrid(commandLine.GetIntegers("size"), commandLine.GetDoubles("spacing"), commandLine.GetDoubles("direction"), sizeof(short) + 2 * sizeof(unsigned char), itk::Vector<double, 3>(extent));
  itk::RequireParameter(!itk::IsLeftHanded(grid.direction),
                    "--direction: a CT series cannot have left-handed axes; change the sign of one column");
  const auto source = Source::New();
  source->SetSize(grid.size);
  source->SetSpacing(grid.spacing);
  source->SetDirection(grid.direction);
  source->CenterOutput();
  source->SetParameters(ReadParameters(commandLine));
  return source;
}

// The positions of one patient belong to one study.
itk::DicomSeriesDescription
Describe(const itk::CommandLine & commandLine)
{
  const std::map<std::string, std::pair<const char *, int>> positions{ { "supine", { "HFS", 1 } },
                                                                       { "prone", { "HFP", 2 } },
                                                                       { "leftDecubitus", { "HFDL", 3 } },
                                                                       { "rightDecubitus", { "HFDR", 4 } } };
  const std::string                                         position = commandLine.GetString("position");
  itk::DicomSeriesDescription                               description;
  description.patientName = "Phantom^Colon";
  description.patientID = "COLON-" + std::to_string(commandLine.GetInteger("seed"));
  description.studyDescription = "CT colonography phantom";
  description.seriesDescription = "Colon, " + position;
  description.patientPosition = positions.at(position).first;
  description.seriesNumber = positions.at(position).second;
  description.seed = static_cast<unsigned>(commandLine.GetInteger("seed"));
  description.comments = itk::ProvenanceComment(commandLine.GetProvenance());
  return description;
}

// Of another position of this patient; no curves where the option is not given.
itk::CurveSet
ReadOtherPosition(itk::CommandLine & commandLine)
{
  if (!commandLine.IsGiven("pairWith"))
  {
    return {};
  }
  itk::RequireParameter(commandLine.IsGiven("truth"), "--pairWith writes points.csv into the folder of --truth; give one");
  itk::CurveSet     other = itk::ReadCurves(commandLine, "pairWith");
  const std::string seed = commandLine.GetString("seed");
  for (const auto & [name, value] : other.facts)
  {
    if (name == "Shapeton.option.seed" && value != seed)
    {
      throw itk::InputError("--pairWith: the points of \"" + commandLine.GetString("pairWith") + "\" are of seed " +
                            value + ", not of " + seed + "; the positions must be of one patient");
    }
  }
  return other;
}

void
MakePhantom(itk::CommandLine & commandLine)
{
  const std::string folder = itk::WithoutTrailingSlashes(commandLine.GetString("outputFolder"));
  const std::string truth = itk::WithoutTrailingSlashes(commandLine.GetString("truth"));
  itk::RequireParameter(folder != truth, "--truth: the series needs a folder of its own");
  commandLine.LeaveOutOfProvenance("truth");
  const itk::CurveSet other = ReadOtherPosition(commandLine);
  const auto          source = MakeSource(commandLine);
  itk::CheckDicomSeriesFolder(folder);
  commandLine.Watch(source, "Scanning the phantom", 0.0, 0.9);
  source->Update();
  if (!truth.empty())
  {
    itk::WriteColonTruth(commandLine, *source, truth, other.curves.empty() ? nullptr : &other);
  }
  itk::WriteDicomSeriesFolder(source->GetOutput(), folder, Describe(commandLine));
  commandLine.RecordRun(folder + ".run.json");
}
} // namespace

int
main(int argc, char * argv[])
{
  return itk::CommandLine::Run(ToolXML, argc, argv, MakePhantom);
}
