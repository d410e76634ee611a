#include "shapetonColonModel.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonColonQuality.h"
#include "shapetonDicomFields.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonExceptions.h"
#include "shapetonPi.h"
#include "shapetonVolumeWriter.h"

#include "itkCastImageFilter.h"
#include "itkRegionOfInterestImageFilter.h"

#include "gtest/gtest.h"
#include "shapetonJson.h"
#include "shapetonTestImages.h"

#include <algorithm>
#include <cmath>

namespace
{
using CtImage = itk::Image<float, 3>;
using Source = shapeton::ColonPhantomImageSource;

/** A patient with a spacing of 2.8 mm on a grid with these axes. */
Source::Pointer
MakePatient(const Source::DirectionType & direction = basetest::Rotation(0, 0.0))
{
  const auto                       source = Source::New();
  shapeton::ColonPhantomParameters parameters;
  parameters.seed = 1;
  source->SetParameters(parameters);
  source->SetSize({ { 128, 128, 120 } });
  source->SetSpacing(Source::SpacingType(2.8));
  source->SetDirection(direction);
  source->CenterOutput();
  source->Update();
  return source;
}

CtImage::Pointer
CtOf(Source * source)
{
  const auto cast = itk::CastImageFilter<Source::ImageType, CtImage>::New();
  cast->SetInput(source->GetOutput());
  cast->Update();
  return cast->GetOutput();
}

shapeton::ColonModelSettings
Options()
{
  shapeton::ColonModelSettings options;
  options.position = "HFS";
  options.faces = 20000;
  return options;
}

void
ExpectTube(const shapeton::SurfaceMesh & mesh)
{
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(mesh);
  EXPECT_EQ(quality.components.size(), 1U);
  EXPECT_EQ(quality.boundaryLoopLengths.size(), 2U);
  EXPECT_TRUE(quality.isManifold);
  EXPECT_TRUE(quality.isOriented);
}

/** Mean distance from the points of the line to the true centerline, mm. */
double
MeanDistance(const shapeton::CurveSet & line, const shapeton::CurveSet & truth)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < line.V.rows(); ++i)
  {
    sum += std::sqrt((truth.V.rowwise() - line.V.row(i)).rowwise().squaredNorm().minCoeff());
  }
  return sum / static_cast<double>(line.V.rows());
}

double
ShareOfLabels(const shapeton::ColonLumen::LabelImageType * found, const Source::LabelImageType * truth)
{
  std::size_t both = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < found->GetLargestPossibleRegion().GetNumberOfPixels(); ++i)
  {
    const bool isFound = found->GetBufferPointer()[i] != 0;
    const bool isReal = truth->GetBufferPointer()[i] != 0;
    both += isFound && isReal;
    all += isFound + isReal;
  }
  return 2.0 * static_cast<double>(both) / static_cast<double>(all);
}

void
ExpectQuality(const shapeton::ColonModel & model)
{
  const shapeton::Json quality = shapeton::ColonQualityToJson(model);
  EXPECT_TRUE(quality.at("isComplete").get<bool>());
  EXPECT_DOUBLE_EQ(quality.at("resolution").at("smallestPolyp").get<double>(), 12.0);
  EXPECT_EQ(quality.at("resolution").at("handlesBeforeRepair").get<int>(), model.wall.report.rawGenus);
  EXPECT_DOUBLE_EQ(shapeton::NotAssessableBelow(model.centerline.curve), 12.0);
  EXPECT_EQ(quality.at("lumen").at("position").get<std::string>(), "supine");
  EXPECT_DOUBLE_EQ(quality.at("distension").at("whole").at("end").get<double>(), model.centerline.length);
  EXPECT_DOUBLE_EQ(quality.at("centerline").at("length").get<double>(), model.centerline.length);
  EXPECT_EQ(quality.at("surface").at("genusRepaired").get<int>(), model.wall.report.repairedGenus);
  EXPECT_EQ(quality.at("surface").at("wall-simplified").at("faces").get<int>(), model.wall.simplified.NumberOfFaces());
}

