#ifndef shapetonDicomFields_h
#define shapetonDicomFields_h

#include "itkMetaDataObject.h"
#include "itkObject.h"

#include <string>

namespace shapeton
{
/** \name DICOM fields of an image
 * Keys in the MetaDataDictionary of an image, as written by ReadVolume() and itk::GDCMImageIO. itk::ImageSeriesReader
 * keeps the fields of each slice, but does not set those of its output:
 * `image->SetMetaDataDictionary(*(*reader->GetMetaDataDictionaryArray())[0])`. Filters of ITK do not copy them to their
 * outputs. \ingroup ShapetonCommon */
///@{
constexpr auto DicomModality = "0008|0060";
constexpr auto DicomSliceThickness = "0018|0050"; ///< mm
constexpr auto DicomPatientPosition = "0018|5100";
///@}

/** Text of a DICOM field of an image; empty if unknown. \ingroup ShapetonCommon */
inline std::string
DicomField(const itk::Object * image, const char * key)
{
  std::string text;
  itk::ExposeMetaData(image->GetMetaDataDictionary(), key, text);
  return text.erase(text.find_last_not_of(' ') + 1); // DICOM pads to an even length
}
} // namespace shapeton

#endif
