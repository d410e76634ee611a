#include "shapetonColonCenterlineFilter.h"
#include "shapetonColonFlatteningFilter.h"
#include "shapetonColonLandmarksFilter.h"
#include "shapetonColonLumenImageFilter.h"
#include "shapetonColonModelFilter.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonColonPositionFilter.h"
#include "shapetonColonWallFilter.h"
#include "shapetonDicomFields.h"
#include "shapetonElectronicCleansingImageFilter.h"
#include "shapetonHaustralFoldsFilter.h"
#include "shapetonHeatDiffusionMetricFilter.h"
#include "shapetonPolypCandidatesFilter.h"
#include "shapetonSupineProneRegistrationFilter.h"
#include "shapetonTestImages.h"

#include "itkChangeInformationImageFilter.h"
#include "itkCommand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

using namespace shapeton;

namespace
{
using Source = ColonPhantomImageSource;
using CtImage = Source::ImageType;

/** A coarse phantom with 3.2 mm voxels, rotated about the body axis. */
CtImage::Pointer
ObliqueCt()
{
  const auto             source = Source::New();
  ColonPhantomParameters parameters;
  parameters.seed = 1;
  source->SetParameters(parameters);
  source->SetSize({ { 112, 112, 106 } });
  source->SetSpacing(Source::SpacingType(3.2));
  source->SetDirection(basetest::Rotation(2, 0.2));
  source->CenterOutput();
  source->Update();
  return source->GetOutput();
}

/** Shared by all tests. */
const CtImage *
Ct()
{
  static const CtImage::Pointer ct = ObliqueCt();
  return ct;
}

template <typename TImage>
bool
HaveEqualVoxels(const TImage * a, const TImage * b)
{
  const auto number = a->GetBufferedRegion().GetNumberOfPixels();
  return a->GetBufferedRegion().GetSize() == b->GetBufferedRegion().GetSize() &&
         std::equal(a->GetBufferPointer(), a->GetBufferPointer() + number, b->GetBufferPointer());
}

void
ExpectEqual(const SurfaceMesh & a, const SurfaceMesh & b)
{
  EXPECT_TRUE(a.V == b.V);
  EXPECT_TRUE(a.F == b.F);
  ASSERT_EQ(a.pointArrays.size(), b.pointArrays.size());
  for (std::size_t i = 0; i < a.pointArrays.size(); ++i)
  {
    EXPECT_EQ(a.pointArrays[i].name, b.pointArrays[i].name);
    EXPECT_TRUE(a.pointArrays[i].values == b.pointArrays[i].values);
  }
  EXPECT_EQ(a.cellArrays.size(), b.cellArrays.size());
  EXPECT_EQ(a.fieldArrays.size(), b.fieldArrays.size());
}

using ModelFilter = ColonModelFilter<CtImage>;

ModelFilter::Pointer
NewModelFilter()
{
  auto filter = ModelFilter::New();
  filter->SetInput(Ct());
  filter->SetPosition("HFS");
  filter->SetFaces(8000);
  return filter;
}

ColonLumenImageFilter<CtImage>::Pointer
NewLumenFilter(const CtImage * ct = Ct(), const char * position = "HFS")
{
  auto filter = ColonLumenImageFilter<CtImage>::New();
  filter->SetInput(ct);
  filter->SetPosition(position);
  return filter;
}

/** The complete pipeline up to candidates, connected but not run. */
struct Pipeline
{
  ModelFilter::Pointer             model = NewModelFilter();
  ColonFlatteningFilter<>::Pointer flattening = ColonFlatteningFilter<>::New();
  ColonLandmarksFilter::Pointer    landmarks = ColonLandmarksFilter::New();
  HaustralFoldsFilter::Pointer     folds = HaustralFoldsFilter::New();
  ColonPositionFilter::Pointer     position = ColonPositionFilter::New();
  PolypCandidatesFilter<>::Pointer candidates = PolypCandidatesFilter<>::New();

  Pipeline() { this->Connect(*this); }

