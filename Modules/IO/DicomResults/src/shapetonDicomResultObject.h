#ifndef shapetonDicomResultObject_h
#define shapetonDicomResultObject_h

#include "shapetonDicomItem.h"
#include "shapetonDicomSource.h"

namespace shapeton
{
bool
IsAscii(const std::string & text);

/** \class DicomResultObject
 * \brief A DICOM object derived from a source series: attributes common to all results, and writing.
 *
 * Patient and study are copied from the source, and its dates unless the header asks for the current time. The UIDs of
 * series and instance are derived from all other data of the file and from its encoding, so output is deterministic and
 * different results have different UIDs. */
class DicomResultObject
{
public:
  DicomResultObject(const DicomSource &       source,
                    const char *              sopClassUID,
                    const std::string &       modality,
                    const DicomResultHeader & header);

  DicomItem
  Root()
  {
    return DicomItem(*m_File.getDataset());
  }

  /** Converts the attributes copied from the source to UTF-8, so that texts in UTF-8 can be added. Throws InputError.
   */
  void
  ConvertToUtf8();
  /** Frame of reference of the source; for images and surfaces. */
  void
  PutFrameOfReference();
  /** Whether pixels were lossily compressed, in this object or in the source; for images. */
  void
  PutLossiness();
  /** Sets RESEARCH; for images. Reports use other flags. */
  void
  PutContentQualification();
  /** References to the source series and slices. */
  void
  PutReferencedSeries();
  /** Properties common to all frames: orientation, pixel spacing, slice distance. Returns the shared functional
   * groups. */
  DicomItem
  PutSharedPlane();

  /** Supports native syntaxes and RLE Lossless. Throws OutputError. */
  DicomInstance
  Save(const std::string & path, E_TransferSyntax syntax = EXS_LittleEndianExplicit);

private:
  void
  PutSourceHeader();
  void
  PutDates(DicomResultDates wanted);
  void
  PutCodingSchemes();
  std::string
  Take(const DcmTagKey & tag);

  const DicomSource & m_Source;
  std::string         m_SopClassUID;
  std::string         m_LossyRatio;
  std::string         m_LossyMethod;
  DcmFileFormat       m_File;
};

/** A reference to a slice of the source: class and instance, and the frame number if the instance is multi-frame. */
void
PutReferenceToSlice(DicomItem item, const DicomSlice & slice);

/** References the source slice of a frame, with this kind of processing (CID 7203). */
void
PutDerivation(DicomItem frame, const DicomSlice & slice, const DicomCode & processing);

} // namespace shapeton

#endif
