#include "LandmarkTrial.h"

#include "shapetonColonFlattening.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonCsvTable.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonExceptions.h"
#include "shapetonVolumeWriter.h"

#include "itkCastImageFilter.h"
#include "itkImageFileReader.h"
#include "itkNrrdImageIO.h"
#include "itkRegionOfInterestImageFilter.h"

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

/** File name without extension; empty if exams are not cached. */
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

/** Crops to 15 mm around the lumen. */
template <typename TImage>
typename TImage::Pointer
AroundLumen(const TImage * image, const LumenMask * lumen)
{
  const auto margin = static_cast<unsigned int>(std::lround(15.0 / lumen->GetSpacing()[0]));
  const auto filter = itk::RegionOfInterestImageFilter<TImage, TImage>::New();
  filter->SetInput(image);
  filter->SetRegionOfInterest(LumenRegion(lumen, margin));
  filter->Update();
  return filter->GetOutput();
}

void
MakeFlat(const LandmarkCase & one, ColonExam & exam)
{
  ColonModel model = MakeTrialModel(one);
  exam.failure = model.failure;
  if (exam.failure.empty())
  {
    exam.centerline = model.centerline.curve;
    exam.lumen = AroundLumen(model.lumen.labels.GetPointer(), model.lumen.labels);
    exam.ct = model.cleansed ? AroundLumen(model.cleansed.GetPointer(), model.lumen.labels) : nullptr;
    exam.catheter =
      model.lumen.catheter && model.lumen.catheter->isSure ? CurveOfCatheter(*model.lumen.catheter) : CurveSet();
    ColonFlatteningSettings options;
    options.centerline = exam.centerline;
    exam.wall = std::move(model.wall.repaired);
    exam.flat = FlattenColon(std::move(model.wall.simplified), NameOfCase(one), options).map.flat;
  }
}

bool
IsThere(const std::string & path)
{
  return std::filesystem::exists(path);
}

void
Keep(const ColonExam & exam, const std::string & cached)
{
  WriteVolume<unsigned char>(exam.lumen, cached + ".lumen.nrrd");
  if (exam.ct)
  {
    const auto cast = itk::CastImageFilter<itk::Image<float, 3>, itk::Image<short, 3>>::New();
    cast->SetInput(exam.ct);
    cast->Update();
    WriteVolume<short>(cast->GetOutput(), cached + ".ct.nrrd");
  }
  if (!exam.catheter.curves.empty())
  {
    WriteCurves(exam.catheter, cached + ".catheter.vtp");
  }
  WriteSurface(exam.flat, cached + ".vtp");
  WriteSurface(exam.wall, cached + ".wall.vtp");
  WriteCurves(exam.centerline, cached + ".line.vtp"); // written last, to mark a complete cache entry
}

void
TakeSurfaces(const std::string & cached, LandmarkExam & exam)
{
  exam.flat = ReadSurface(cached + ".vtp").mesh;
  exam.wall = ReadSurface(cached + ".wall.vtp").mesh;
  exam.centerline = ReadCurves(cached + ".line.vtp");
}

template <typename TImage>
typename TImage::Pointer
ReadCached(const std::string & path)
{
  const auto reader = itk::ImageFileReader<TImage>::New();
  reader->SetImageIO(itk::NrrdImageIO::New());
  reader->SetFileName(path);
  reader->Update();
  return reader->GetOutput();
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

ColonModel
MakeTrialModel(const LandmarkCase & one, ColonModelSettings settings)
{
  const auto source = MakePhantom(one);
  if (!one.isFromCt)
  {
    return BuildColonModelOfLumen(source->GetLumenOutput(), settings);
  }
  settings.position = one.parameters.position;
  const auto cast = itk::CastImageFilter<Source::ImageType, itk::Image<float, 3>>::New();
  cast->SetInput(source->GetOutput());
  cast->Update();
  return BuildColonModel(cast->GetOutput(), settings);
}

LandmarkExam
MakeLandmarkExam(const LandmarkCase & one)
{
  const std::string cached = CachedName(one);
  if (cached.empty() || !IsThere(cached + ".line.vtp"))
  {
    return MakeColonExam(one);
  }
  LandmarkExam exam;
  exam.anatomy = std::make_shared<ColonAnatomy>(one.parameters);
  TakeSurfaces(cached, exam);
  return exam;
}

ColonExam
MakeColonExam(const LandmarkCase & one)
{
  ColonExam exam;
  exam.anatomy = std::make_shared<ColonAnatomy>(one.parameters);
  const std::string cached = CachedName(one);
  if (!cached.empty() && IsThere(cached + ".line.vtp"))
  {
    TakeSurfaces(cached, exam);
    exam.lumen = ReadCached<LumenMask>(cached + ".lumen.nrrd");
    exam.ct = one.isFromCt ? ReadCached<itk::Image<float, 3>>(cached + ".ct.nrrd") : nullptr;
    exam.catheter = IsThere(cached + ".catheter.vtp") ? ReadCurves(cached + ".catheter.vtp") : CurveSet();
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
    Keep(exam, cached);
  }
  return exam;
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
