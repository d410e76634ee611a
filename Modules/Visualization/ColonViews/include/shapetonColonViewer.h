#ifndef shapetonColonViewer_h
#define shapetonColonViewer_h

#include "ShapetonColonViewsExport.h"
#include "shapetonOutputPath.h"

#include <string>
#include <vector>

namespace shapeton
{
/** Options of the viewer page of a colon. \ingroup ShapetonColonViews */
struct ColonViewerOptions
{
  /** If true, the page contains all data; otherwise the data are script files in the folder `data`, which load faster.
   */
  bool isSingle{ false };
  /** 8 bits hold -1024 to 320 HU in steps of 6 HU, and up to 1560 HU in steps of 40 HU; 16 bits hold all values. */
  int bits{ 8 };
  /** Distance from the lumen (mm, 0 to 100) beyond which the volume is stored as means of 4^3 voxels. */
  double near{ 14.0 };
  /** Stores all voxels; `near` has no effect. */
  bool isFull{ false };
  /** The page hides the candidates until the reader asks for them. */
  bool isSecondReader{ false };
  /** Omits the series UIDs and the folder name. */
  bool isAnonymous{ false };
  /** Path of a verdicts.json saved by the page; may be empty. */
  std::string verdicts;
  /** Run of the patient's other position. If empty, the other position in the folder of the run is shown, if there is
   * one. */
  std::string second;
  /** ColonRegistration folder for the run and `second`; without it, the positions are not linked. */
  std::string registration;
  /** Warnings about the run, for the page. */
  std::vector<std::string> warnings;
};

/** Writes `folder`/viewer.html, a page for reading a finished run of VirtualColonoscopy: the flat wall, the wall in
 * space, the endoluminal view and slices of the original and the cleansed CT with a linked crosshair, candidates,
 * verdicts. The page works offline. With
 * verdicts, also writes `folder`/verdicts.mrk.json for 3D Slicer.
 *
 * `exam` is the folder of the run. If it contains the folders `second` and `registration`, the page shows both
 * positions, linked by the map. Equal input gives equal bytes. `outputPath` maps final names to the names to write to.
 * `folder`, and its folder `data` unless the page is single, must exist.
 *
 * Throws InputError for an unfinished run, a file not written by the run, verdicts of another examination or a map of
 * other positions; ParameterError for an option out of range; OutputError.
 * \ingroup ShapetonColonViews */
ShapetonColonViews_EXPORT void
WriteColonViewer(const std::string &        exam,
                 const std::string &        folder,
                 const ColonViewerOptions & options,
                 const OutputPath &         outputPath);
} // namespace shapeton

#endif
