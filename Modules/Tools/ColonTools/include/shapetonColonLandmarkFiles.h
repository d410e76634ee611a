#ifndef shapetonColonLandmarkFiles_h
#define shapetonColonLandmarkFiles_h

#include "ShapetonColonToolsExport.h"
#include "shapetonColonSplitting.h"
#include "shapetonSceneFiles.h"
#include "shapetonSlicerMarkups.h"

#include <array>

namespace shapeton
{
class CommandLine;

/** \class ColonLandmarkFiles
 * \brief Landmark files in a folder, as the tools write them.
 *
 * taeniae.vtp, flexures.vtp, segments.vtp, folds-surface.vtp, landmarks.json, taeniae.mrk.json, flexures.mrk.json,
 * ileocecal-valve.mrk.json; segment-NAME.vtp for pieces. Landmarks that were not found have no file; a stale file of
 * an earlier run is removed. All files state their provenance.
 *
 * \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT ColonLandmarkFiles
{
public:
  /** Creates the folder. Throws OutputError if the folder cannot be written to. */
  ColonLandmarkFiles(CommandLine & commandLine, const std::string & folder);

  /** `pieces` may be null. The warnings of the command line are written to landmarks.json. */
  void
  Write(const SurfaceMesh & flat, const ColonLandmarks & landmarks, const ColonPieces * pieces) const;

private:
  void
  WriteOrRemove(const std::string & name, const CurveSet & curves) const;
  void
  WriteOrRemove(const std::string & name, const std::vector<Markup> & markups) const;
  void
  WriteTaeniaMarkups(const CurveSet & taeniae) const;
  void
  WriteFlexureMarkups(const ColonLandmarks & landmarks, const CurveSet & loops) const;
  void
  WriteValveMarkup(const std::optional<IleocecalValve> & valve) const;
  void
  WriteDocument(const ColonLandmarks & landmarks, const ColonPieces * pieces) const;
  void
  WritePieces(const ColonPieces * pieces) const;
  std::string
  PathOf(const std::string & name) const;

  CommandLine & m_CommandLine;
  std::string   m_Folder;
  SceneFiles    m_Scene;
};

/** Reads numbers of taeniae from registration.json of ColonRegistration, for its prone position. Throws InputError if
 * they are unknown. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT std::array<int, 3>
                          ReadTaeniaNumbers(CommandLine & commandLine, const std::string & parameter);

/** Reads markers for taeniae: points and vertices of a VTP file or of 3D Slicer markups; LPS, mm.
 * Throws InputError for a file without points, ParameterError for an unsupported extension. \ingroup ShapetonColonTools
 */
ShapetonColonTools_EXPORT std::vector<Eigen::Vector3d>
                          ReadTaeniaMarkers(CommandLine & commandLine, const std::string & parameter);
} // namespace shapeton

#endif
