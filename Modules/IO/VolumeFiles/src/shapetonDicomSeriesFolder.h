#ifndef shapetonDicomSeriesFolder_h
#define shapetonDicomSeriesFolder_h

#include "shapetonDicomSeriesWriter.h"

#include <functional>
#include <string>

namespace shapeton
{
/** Manufacturer and model in the headers of our slices; they identify a series that may be replaced. */
constexpr const char * DicomSeriesManufacturer = "Shapeton";
constexpr const char * DicomSeriesModel = "DicomSeries";

/** The file name of slice 1, 2, ... */
std::string
DicomSliceName(std::size_t number);

/** WriteDicomSeries that calls `beforeSlice` before each slice; an exception of it stops the writing. */
void
WriteDicomSlices(const itk::Image<short, 3> *   image,
                 const std::string &            folder,
                 const DicomSeriesDescription & description,
                 const std::function<void()> &  beforeSlice);
} // namespace shapeton

#endif
