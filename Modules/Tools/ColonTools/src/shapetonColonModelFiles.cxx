#include "shapetonColonModelFiles.h"

#include "shapetonColonQuality.h"
#include "shapetonCommandLine.h"
#include "shapetonExaminationFiles.h"
#include "shapetonJson.h"
#include "shapetonMappedImage.h"
#include "shapetonParallelFor.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace shapeton
{
namespace
{
/** Rounded to integer HU, like the original scan. */
itk::Image<short, 3>::Pointer
RoundedToHU(const itk::Image<float, 3> * image)
{
  return MapVoxels<short>(image, [](float value) {
    constexpr float least = std::numeric_limits<short>::min();
    constexpr float greatest = std::numeric_limits<short>::max();
    return static_cast<short>(std::lround(std::clamp(value, least, greatest)));
  });
}

CurveSet
WithProvenance(CurveSet curves, const CommandLine & commandLine)
{
  curves.facts = ProvenanceMetadata(commandLine.GetProvenance());
  return curves;
}

/** The labels of the lumen, with 3 for the terminal ileum. */
itk::Image<unsigned char, 3>::Pointer
LabelsOf(const ColonModel & model)
{
  using LabelImage = itk::Image<unsigned char, 3>;
  if (!model.terminalIleum)
  {
    return model.lumen.labels;
  }
  constexpr unsigned char     ileumLabel = 3;
  const auto                  labels = NewImageOn<LabelImage>(model.lumen.labels);
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
            { { "cleansedVolume", examination::cleansedCt.name },
              { "lumenLabels", examination::lumen.name },
              { "wallModel", examination::simplifiedWall.name },
              { "centerlineModel", examination::centerline.name } })
{
  commandLine.MakeFolder(folder);
  commandLine.RecordRun(folder + "/run.json");
}

ColonModelFiles::File
ColonModelFiles::CleansedFile(const itk::Image<float, 3> * cleansed) const
{
  return { examination::cleansedCt.name, [this, cleansed](const std::string & path) {
            WriteVolume(RoundedToHU(cleansed).GetPointer(), path, ProvenanceMetadata(m_CommandLine.GetProvenance()));
          } };
}

ColonModelFiles::File
ColonModelFiles::CleansingFile(const itk::Image<float, 3> * cleansed) const
{
  return { examination::cleansing.name, [this, cleansed](const std::string & path) {
            const auto          removed = RoundedToHU(m_Ct);
            const auto          rest = RoundedToHU(cleansed);
            const std::size_t   voxels = removed->GetLargestPossibleRegion().GetNumberOfPixels();
            short * const       values = removed->GetBufferPointer();
            const short * const kept = rest->GetBufferPointer();
            ParallelForBlocks(voxels, [=](std::size_t i) { values[i] = static_cast<short>(values[i] - kept[i]); });
            WriteVolume(removed.GetPointer(), path, ProvenanceMetadata(m_CommandLine.GetProvenance()));
          } };
}

ColonModelFiles::File
ColonModelFiles::LumenFile(const ColonModel & model) const
{
  return { examination::lumen.name, [this, &model](const std::string & path) {
            WriteVolume(LabelsOf(model).GetPointer(), path, ProvenanceMetadata(m_CommandLine.GetProvenance()));
          } };
}

ColonModelFiles::File
ColonModelFiles::FileOf(const char * name, const SurfaceMesh & surface)
{
  return { name, [&surface](const std::string & path) { WriteSurface(surface, path); } };
}

std::vector<ColonModelFiles::File>
ColonModelFiles::WallsOf(const SurfaceMesh & raw, const SurfaceMesh & repaired)
{
  return { FileOf(examination::wall.name, raw), FileOf(examination::repairedWall.name, repaired) };
}

std::vector<ColonModelFiles::File>
ColonModelFiles::FilesOf(const ColonModel & model) const
{
  std::vector<File> files{ this->LumenFile(model) };
  if (model.cleansed)
  {
    files.push_back(this->CleansedFile(model.cleansed));
    files.push_back(this->CleansingFile(model.cleansed));
  }
  if (model.wall.raw.NumberOfFaces() > 0)
  {
    const std::vector<File> walls = WallsOf(model.wall.raw, model.wall.repaired);
    files.insert(files.end(), walls.begin(), walls.end());
    files.push_back(FileOf(examination::simplifiedWall.name, model.wall.simplified));
  }
  files.push_back({ examination::quality.name, [this, &model](const std::string & path) {
                     Json document;
                     document["provenance"] = ProvenanceToJson(m_CommandLine.GetProvenance());
                     document.update(ColonQualityToJson(model));
                     WriteJson(document, path);
                   } });
  if (!model.centerline.curve.curves.empty())
  {
    files.push_back({ examination::centerline.name, [this, &model](const std::string & path) {
                       WriteCurves(WithProvenance(model.centerline.curve, m_CommandLine), path);
                     } });
  }
  if (model.lumen.catheter && model.lumen.catheter->isSure)
  {
    files.push_back({ examination::catheter.name, [this, &model](const std::string & path) {
                       WriteCurves(WithProvenance(CurveOfCatheter(*model.lumen.catheter), m_CommandLine), path);
                     } });
  }
  return files;
}

void
ColonModelFiles::WriteFiles(const std::vector<File> & files)
{
  std::vector<std::string> outputs;
  {
    const std::lock_guard lock(m_Mutex);
    for (const File & file : files)
    {
      std::string & output = m_Outputs[file.name];
      output = output.empty() ? m_CommandLine.Output(m_Folder + '/' + file.name) : output;
      outputs.push_back(output);
    }
  }
  ParallelFor(files.size(), [&](std::size_t i) {
    files[i].write(outputs[i]);
    m_Scene.Copy(files[i].name, outputs[i]);
  });
}

void
ColonModelFiles::WriteBeside(ColonModelSettings & options, const itk::Image<float, 3> * ct)
{
  m_Ct = ct;
  options.facts = ProvenanceMetadata(m_CommandLine.GetProvenance()); // adding it later would copy the surface
  options.onCleansed = [this](const auto * cleansed) {
    this->WriteFiles({ this->CleansedFile(cleansed), this->CleansingFile(cleansed) });
  };
  options.besideWall = [this](const ColonModel & model) { this->WriteFiles({ this->LumenFile(model) }); };
  options.besideSimplification = [this](const SurfaceMesh & raw, const SurfaceMesh & repaired) {
    for (const File & file : WallsOf(raw, repaired)) // sequentially, to halve the memory
    {
      this->WriteFiles({ file });
    }
  };
}

void
ColonModelFiles::Write(const ColonModel & model, bool atOnce)
{
  const std::vector<File> files = this->FilesOf(model);
  std::vector<File>       rest;
  std::copy_if(files.begin(), files.end(), std::back_inserter(rest), [this](const File & file) {
    return m_Outputs.count(file.name) == 0;
  });
  this->WriteFiles(rest);
  for (std::size_t i = 0; atOnce && i < files.size(); ++i)
  {
    m_CommandLine.Publish(m_Folder + '/' + files[i].name);
  }
}
} // namespace shapeton
