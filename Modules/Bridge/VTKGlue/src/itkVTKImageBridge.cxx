#include "itkVTKImageBridge.h"

#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkTypeTraits.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace itk
{
namespace
{
void
CopyGeometryToVTK(const ImageBase<3> & from, vtkImageData & to)
{
  double direction[9];
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      direction[3 * row + column] = from.GetDirection()[row][column];
    }
  }
  to.SetOrigin(from.GetOrigin().GetDataPointer());
  to.SetSpacing(from.GetSpacing().GetDataPointer());
  to.SetDirectionMatrix(direction);
}

void
CopyGeometryFromVTK(vtkImageData & from, ImageBase<3> & to)
{
  ImageBase<3>::DirectionType direction;
  for (unsigned int row = 0; row < 3; ++row)
  {
    for (unsigned int column = 0; column < 3; ++column)
    {
      direction[row][column] = from.GetDirectionMatrix()->GetElement(row, column);
    }
  }
  to.SetOrigin(from.GetOrigin());
  to.SetSpacing(from.GetSpacing());
  to.SetDirection(direction);
}

ImageRegion<3>
RegionOfExtent(const int extent[6])
{
  ImageRegion<3> region;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetIndex(axis, extent[2 * axis]);
    region.SetSize(axis, extent[2 * axis + 1] - extent[2 * axis] + 1);
  }
  return region;
}
} // namespace

template <typename TPixel>
vtkSmartPointer<vtkImageData>
ImageToVTK(const Image<TPixel, 3> * image)
{
  if (!image)
  {
    throw std::invalid_argument("ImageToVTK: there is no image");
  }
  const ImageRegion<3> region = image->GetBufferedRegion();
  int                  extent[6];
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = static_cast<int>(region.GetIndex(axis));
    extent[2 * axis + 1] = static_cast<int>(region.GetIndex(axis) + region.GetSize(axis)) - 1;
  }
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetExtent(extent);
  CopyGeometryToVTK(*image, *result);
  result->AllocateScalars(vtkTypeTraits<TPixel>::VTK_TYPE_ID, 1);
  std::copy_n(image->GetBufferPointer(), region.GetNumberOfPixels(), static_cast<TPixel *>(result->GetScalarPointer()));
  return result;
}

template <typename TPixel>
typename Image<TPixel, 3>::Pointer
ImageFromVTK(vtkImageData * image)
{
  vtkDataArray * const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars)
  {
    throw std::invalid_argument("ImageFromVTK: the VTK image has no scalars");
  }
  if (scalars->GetNumberOfComponents() != 1 || scalars->GetDataType() != vtkTypeTraits<TPixel>::VTK_TYPE_ID)
  {
    throw std::invalid_argument(std::string("ImageFromVTK: the VTK image holds ") +
                                std::to_string(scalars->GetNumberOfComponents()) + " x " +
                                scalars->GetDataTypeAsString() + ", not one " + vtkTypeTraits<TPixel>::Name());
  }
  auto result = Image<TPixel, 3>::New();
  CopyGeometryFromVTK(*image, *result);
  result->SetRegions(RegionOfExtent(image->GetExtent()));
  result->Allocate();
  std::copy_n(
    static_cast<const TPixel *>(image->GetScalarPointer()), scalars->GetNumberOfTuples(), result->GetBufferPointer());
  return result;
}

#define itkVTKImageBridgeTemplate(TPixel)                                                                              \
  template VTKGlue_EXPORT vtkSmartPointer<vtkImageData> ImageToVTK(const Image<TPixel, 3> *);                          \
  template VTKGlue_EXPORT Image<TPixel, 3>::Pointer ImageFromVTK<TPixel>(vtkImageData *)

itkVTKImageBridgeTemplate(float);
itkVTKImageBridgeTemplate(short);
itkVTKImageBridgeTemplate(unsigned char);
itkVTKImageBridgeTemplate(unsigned short);
itkVTKImageBridgeTemplate(unsigned int);
} // namespace itk
