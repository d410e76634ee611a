#include "itkVTKImageBridge.h"

#include "gtest/gtest.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace
{
/** An oblique, anisotropic grid whose region does not start at 0 and whose values are all different. */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeObliqueImage()
{
  using ImageType = itk::Image<TPixel, 3>;
  auto                               image = ImageType::New();
  typename ImageType::DirectionType  direction;
  typename ImageType::RegionType     region;
  const typename ImageType::SizeType size{ { 5, 4, 3 } };
  region.SetSize(size);
  region.SetIndex({ { -2, 7, 1 } });
  // A rotation by 30 degrees about z after one by 20 degrees about x.
  const double c = std::cos(0.5235987755982988);
  const double s = std::sin(0.5235987755982988);
  const double d = std::cos(0.3490658503988659);
  const double t = std::sin(0.3490658503988659);
  const double rows[3][3] = { { c, -s * d, s * t }, { s, c * d, -c * t }, { 0.0, t, d } };
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      direction[row][column] = rows[row][column];
    }
  }
  const double spacing[3] = { 0.7, 0.9, 2.5 };
  const double origin[3] = { -101.25, 33.5, 812.0 };
  image->SetDirection(direction);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetRegions(region);
  image->Allocate();
  for (itk::SizeValueType i = 0; i < region.GetNumberOfPixels(); ++i)
  {
    image->GetBufferPointer()[i] = static_cast<TPixel>(std::numeric_limits<TPixel>::max() / 4 + i);
  }
  image->SetPixel({ { -2, 7, 1 } }, std::numeric_limits<TPixel>::lowest());
  return image;
}

template <typename TPixel>
class VTKImageBridge : public testing::Test
{};

using PixelTypes = testing::Types<float, short, unsigned char, unsigned short, unsigned int>;
TYPED_TEST_SUITE(VTKImageBridge, PixelTypes);

TYPED_TEST(VTKImageBridge, VoxelsKeepValueIndexAndPhysicalPosition)
{
  const auto                       image = MakeObliqueImage<TypeParam>();
  const auto                       vtk = itk::ImageToVTK<TypeParam>(image);
  const itk::ImageRegion<3>        region = image->GetBufferedRegion();
  itk::Image<TypeParam, 3> * const pointer = image;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    itk::Index<3> index;
    int           vtkIndex[3];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      index[axis] = region.GetIndex(axis) + ((corner >> axis) & 1 ? region.GetSize(axis) - 1 : 0);
      vtkIndex[axis] = static_cast<int>(index[axis]);
    }
    itk::ImageBase<3>::PointType point;
    pointer->TransformIndexToPhysicalPoint(index, point);
    double vtkPoint[3];
    vtk->TransformIndexToPhysicalPoint(vtkIndex, vtkPoint);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(vtkPoint[axis], point[axis], 1e-9) << "corner " << corner;
    }
    EXPECT_EQ(*static_cast<TypeParam *>(vtk->GetScalarPointer(vtkIndex)), pointer->GetPixel(index));
  }
}

TYPED_TEST(VTKImageBridge, RoundTripIsExact)
{
  const auto image = MakeObliqueImage<TypeParam>();
  const auto back = itk::ImageFromVTK<TypeParam>(itk::ImageToVTK<TypeParam>(image));
  EXPECT_EQ(back->GetBufferedRegion(), image->GetBufferedRegion());
  EXPECT_EQ(back->GetOrigin(), image->GetOrigin());
  EXPECT_EQ(back->GetSpacing(), image->GetSpacing());
  EXPECT_EQ(back->GetDirection(), image->GetDirection());
  for (itk::SizeValueType i = 0; i < image->GetBufferedRegion().GetNumberOfPixels(); ++i)
  {
    ASSERT_EQ(back->GetBufferPointer()[i], image->GetBufferPointer()[i]);
  }
}

TYPED_TEST(VTKImageBridge, TheCopyIsIndependent)
{
  auto       image = MakeObliqueImage<TypeParam>();
  const auto vtk = itk::ImageToVTK<TypeParam>(image);
  const auto before = image->GetBufferPointer()[7];
  image->FillBuffer(1);
  image = nullptr;
  EXPECT_EQ(static_cast<TypeParam *>(vtk->GetScalarPointer())[7], before);
}
} // namespace

TEST(VTKImageBridgeErrors, TypesAreNotConverted)
{
  const auto shorts = itk::ImageToVTK<short>(MakeObliqueImage<short>());
  EXPECT_THROW(itk::ImageFromVTK<float>(shorts), std::invalid_argument);
  EXPECT_THROW(itk::ImageFromVTK<unsigned short>(shorts), std::invalid_argument);
  auto colours = vtkSmartPointer<vtkImageData>::New();
  colours->SetDimensions(2, 2, 2);
  EXPECT_THROW(itk::ImageFromVTK<unsigned char>(colours), std::invalid_argument);
  colours->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  EXPECT_THROW(itk::ImageFromVTK<unsigned char>(colours), std::invalid_argument);
  EXPECT_THROW(itk::ImageFromVTK<float>(nullptr), std::invalid_argument);
  EXPECT_THROW(itk::ImageToVTK<float>(nullptr), std::invalid_argument);
}
