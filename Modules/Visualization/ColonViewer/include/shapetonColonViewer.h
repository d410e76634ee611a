#ifndef shapetonColonViewer_h
#define shapetonColonViewer_h

#include "ColonViewerExport.h"
#include "shapetonHtmlReport.h"

#include <string>

namespace shapeton
{
/** How the page of a colon is made. \ingroup ColonViewer */
struct ColonViewerOptions
{
  /** All data within the page; otherwise in script files in the folder `data` beside it, which load faster. */
  bool isSingle{ false };
  /** 8 bits hold -1024 to 512 HU in steps of 6 HU, 16 bits all values. */
  int bits{ 8 };
  /** mm, 0 to 100: beyond this distance from the lumen the volume is kept as means of 4^3 voxels. */
  double near{ 14.0 };
  /** Leaves out the UIDs of the series and the name of the folder. */
  bool isAnonymous{ false };
  /** A verdicts.json that the page saved; empty for none. */
  std::string verdicts;
  /** The run of the other position of the patient, where it is not part of the run; empty for that of the run. */
  std::string second;
  /** The folder that ColonRegistration wrote of run and `second`; without it these positions are not linked. */
  std::string registration;
};

/** Writes `folder`/viewer.html, a page on which a person reads a finished run of VirtualColonoscopy: the flat wall, the
 * wall in space, from inside and slices with one crosshair, candidates, verdicts. It asks for no network. With
 * verdicts, `folder`/verdicts.mrk.json, too, which 3D Slicer loads.
 *
 * `exam` is the folder of the run; with its folders `second` and `registration` the page shows both positions, linked
 * by the map. Equal input gives equal bytes. `outputPath` maps final names to those to write to; `folder`, and `data`
 * within it unless the page is single, are there already.
 *
 * Throws InputError for a run that is not finished, a file that is not what the run writes, and verdicts of another
 * examination or a map of other positions; ParameterError for an option out of range; OutputError.
 * \ingroup ColonViewer */
ColonViewer_EXPORT void
WriteColonViewer(const std::string &        exam,
                 const std::string &        folder,
                 const ColonViewerOptions & options,
                 const OutputPath &         outputPath);
} // namespace shapeton

#endif
