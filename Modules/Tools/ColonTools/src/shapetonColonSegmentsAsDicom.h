#ifndef shapetonColonSegmentsAsDicom_h
#define shapetonColonSegmentsAsDicom_h

#include "shapetonDicomExamination.h"

namespace shapeton
{
/** \class ColonSegmentsAsDicom
 * \brief Assigns the structures of an examination to two DICOM segmentations whose segments do not overlap, since
 * viewers such as OHIF lose voxels of overlapping segments.
 *
 * The findings are gas, fluid and heads of candidates. The anatomy is the segments of the colon, which divide the same
 * lumen by position along the colon, the terminal ileum and the folds. */
class ColonSegmentsAsDicom
{
public:
  explicit ColonSegmentsAsDicom(const DicomExamination & exam);

  /** A segment in its file. */
  struct Place
  {
    DicomInstance instance;
    /** 0 for a segment without voxels. */
    int number{ 0 };
    /** ml. */
    double volume{ 0.0 };
    /** In the segment, LPS, mm. */
    std::array<double, 3> center{};
  };

  enum class Part
  {
    Findings,
    Anatomy
  };

  /** Whether any voxel belongs to the anatomy; otherwise it cannot be written. */
  bool
  HasAnatomy() const;
  DicomInstance
  Write(Part                      part,
        const DicomSource &       source,
        const DicomResultHeader & header,
        const std::string &       path,
        DicomSegmentationFormat   format);

  /** All segments, findings first. */
  std::vector<DicomSegment>
  Segments() const;
  /** UID that identifies a candidate in all objects. */
  std::string
  TrackingUIDOfCandidate(const PolypCandidate & candidate) const;
  /** UID that identifies a structure of this kind at a place (LPS, mm) of the series. */
  std::string
  TrackingUIDAt(const std::string & kind, const Eigen::Vector3d & place) const;
  /** The written segment with a tracking UID; number 0 if there is none. */
  Place
  PlaceOf(const std::string & trackingUID) const;

private:
  struct File
  {
    DicomLabelImage::Pointer  labels;
    std::vector<DicomSegment> segments;
    DicomSegmentation         written;
  };

  void
  AddLumen();
  void
  AddFolds();
  void
  AddHeads();
  void
  AddColonSegments();
  void
  MoveToAnatomy(unsigned short from, unsigned short to);
  void
  Add(File &                               file,
      const std::string &                  name,
      const DicomCode &                    category,
      const DicomCode &                    type,
      const std::string &                  role,
      int                                  label,
      const std::array<unsigned char, 3> & color);
  std::string
  UIDOf(const std::string & role) const;

  const DicomExamination & m_Exam;
  File                     m_Findings;
  File                     m_Anatomy;
};
} // namespace shapeton

#endif