  /** Sets the inputs of all filters to results of a pipeline, which may be another one. */
  void
  Connect(Pipeline & results)
  {
    flattening->SetInput(results.model->GetOutput());
    flattening->SetCenterline(results.model->GetCenterlineOutput());
    landmarks->SetFlatColon(results.flattening->GetFlatColonOutput());
    landmarks->SetCenterline(results.model->GetCenterlineOutput());
    folds->SetFlatColon(results.flattening->GetFlatColonOutput());
    folds->SetTaeniae(results.landmarks->GetTaeniaeOutput());
    position->SetFlatColon(results.flattening->GetFlatColonOutput());
    position->SetCenterline(results.model->GetCenterlineOutput());
    position->SetLandmarks(results.landmarks->GetOutput());
    position->SetFolds(results.folds->GetFoldsOutput());
    candidates->SetInput(results.model->GetOutput(1));
    candidates->SetModel(results.model->GetModelOutput());
    candidates->SetFlatColon(results.flattening->GetFlatColonOutput());
    candidates->SetLandmarks(results.landmarks->GetOutput());
  }
};

/** The pipeline, run once for all tests. */
Pipeline &
FinishedPipeline()
{
  static Pipeline pipeline;
  pipeline.candidates->Update();
  pipeline.position->Update();
  return pipeline;
}

/** Counts the executions of a process object, records its progress, and may abort it. */
class Observer : public itk::Command
{
public:
  using Pointer = itk::SmartPointer<Observer>;
  itkNewMacro(Observer);

  int    starts{ 0 };
  double share{ 0.0 };
  bool   ascends{ true };
  double abortAt{ 2.0 };
  int    aborts{ 0 };

  static Pointer
  Of(itk::ProcessObject * process)
  {
    const auto observer = New();
    process->AddObserver(itk::AnyEvent(), observer);
    return observer;
  }

  void
  Execute(itk::Object * caller, const itk::EventObject & event) override
  {
    auto * const process = static_cast<itk::ProcessObject *>(caller);
    starts += itk::StartEvent().CheckEvent(&event);
    aborts += itk::AbortEvent().CheckEvent(&event);
    if (itk::ProgressEvent().CheckEvent(&event))
    {
      ascends = ascends && process->GetProgress() >= share;
      share = process->GetProgress();
      process->SetAbortGenerateData(share >= abortAt);
    }
  }
  void
  Execute(const itk::Object *, const itk::EventObject &) override
  {}
};
} // namespace

/** The CT is supine, so the position of a prone patient contradicts its fluid levels. */
TEST(ColonFilters, PositionIsThatOfTheHeader)
{
  const auto ct = CtImage::New();
  ct->Graft(Ct());
  itk::EncapsulateMetaData<std::string>(ct->GetMetaDataDictionary(), DicomPatientPosition, "HFP ");
  const auto ofHeader = NewLumenFilter(ct, "auto");
  const auto given = NewLumenFilter(Ct(), "HFP");
  ofHeader->Update();
  given->Update();
  EXPECT_TRUE(HaveEqualVoxels(ofHeader->GetOutput(), given->GetOutput()));
  EXPECT_EQ(ofHeader->GetLumenOutput()->Get().warnings, given->GetLumenOutput()->Get().warnings);
  EXPECT_FALSE(given->GetLumenOutput()->Get().warnings.empty());
}

TEST(ColonFilters, SingleStagesDoWhatTheFunctionsDo)
{
  const auto floats = FloatsFromIndexZero(Ct());
  const auto lumen = NewLumenFilter();
  const auto cleansing = ElectronicCleansingImageFilter<CtImage>::New();
  cleansing->SetInput(Ct());
  cleansing->SetLumen(lumen->GetLumenOutput());
  const auto centerline = ColonCenterlineFilter::New();
  centerline->SetInput(lumen->GetOutput());
  const auto wall = ColonWallFilter<>::New();
  wall->SetCleansed(cleansing->GetCleansedOutput());
  wall->SetCenterline(centerline->GetOutput());
  wall->SetFaces(8000);
  wall->Update();

  ColonLumenSettings options;
  options.position = "HFS";
  const ColonLumen expectedLumen = SegmentColonLumen(floats, options);
  EXPECT_TRUE(HaveEqualVoxels(lumen->GetOutput(), expectedLumen.labels.GetPointer()));
  EXPECT_EQ(lumen->GetLumenOutput()->Get().levels.size(), expectedLumen.levels.size());
  const CleansedColon expectedCleansed = CleanseColon(floats, expectedLumen);
  EXPECT_TRUE(HaveEqualVoxels(cleansing->GetOutput(), expectedCleansed.ct.GetPointer()));
  const ColonCenterline expectedLine = TraceColonCenterline(expectedLumen.labels);
  EXPECT_EQ(centerline->GetOutput()->Get().V, expectedLine.curve.V);
  EXPECT_EQ(centerline->GetCenterlineOutput()->Get().coverage, expectedLine.coverage);
  ColonWallSettings wallOptions;
  wallOptions.faces = 8000;
  const ColonWall expectedWall = BuildColonWall(expectedCleansed.occupancy, expectedLine.curve, wallOptions);
  ExpectEqual(SurfaceOf(*wall->GetOutput(0)), expectedWall.simplified);
  ExpectEqual(SurfaceOf(*wall->GetOutput(1)), expectedWall.repaired);
  ExpectEqual(SurfaceOf(*wall->GetOutput(2)), expectedWall.raw);

  const auto metric = HeatDiffusionMetricFilter<>::New();
  metric->SetInput(wall->GetOutput());
  metric->SetTime(40.0);
  metric->Update();
  EXPECT_EQ(metric->GetOutput()->Get().edgeLengths,
            ComputeHeatDiffusionMetric(expectedWall.simplified, 40.0).edgeLengths);
}

