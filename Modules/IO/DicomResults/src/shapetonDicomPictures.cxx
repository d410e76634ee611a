#include "shapetonDicomPictures.h"

#include "shapetonDicomResultObject.h"
#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonSurfaceWriter.h"

#include <filesystem>
#include <limits>

namespace shapeton
{
namespace
{
/** Serializes a surface as STL, via a temporary file next to the object. */
std::string
StlOf(const SurfaceMesh & mesh, const std::string & path)
{
  const std::string stl = path + ".stl";
  WriteSurface(mesh, stl);
  std::string bytes = ReadFileBytes(stl);
  std::filesystem::remove(stl);
  return bytes;
}

/** References all slices of the source. */
void
PutSlices(DicomResultObject & object, const DcmTagKey & sequence, const DicomSource & source)
{
  for (const DicomSlice & slice : source.series.slices)
  {
    PutReferenceToSlice(object.Root().Add(sequence), slice);
  }
}
} // namespace

DicomInstance
WriteDicomPicture(const DicomSource &                                 source,
                  const itk::Image<itk::RGBPixel<unsigned char>, 2> * picture,
                  const DicomResultHeader &                           header,
                  const std::string &                                 path)
{
  const auto            size = picture->GetBufferedRegion().GetSize();
  constexpr std::size_t greatest = std::numeric_limits<Uint16>::max();
  if (size[0] > greatest || size[1] > greatest)
  {
    throw InputError("the picture for \"" + path +
                     "\" has more than 65535 rows or columns, the most that DICOM allows");
  }
  const auto * const first = reinterpret_cast<const Uint8 *>(picture->GetBufferPointer());
  constexpr Uint32   bits = 8;
  DicomResultObject  object(source, UID_SecondaryCaptureImageStorage, "OT", header);
  object.PutReferencedSeries();
  object.PutContentQualification();
  object.PutLossiness();
  object.Root()
    .Text(DCM_ConversionType, "WSD")
    .Text(DCM_ImageType, "DERIVED\\SECONDARY")
    .Text(DCM_PatientOrientation, "")
    .Text(DCM_ImageLaterality, "U") // not a paired body part
    .Text(DCM_BurnedInAnnotation, "NO")
    .Text(DCM_ImageComments, DicomResearchNote)
    .Integers(DCM_SamplesPerPixel, { 3 })
    .Text(DCM_PhotometricInterpretation, "RGB")
    .Integers(DCM_PlanarConfiguration, { 0 })
    .Integers(DCM_Rows, { static_cast<Uint32>(size[1]) })
    .Integers(DCM_Columns, { static_cast<Uint32>(size[0]) })
    .Integers(DCM_BitsAllocated, { bits })
    .Integers(DCM_BitsStored, { bits })
    .Integers(DCM_HighBit, { bits - 1 })
    .Integers(DCM_PixelRepresentation, { 0 })
    .Bytes(DCM_PixelData, { first, first + 3 * size[0] * size[1] });
  PutSlices(object, DCM_SourceImageSequence, source);
  return object.Save(path);
}

DicomInstance
WriteDicomSurface(const DicomSource &       source,
                  const SurfaceMesh &       mesh,
                  const DicomCode &         what,
                  const DicomResultHeader & header,
                  const std::string &       path)
{
  const std::string stl = StlOf(mesh, path);
  DicomResultObject object(source, UID_EncapsulatedSTLStorage, "M3D", header);
  object.PutFrameOfReference();
  object.PutReferencedSeries();
  object.Root()
    .Text(DCM_AcquisitionDateTime, "")
    .Text(DCM_BurnedInAnnotation, "NO")
    .Text(DCM_DocumentTitle, what.meaning)
    .Code(DCM_ConceptNameCodeSequence, what)
    .Code(DCM_MeasurementUnitsCodeSequence, { "mm", "UCUM", "mm" })
    .Text(DCM_ModelModification, "NO")
    .Text(DCM_ModelMirroring, "NO")
    .Text(DCM_ContentDescription, DicomResearchNote)
    .Text(DCM_MIMETypeOfEncapsulatedDocument, "model/stl")
    .Integers(DCM_EncapsulatedDocumentLength, { static_cast<Uint32>(stl.size()) })
    .Bytes(DCM_EncapsulatedDocument, { stl.begin(), stl.end() });
  PutSlices(object, DCM_SourceInstanceSequence, source);
  return object.Save(path);
}
} // namespace shapeton
