#ifndef shapetonColonSegmentsAsDicom_h
#define shapetonColonSegmentsAsDicom_h

#include "shapetonColonExamination.h"

namespace shapeton
{
/** \class ColonSegmentsAsDicom
 * \brief What of an examination is written as a segment of voxels, and under which number.
 *
 * Lumen, terminal ileum, folds and heads of candidates share no voxel; the segments of the colon are those of its lumen
 * once more, by their place along the colon. */
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
  /** By which a candidate is known in all objects. */
  std::string
  TrackingUIDOfCandidate(const PolypCandidate & candidate) const;
  /** The number in the file, or 0, by tracking UID. */
  int
  NumberOf(const std::string & trackingUID) const;
  /** ml */
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
  DicomLabelImage::Pointer  m_Parts;         ///< lumen, ileum, folds, heads
  DicomLabelImage::Pointer  m_ColonSegments; ///< of the colon
  std::vector<DicomSegment> m_Segments;
  DicomSegmentation         m_Written;
};
} // namespace shapeton

#endif
