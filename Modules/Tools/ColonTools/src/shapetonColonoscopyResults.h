#ifndef shapetonColonoscopyResults_h
#define shapetonColonoscopyResults_h

#include "ShapetonColonToolsExport.h"

#include "shapetonColonExamination.h"
#include "shapetonColonPositionFiles.h"
#include "shapetonCurveSet.h"
#include "shapetonDevice.h"
#include "shapetonFlatColon.h"
#include "shapetonJson.h"
#include "shapetonPolypCandidates.h"
#include "shapetonRegistrationResults.h"
#include "shapetonStagedRun.h"

#include "itkImage.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** A fold, located by its center. \ingroup ShapetonColonTools */
struct ColonoscopyFold
{
  int    label{ 0 };
  double arcLength{ 0.0 };
  double reliability{ 0.0 };
};

/** The colon in two positions. \ingroup ShapetonColonTools */
struct ColonoscopyPair
{
  ColonPositionFiles  first;
  ColonPositionFiles  second;
  RegistrationResults registration;
};

/** Results of the completed stages, read from their files.
 * \ingroup ShapetonColonTools */
struct ShapetonColonTools_EXPORT ColonoscopyResults
{
  /** Stages that were started, in order. */
  std::vector<StageResult> stages;

  Json                          inspection; ///< series.json; null for a volume
  Json                          quality;    ///< quality report of the segmentation
  CurveSet                      centerline;
  SurfaceMesh                   wall;
  itk::Image<float, 3>::Pointer ct;       ///< cleansed; null for a mask
  itk::Image<float, 3>::Pointer original; ///< CT before cleansing; null for a mask
  /** 1 gas, 2 tagged fluid, 3 terminal ileum; null if it was not read. */
  itk::Image<unsigned char, 3>::Pointer lumen;
  DeviceUse                             device; ///< device that renders the CT

  Json flatStatistics;
  /** Null if it was not read. */
  std::shared_ptr<const FlatColon> flat;

  Json                            landmarks;
  CurveSet                        taeniae;
  CurveSet                        flexures;
  SurfaceMesh                     labeled; ///< has the cell array segment
  std::vector<ColonSegmentExtent> segments;

  itk::Image<unsigned short, 2>::Pointer foldLabels;
  CurveSet                               features;
  std::vector<ColonoscopyFold>           folds;

  std::vector<PolypCandidate> polyps;
  /** Picture files of the candidates: the flat colon, then one per candidate. */
  std::vector<std::string> polypPictures;

  /** Set if a second series was registered with this one. */
  std::shared_ptr<const ColonoscopyPair> pair;
  Json                                   qualityOfSecond; ///< quality.json of the second series
  std::vector<PolypCandidate>            polypsOfOther;   ///< candidates of the other series
  /** Whether this is the second series of a run. */
  bool isSecond{ false };

  bool
  IsSinglePosition() const
  {
    return !pair && !isSecond;
  }

  /** The result of a stage; null if it was not started. */
  const StageResult *
  Find(const std::string & stage) const;
  bool
  IsDone(const std::string & stage) const;
};

/** Reads the existing results. Throws InputError for a file that cannot be read. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT ColonoscopyResults
ReadColonoscopyResults(const std::string & folder, const std::vector<StageResult> & stages);
} // namespace shapeton

#endif
