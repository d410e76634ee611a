#include "shapetonImageDataAdapter.h"
#include "shapetonExceptions.h"
#include "shapetonTestImages.h"

#include "itkVectorImage.h"
#include "itkRGBPixel.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

using namespace shapeton;

namespace
{
/** Anisotropic and oblique, with a region that does not start at 0; values 0, 1, 2, ... */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
ObliqueImage()
{
  using ImageType = itk::Image<TPixel, 3>;
  auto                          image = ImageType::New();
  typename ImageType::IndexType start{ { 2, -1, 5 } };
  typename ImageType::SizeType  size{ { 4, 3, 2 } };
  image->SetRegions(typename ImageType::RegionType(start, size));
  image->SetSpacing(std::array<double, 3>{ { 0.7, 1.1, 2.5 } }.data());
  image->SetOrigin(std::array<double, 3>{ { -20.0, 35.0, 7.0 } }.data());
  image->SetDirection(basetest::Rotation(2, 0.4));
  image->Allocate();
  std::iota(image->GetBufferPointer(), image->GetBufferPointer() + 24, TPixel(0));
  return image;
}
} // namespace

TEST(ImageDataAdapter, EachVoxelKeepsItsValueAtItsPlaceInThePatient)
{
  const auto image = ObliqueImage<short>();
  for (const PatientSpace space : { PatientSpace::LPS, PatientSpace::RAS })
  {
    const double sign = space == PatientSpace::RAS ? -1.0 : 1.0;
    const auto   data = ImageDataOf(image.GetPointer(), space);
    EXPECT_EQ(SpaceOf(*data->GetFieldData(), PatientSpace::LPS), space);
    EXPECT_EQ(data->GetScalarType(), VTK_SHORT);
    for (vtkIdType i = 0; i < 24; ++i)
    {
      const auto index = image->ComputeIndex(i);
      const auto place = image->TransformIndexToPhysicalPoint<double>(index);
      int ijk[3] = { static_cast<int>(index[0] - 2), static_cast<int>(index[1] + 1), static_cast<int>(index[2] - 5) };
      double xyz[3];
      data->TransformIndexToPhysicalPoint(ijk, xyz);
      EXPECT_NEAR(xyz[0], sign * place[0], 1e-12);
      EXPECT_NEAR(xyz[1], sign * place[1], 1e-12);
      EXPECT_NEAR(xyz[2], place[2], 1e-12);
      EXPECT_EQ(data->GetScalarComponentAsDouble(ijk[0], ijk[1], ijk[2], 0), image->GetPixel(index));
    }
  }
}

TEST(ImageDataAdapter, AnImageComesBackFromEitherSpace)
{
  const auto image = ObliqueImage<float>();
  for (const PatientSpace space : { PatientSpace::LPS, PatientSpace::RAS })
  {
    // The space stated by the data takes precedence over the argument.
    const auto back = ImageOf<itk::Image<float, 3>>(*ImageDataOf(image.GetPointer(), space), PatientSpace::RAS);
    EXPECT_EQ(back->GetSpacing(), image->GetSpacing());
    EXPECT_EQ(back->GetDirection(), image->GetDirection());
    const auto first = image->GetBufferedRegion().GetIndex();
    EXPECT_LT(back->GetOrigin().EuclideanDistanceTo(image->TransformIndexToPhysicalPoint<double>(first)), 1e-12);
    EXPECT_TRUE(std::equal(image->GetBufferPointer(), image->GetBufferPointer() + 24, back->GetBufferPointer()));
  }
}

TEST(ImageDataAdapter, AnExtentThatDoesNotStartAt0KeepsItsPlace)
{
  vtkNew<vtkImageData> data;
  data->SetExtent(3, 4, 0, 0, -2, -1);
  data->SetSpacing(2.0, 1.0, 0.5);
  data->SetOrigin(10.0, 20.0, 30.0);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  data->SetScalarComponentFromDouble(4, 0, -1, 0, 7.0);
  const auto                  image = ImageOf<itk::Image<unsigned char, 3>>(*data);
  const itk::Point<double, 3> first(std::array<double, 3>{ { 16.0, 20.0, 29.0 } });
  EXPECT_EQ(image->GetOrigin(), first);
  EXPECT_EQ(image->GetPixel({ { 1, 0, 1 } }), 7);
}

TEST(ImageDataAdapter, ColorsKeepTheirComponents)
{
  using Picture = itk::Image<itk::RGBPixel<unsigned char>, 2>;
  auto picture = Picture::New();
  picture->SetRegions(Picture::SizeType{ { 3, 2 } });
  picture->Allocate();
  itk::RGBPixel<unsigned char> color;
  color.Set(1, 2, 3);
  picture->FillBuffer(color);
  color.Set(250, 7, 90);
  picture->SetPixel({ { 2, 1 } }, color);
  const auto data = ImageDataOf(picture.GetPointer());
  EXPECT_EQ(data->GetNumberOfScalarComponents(), 3);
  EXPECT_EQ(data->GetScalarComponentAsDouble(2, 1, 0, 1), 7.0);
  EXPECT_EQ(ImageOf<Picture>(*data)->GetPixel({ { 2, 1 } }), color);
}

TEST(ImageDataAdapter, VectorImagesKeepTheirComponents)
{
  using Vectors = itk::VectorImage<float, 3>;
  const auto vectors = Vectors::New();
  vectors->SetRegions(Vectors::SizeType{ { 2, 3, 4 } });
  vectors->SetNumberOfComponentsPerPixel(5);
  vectors->Allocate();
  for (int i = 0; i < 2 * 3 * 4 * 5; ++i)
  {
    vectors->GetBufferPointer()[i] = static_cast<float>(i);
  }
  const auto data = ImageDataOf(vectors.GetPointer());
  ASSERT_EQ(data->GetNumberOfScalarComponents(), 5);
  EXPECT_EQ(data->GetScalarComponentAsDouble(1, 2, 3, 4), 119.0);
  EXPECT_EQ(data->GetScalarComponentAsDouble(1, 0, 0, 2), vectors->GetPixel({ { 1, 0, 0 } })[2]);
}

TEST(ImageDataAdapter, WhatIsNoSuchImageIsRefused)
{
  vtkNew<vtkImageData> empty;
  EXPECT_THROW((ImageOf<itk::Image<float, 3>>(*empty)), InputError);
  const auto volume = ImageDataOf(ObliqueImage<float>().GetPointer());
  EXPECT_THROW((ImageOf<itk::Image<float, 2>>(*volume)), InputError);
  EXPECT_THROW((ImageOf<itk::Image<itk::RGBPixel<float>, 3>>(*volume)), InputError);
}
