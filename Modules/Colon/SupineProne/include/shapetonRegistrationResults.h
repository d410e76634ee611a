#ifndef shapetonRegistrationResults_h
#define shapetonRegistrationResults_h

#include "shapetonColonPositionFiles.h"
#include "shapetonJson.h"
#include "shapetonRegistrationErrors.h"

#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup RegistrationResults Results of a registration of two examinations
 * \ingroup ShapetonSupineProne */
///@{

/** Verdict on a pair of folds or on a supine fold, or on ends of folds, based on points with known correspondence. */
enum class FoldVerdict
{
  /** No point is nearby, or the true partner was not detected. */
  Unknown,
  Correct,
  Wrong,
  /** The fold is unmatched although its true partner was detected and is free. */
  Unmatched
};

/** "", "correct", "wrong", "unmatched". */
ShapetonSupineProne_EXPORT std::string
                           NameOf(FoldVerdict verdict);

/** A matched pair of folds, or of ends of folds for the published map: a row of the table. */
struct MatchedFolds
{
  /** HaustralFold::label. */
  int             supineFold{ 0 };
  int             proneFold{ 0 };
  Eigen::Vector3d supinePoint{ Eigen::Vector3d::Zero() }; ///< centers or ends, LPS, mm
  Eigen::Vector3d pronePoint{ Eigen::Vector3d::Zero() };
  /** mm along the centerlines. */
  double supineArcLength{ 0.0 };
  double proneArcLength{ 0.0 };
  /** Segment in the supine position; "" if unknown. */
  std::string segment;
  /** See FoldMatch. */
  double cost{ 0.0 };
  double residual{ 0.0 };
  double weight{ 0.0 };
  /** Correct or Wrong if points are available. */
  FoldVerdict verdict{ FoldVerdict::Unknown };

  /** Whether the map is consistent with the pair. An inconsistent pair contradicts its neighbors. */
  bool
  IsFollowed() const
  {
    return weight >= 0.5;
  }
};

/** Counts of folds and matches in a segment of the colon, as in Table 4.1 of the dissertation, but with separate counts
 * of unmatched folds and wrong pairs. For the published map, the ends of folds near the main taenia are counted instead
 * of folds. The prone ones are assigned to segments by the prone landmarks. */
struct SegmentMatches
{
  std::string segment;
  int         supineFolds{ 0 };
  int         proneFolds{ 0 };
  /** Pairs, counted in the segment of the supine fold. */
  int followed{ 0 };
  int contradicted{ 0 };
  int supineAlone{ 0 };
  int proneAlone{ 0 };
  /** Mean confidence of the visible part, 0 to 1; NaN if no part is visible. */
  double confidence{ 0.0 };
  /** \name With ground truth: correct and wrong pairs, and unmatched supine folds whose true partner was detected but
   * is not in a correct pair */
  ///@{
  int correct{ 0 };
  int wrong{ 0 };
  int unmatched{ 0 };
  ///@}
};

/** Contents of the result files and pictures. */
struct RegistrationResults
{
  /** The flat surface of one position with its map to the other: point arrays mapped (LPS, mm, on the other wall),
   * mappedUv (mm of the other flat map), displacement (mapped minus the point, mm), confidence (0 to 1) and excluded (1
   * where the wall is not visible in one of the positions). */
  SurfaceMesh supineToProne;
  SurfaceMesh proneToSupine;
  /** Ordered by supine fold. */
  std::vector<MatchedFolds>   matches;
  std::vector<SegmentMatches> segments;
  /** Ground-truth points with errors. */
  std::vector<PointPair>  points;
  std::vector<PointError> errors;
  /** Content of registration.json except for provenance and warnings. */
  Json document;
};

/** \param truth points with known correspondence, used to compute errors; may be empty. */
ShapetonSupineProne_EXPORT RegistrationResults
MakeRegistrationResults(const ColonPositionFiles &      supine,
                        const ColonPositionFiles &      prone,
                        const SupineProneRegistration & registration,
                        const std::vector<PointPair> &  truth = {},
                        const Progress &                progress = {});
///@}
} // namespace shapeton

#endif
