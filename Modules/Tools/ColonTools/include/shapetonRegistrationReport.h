#ifndef shapetonRegistrationReport_h
#define shapetonRegistrationReport_h

#include "ColonToolsExport.h"

#include "shapetonHtmlReport.h"
#include "shapetonRegistrationPictures.h"

#include <functional>

namespace shapeton
{
class CommandLine;

/** Puts a picture with its caption into a page; `name` is that of a file, without extension. \ingroup ColonTools
 */
using AddPictureToPage =
  std::function<void(const Picture * picture, const std::string & name, const std::string & caption)>;

/** What to know about the registration in short: name and value. \ingroup ColonTools */
ColonTools_EXPORT std::vector<std::pair<std::string, std::string>>
                  RegistrationFacts(const RegistrationParts & parts);

/** The part of a page on both positions: confidence, both walls row under row, the checkerboard, a table of matches by
 * segments, and errors where points are known. Of parts that were just made, or read back by ReadColonPosition() and
 * ReadRegistrationResults(), so that any report can hold it. \ingroup ColonTools */
ColonTools_EXPORT void
AddRegistrationSection(HtmlReport &                 html,
                       const RegistrationParts &    parts,
                       const AddPictureToPage &     addPicture,
                       const AlignedColonsOptions & options = {});

/** \class RegistrationReport
 * \brief index.html in a folder, with its pictures inside of it and beside it.
 * \ingroup ColonTools */
class ColonTools_EXPORT RegistrationReport
{
public:
  /** Makes the folder. Nothing is written where the folder is "". Throws OutputError. */
  RegistrationReport(CommandLine & commandLine, const std::string & folder);

  void
  Write(const RegistrationParts & parts) const;

private:
  CommandLine & m_CommandLine;
  std::string   m_Folder;
};
} // namespace shapeton

#endif
