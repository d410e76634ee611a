#include "SurfaceSpectrumXML.h"

#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonHeatKernel.h"
#include "shapetonHeatKernelSignatureOptions.h"
#include "shapetonReadOptions.h"
#include "shapetonToolSurfaces.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonExceptions.h"

namespace
{
using namespace shapeton;

void
CheckUsage(const CommandLine & commandLine, const HeatKernelSignatureOptions & options)
{
  const std::string signature = commandLine.GetString("heatKernelSignature");
  RequireParameter(signature.empty() || (signature.size() > 4 && signature.substr(signature.size() - 4) == ".vtp"),
                   "--heatKernelSignature writes VTP; the file name must end in .vtp");
  RequireParameter(!commandLine.IsGiven("times") || commandLine.IsGiven("heatKernelSignature"),
                   "--times requires --heatKernelSignature");
  for (const double time : options.times)
  {
    RequireParameter(time > 0.0, "--times must be greater than 0 mm^2");
  }
}

SurfaceSpectrum
SpectrumOf(const CommandLine & commandLine, const SurfaceMesh & mesh, int eigenpairs)
{
  const SurfaceConnectivity connectivity(mesh);
  try
  {
    return ComputeSurfaceSpectrum(MakeSurfaceLaplacian(connectivity, mesh.V), eigenpairs);
  }
  catch (const InputError & error)
  {
    throw InputError(commandLine.GetString("inputSurface") + ": " + error.what());
  }
}

void
WriteEigenvalues(const SurfaceSpectrum & spectrum, const std::string & path)
{
  CsvTable table({ "number", "eigenvalue", "residual" });
  for (int i = 0; i < spectrum.NumberOfPairs(); ++i)
  {
    table.AddRow({ std::to_string(i),
                   CsvTable::Rounded(spectrum.eigenvalues[i], 10),
                   CsvTable::Rounded(spectrum.residuals[i], 2) });
  }
  table.Write(path);
}

std::vector<double>
TimesOf(CommandLine & commandLine, const std::vector<double> & given, const SurfaceSpectrum & spectrum)
{
  constexpr int    numberOfTimes = 4;
  constexpr double noticeable = 0.01;
  if (given.empty())
  {
    return HeatKernelSignatureTimes(spectrum, numberOfTimes);
  }
  for (const double time : given)
  {
    if (const double share = ShareOfLastPair(spectrum, time); share > noticeable)
    {
      commandLine.Warn("at " + CsvTable::Number(time) + " mm^2 the last eigenpair still has " +
                       CsvTable::Rounded(share, 2) +
                       " of its heat, so the signature lacks the contribution of higher eigenpairs; "
                       "increase --eigenpairs");
    }
  }
  return given;
}

void
WriteSignature(CommandLine &               commandLine,
               const std::vector<double> & given,
               const SurfaceSpectrum &     spectrum,
               SurfaceMesh                 mesh,
               const std::string &         path)
{
  const std::vector<double> times = TimesOf(commandLine, given, spectrum);
  for (const double time : times)
  {
    mesh.pointArrays.push_back(
      { "heatKernelSignature_" + CsvTable::Rounded(time, 6), HeatKernelSignature(spectrum, time) });
  }
  mesh.fieldArrays.push_back({ "times", Eigen::Map<const Eigen::VectorXd>(times.data(), times.size()) });
  mesh.fieldArrays.push_back({ "eigenvalues", spectrum.eigenvalues });
  WriteSurface(std::move(mesh), commandLine.GetProvenance(), path);
}

void
Analyze(CommandLine & commandLine)
{
  HeatKernelSignatureOptions options;
  ReadOptions(commandLine, options);
  CheckUsage(commandLine, options);
  const std::string eigenvalues = commandLine.MainOutput("eigenvalues");
  const std::string signature = commandLine.OutputOf("heatKernelSignature");
  const Surface     surface = ReadRepairedSurface(commandLine, "inputSurface");
  commandLine.Progress("Computing eigenpairs", 0.1);
  const SurfaceSpectrum spectrum = SpectrumOf(commandLine, surface.mesh, options.eigenpairs);
  commandLine.Progress("Writing", 0.9);
  WriteEigenvalues(spectrum, eigenvalues);
  if (!signature.empty())
  {
    WriteSignature(commandLine, options.times, spectrum, surface.mesh, signature);
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Analyze);
}
