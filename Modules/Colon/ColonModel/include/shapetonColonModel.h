#ifndef shapetonColonModel_h
#define shapetonColonModel_h

#include "ShapetonColonModelExport.h"
#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonColonAssessability.h"
#include "shapetonColonCenterline.h"
#include "shapetonColonDistension.h"
#include "shapetonColonLumenSegmentation.h"
#include "shapetonColonModelOptions.h"
#include "shapetonColonWall.h"
#include "shapetonScanResolution.h"
#include "shapetonTerminalIleum.h"

#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
struct ColonModel;

/** Settings of BuildColonModel(). For a mask without a CT, `position` is not used. \ingroup ShapetonColonModel */
struct ColonModelSettings : ColonModelOptions
{
  /** Slice thickness of the CT, mm; 0: that among the DICOM fields of the image, see DicomField(), if known. */
  double sliceThickness{ 0.0 };
  /** Called on the calling thread with the stage and the completed fraction, 0 to 1. */
  Progress progress;
  /** Called with the cleansed CT (HU) on another thread, in parallel with the remaining steps (after them if
   * single-threaded). Called again, after the first call has returned, if the CT changes because gaps of the line were
   * filled with gas. Intended for slow work such as writing. */
  std::function<void(const itk::Image<float, 3> *)> onCleansed;
  /** Called on another thread with the model, except for its wall, while the wall is built (afterwards if
   * single-threaded). Intended for slow work that does not require the wall, such as writing the volumes. */
  std::function<void(const ColonModel &)> besideWall;
  /** Metadata stored with the surfaces, see ColonWallSettings. */
  std::vector<std::pair<std::string, std::string>> facts;
  /** See ColonWallSettings. */
  std::function<void(const SurfaceMesh & raw, const SurfaceMesh & repaired)> besideSimplification;
};

/** \class ColonModel
 * \brief Model of a colon: lumen, centerline and wall.
 * \ingroup ShapetonColonModel
 */
struct ColonModel
{
  /** Labels on the grid of the input. For a mask without a CT, only the labels and the pieces are set. */
  ColonLumen lumen;
  /** Whether a CT was given, rather than only a mask. */
  bool           hasIntensities{ true };
  ScanResolution resolution;
  /** Cleansed CT (HU); null if there are no intensities. */
  itk::Image<float, 3>::Pointer cleansed;
  /** Centerline, including the valve, see SetIleocecalValve(), and the resolution limit, see SetNotAssessableBelow().
   */
  ColonCenterline centerline;
  ValveSearch     valve;
  /** Terminal ileum, which was removed from labels, line and wall. */
  std::optional<TerminalIleum> terminalIleum;
  /** Distension of the whole line. */
  ColonDistension distension;
  ColonWall       wall;
  /** Warnings of all stages. */
  Remarks warnings;
  /** Reason why the colon is not usable, or empty. On failure, only the parts computed before it are set, or, with
   * keepPartial, all parts that can be computed. */
  std::string failure;
};

/** Runs the pipeline on a CT colonography in HU: lumen, cleansing, centerline, distension, wall.
 * Throws the exceptions of the individual steps. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ColonModel
BuildColonModel(const itk::Image<float, 3> * ct, const ColonModelSettings & options);

/** Runs the pipeline with a mask on the grid of the CT instead of the automatic lumen. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ColonModel
BuildColonModel(const itk::Image<float, 3> * ct, const LumenMask * lumen, const ColonModelSettings & options);

/** Runs the pipeline, except for cleansing, on a mask of the lumen. The raw wall is the 0.5 isosurface of the mask,
 * with stairs and handles; the repaired wall is extracted from the smoothed mask. \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT ColonModel
BuildColonModelOfLumen(const LumenMask * lumen, const ColonModelSettings & options);

/** Stretches, at least 10 mm long, where the scan border cuts the colon; shorter ones are the anal canal.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::vector<HinderedStretch>
                          CutsByScan(const CurveSet & line);

/** Axis of a catheter with the point arrays radius (outer radius, different at the tip) and balloonRadius (0 where
 * there is no balloon) in mm, as input of RankCatheterLast(). \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT CurveSet
CurveOfCatheter(const RectalCatheter & catheter);
} // namespace shapeton

#endif
