#ifndef shapetonReadImage_h
#define shapetonReadImage_h

#include "shapetonExceptions.h"

#include "itkImageFileReader.h"

#include <string>

namespace shapeton
{
/** Reads an image written by one of the tools, with its own pixel type. Throws InputError with the file name and
 * `advice`. \ingroup ShapetonVolumeFiles */
template <typename TImage>
typename TImage::Pointer
ReadImage(const std::string & path, itk::ImageIOBase * format, const std::string & advice)
{
  const auto reader = itk::ImageFileReader<TImage>::New();
  reader->SetImageIO(format);
  reader->SetFileName(path);
  try
  {
    reader->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    throw InputError("\"" + path + "\" cannot be read (" + error.GetDescription() + "); " + advice);
  }
  return reader->GetOutput();
}
} // namespace shapeton

#endif