/** Baseline data: an axial slice of the cleansed CT, and the centerline as an image of 3 columns. */
void
WriteForBaselines(const shapeton::ColonModel & model)
{
  const std::string folder = SHAPETON_TEST_TEMPORARY_DIR;
  const auto        slice = itk::RegionOfInterestImageFilter<CtImage, CtImage>::New();
  slice->SetInput(model.cleansed);
  slice->SetRegionOfInterest({ { { 0, 0, 64 } }, { { 128, 128, 2 } } });
  slice->Update();
  shapeton::WriteVolume(slice->GetOutput(), folder + "/ColonCleansedSlice.nrrd");
  const shapeton::VertexMatrix & line = model.centerline.curve.V;
  const auto points = basetest::NewImage<CtImage>({ { 3, static_cast<itk::SizeValueType>(line.rows()), 1 } });
  std::copy(line.data(), line.data() + line.size(), points->GetBufferPointer());
  shapeton::WriteVolume(points.GetPointer(), folder + "/ColonCenterline.nrrd");
}

TEST(ColonModel, OfACtIsATubeAroundTheTrueLine)
{
  const auto patient = MakePatient();
  auto       options = Options();
  double     progress = 0.0;
  options.sliceThickness = 4.0;
  options.progress = [&progress](const std::string & stage, double share) {
    EXPECT_FALSE(stage.empty());
    EXPECT_GE(share, progress);
    progress = share;
  };
  const shapeton::ColonModel model = shapeton::BuildColonModel(CtOf(patient).GetPointer(), options);
  ASSERT_EQ(model.failure, "");
  EXPECT_DOUBLE_EQ(progress, 1.0);
  EXPECT_GT(ShareOfLabels(model.lumen.labels, patient->GetLumenOutput()), 0.95);
  EXPECT_LT(MeanDistance(model.centerline.curve, patient->GetAnatomy().Centerline()), 3.0);
  EXPECT_NEAR(model.centerline.length / patient->GetAnatomy().Length(), 1.0, 0.05);
  ExpectTube(model.wall.repaired);
  ExpectTube(model.wall.simplified);
  EXPECT_LE(model.wall.report.repairedGenus, 2);
  EXPECT_NEAR(model.wall.simplified.NumberOfFaces(), 20000, 400);
  ExpectQuality(model);
  WriteForBaselines(model);
}

TEST(ColonModel, ObliqueAxesGiveTheSameColon)
{
  // Rotation by 20 degrees about z, and two axes swapped.
  const auto patient =
    MakePatient(Source::DirectionType(basetest::Rotation(2, 0.35) * basetest::Rotation(0, 0.5 * shapeton::Pi)));
  const auto ct = CtOf(patient);
  itk::EncapsulateMetaData<std::string>(ct->GetMetaDataDictionary(), shapeton::DicomSliceThickness, "1.25");
  const shapeton::ColonModel model = shapeton::BuildColonModel(ct.GetPointer(), Options());
  ASSERT_EQ(model.failure, "");
  EXPECT_EQ(model.resolution.sliceThickness, 1.25);
  EXPECT_LT(MeanDistance(model.centerline.curve, patient->GetAnatomy().Centerline()), 3.0);
  EXPECT_NEAR(model.centerline.length / patient->GetAnatomy().Length(), 1.0, 0.05);
  ExpectTube(model.wall.simplified);
}

void
ExpectModelOfMask(Source * patient)
{
  const shapeton::ColonModel model = shapeton::BuildColonModelOfLumen(patient->GetLumenOutput(), Options());
  EXPECT_FALSE(model.hasIntensities);
  EXPECT_EQ(model.cleansed, nullptr);
  ExpectTube(model.wall.simplified);
  double volume = 0.0;
  for (const shapeton::LumenPiece & piece : model.lumen.pieces)
  {
    volume += piece.gasMl;
  }
  EXPECT_NEAR(volume, model.wall.report.topology.lumenVolume + model.wall.report.topology.droppedVolume, 0.02 * volume);
  EXPECT_LT(MeanDistance(model.centerline.curve, patient->GetAnatomy().Centerline()), 3.0);
}

