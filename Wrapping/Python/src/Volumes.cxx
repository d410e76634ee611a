#include "Bindings.h"
#include "Conversions.h"
#include "Errors.h"
#include "Options.h"

#include "shapetonDicomSeriesScan.h"
#include "shapetonExceptions.h"
#include "shapetonVolumeReader.h"
#include "shapetonVolumeWriter.h"

#include <algorithm>
#include <cmath>

namespace shapeton::python
{
namespace
{
py::object
ImageWithFacts(const Volume & volume)
{
  py::object image = ToPython<float>(volume.image.GetPointer());
  image.attr("facts") = py::dict("modality"_a = volume.modality,
                                 "patient_position"_a = volume.patientPosition,
                                 "slice_thickness"_a = volume.sliceThickness,
                                 "series_uid"_a = volume.seriesUID,
                                 "identity"_a = volume.identity,
                                 "repairs"_a = volume.repairs,
                                 "notes"_a = volume.notes);
  return image;
}

py::object
ReadWithFacts(const Path & path, const Given<VolumeReadOptions> & given, const Progress & progress)
{
  Volume volume;
  {
    const WithoutGil withoutGil;
    volume = ReadVolume(path.text, given.options, progress);
  }
  return ImageWithFacts(volume);
}

template <typename TPixel>
void
WriteAs(const py::object & image, const std::string & path, const VolumeMetadata & metadata)
{
  const auto       pixels = ImageOf<TPixel>(image);
  const WithoutGil withoutGil;
  WriteVolume(pixels.GetPointer(), path, metadata);
}

/** Throws ParameterError if single precision would round a voxel. */
void
RequireSinglePrecision(const py::array & array)
{
  const py::array_t<double, py::array::c_style | py::array::forcecast> voxels(array);
  const auto isRounded = [](double value) { return std::isfinite(value) && static_cast<float>(value) != value; };
  RequireParameter(
    std::none_of(voxels.data(), voxels.data() + voxels.size(), isRounded),
    "the parameter \"image\" has the type float64, which is written as float32 and would be rounded; round it first: "
    "image.like(image.array.astype(\"float32\"))");
}

void
Write(const py::object & image, const Path & file, const VolumeMetadata & metadata)
{
  const std::string & path = file.text;
  RequireVolumeName(path);
  const auto        array = image.attr("array").cast<py::array>();
  const std::string name = py::str(array.dtype().attr("name"));
  if (name == "float64")
  {
    RequireSinglePrecision(array);
  }
  if (name == "float32" || name == "float64")
  {
    WriteAs<float>(image, path, metadata);
  }
  else if (name == "int16")
  {
    WriteAs<short>(image, path, metadata);
  }
  else if (name == "uint8" || name == "bool")
  {
    WriteAs<unsigned char>(image, path, metadata);
  }
  else if (name == "uint16")
  {
    WriteAs<unsigned short>(image, path, metadata);
  }
  else if (name == "uint32")
  {
    WriteAs<unsigned int>(image, path, metadata);
  }
  else
  {
    throw ParameterError("the parameter \"image\" has the type " + name +
                         ", which cannot be written; convert it to float32, int16, uint8, uint16 or uint32");
  }
}
} // namespace

void
AddVolumes(py::module_ & module)
{
  py::class_<DicomDefect>(module, "DicomDefect", "A defect or peculiarity of a DICOM series.")
    .def_property_readonly(
      "name", [](const DicomDefect & defect) { return GetDicomDefectName(defect.kind); }, "For example \"gap\".")
    .def_property_readonly(
      "advice", [](const DicomDefect & defect) { return InPython(GetDicomDefectAdvice(defect)); }, "Possible remedy.")
    .def_readonly("message", &DicomDefect::message, "The defect as a sentence.")
    .def_readonly("files", &DicomDefect::files, "The affected files.")
    .def_readonly("slices", &DicomDefect::slices, "The affected slices, counted from 1 along the normal.");

  py::class_<DicomSeries>(module, "DicomSeries", "A DICOM series of a folder; see `list_series`.")
    .def_property_readonly(
      "selector", &DicomSeries::GetSelector, "The series_uid for `read_volume`: the UID, with \"#part\" if needed.")
    .def_readonly("uid", &DicomSeries::uid, "Series Instance UID.")
    .def_readonly("number", &DicomSeries::number, "Series Number.")
    .def_readonly("description", &DicomSeries::description, "Series Description.")
    .def_readonly("modality", &DicomSeries::modality, "For example \"CT\".")
    .def_readonly("patient_position", &DicomSeries::patientPosition, "For example \"HFS\".")
    .def_property_readonly(
      "size",
      [](const DicomSeries & s) { return py::make_tuple(s.size[0], s.size[1], s.size[2]); },
      "Columns, rows, slices: the extents along x, y, z.")
    .def_property_readonly(
      "spacing",
      [](const DicomSeries & s) { return py::make_tuple(s.spacing[0], s.spacing[1], s.spacing[2]); },
      "Spacing of columns, rows, slices; mm, 0 if unknown.")
    .def_property_readonly("is_usable", &DicomSeries::IsUsable, "Whether a volume can be read without repair.")
    .def_readonly(
      "refusal", &DicomSeries::refusal, "Reason why this is not a volume, if no defect explains it; otherwise empty.")
    .def_readonly("defects", &DicomSeries::defects, "Defects that prevent reading the series without repair.")
    .def_readonly("remarks", &DicomSeries::remarks, "Peculiarities that do not prevent reading.")
    .def("__repr__", [](const DicomSeries & s) {
      return "<shapeton.DicomSeries " + s.modality + " \"" + s.description + "\", " + s.GetSelector() + ">";
    });

  module.def("list_series",
             Reporting(+[](const Path & path, const Progress & progress) {
               return ScanDicom(path.text, progress.Part("Reading headers", 0.0, 1.0)).series;
             }),
             ReleaseGil());

  module.def("read_volume", Reporting(&ReadWithFacts));

  module.def("write_volume", &Write);
}
} // namespace shapeton::python
