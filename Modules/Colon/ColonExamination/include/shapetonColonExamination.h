#ifndef shapetonColonExamination_h
#define shapetonColonExamination_h

#include "shapetonExaminationFolder.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Folder of the second position inside the folder of a run. \ingroup ShapetonColonExamination */
constexpr const char * secondPositionFolder = "second";

/** \class ColonExamination
 * \brief The one or two positions of an examination.
 * \ingroup ShapetonColonExamination */
class ShapetonColonExamination_EXPORT ColonExamination
{
public:
  /** \param second the run of the other position; if empty, the folder `second` of the run is used if it contains a
   * flat wall. \param reader see ExaminationFolder. Throws InputError. */
  explicit ColonExamination(const std::string & folder,
                            const std::string & second = {},
                            const std::string & reader = {});

  const std::vector<ExaminationFolder> &
  GetPositions() const
  {
    return m_Positions;
  }
  const std::string &
  GetFolder() const
  {
    return m_Positions.front().GetFolder();
  }

  /** Identity for verdicts: a SHA-256 of the flat walls, which depend on all earlier results, and the candidates. */
  std::string
  Digest() const;
  /** The candidates of each position; empty for a position that was not searched. Throws InputError. */
  std::vector<std::vector<PolypCandidate>>
  ReadCandidates() const;

private:
  std::vector<ExaminationFolder> m_Positions;
};

/** Name of a candidate in verdicts: "1"; "second/1" for the second position. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::string
                                NameOfCandidate(std::size_t position, int number);

/** The candidate with this name; null if there is none. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT const PolypCandidate *
FindCandidate(const std::vector<std::vector<PolypCandidate>> & candidates, const std::string & name);
} // namespace shapeton

#endif