/** If no position is given, gravity points from gas to fluid. */
void
ExpectGasAndFluidOfMask(Source * patient)
{
  auto options = Options();
  options.position.clear();
  const auto                 ct = CtOf(patient);
  const shapeton::ColonModel model = shapeton::BuildColonModel(ct.GetPointer(), patient->GetLumenOutput(), options);
  ASSERT_EQ(model.failure, "");
  EXPECT_EQ(model.lumen.gravity[1], 1.0);
  EXPECT_TRUE(model.lumen.isTagged);
  EXPECT_NEAR(model.lumen.thresholds.gas, -994.0, 5.0);
  std::size_t right = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < model.lumen.labels->GetLargestPossibleRegion().GetNumberOfPixels(); ++i)
  {
    const auto truth = patient->GetLumenOutput()->GetBufferPointer()[i];
    all += truth != 0;
    right += truth != 0 && truth == model.lumen.labels->GetBufferPointer()[i];
  }
  EXPECT_GT(static_cast<double>(right), 0.93 * static_cast<double>(all)); // except partial volume at levels and walls
}

TEST(ColonModel, OfTheTrueMaskAloneOrBesideTheCt)
{
  const auto patient = MakePatient();
  ExpectModelOfMask(patient);
  ExpectGasAndFluidOfMask(patient);
}

TEST(ColonModel, TheCatheterIsWrittenWhereOneLies)
{
  shapeton::ColonModel model;
  EXPECT_FALSE(shapeton::ColonQualityToJson(model)["lumen"].contains("catheter"));
  shapeton::RectalCatheter catheter;
  catheter.isSure = true;
  catheter.axis.resize(41);
  catheter.axis.back().Fill(40.0);
  catheter.outerDiameter = 10.0;
  catheter.wallHU = 150.0;
  catheter.evidence.length = 35.0;
  catheter.evidence.confidence = 0.75;
  model.lumen.catheter = catheter;
  const auto json = shapeton::ColonQualityToJson(model)["lumen"]["catheter"];
  EXPECT_EQ(json["found"], true);
  EXPECT_EQ(json["from"], shapeton::Json({ 0.0, 0.0, 0.0 }));
  EXPECT_EQ(json["to"], shapeton::Json({ 40.0, 40.0, 40.0 }));
  EXPECT_EQ(json["length"], 35.0);
  EXPECT_EQ(json["outerDiameter"], 10.0);
  EXPECT_EQ(json["wallHU"], 150.0);
  EXPECT_EQ(json["confidence"], 0.75);
  EXPECT_TRUE(json["evidence"].contains("enclosedShare"));
}

TEST(ColonModel, WithoutAColonSaysSo)
{
  const auto ct = basetest::NewImage<CtImage>({ { 32, 32, 32 } });
  ct->FillBuffer(40.0F);
  auto options = Options();
  options.keepPartial = true;
  const shapeton::ColonModel model = shapeton::BuildColonModel(ct.GetPointer(), options);
  EXPECT_EQ(model.failure.compare(0, 14, "no colon found"), 0) << model.failure;
  EXPECT_EQ(model.wall.raw.NumberOfFaces(), 0);
  const shapeton::Json quality = shapeton::ColonQualityToJson(model);
  EXPECT_FALSE(quality.at("isComplete").get<bool>());
  EXPECT_EQ(quality.at("failure").get<std::string>(), model.failure);
}

/** Soft tissue around gas 100 mm long and 50 mm wide, like a stomach, and a mask of the gas. */
std::pair<CtImage::Pointer, shapeton::LumenMask::Pointer>
BagOfGas()
{
  const auto ct = basetest::NewImage<CtImage>({ { 48, 48, 64 } }, { 2.5, 2.5, 2.5 });
  const auto mask = shapeton::NewImageOn<shapeton::LumenMask>(ct, true);
  basetest::ForVoxels(ct, [&](const auto & index, const auto & p) {
    const double along = std::max(0.0, std::abs(p[2] - 80.0) - 25.0);
    const bool   isGas = std::hypot(p[0] - 60.0, p[1] - 60.0, along) < 25.0;
    ct->SetPixel(index, isGas ? -1000.0F : 40.0F);
    mask->SetPixel(index, isGas);
  });
  return { ct, mask };
}

