// Reads a DICOM series with ITK for the examples.
#ifndef ITKSeries_h
#define ITKSeries_h

#include "itkGDCMImageIO.h"
#include "itkGDCMSeriesFileNames.h"
#include "itkImageSeriesReader.h"

#include <string>

inline itk::Image<float, 3>::Pointer
ReadITKSeries(const std::string & folder)
{
  const auto names = itk::GDCMSeriesFileNames::New();
  names->SetInputDirectory(folder);
  const auto reader = itk::ImageSeriesReader<itk::Image<float, 3>>::New();
  reader->SetImageIO(itk::GDCMImageIO::New());
  reader->SetFileNames(names->GetInputFileNames());
  reader->Update();
  // ITK's reader keeps the DICOM fields of each slice, but does not set those of the volume. Shapeton uses modality,
  // patient position and slice thickness, see shapetonDicomFields.h.
  itk::Image<float, 3>::Pointer image = reader->GetOutput();
  image->SetMetaDataDictionary(*(*reader->GetMetaDataDictionaryArray())[0]);
  return image;
}

#endif
