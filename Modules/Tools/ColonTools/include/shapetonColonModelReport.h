#ifndef shapetonColonModelReport_h
#define shapetonColonModelReport_h

#include "ShapetonColonToolsExport.h"
#include "shapetonColonModel.h"

#include <string>

namespace shapeton
{
class CommandLine;
struct Volume;

/** \class ColonModelReport
 * \brief Report on a colon model, written into a folder.
 * \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT ColonModelReport
{
public:
  /** Creates the folder; an empty name disables the report. Throws OutputError. */
  ColonModelReport(CommandLine & commandLine, const std::string & folder);

  /** With `atOnce` the files get their final names immediately, even if the run fails later. `volume` is the input: the
   * CT, or the mask for a model without intensities. */
  void
  Write(const ColonModel & model, const Volume & volume, bool atOnce = false) const;

private:
  CommandLine & m_CommandLine;
  std::string   m_Folder;
};
} // namespace shapeton

#endif
