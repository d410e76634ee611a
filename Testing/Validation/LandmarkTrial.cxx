#include "LandmarkTrial.h"

#include "shapetonColonFlattening.h"
#include "shapetonColonModel.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonCsvTable.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonExceptions.h"
#include "shapetonVolumeWriter.h"

#include "itkCastImageFilter.h"
#include "itkImageFileReader.h"
#include "itkNrrdImageIO.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

using namespace shapeton;

namespace
{
using Source = ColonPhantomImageSource;

Source::Pointer
MakePhantom(const LandmarkCase & one)
{
  const auto       source = Source::New();
  const double     extent[3] = { 358.4, 358.4, 336.0 }; // mm
  Source::SizeType size;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<itk::SizeValueType>(std::lround(extent[axis] / one.spacing));
  }
  source->SetParameters(one.parameters);
  source->SetSize(size);
  source->SetSpacing(Source::SpacingType(one.spacing));
  source->CenterOutput();
  source->SetTruthOnly(!one.isFromCt);
  source->Update();
  return source;
}

ColonModel
MakeModel(const LandmarkCase & one)
{
  const auto        source = MakePhantom(one);
  ColonModelOptions options;
  if (!one.isFromCt)
  {
    return BuildColonModelOfLumen(source->GetLumenOutput(), options);
  }
  options.patientPosition = one.parameters.position;
  const auto cast = itk::CastImageFilter<Source::ImageType, itk::Image<float, 3>>::New();
  cast->SetInput(source->GetOutput());
  cast->Update();
  return BuildColonModel(cast->GetOutput(), options);
}

/** Without an extension; empty where nothing is kept. */
std::string
CachedName(const LandmarkCase & one)
{
  const char * const folder = std::getenv("SHAPETON_LANDMARK_CACHE");
  if (!folder || !*folder)
  {
    return "";
  }
  std::filesystem::create_directories(folder);
  return std::string(folder) + '/' + one.parameters.preset + '-' + std::to_string(one.parameters.seed) + '-' +
         one.parameters.position + (one.isFromCt ? "-ct-" : "-true-") +
         std::to_string(std::lround(1000.0 * one.spacing));
}

void
MakeFlat(const LandmarkCase & one, LandmarkExam & exam)
{
  ColonModel model = MakeModel(one);
  exam.failure = model.failure;
  if (exam.failure.empty())
  {
    if (const std::string cached = CachedName(one); !cached.empty())
    {
      WriteVolume<unsigned char>(model.lumen.labels, cached + ".lumen.nrrd");
    }
    exam.centreline = model.centreline.curve;
    ColonFlatteningOptions options;
    options.centreline = exam.centreline;
    exam.wall = std::move(model.wall.repaired);
    exam.flat = FlattenColon(std::move(model.wall.simplified), NameOfCase(one), options).map.flat;
  }
}
} // namespace

LandmarkCase
ValidationCase(const std::string & preset,
               unsigned int        seed,
               const std::string & position,
               double              spacing,
               bool                isFromCt)
{
  LandmarkCase one;
  one.parameters = ColonPhantomPreset(preset);
  one.parameters.seed = seed;
  one.parameters.position = position;
  one.spacing = spacing;
  one.isFromCt = isFromCt;
  return one;
}

LandmarkExam
MakeLandmarkExam(const LandmarkCase & one)
{
  LandmarkExam exam;
  exam.anatomy = std::make_shared<ColonAnatomy>(one.parameters);
  const std::string cached = CachedName(one);
  if (!cached.empty() && std::filesystem::exists(cached + ".line.vtp"))
  {
    exam.flat = ReadSurface(cached + ".vtp").mesh;
    exam.wall = ReadSurface(cached + ".wall.vtp").mesh;
    exam.centreline = ReadCurves(cached + ".line.vtp");
    return exam;
  }
  try
  {
    MakeFlat(one, exam);
  }
  catch (const Exception & error)
  {
    exam.failure = error.what();
  }
  if (!cached.empty() && exam.failure.empty())
  {
    WriteSurface(exam.flat, cached + ".vtp");
    WriteSurface(exam.wall, cached + ".wall.vtp");
    WriteCurves(exam.centreline, cached + ".line.vtp");
  }
  return exam;
}

itk::Image<unsigned char, 3>::Pointer
LumenOfCase(const LandmarkCase & one)
{
  const std::string cached = CachedName(one);
  if (!cached.empty() && std::filesystem::exists(cached + ".lumen.nrrd"))
  {
    const auto reader = itk::ImageFileReader<itk::Image<unsigned char, 3>>::New();
    reader->SetImageIO(itk::NrrdImageIO::New());
    reader->SetFileName(cached + ".lumen.nrrd");
    reader->Update();
    return reader->GetOutput();
  }
  itk::Image<unsigned char, 3>::Pointer lumen;
  if (one.isFromCt)
  {
    const ColonModel model = MakeModel(one);
    if (!model.failure.empty())
    {
      throw InputError(NameOfCase(one) + ": " + model.failure);
    }
    lumen = model.lumen.labels;
  }
  else
  {
    lumen = MakePhantom(one)->GetLumenOutput();
  }
  if (!cached.empty())
  {
    WriteVolume<unsigned char>(lumen, cached + ".lumen.nrrd");
  }
  return lumen;
}

std::string
TitleOfColumn(const std::string & preset, bool isFromCt, double spacing)
{
  return "Preset " + preset + ", " + (isFromCt ? "from CT of " : "from the true lumen in voxels of ") +
         CsvTable::Rounded(spacing, 3) + " mm";
}

std::string
NameOfCase(const LandmarkCase & one)
{
  return "seed " + std::to_string(one.parameters.seed) + ", " + one.parameters.position;
}
