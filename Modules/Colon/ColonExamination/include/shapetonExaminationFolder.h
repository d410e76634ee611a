#ifndef shapetonExaminationFolder_h
#define shapetonExaminationFolder_h

#include "shapetonColonLandmarkDocument.h"
#include "shapetonCurveSet.h"
#include "shapetonExaminationFiles.h"
#include "shapetonJson.h"
#include "shapetonPolypCandidates.h"
#include "shapetonSurfaceMesh.h"

#include "itkImage.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
class FlatColon;

/** \class ExaminationFolder
 * \brief Results of VirtualColonoscopy for one position of the colon, read from their folder when they are requested.
 *
 * format/files.json describes the files. Each Read method throws an InputError that names the missing or malformed
 * file; positions are LPS in mm.
 *
 * \ingroup ShapetonColonExamination */
class ShapetonColonExamination_EXPORT ExaminationFolder
{
public:
  /** \param reader the tool that reads the folder. VirtualColonoscopy runs a tool again if a file that the tool is
   * declared to read has changed. Therefore, reading an undeclared file throws std::logic_error. Empty for a program
   * that is not a stage.
   *
   * Throws InputError if the folder does not exist or has a different format version. */
  explicit ExaminationFolder(std::string folder, std::string reader = {});

  const std::string &
  GetFolder() const
  {
    return m_Folder;
  }
  std::string
  PathOf(const ExaminationFile & file) const;
  bool
  Has(const ExaminationFile & file) const;
  /** The path of a file that exists. Throws InputError, naming the stage that writes it, if it does not. */
  std::string
  Required(const ExaminationFile & file) const;

  /** Measurements of ColonSegmentation. */
  Json
  ReadQuality() const;
  /** Flexures, segments and taeniae. */
  Json
  ReadLandmarks() const;
  /** Segments with known ends; empty if there are no landmarks. */
  std::vector<ColonSegmentExtent>
  ReadSegments() const;
  /** One curve with the point array arcLength (mm). */
  CurveSet
  ReadCenterline() const;
  CurveSet
  ReadCurvesOf(const ExaminationFile & file) const;
  SurfaceMesh
  ReadSurfaceOf(const ExaminationFile & file) const;
  std::shared_ptr<const FlatColon>
  ReadFlatColon() const;
  /** 1 gas, 2 tagged fluid, 3 terminal ileum. */
  itk::Image<unsigned char, 3>::Pointer
  ReadLumen() const;
  /** CT from which tagged residue was removed (HU); null if the input was a lumen mask. */
  itk::Image<float, 3>::Pointer
  ReadCleansedCt() const;
  /** The original CT (HU): the sum of the cleansed CT and the removed residue; null if one of them is missing. */
  itk::Image<float, 3>::Pointer
  ReadOriginalCt(const itk::Image<float, 3> * cleansed) const;
  /** Fold number at each pixel of the flat map; null if no folds were found. */
  itk::Image<unsigned short, 2>::Pointer
  ReadFolds() const;
  /** Empty if candidates were not searched for. */
  std::vector<PolypCandidate>
  ReadCandidates() const;

private:
  std::string m_Folder;
  std::string m_Reader;
};

/** Position of the patient: "supine", "prone", ...; "" if unknown. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::string
                                PositionOfQuality(const Json & quality);
/** UID of the DICOM series read by the run; "#part" is appended for a part of a mixed series. Empty for a volume.
 * \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::string
                                SeriesOfQuality(const Json & quality);

/** The DICOM series read by the run, as inspection/series.json describes it; an empty object if unknown.
 * \param inspection that file; null for a volume. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT Json
SeriesRead(const Json & inspection, const Json & quality);

/** Whether the position of the patient was read or estimated rather than assumed. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT bool
IsPositionKnown(const Json & quality);

/** Writes examination.json, which contains the version of the format. Throws OutputError.
 * \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT void
WriteExaminationVersion(const std::string & path);
} // namespace shapeton

#endif
