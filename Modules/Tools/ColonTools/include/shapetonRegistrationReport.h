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

/** \class RegistrationReport
 * \brief index.html in a folder; its pictures are embedded and also written as files.
 * \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT RegistrationReport
{
public:
  /** Creates the folder; an empty name disables the report. Throws OutputError. */
  RegistrationReport(CommandLine & commandLine, const std::string & folder);

  void
  Write(const RegistrationParts & parts) const;

private:
  CommandLine & m_CommandLine;
  std::string   m_Folder;
};
} // namespace shapeton

#endif
