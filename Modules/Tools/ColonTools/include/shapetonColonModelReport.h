#ifndef shapetonColonModelReport_h
#define shapetonColonModelReport_h

#include "ShapetonColonToolsExport.h"
#include "shapetonColonModel.h"

#include <string>

namespace shapeton
{
class CommandLine;
struct Volume;

/** The report on a colon model in an existing folder; nothing if the name of the folder is empty. With `atOnce` the
 * files get their final names immediately, even if the run fails later. `volume` is the input: the CT, or the mask for
 * a model without intensities. Throws OutputError. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WriteColonModelReport(CommandLine &       commandLine,
                      const std::string & folder,
                      const ColonModel &  model,
                      const Volume &      volume,
                      bool                atOnce);
} // namespace shapeton

#endif
