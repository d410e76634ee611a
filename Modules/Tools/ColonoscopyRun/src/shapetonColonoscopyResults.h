#ifndef shapetonColonoscopyResults_h
#define shapetonColonoscopyResults_h

#include "ColonoscopyRunExport.h"

#include "shapetonColonLandmarkDocument.h"
#include "shapetonColonPositionFiles.h"
#include "shapetonColonoscopyStageTools.h"
#include "shapetonCurveSet.h"
#include "shapetonDevice.h"
#include "shapetonFlatColon.h"
#include "shapetonJson.h"
#include "shapetonPolypCandidates.h"
#include "shapetonRegistrationResults.h"
#include "shapetonStagedRun.h"

#include "itkImage.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace shapeton
{
/** A fold by its centre. \ingroup ColonoscopyRun */
struct ColonoscopyFold
{
  int    label{ 0 };
  double arcLength{ 0.0 };
  double reliability{ 0.0 };
};

/** The colon in two positions. \ingroup ColonoscopyRun */
struct ColonoscopyPair
{
  ColonPositionFiles  first;
  ColonPositionFiles  second;
  RegistrationResults registration;
};

/** What the stages have found, read from their files; of a stage that did not come to its end, nothing.
 * \ingroup ColonoscopyRun */
struct ColonoscopyRun_EXPORT ColonoscopyResults
{
  /** Those that were tried, in order. */
  std::vector<StageResult> stages;

  Json                          quality; ///< of the segmentation
  CurveSet                      centreline;
  SurfaceMesh                   wall;
  itk::Image<float, 3>::Pointer ct;     ///< cleansed; null of a mask
  DeviceUse                     device; ///< that renders it

  Json flatStatistics;
  /** Null where it was not read. */
  std::shared_ptr<const FlatColon> flat;

  Json                            landmarks;
  CurveSet                        taeniae;
  CurveSet                        flexures;
  SurfaceMesh                     labelled; ///< with the cell array segment
  std::vector<ColonSegmentExtent> segments;

  itk::Image<unsigned short, 2>::Pointer foldLabels;
  CurveSet                               features;
  std::vector<ColonoscopyFold>           folds;

  std::vector<PolypCandidate> polyps;
  /** Files of pictures of the candidates: the flat colon, then one of each. */
  std::vector<std::string> polypPictures;

  /** Where a second series was registered with this one. */
  std::shared_ptr<const ColonoscopyPair> pair;

  /** Null where it was not tried. */
  const StageResult *
  Find(const std::string & stage) const;
  bool
  IsDone(const std::string & stage) const;
};

/** The folder of the second series in that of the run. \ingroup ColonoscopyRun */
constexpr const char * colonoscopySecondFolder = "second";

/** Reads what is there. Throws InputError for a file that cannot be read. \ingroup ColonoscopyRun */
ColonoscopyRun_EXPORT ColonoscopyResults
ReadColonoscopyResults(const std::string & folder, const std::vector<StageResult> & stages);
} // namespace shapeton

#endif