TEST(ColonModel, AShortBagOfGasWithinTheScanIsNotAColon)
{
  const auto [ct, mask] = BagOfGas();
  const auto model = shapeton::BuildColonModel(ct.GetPointer(), Options());
  EXPECT_NE(model.failure.find("shorter than a colon"), std::string::npos) << model.failure;
  EXPECT_EQ(model.wall.raw.NumberOfFaces(), 0);
  EXPECT_EQ(shapeton::ColonQualityToJson(model).at("missing").size(), 1U);
  auto options = Options();
  options.keepPartial = true;
  EXPECT_GT(shapeton::BuildColonModel(ct.GetPointer(), options).wall.raw.NumberOfFaces(), 0);
  options = Options();
  options.seedPoint.emplace_back(std::array<double, 3>{ 60.0, 60.0, 80.0 }.data()); // as suggested by the message
  EXPECT_EQ(shapeton::BuildColonModel(ct.GetPointer(), options).failure, "");
  EXPECT_EQ(shapeton::BuildColonModel(ct.GetPointer(), mask.GetPointer(), Options()).failure, "");
}

TEST(ColonModel, APieceOfColonIsUsableAndNotComplete)
{
  const auto [ct, mask] = BagOfGas();
  const auto model = shapeton::BuildColonModelOfLumen(mask.GetPointer(), Options());
  auto       quality = shapeton::ColonQualityToJson(model);
  EXPECT_EQ(model.failure, "");
  EXPECT_FALSE(quality.at("isComplete").get<bool>());
  ASSERT_FALSE(quality.at("missing").empty());
  const auto tellsValve = [&] { return quality.at("missing").dump().find("ileocecal valve") != std::string::npos; };
  EXPECT_TRUE(tellsValve()) << quality.at("missing");
  const auto               parts = quality.at("missing").size();
  shapeton::IleocecalValve valve;
  shapeton::StateValve({ valve, "", {} }, quality); // found with the other position
  EXPECT_FALSE(tellsValve());
  EXPECT_EQ(quality.at("missing").size(), parts - 1);
  EXPECT_TRUE(quality.at("ileocecalValve").at("found").get<bool>());
  shapeton::StateValve({ std::nullopt, "why", {} }, quality);
  EXPECT_TRUE(tellsValve());
}

TEST(ColonModel, AMaskWithoutGasIsRefused)
{
  const auto ct = basetest::NewImage<CtImage>({ { 32, 32, 32 } });
  ct->FillBuffer(40.0F);
  const auto mask = shapeton::NewImageOn<shapeton::LumenMask>(ct, true);
  EXPECT_THROW(shapeton::BuildColonModel(ct.GetPointer(), mask.GetPointer(), Options()), shapeton::InputError);
  for (int i = 0; i < 12 * 12 * 12; ++i)
  {
    mask->SetPixel({ { 8 + i % 12, 8 + i / 12 % 12, 8 + i / 144 } }, 1);
  }
  EXPECT_THROW(shapeton::BuildColonModel(ct.GetPointer(), mask.GetPointer(), Options()), shapeton::InputError);
}

/** Whether a point is in the region around a section of a line along z. */
bool
IsInCapsule(const itk::Point<double, 3> & p, double x, double begin, double end, double radius)
{
  return std::hypot(p[0] - x, p[1], p[2] - std::clamp(p[2], begin, end)) < radius;
}

/** A straight colon with a diameter of 36 mm in soft tissue. At the given distance from its 118 mm gap, there is gas
 * 110 mm long and as narrow as small bowel. LPS, mm; 2 mm voxels. */