TEST(ColonFilters, TheChainDoesWhatTheFunctionsDo)
{
  Pipeline &         pipeline = FinishedPipeline();
  ColonModelSettings options;
  options.position = "HFS";
  options.faces = 8000;
  const ColonModel model = BuildColonModel(FloatsFromIndexZero(Ct()), options);
  ExpectEqual(SurfaceOf(*pipeline.model->GetOutput()), model.wall.simplified);
  ColonFlatteningSettings flatteningOptions;
  flatteningOptions.centerline = model.centerline.curve;
  const ColonFlattening flattening = FlattenColon(model.wall.simplified, "the wall", flatteningOptions);
  ExpectEqual(SurfaceOf(*pipeline.flattening->GetOutput()), flattening.map.flat);

  const FlatColon      flat(flattening.map.flat);
  const ColonLandmarks landmarks = FindColonLandmarks(flat, model.centerline.curve);
  const CurveSet       taeniae = TaeniaCurves(landmarks.taeniae);
  EXPECT_EQ(pipeline.landmarks->GetTaeniaeOutput()->Get().V, taeniae.V);
  HaustralFoldSettings foldOptions;
  foldOptions.taeniae = &taeniae;
  const HaustralFolds folds = FindHaustralFolds(flat, foldOptions);
  EXPECT_TRUE(HaveEqualVoxels(pipeline.folds->GetOutput(), folds.labels.GetPointer()));
  EXPECT_EQ(pipeline.folds->GetOutput()->GetSpacing(), folds.labels->GetSpacing());

  const ColonPosition & position = pipeline.position->GetOutput()->Get();
  EXPECT_EQ(position.folds.size(), folds.folds.size());
  EXPECT_EQ(position.flexures[3], landmarks.flexures.flexures[3].arcLength);
  const auto & candidates = pipeline.candidates->GetOutput()->Get();
  ASSERT_FALSE(candidates.empty());
  EXPECT_GT(candidates.front().segment, 0); // from the landmarks
  EXPECT_TRUE(std::isfinite(candidates.front().uv[0]));
  EXPECT_TRUE(std::isfinite(candidates.front().attenuation));
}

TEST(ColonFilters, APositionIsRegisteredWithItself)
{
  const auto registration = SupineProneRegistrationFilter::New();
  registration->SetSource(FinishedPipeline().position->GetOutput());
  registration->SetTarget(FinishedPipeline().position->GetOutput());
  registration->Update();
  const SupineProneRegistration & result = registration->GetOutput()->Get();
  EXPECT_FALSE(result.confidence.isFlagged);
  EXPECT_EQ(result.figures.flips, 0);
  const Eigen::Vector2d place(400.0, 40.0);
  EXPECT_LT((MapUv(result, place) - place).norm(), 2.0);
}

