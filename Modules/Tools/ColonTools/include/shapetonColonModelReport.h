#ifndef shapetonColonModelReport_h
#define shapetonColonModelReport_h

#include "ColonToolsExport.h"
#include "shapetonColonModel.h"

#include <string>

namespace shapeton
{
class CommandLine;
struct Volume;

/** \class ColonModelReport
 * \brief The report of a tool on the model of a colon, in a folder.
 * \ingroup ColonTools */
class ColonTools_EXPORT ColonModelReport
{
public:
  /** Makes the folder; none is written where its name is empty. Throws OutputError. */
  ColonModelReport(CommandLine & commandLine, const std::string & folder);

  /** With `atOnce` the files get their names now, even if the run fails later. `volume` is the input: the CT, or the
   * mask where the model has no intensities. */
  void
  Write(const ColonModel & model, const Volume & volume, bool atOnce = false) const;

private:
  CommandLine & m_CommandLine;
  std::string   m_Folder;
};
} // namespace shapeton

#endif
