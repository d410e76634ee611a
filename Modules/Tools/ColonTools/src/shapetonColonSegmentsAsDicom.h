#ifndef shapetonColonSegmentsAsDicom_h
#define shapetonColonSegmentsAsDicom_h

#include "shapetonColonExamination.h"

namespace shapeton
{
/** \class ColonSegmentsAsDicom
 * \brief Assigns the structures of an examination to DICOM segments and their numbers.
 *
 * Lumen, terminal ileum, folds and heads of candidates are disjoint. The segments of the colon divide the same lumen
 * by position along the colon. */
class ColonSegmentsAsDicom
{
public:
  explicit ColonSegmentsAsDicom(const ColonExamination & exam);

  void
  Write(const DicomSource & source, const DicomResultHeader & header, const std::string & path, bool isDeflated);

  const DicomInstance &
  Instance() const
  {
    return m_Written.instance;
  }
  const std::vector<DicomSegment> &
  Segments() const
  {
    return m_Segments;
  }
  /** UID that identifies a candidate in all objects. */
  std::string
  TrackingUIDOfCandidate(const PolypCandidate & candidate) const;
  /** UID that identifies a structure of this kind at a place (LPS, mm) of the series. */
  std::string
  TrackingUIDAt(const std::string & kind, const Eigen::Vector3d & place) const;
  /** Segment number in the file for a tracking UID; 0 if there is none. */
  int
  NumberOf(const std::string & trackingUID) const;
  /** Volume in ml. */
  double
  VolumeOf(const std::string & trackingUID) const;

private:
  void
  AddLumen();
  void
  AddFolds();
  void
  AddHeads();
  void
  AddColonSegments();
  void
  Add(const std::string &                  name,
      const DicomCode &                    category,
      const DicomCode &                    type,
      const std::string &                  role,
      const DicomLabelImage *              labels,
      int                                  label,
      const std::array<unsigned char, 3> & color);
  std::string
  UIDOf(const std::string & role) const;
  std::ptrdiff_t
  PlaceOf(const std::string & trackingUID) const;

  const ColonExamination &  m_Exam;
  DicomLabelImage::Pointer  m_Parts;         ///< lumen, ileum, folds, heads of candidates
  DicomLabelImage::Pointer  m_ColonSegments; ///< segments of the colon
  std::vector<DicomSegment> m_Segments;
  DicomSegmentation         m_Written;
};
} // namespace shapeton

#endif