TEST(ColonFilters, NothingIsComputedTwiceAndChangesAreFollowed)
{
  Pipeline & pipeline = FinishedPipeline();
  const auto model = Observer::Of(pipeline.model);
  const auto folds = Observer::Of(pipeline.folds);
  pipeline.candidates->Update();
  pipeline.folds->Update();
  EXPECT_EQ(model->starts, 0);
  EXPECT_EQ(folds->starts, 0);
  const auto number = pipeline.folds->GetFoldsOutput()->Get().folds.size();
  pipeline.folds->SetMinimumLength(7.0); // unchanged value
  pipeline.folds->Update();
  EXPECT_EQ(folds->starts, 0);
  pipeline.folds->SetMinimumLength(30.0);
  pipeline.folds->Update();
  EXPECT_EQ(folds->starts, 1);
  EXPECT_EQ(model->starts, 0);
  EXPECT_LT(pipeline.folds->GetFoldsOutput()->Get().folds.size(), number);
  pipeline.folds->SetMinimumLength(7.0);
  pipeline.folds->Update();
  EXPECT_EQ(pipeline.folds->GetFoldsOutput()->Get().folds.size(), number);
  pipeline.model->RemoveAllObservers();
  pipeline.folds->RemoveAllObservers();
}

TEST(ColonFilters, ProgressIsReportedAndARunCanBeAborted)
{
  const auto filter = NewModelFilter();
  const auto observer = Observer::Of(filter);
  observer->abortAt = 0.4;
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
  EXPECT_TRUE(observer->ascends);
  EXPECT_GE(observer->share, 0.4);
  EXPECT_EQ(observer->aborts, 1);
  EXPECT_FALSE(filter->GetModelOutput()->HasResult());
  observer->abortAt = 2.0;
  observer->share = 0.0;
  filter->SetAbortGenerateData(false);
  EXPECT_NO_THROW(filter->Update());
  EXPECT_TRUE(observer->ascends);
  EXPECT_EQ(observer->share, 1.0);
}

TEST(ColonFilters, EachStageOnTheWallReportsAndCanBeAborted)
{
  Pipeline & finished = FinishedPipeline();
  Pipeline   stages; // new filters on existing results
  stages.Connect(finished);
  const auto metric = HeatDiffusionMetricFilter<>::New();
  metric->SetInput(finished.model->GetOutput());
  metric->SetTime(40.0);
  const auto registration = SupineProneRegistrationFilter::New();
  registration->SetSource(finished.position->GetOutput());
  registration->SetTarget(finished.position->GetOutput());
  for (itk::ProcessObject * stage : std::initializer_list<itk::ProcessObject *>{
         metric, stages.flattening, stages.landmarks, stages.folds, stages.candidates, registration })
  {
    const auto observer = Observer::Of(stage);
    observer->abortAt = 0.3;
    EXPECT_THROW(stage->Update(), itk::ProcessAborted) << stage->GetNameOfClass();
    EXPECT_GE(observer->share, 0.3);
    EXPECT_LT(observer->share, 0.9) << stage->GetNameOfClass();
    EXPECT_TRUE(observer->ascends);
    EXPECT_EQ(observer->aborts, 1);
  }
}

TEST(ColonFilters, AnOutputThatIsTakenAwayIsReplacedByOneOfItsType)
{
  Pipeline   stages;
  const auto lumen = ColonLumenImageFilter<CtImage>::New();
  const auto cleansing = ElectronicCleansingImageFilter<CtImage>::New();
  const auto source = Source::New();
  for (itk::ProcessObject * stage : std::initializer_list<itk::ProcessObject *>{
         lumen, cleansing, source, stages.model, stages.flattening, stages.landmarks, stages.folds })
  {
    for (const itk::DataObject::Pointer & output : stage->GetIndexedOutputs())
    {
      const auto        index = output->GetSourceOutputIndex();
      const std::string type = typeid(*output).name();
      output->DisconnectPipeline();
      const auto & another = *stage->GetIndexedOutputs()[index];
      EXPECT_NE(&another, output.GetPointer());
      EXPECT_EQ(typeid(another).name(), type) << stage->GetNameOfClass() << ", output " << index;
    }
  }
}

TEST(ColonFilters, AnImageMayBeginAtAnyIndex)
{
  using Shift = itk::ChangeInformationImageFilter<CtImage>;
  const auto shift = Shift::New();
  shift->SetInput(Ct());
  itk::Offset<3> offset{ { 7, -3, 12 } };
  shift->ChangeRegionOn();
  shift->SetOutputOffset(offset);
  auto origin = Ct()->GetOrigin(); // the voxels keep their positions
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    origin -= itk::Vector<double, 3>(Ct()->GetDirection().GetVnlMatrix().get_column(axis).data_block()) *
              (Ct()->GetSpacing()[axis] * static_cast<double>(offset[axis]));
  }
  shift->SetOutputOrigin(origin);
  shift->ChangeOriginOn();
  const auto lumen = NewLumenFilter(shift->GetOutput());
  lumen->Update();
  const auto reference = NewLumenFilter();
  reference->Update();
  EXPECT_TRUE(HaveEqualVoxels(lumen->GetOutput(), reference->GetOutput()));
  EXPECT_EQ(lumen->GetOutput()->GetLargestPossibleRegion().GetIndex(), (itk::Index<3>{ { 7, -3, 12 } }));
  EXPECT_LT(lumen->GetOutput()->GetOrigin().EuclideanDistanceTo(origin), 1e-9);
}

