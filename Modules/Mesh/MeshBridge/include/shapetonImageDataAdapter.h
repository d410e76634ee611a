#ifndef shapetonImageDataAdapter_h
#define shapetonImageDataAdapter_h

#include "shapetonPatientSpace.h"

#include "itkDefaultConvertPixelTraits.h"
#include "itkImage.h"
#include "itkVariableLengthVector.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <cstring>
#include <type_traits>

namespace shapeton
{
/** Throws InputError unless the data have scalars with this number of components and at most these dimensions.
 * \ingroup ShapetonMeshBridge */
ShapetonMeshBridge_EXPORT void
RequireScalars(vtkImageData & data, unsigned int dimension, int components);

/** \name Images as vtkImageData
 * Images of two or three dimensions with pixels of one or several components (RGBPixel, Vector; ImageDataOf() also
 * VectorImage). Spacing, origin and direction cosines are kept; SPACE in the field data states the axes. VTK filters
 * before version 9.0 ignore directions: use axis-aligned images. Pixels are copied. */
///@{

/** Converts the buffered region of an image to the given space; its first pixel is at the origin.
 * \ingroup ShapetonMeshBridge */
template <typename TImage>
vtkSmartPointer<vtkImageData>
ImageDataOf(const TImage * image, PatientSpace space = PatientSpace::LPS)
{
  constexpr unsigned int dimension = TImage::ImageDimension;
  using Traits = itk::DefaultConvertPixelTraits<typename TImage::PixelType>;
  using Component = typename Traits::ComponentType;
  static_assert(!std::is_same_v<typename TImage::InternalPixelType, itk::VariableLengthVector<Component>>,
                "images of VariableLengthVector are not supported: use an itk::VectorImage");
  const auto components = static_cast<int>(image->GetNumberOfComponentsPerPixel());
  const auto region = image->GetBufferedRegion();
  const auto origin = image->template TransformIndexToPhysicalPoint<double>(region.GetIndex());
  int        dimensions[3] = { 1, 1, 1 };
  double     spacings[3] = { 1.0, 1.0, 1.0 };
  double     place[3] = { 0.0, 0.0, 0.0 };

  vtkNew<vtkMatrix3x3> direction; // identity
  for (unsigned int i = 0; i < dimension; ++i)
  {
    const double sign = space == PatientSpace::RAS && i < 2 ? -1.0 : 1.0;
    dimensions[i] = static_cast<int>(region.GetSize(i));
    spacings[i] = image->GetSpacing()[i];
    place[i] = sign * origin[i];
    for (unsigned int j = 0; j < dimension; ++j)
    {
      direction->SetElement(i, j, sign * image->GetDirection()(i, j));
    }
  }
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(dimensions);
  data->SetSpacing(spacings);
  data->SetOrigin(place);
  data->SetDirectionMatrix(direction);
  vtkNew<vtkAOSDataArrayTemplate<Component>> scalars;
  scalars->SetName("scalars");
  scalars->SetNumberOfComponents(components);
  scalars->SetNumberOfTuples(static_cast<vtkIdType>(region.GetNumberOfPixels()));
  std::memcpy(
    scalars->GetVoidPointer(0), image->GetBufferPointer(), sizeof(Component) * components * region.GetNumberOfPixels());
  data->GetPointData()->SetScalars(scalars);
  SetSpace(space, *data->GetFieldData());
  return data;
}

/** Converts the scalars to an image in LPS. `space` is used unless the field data state a space. Values are converted
 * to the pixel type by static_cast. Throws InputError if there are no scalars, or if their number of components
 * differs from the pixels'. \ingroup ShapetonMeshBridge */
template <typename TImage>
typename TImage::Pointer
ImageOf(vtkImageData & data, PatientSpace space = PatientSpace::LPS)
{
  constexpr unsigned int dimension = TImage::ImageDimension;
  using Traits = itk::DefaultConvertPixelTraits<typename TImage::PixelType>;
  static_assert(!std::is_same_v<typename TImage::PixelType, itk::VariableLengthVector<typename Traits::ComponentType>>,
                "the image type must have a fixed number of components per pixel");
  vtkDataArray * const scalars = data.GetPointData()->GetScalars();
  RequireScalars(data, dimension, static_cast<int>(Traits::GetNumberOfComponents()));
  space = SpaceOf(*data.GetFieldData(), space);

  const int * const extent = data.GetExtent();
  const int         first[3] = { extent[0], extent[2], extent[4] };
  double            place[3];
  data.TransformIndexToPhysicalPoint(first, place);
  typename TImage::SizeType      size;
  typename TImage::SpacingType   spacing;
  typename TImage::PointType     origin;
  typename TImage::DirectionType direction;
  for (unsigned int i = 0; i < dimension; ++i)
  {
    const double sign = space == PatientSpace::RAS && i < 2 ? -1.0 : 1.0;
    size[i] = static_cast<itk::SizeValueType>(data.GetDimensions()[i]);
    spacing[i] = data.GetSpacing()[i];
    origin[i] = sign * place[i];
    for (unsigned int j = 0; j < dimension; ++j)
    {
      direction(i, j) = sign * data.GetDirectionMatrix()->GetElement(i, j);
    }
  }
  auto image = TImage::New();
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  image->Allocate();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    for (unsigned int c = 0; c < Traits::GetNumberOfComponents(); ++c)
    {
      Traits::SetNthComponent(
        static_cast<int>(c),
        image->GetBufferPointer()[i],
        static_cast<typename Traits::ComponentType>(scalars->GetComponent(i, static_cast<int>(c))));
    }
  }
  return image;
}
///@}
} // namespace shapeton

#endif
