#ifndef shapetonColonModel_h
#define shapetonColonModel_h

#include "ColonModelExport.h"
#include "shapetonRemarks.h"
#include "shapetonProgress.h"
#include "shapetonColonAssessability.h"
#include "shapetonColonCentreline.h"
#include "shapetonColonDistension.h"
#include "shapetonColonLumenSegmentation.h"
#include "shapetonColonWall.h"
#include "shapetonTerminalIleum.h"

#include <functional>
#include <string>
#include <vector>

namespace shapeton
{
struct ColonModel;

/** What the chain from CT colonography to the wall is to use. See BuildColonModel(). \ingroup ColonModel */
struct ColonModelOptions
{
  /** See ColonLumenOptions. Of a mask without a CT only the seed points count. */
  std::string                        patientPosition;
  std::vector<itk::Point<double, 3>> seedPoints;
  /** Of the simplified wall; 0: a number that suits it, as in ColonWallOptions. */
  int faces{ 0 };
  /** Leave the pieces of a broken lumen apart: no tubes through collapsed stretches. */
  bool keepPieces{ false };
  /** Where the colon is not distended or tagged enough, go on with what was found as far as that leads. */
  bool keepPartial{ false };
  /** Told the stage and the share of all that is done, from 0 to 1; from the calling thread. */
  Progress progress;
  /** Called on another thread with the cleansed CT, HU, as soon as it is there, beside all that follows; where there is
   * one thread alone, after it. Again, when it has returned, where gas that fills gaps of the line has made it another
   * CT. For what takes long, such as writing it. */
  std::function<void(const itk::Image<float, 3> *)> onCleansed;
  /** Called on another thread while the wall is made, with all of the model but the wall; where there is one thread
   * alone, after it. For what takes long and needs no wall, such as writing the volumes. */
  std::function<void(const ColonModel &)> besideWall;
  /** Of the surfaces, see ColonWallOptions. */
  std::vector<std::pair<std::string, std::string>> facts;
  /** See ColonWallOptions. */
  std::function<void(const SurfaceMesh & raw, const SurfaceMesh & repaired)> besideSimplification;
};

/** \class ColonModel
 * \brief A colon: lumen, centreline and wall.
 * \ingroup ColonModel
 */
struct ColonModel
{
  /** Labels on the grid of the input. Of a mask without a CT only the labels and pieces are known. */
  ColonLumen lumen;
  /** False where the input was a mask alone. */
  bool hasIntensities{ true };
  /** HU; null where there are no intensities. */
  itk::Image<float, 3>::Pointer cleansed;
  /** With the valve, see SetIleocaecalValve(). */
  ColonCentreline centreline;
  ValveSearch     valve;
  /** What was lumen and is not colon: labels, line and wall do not hold it. */
  std::optional<TerminalIleum> terminalIleum;
  /** Of the segments, and of the whole line. */
  std::vector<SegmentDistension> distension;
  SegmentDistension              wholeDistension;
  ColonWall                      wall;
  /** What is missing or doubtful, of all stages. */
  Remarks warnings;
  /** Empty, or why this is no usable colon; then only the first parts are there. With keepPartial those that could be
   * made. */
  std::string failure;
};

/** The chain from a CT colonography in HU: lumen, cleansing, centreline, distension, wall.
 * Throws as its parts do. \ingroup ColonModel */
ColonModel_EXPORT ColonModel
BuildColonModel(const itk::Image<float, 3> * ct, const ColonModelOptions & options);

/** The chain with a mask on the grid of the CT in place of the automatic lumen. \ingroup ColonModel */
ColonModel_EXPORT ColonModel
BuildColonModel(const itk::Image<float, 3> * ct, const LumenMask * lumen, const ColonModelOptions & options);

/** The chain from a mask of the lumen alone: no cleansing. The raw wall is the 0.5 level of the mask as it is, with its
 * stairs and handles; the repaired one that of the mask smoothed. \ingroup ColonModel */
ColonModel_EXPORT ColonModel
BuildColonModelOfLumen(const LumenMask * lumen, const ColonModelOptions & options);

/** The stretches of at least 10 mm where the border of the scan cuts the colon; shorter ones are the anal canal.
 * \ingroup ColonModel */
ColonModel_EXPORT std::vector<HinderedStretch>
                  CutsByScan(const CurveSet & line);

/** The axis of a catheter with the point arrays radius (outer; of the tip another one) and balloonRadius (0 where no
 * balloon is around it), mm, as RankCatheterLast() takes it. \ingroup ColonModel */
ColonModel_EXPORT CurveSet
CurveOfCatheter(const RectalCatheter & catheter);
} // namespace shapeton

#endif
