#ifndef shapetonDicomSeriesFolder_h
#define shapetonDicomSeriesFolder_h

#include "shapetonDicomSeriesWriter.h"

#include <functional>
#include <string>

namespace shapeton
{
/** Manufacturer and model in written headers; they identify series that may be replaced. */
constexpr const char * DicomSeriesManufacturer = "Shapeton";
constexpr const char * DicomSeriesModel = "DicomSeries";

/** The file name of slice 1, 2, ... */
std::string
DicomSliceName(std::size_t number);

/** WriteDicomSeries with a callback `beforeSlice`, which is called before each slice and may throw to abort. */
void
WriteDicomSlices(const itk::Image<short, 3> *   image,
                 const std::string &            folder,
                 const DicomSeriesDescription & description,
                 const std::function<void()> &  beforeSlice);
} // namespace shapeton

#endif