CtImage::Pointer
ColonInTwoParts(double aside)
{
  const auto image = basetest::NewImage<CtImage>({ { 90, 90, 220 } }, { 2.0, 2.0, 2.0 }, { -89.0, -89.0, 0.0 });
  basetest::ForVoxels(image, [&](const auto & index, const auto & p) {
    const bool isBody = std::max(std::abs(p[0]), std::abs(p[1])) < 80.0;
    const bool isColon = IsInCapsule(p, 0.0, 38.0, 132.0, 18.0) || IsInCapsule(p, 0.0, 286.0, 402.0, 18.0);
    const bool isThin = IsInCapsule(p, aside, 163.0, 255.0, 9.0);
    image->SetPixel(index, isBody && !isColon && !isThin ? 40.0F : -1000.0F);
  });
  return image;
}

unsigned char
LabelAt(const shapeton::ColonModel & model, double x, double z)
{
  const double place[] = { x, 0.0, z };
  return model.lumen.labels->GetPixel(model.lumen.labels->TransformPhysicalPointToIndex(itk::Point<double, 3>(place)));
}

bool
TellsOfAFilledGap(const shapeton::ColonModel & model)
{
  return std::any_of(model.warnings.begin(), model.warnings.end(), [](const std::string & warning) {
    return warning.find("connect the ends of a gap") != std::string::npos;
  });
}

/** The model of a colon in two parts; `cleansed` receives each cleansed image reported along the way. */
shapeton::ColonModel
ModelOfTwoParts(double aside, std::vector<const CtImage *> & cleansed)
{
  auto options = Options();
  options.onCleansed = [&cleansed](const CtImage * ct) { cleansed.push_back(ct); };
  return shapeton::BuildColonModel(ColonInTwoParts(aside), options);
}

TEST(ColonModel, ThinGasThatFillsAGapIsColon)
{
  std::vector<const CtImage *> cleansed;
  const shapeton::ColonModel   model = ModelOfTwoParts(0.0, cleansed);
  EXPECT_EQ(model.failure, "");
  EXPECT_TRUE(TellsOfAFilledGap(model));
  ASSERT_EQ(cleansed.size(), 2U); // the first result is without the gas
  EXPECT_EQ(cleansed.back(), model.cleansed.GetPointer());
  EXPECT_EQ(LabelAt(model, 0.0, 209.0), 1);
  for (const shapeton::CenterlineGap & gap : model.centerline.gaps)
  {
    EXPECT_LT(gap.distance, 15.0);
  }
}

TEST(ColonModel, ThinGasBesideAGapIsLeftOut)
{
  std::vector<const CtImage *> cleansed;
  const shapeton::ColonModel   model = ModelOfTwoParts(40.0, cleansed);
  ASSERT_EQ(cleansed.size(), 1U);
  EXPECT_EQ(cleansed.front(), model.cleansed.GetPointer());
  EXPECT_EQ(model.failure, "");
  EXPECT_FALSE(TellsOfAFilledGap(model));
  EXPECT_EQ(LabelAt(model, 40.0, 209.0), 0);
  ASSERT_EQ(model.centerline.gaps.size(), 1U);
  EXPECT_NEAR(model.centerline.gaps[0].distance, 118.0, 8.0);
}

} // namespace

TEST(ColonModel, AFailureBesideAnotherIsNotLost)
{
  auto options = Options();
  options.besideSimplification = [](const auto &, const auto &) { throw shapeton::InputError("no such wall"); };
  const auto ct = CtOf(MakePatient());
  EXPECT_THROW(shapeton::BuildColonModel(ct.GetPointer(), options), shapeton::InputError);
  options.onCleansed = [](const CtImage *) { throw shapeton::OutputError("the disk is full"); };
  EXPECT_THROW(shapeton::BuildColonModel(ct.GetPointer(), options), shapeton::OutputError);
}

TEST(ColonModel, OfACoarseLumenIsMadeWhereTheLineLeavesOneOfItsFields)
{
  const auto source = Source::New();
  source->SetSize({ { 96, 96, 90 } });
  source->SetSpacing(Source::SpacingType(3.7));
  source->CenterOutput();
  source->SetTruthOnly(true);
  source->Update();
  const shapeton::ColonModel model = shapeton::BuildColonModelOfLumen(source->GetLumenOutput(), Options());
  EXPECT_GT(model.wall.repaired.NumberOfFaces(), 10000);
}
