#ifndef shapetonExaminationFile_h
#define shapetonExaminationFile_h

#include "ShapetonColonExaminationExport.h"

#include <string>
#include <vector>

namespace shapeton
{
/** \brief A result file of a virtual colonoscopy. shapetonExaminationFiles.h, generated from format/files.json,
 * declares all of them. \ingroup ShapetonColonExamination */
struct ShapetonColonExamination_EXPORT ExaminationFile
{
  /** Stage that writes the file, also the name of its folder; "" for the folder of the run. */
  const char * stage;
  const char * name;
  /** Tool of the stage. */
  const char * tool;
  /** Tools that read the file from the folder of a position, separated by spaces. */
  const char * readers;
  /** Whether the stage always writes the file. */
  bool isAlways;

  /** "STAGE/NAME". */
  std::string
  Path() const;
  bool
  IsReadBy(const std::string & reader) const;
};

/** Paths of the files that a tool reads from the folder of a position. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::vector<std::string>
                                FilesReadBy(const std::string & tool);

/** Names of the files that a stage always writes. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::vector<std::string>
                                FilesAlwaysWrittenBy(const std::string & stage);

/** The tool of a stage. Throws std::logic_error if there is no such stage. \ingroup ShapetonColonExamination */
ShapetonColonExamination_EXPORT std::string
                                ToolOfStage(const std::string & stage);
} // namespace shapeton

#endif
