#ifndef shapetonExaminationPositions_h
#define shapetonExaminationPositions_h

#include "ShapetonColonViewsExport.h"
#include "shapetonPolypCandidates.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Folders of the positions of an examination, one or two. `second` is the run of the other position; if empty, it is
 * the folder `second` of the run, if that is finished. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT std::vector<std::string>
                          PositionFoldersOf(const std::string & exam, const std::string & second = {});

/** Identity of an examination for verdicts (SHA-256): the flat walls, which depend on all earlier results, and the
 * candidates. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT std::string
                          DigestOfPositions(const std::vector<std::string> & folders);

/** The candidates of each position; empty for a position that was not searched. Throws InputError.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT std::vector<std::vector<PolypCandidate>>
                          CandidatesOfPositions(const std::vector<std::string> & folders);

/** Name of a candidate in verdicts: "1"; "second/1" for the second position. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT std::string
                          NameOfCandidate(std::size_t position, int number);

/** The candidate with this name; null if there is none. \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT const PolypCandidate *
FindCandidate(const std::vector<std::vector<PolypCandidate>> & candidates, const std::string & name);
} // namespace shapeton

#endif
