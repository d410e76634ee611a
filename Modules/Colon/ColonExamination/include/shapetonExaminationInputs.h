#ifndef shapetonExaminationInputs_h
#define shapetonExaminationInputs_h

#include "shapetonColonPositionFiles.h"
#include "shapetonExaminationFolder.h"
#include "shapetonPolypSearch.h"

namespace shapeton
{
/** The input of SearchPolyps(): the repaired wall and the lumen are required; steps that depend on other, missing files
 * are skipped with a warning. Throws InputError. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT PolypColon
ReadPolypColon(const ExaminationFolder & exam);

/** The input of a registration: centerline, flat wall, landmarks, taeniae (absent if none were found), curvature and
 * folds. \param name for messages, "supine" or "prone". Throws InputError. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT ColonPositionFiles
ReadColonPosition(const ExaminationFolder & exam, const std::string & name);
} // namespace shapeton

#endif