TEST(ColonFilters, WhatIsDoneToAnOutputChangesNoResultBesideIt)
{
  const auto lumen = NewLumenFilter();
  lumen->Update();
  const auto         result = lumen->GetLumenOutput()->Share();
  const auto * const begin = result->labels->GetBufferPointer();
  const auto         number = result->labels->GetBufferedRegion().GetNumberOfPixels();
  const std::vector  before(begin, begin + number);
  lumen->GetOutput()->FillBuffer(0);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), begin));
}

TEST(ColonFilters, GridsThatDifferAreRefused)
{
  const auto moved = CtImage::New();
  moved->Graft(Ct());
  auto origin = Ct()->GetOrigin();
  origin[0] += 100.0;
  moved->SetOrigin(origin);
  const auto lumen = NewLumenFilter();
  const auto cleansing = ElectronicCleansingImageFilter<CtImage>::New();
  cleansing->SetInput(moved);
  cleansing->SetLumen(lumen->GetLumenOutput());
  EXPECT_THROW(cleansing->Update(), InputError);
  const auto mask = NewImageOn<LumenMaskImage>(moved, true);
  const auto model = NewModelFilter();
  model->SetLumenMask(mask);
  EXPECT_THROW(model->Update(), InputError);
}

TEST(ColonFilters, MeshesOfAnyTypeAreFlattenedAndFilledAnew)
{
  using Floats = itk::Mesh<float, 3>;
  const auto  floats = Floats::New();
  SurfaceMesh wall = SurfaceOf(*FinishedPipeline().model->GetOutput());
  wall.pointArrays.clear();
  wall.cellArrays.clear();
  FillMesh(wall, *floats);
  const auto flattening = ColonFlatteningFilter<Floats, PipelineMesh>::New();
  flattening->SetInput(floats);
  flattening->SetCenterline(FinishedPipeline().model->GetCenterlineOutput());
  flattening->ReleaseDataBeforeUpdateFlagOff();
  flattening->Update();
  const auto faces = [&] {
    return static_cast<std::size_t>(flattening->GetFlatteningOutput()->Get().map.flat.F.rows());
  };
  EXPECT_EQ(flattening->GetOutput()->GetNumberOfCells(), faces());
  flattening->SetTime(2.0 * FinishedPipeline().flattening->GetFlatteningOutput()->Get().time);
  flattening->Update();
  EXPECT_EQ(flattening->GetOutput()->GetNumberOfCells(), faces());
}

TEST(ColonFilters, ErrorsAreExceptionsOfItk)
{
  const auto unconnected = ColonLandmarksFilter::New();
  EXPECT_THROW(unconnected->Update(), itk::ExceptionObject);
  EXPECT_THROW(NewLumenFilter(Ct(), "sitting")->Update(), ParameterError);
  const auto wall = ColonWallFilter<>::New();
  wall->SetCenterline(FinishedPipeline().model->GetCenterlineOutput());
  EXPECT_THROW(wall->Update(), itk::ExceptionObject); // neither Cleansed nor Mask
  EXPECT_THROW(ResultObject<CurveSet>::New()->Get(), itk::ExceptionObject);

  const auto soft = basetest::NewImage<CtImage>({ { 32, 32, 32 } }); // a body without gas
  soft->FillBuffer(40);
  const auto model = ModelFilter::New();
  model->SetInput(soft);
  EXPECT_THROW(model->Update(), InputError);
}

TEST(ColonFilters, ParametersArePrinted)
{
  const auto filter = NewModelFilter();
  filter->KeepPiecesOn();
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("Position: HFS"), std::string::npos);
  EXPECT_NE(text.str().find("Faces: 8000"), std::string::npos);
  EXPECT_NE(text.str().find("KeepPieces: 1"), std::string::npos);
}
