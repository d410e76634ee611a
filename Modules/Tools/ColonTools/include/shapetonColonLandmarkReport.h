#ifndef shapetonColonLandmarkReport_h
#define shapetonColonLandmarkReport_h

#include "ShapetonColonToolsExport.h"
#include "shapetonColonLandmarkPictures.h"
#include "shapetonColonSplitting.h"

namespace shapeton
{
class CommandLine;

/** \class ColonLandmarkReport
 * \brief Report of the tool ColonLandmarks: index.html and its pictures as PNG files in the same folder.
 * \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT ColonLandmarkReport
{
public:
  /** Creates the folder; an empty name disables the report. Throws OutputError. */
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
