#include "LandmarkTrial.h"
#include "SampledScenes.h"
#include "Tables.h"

#include "shapetonColonFlattening.h"
#include "shapetonExceptions.h"

#include "itkRegionOfInterestImageFilter.h"

#include <cmath>

using namespace shapeton;

namespace
{
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

std::vector<LandmarkCase>
BothPositions(const std::string & preset, const std::vector<unsigned int> & seeds, double spacing, bool isFromCt)
{
  std::vector<LandmarkCase> cases;
  for (const unsigned int seed : seeds)
  {
    for (const char * const position : { "supine", "prone" })
    {
      cases.push_back(ValidationCase(preset, seed, position, spacing, isFromCt));
    }
  }
  return cases;
}

ColonPhantomImageSource::Pointer
MakePhantom(const LandmarkCase & one)
{
  const auto                        source = ColonPhantomImageSource::New();
  const double                      extent[3] = { 358.4, 358.4, 336.0 }; // mm
  ColonPhantomImageSource::SizeType size;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = static_cast<itk::SizeValueType>(std::lround(extent[axis] / one.spacing));
  }
  source->SetParameters(one.parameters);
  source->SetSize(size);
  source->SetSpacing(ColonPhantomImageSource::SpacingType(one.spacing));
  source->CenterOutput();
  source->SetTruthOnly(!one.isFromCt);
  source->Update();
  return source;
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
  return BuildColonModel(ToFloat(source->GetOutput()), settings);
}

LandmarkExam
MakeLandmarkExam(const LandmarkCase & one)
{
  return MakeColonExam(one);
}

ColonExam
MakeColonExam(const LandmarkCase & one)
{
  ColonExam exam;
  exam.anatomy = std::make_shared<ColonAnatomy>(one.parameters);
  try
  {
    MakeFlat(one, exam);
  }
  catch (const Exception & error)
  {
    exam.failure = error.what();
  }
  return exam;
}

std::string
TitleOfColumn(const std::string & preset, bool isFromCt, double spacing)
{
  return "Preset " + preset + ", " + (isFromCt ? "from CT of " : "from the true lumen in voxels of ") +
         Rounded(spacing) + " mm";
}

std::string
NameOfCase(const LandmarkCase & one)
{
  return "seed " + std::to_string(one.parameters.seed) + ", " + one.parameters.position;
}
