#include "shapetonImageDataAdapter.h"

#include "shapetonExceptions.h"

namespace shapeton
{
void
RequireScalars(vtkImageData & data, unsigned int dimension, int components)
{
  vtkDataArray * const scalars = data.GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    throw InputError("the vtkImageData has no scalars; an image is required");
  }
  if (scalars->GetNumberOfComponents() != components)
  {
    throw InputError("the vtkImageData has " + std::to_string(scalars->GetNumberOfComponents()) +
                     " components per pixel, but the image type has " + std::to_string(components));
  }
  if (dimension < 3 && data.GetDimensions()[2] != 1)
  {
    throw InputError("the vtkImageData has " + std::to_string(data.GetDimensions()[2]) +
                     " slices, but the image is two-dimensional");
  }
}
} // namespace shapeton
