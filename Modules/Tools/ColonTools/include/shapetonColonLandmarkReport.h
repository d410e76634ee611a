#ifndef shapetonColonLandmarkReport_h
#define shapetonColonLandmarkReport_h

#include "ColonToolsExport.h"
#include "shapetonColonLandmarkPictures.h"
#include "shapetonColonSplitting.h"

namespace shapeton
{
class CommandLine;

/** \class ColonLandmarkReport
 * \brief Report of the tool ColonLandmarks: index.html with its pictures, which lie beside it as PNG.
 * \ingroup ColonTools */
class ColonTools_EXPORT ColonLandmarkReport
{
public:
  /** Makes the folder; an empty name is no report. Throws OutputError. */
  ColonLandmarkReport(CommandLine & commandLine, const std::string & folder);

  /** `pieces` may be null. */
  void
  Write(const FlatColon & flat, const ColonLandmarks & landmarks, const ColonPieces * pieces) const;

private:
  CommandLine & m_CommandLine;
  std::string   m_Folder;
};
} // namespace shapeton

#endif
