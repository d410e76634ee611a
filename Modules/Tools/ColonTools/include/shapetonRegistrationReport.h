#ifndef shapetonRegistrationReport_h
#define shapetonRegistrationReport_h

#include "ShapetonColonToolsExport.h"

#include "shapetonHtmlReport.h"
#include "shapetonRegistrationPictures.h"

#include <functional>

namespace shapeton
{
class CommandLine;

/** Adds a picture with its caption to a page; `name` is a file name without extension. \ingroup ShapetonColonTools */
using AddPictureToPage =
  std::function<void(const Picture * picture, const std::string & name, const std::string & caption)>;

/** Summary of the registration: names and values. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT std::vector<std::pair<std::string, std::string>>
                          RegistrationFacts(const RegistrationParts & parts);

/** Adds the section on both positions to a page: confidence, both walls in paired rows, the checkerboard, a table of
 * matches by segment, and errors if points are known. The arguments may be newly computed or read back by
 * ReadColonPosition() and ReadRegistrationResults(), so any report can include this section.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
AddRegistrationSection(HtmlReport &                 html,
                       const RegistrationParts &    parts,
                       const AddPictureToPage &     addPicture,
                       const AlignedColonsOptions & options = {});

/** Writes index.html into an existing folder; its pictures are embedded and also written as files. Does nothing if the
 * name of the folder is empty. Throws OutputError. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WriteRegistrationReport(CommandLine & commandLine, const std::string & folder, const RegistrationParts & parts);
} // namespace shapeton

#endif
