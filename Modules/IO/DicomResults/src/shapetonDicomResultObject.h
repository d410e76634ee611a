#ifndef shapetonDicomResultObject_h
#define shapetonDicomResultObject_h

#include "shapetonDicomItem.h"
#include "shapetonDicomSource.h"

namespace shapeton
{
/** \class DicomResultObject
 * \brief A DICOM object that belongs to a source series: what all results have in common, and how they are saved.
 *
 * Patient, study and dates are those of the source; the UIDs of series and instance come from all else in the file, so
 * that equal results have equal bytes, and different ones never share a UID. */
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

  /** Frame of reference of the source: of images and surfaces. */
  void
  PutFrameOfReference();
  /** Whether pixels went through a lossy compression, here or in the source: of images. */
  void
  PutLossiness();
  /** RESEARCH: of images. Reports have flags of their own. */
  void
  PutContentQualification();
  /** Which series and slices the result was made from. */
  void
  PutReferencedSeries();
  /** What all frames share: orientation, pixel spacing, distance of slices. Returns the shared functional groups. */
  DicomItem
  PutSharedPlane();

  /** Throws OutputError. */
  DicomInstance
  Save(const std::string & path, bool isDeflated = false);

private:
  void
  PutSourceHeader();
  void
  PutDates();
  std::string
  Take(const DcmTagKey & tag);

  const DicomSource & m_Source;
  std::string         m_SopClassUID;
  std::string         m_LossyRatio;
  std::string         m_LossyMethod;
  DcmFileFormat       m_File;
};

/** A reference to a slice of the source: class and instance, and the frame where the
 * instance has frames. */
void
PutReferenceToSlice(DicomItem item, const DicomSlice & slice);

/** That a frame was made from a slice, by this kind of processing (CID 7203). */
void
PutDerivation(DicomItem frame, const DicomSlice & slice, const DicomCode & processing);

} // namespace shapeton

#endif
