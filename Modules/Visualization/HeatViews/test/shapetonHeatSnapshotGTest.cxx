#include "shapetonHeatClassification.h"
#include "shapetonHeatSnapshot.h"
#include "shapetonVolumeReader.h"
#include "shapetonPictureTestUtilities.h"
#include "shapetonImageGrid.h"

#include "itkImageFileWriter.h"
#include "itkMetaDataObject.h"
#include "itkNrrdImageIO.h"
#include "shapetonTestErrors.h"
#include "shapetonVolumeWriter.h"
#include "shapetonTestImages.h"

namespace
{
using ImageType = itk::Image<float, 3>;

ImageType::Pointer
MakeHeat(float heat)
{
  auto image = basetest::NewImage<ImageType>({ { 4, 3, 2 } });
  image->FillBuffer(heat);
  return image;
}

void
WriteHeat(const std::string & path, const std::string & timeStep)
{
  auto image = MakeHeat(0.5F);
  if (!timeStep.empty())
  {
    itk::EncapsulateMetaData<std::string>(image->GetMetaDataDictionary(), "timeStep", timeStep);
  }
  auto writer = itk::ImageFileWriter<ImageType>::New();
  writer->SetImageIO(itk::NrrdImageIO::New());
  writer->SetInput(image);
  writer->SetFileName(path);
  writer->Update();
}

template <typename TError>
std::string
MessageOf(const std::string & path, std::optional<std::uint64_t> timeStep)
{
  return basetest::ErrorOf<TError>([&] { shapeton::FindHeatSnapshot(path, timeStep); });
}
} // namespace

TEST(HeatSnapshot, IsFoundInAFolder)
{
  const std::string folder = shapeton::TemporaryFolder("snapshots");
  EXPECT_EQ(shapeton::HeatSnapshotName(1000), "heat-000001000.nrrd");
  EXPECT_EQ(shapeton::HeatSnapshotName(12345678901ULL), "heat-12345678901.nrrd");
  for (const std::uint64_t timeStep : { 20ULL, 100ULL, 1000000ULL })
  {
    WriteHeat(folder + "/" + shapeton::HeatSnapshotName(timeStep), std::to_string(timeStep));
  }
  std::ofstream(folder + "/heat-00000abcd.nrrd") << "no snapshot";
  std::ofstream(folder + "/heat-30.nrrd") << "no snapshot";
  std::ofstream(folder + "/readme.txt") << "no snapshot";
  EXPECT_EQ(shapeton::FindHeatSnapshot(folder).path, folder + "/heat-001000000.nrrd");
  EXPECT_EQ(*shapeton::FindHeatSnapshot(folder, 20).timeStep, 20U);
  EXPECT_EQ(shapeton::FindHeatSnapshot(folder, 20).path, folder + "/heat-000000020.nrrd");
  EXPECT_NE(MessageOf<shapeton::ParameterError>(folder, 30).find("20, 100, 1000000"), std::string::npos);
}

TEST(HeatSnapshot, AVolumeShowsTheTimeStepOfItsHeader)
{
  const std::string folder = shapeton::TemporaryFolder("snapshot-volume");
  WriteHeat(folder + "/stated.nrrd", "750");
  WriteHeat(folder + "/silent.nrrd", "");
  EXPECT_EQ(*shapeton::FindHeatSnapshot(folder + "/stated.nrrd").timeStep, 750U);
  EXPECT_EQ(*shapeton::FindHeatSnapshot(folder + "/stated.nrrd", 750).timeStep, 750U);
  EXPECT_NE(MessageOf<shapeton::ParameterError>(folder + "/stated.nrrd", 751).find("750"), std::string::npos);
  EXPECT_FALSE(shapeton::FindHeatSnapshot(folder + "/silent.nrrd").timeStep);
  EXPECT_EQ(*shapeton::FindHeatSnapshot(folder + "/silent.nrrd", 3).timeStep, 3U);
}

TEST(HeatSnapshot, AMetaImageShowsItsTimeStepToo)
{
  auto heat = basetest::NewImage<itk::Image<float, 3>>({ { 3, 3, 3 } });
  heat->FillBuffer(0.5F);
  const std::string path = SHAPETON_TEST_TEMPORARY_DIR "/stated.mha";
  shapeton::WriteVolume(heat.GetPointer(), path, { { "timeStep", "50" } });
  EXPECT_EQ(shapeton::FindHeatSnapshot(path).timeStep, std::optional<std::uint64_t>(50));
  EXPECT_THROW(shapeton::FindHeatSnapshot(path, 49), shapeton::ParameterError);
}

TEST(HeatSnapshot, WhatIsMissingIsNamed)
{
  const std::string folder = shapeton::TemporaryFolder("snapshots-none");
  EXPECT_NE(MessageOf<shapeton::InputError>(folder, {}).find(folder), std::string::npos);
  EXPECT_NE(MessageOf<shapeton::InputError>(folder + "/none.nrrd", {}).find("none.nrrd"), std::string::npos);
}

TEST(HeatSnapshot, HeatLiesBetweenZeroAndOne)
{
  EXPECT_NO_THROW(shapeton::RequireHeat(MakeHeat(0.0F), "a"));
  EXPECT_NO_THROW(shapeton::RequireHeat(MakeHeat(1.0F), "a"));
  EXPECT_THROW(shapeton::RequireHeat(MakeHeat(1.01F), "a"), shapeton::InputError);
  EXPECT_THROW(shapeton::RequireHeat(MakeHeat(-0.01F), "a"), shapeton::InputError);
  EXPECT_THROW(shapeton::RequireHeat(MakeHeat(std::numeric_limits<float>::quiet_NaN()), "a"), shapeton::InputError);
}

TEST(HeatSnapshot, GridsAgreeBySizeAndPlace)
{
  const auto a = MakeHeat(0.0F);
  const auto same = MakeHeat(1.0F);
  EXPECT_TRUE(shapeton::HaveSameGrid(a, same));
  const double nearly[3] = { 1.0 + 1e-6, 1.0, 1.0 };
  same->SetSpacing(nearly);
  EXPECT_TRUE(shapeton::HaveSameGrid(a, same));
  const double wider[3] = { 1.01, 1.0, 1.0 };
  same->SetSpacing(wider);
  EXPECT_FALSE(shapeton::HaveSameGrid(a, same));
  const auto   moved = MakeHeat(0.0F);
  const double origin[3] = { 0.0, 0.0, 0.1 };
  moved->SetOrigin(origin);
  EXPECT_FALSE(shapeton::HaveSameGrid(a, moved));
  const auto               turned = MakeHeat(0.0F);
  ImageType::DirectionType direction = turned->GetDirection();
  direction[0][0] = -1.0;
  direction[1][1] = -1.0;
  turned->SetDirection(direction);
  EXPECT_FALSE(shapeton::HaveSameGrid(a, turned));
  auto larger = basetest::NewImage<ImageType>({ { 4, 3, 3 } });
  EXPECT_FALSE(shapeton::HaveSameGrid(a, larger));
}
