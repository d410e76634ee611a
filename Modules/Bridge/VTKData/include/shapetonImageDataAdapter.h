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
/** Throws InputError where the data have no scalars of so many components, or more dimensions. \ingroup VTKData */
VTKData_EXPORT void
RequireScalars(vtkImageData & data, unsigned int dimension, int components);

/** \name Images as vtkImageData
 * Images of two or three dimensions with pixels of one or several components (RGBPixel, Vector; ImageDataOf() also
 * VectorImage). Spacing, origin and direction cosines come along; SPACE in the field data says in which axes. Filters
 * of VTK that are older than its 9.0 overlook directions: give them images along the axes. Pixels are copied. */
///@{

/** An image in the given space. The buffered region alone, so that its first pixel lies at the origin.
 * \ingroup VTKData */
template <typename TImage>
vtkSmartPointer<vtkImageData>
ImageDataOf(const TImage * image, PatientSpace space = PatientSpace::LPS)
{
  constexpr unsigned int dimension = TImage::ImageDimension;
  using Traits = itk::DefaultConvertPixelTraits<typename TImage::PixelType>;
  using Component = typename Traits::ComponentType;
  static_assert(!std::is_same_v<typename TImage::InternalPixelType, itk::VariableLengthVector<Component>>,
                "pixels of variable length that each own their memory: use an itk::VectorImage");
  const auto components = static_cast<int>(image->GetNumberOfComponentsPerPixel());
  const auto region = image->GetBufferedRegion();
  const auto origin = image->template TransformIndexToPhysicalPoint<double>(region.GetIndex());
  int        dimensions[3] = { 1, 1, 1 };
  double     spacings[3] = { 1.0, 1.0, 1.0 };
  double     place[3] = { 0.0, 0.0, 0.0 };

  vtkNew<vtkMatrix3x3> direction; // the identity
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

/** The scalars as an image in LPS. `space` is that of the data where their field data state none. Values are converted
 * to the type of the pixels as static_cast does. Throws InputError where there are no scalars, or their number of
 * components is not that of the pixels. \ingroup VTKData */
template <typename TImage>
typename TImage::Pointer
ImageOf(vtkImageData & data, PatientSpace space = PatientSpace::LPS)
{
  constexpr unsigned int dimension = TImage::ImageDimension;
  using Traits = itk::DefaultConvertPixelTraits<typename TImage::PixelType>;
  static_assert(!std::is_same_v<typename TImage::PixelType, itk::VariableLengthVector<typename Traits::ComponentType>>,
                "an image whose pixels have a fixed number of components is needed");
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
