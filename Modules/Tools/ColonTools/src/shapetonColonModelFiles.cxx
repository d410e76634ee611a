#include "shapetonColonModelFiles.h"

#include "shapetonColonQuality.h"
#include "shapetonCommandLine.h"
#include "shapetonJson.h"
#include "shapetonParallelFor.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Whole HU, as a scanner gives them. */
itk::Image<short, 3>::Pointer
RoundedToHU(const itk::Image<float, 3> * image)
{
  const auto rounded = itk::Image<short, 3>::New();
  rounded->CopyInformation(image);
  rounded->SetRegions(image->GetLargestPossibleRegion());
  rounded->Allocate();
  const float * const from = image->GetBufferPointer();
  const float * const end = from + image->GetLargestPossibleRegion().GetNumberOfPixels();
  std::transform(from, end, rounded->GetBufferPointer(), [](float value) {
    return static_cast<short>(std::lround(std::clamp(value, -32768.0F, 32767.0F)));
  });
  return rounded;
}

template <typename TGeometry>
TGeometry
WithProvenance(TGeometry geometry, const CommandLine & commandLine)
{
  geometry.facts = ProvenanceMetadata(commandLine.GetProvenance());
  return geometry;
}
/** The labels of the lumen, and 3 for the terminal ileum. */
itk::Image<unsigned char, 3>::Pointer
LabelsOf(const ColonModel & model)
{
  using LabelImage = itk::Image<unsigned char, 3>;
  if (!model.terminalIleum)
  {
    return model.lumen.labels;
  }
  constexpr unsigned char ileumLabel = 3;
  const auto              labels = LabelImage::New();
  labels->CopyInformation(model.lumen.labels);
  labels->SetRegions(model.lumen.labels->GetLargestPossibleRegion());
  labels->Allocate();
  const unsigned char * const colon = model.lumen.labels->GetBufferPointer();
  const std::size_t           voxels = labels->GetLargestPossibleRegion().GetNumberOfPixels();
  std::transform(colon,
                 colon + voxels,
                 model.terminalIleum->mask->GetBufferPointer(),
                 labels->GetBufferPointer(),
                 [](unsigned char label, unsigned char ileum) { return ileum != 0 ? ileumLabel : label; });
  return labels;
}
} // namespace

ColonModelFiles::ColonModelFiles(CommandLine & commandLine, const std::string & folder)
  : m_CommandLine(commandLine)
  , m_Folder(folder)
  , m_Scene(commandLine,
            { { "cleansedVolume", "cleansed.nrrd" },
              { "lumenLabels", "lumen.nrrd" },
              { "wallModel", "wall-simplified.vtp" },
              { "centrelineModel", "centreline.vtp" } })
{
  commandLine.MakeFolder(folder);
  commandLine.RecordRun(folder + "/run.json");
}

std::vector<ColonModelFiles::File>
ColonModelFiles::VolumesOf(const ColonModel & model) const
{
  const auto        metadata = ProvenanceMetadata(m_CommandLine.GetProvenance());
  std::vector<File> files;
  if (model.cleansed)
  {
    files.push_back({ "cleansed.nrrd", [&model, metadata](const std::string & path) {
                       WriteVolume(RoundedToHU(model.cleansed).GetPointer(), path, metadata);
                     } });
  }
  files.push_back({ "lumen.nrrd", [&model, metadata](const std::string & path) {
                     WriteVolume(LabelsOf(model).GetPointer(), path, metadata);
                   } });
  return files;
}

std::vector<ColonModelFiles::File>
ColonModelFiles::FilesOf(const ColonModel & model) const
{
  std::vector<File> files;
  files.push_back({ "quality.json", [this, &model](const std::string & path) {
                     Json document;
                     document["provenance"] = ProvenanceToJson(m_CommandLine.GetProvenance());
                     document.update(ColonQualityToJson(model));
                     WriteJson(document, path);
                   } });
  const std::pair<const char *, const SurfaceMesh *> surfaces[] = { { "wall.vtp", &model.wall.raw },
                                                                    { "wall-repaired.vtp", &model.wall.repaired },
                                                                    { "wall-simplified.vtp", &model.wall.simplified } };
  for (const auto & [name, surface] : surfaces)
  {
    if (surface->NumberOfFaces() > 0)
    {
      files.push_back({ name, [this, mesh = surface](const std::string & path) {
                         WriteSurface(WithProvenance(*mesh, m_CommandLine), path);
                       } });
    }
  }
  if (!model.centreline.curve.curves.empty())
  {
    files.push_back({ "centreline.vtp", [this, &model](const std::string & path) {
                       WriteCurves(WithProvenance(model.centreline.curve, m_CommandLine), path);
                     } });
  }
  if (model.lumen.catheter && model.lumen.catheter->isSure)
  {
    files.push_back({ "catheter.vtp", [this, &model](const std::string & path) {
                       WriteCurves(WithProvenance(CurveOfCatheter(*model.lumen.catheter), m_CommandLine), path);
                     } });
  }
  return files;
}

void
ColonModelFiles::WriteFiles(const std::vector<File> & files)
{
  std::vector<std::string> outputs;
  for (const File & file : files)
  {
    outputs.push_back(m_CommandLine.Output(m_Folder + '/' + file.name));
    m_Written.push_back(file.name);
  }
  ParallelFor(files.size(), [&](std::size_t i) {
    files[i].write(outputs[i]);
    m_Scene.Copy(files[i].name, outputs[i]);
  });
}

void
ColonModelFiles::WriteVolumes(const ColonModel & model)
{
  this->WriteFiles(this->VolumesOf(model));
}

void
ColonModelFiles::Write(const ColonModel & model, bool atOnce)
{
  if (m_Written.empty())
  {
    this->WriteVolumes(model);
  }
  this->WriteFiles(this->FilesOf(model));
  for (std::size_t i = 0; atOnce && i < m_Written.size(); ++i)
  {
    m_CommandLine.Publish(m_Folder + '/' + m_Written[i]);
  }
}
} // namespace shapeton
