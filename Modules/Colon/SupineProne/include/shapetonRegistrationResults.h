#ifndef shapetonRegistrationResults_h
#define shapetonRegistrationResults_h

#include "shapetonColonPositionFiles.h"
#include "shapetonJson.h"
#include "shapetonRegistrationErrors.h"

#include <string>
#include <vector>

namespace shapeton
{
/** \defgroup RegistrationResults What is reported about a registration of two examinations
 * \ingroup SupineProne */
///@{

/** What points with known correspondence say about a pair of folds, or a fold of the supine position. */
enum class FoldVerdict
{
  /** No point is near, or the other fold was not found. */
  Unknown,
  Correct,
  Wrong,
  /** The fold has no partner though its true one was found and is free. */
  Unmatched
};

/** "", "correct", "wrong", "unmatched". */
SupineProne_EXPORT std::string
                   NameOf(FoldVerdict verdict);

/** Two folds that are taken for one, as a table tells it. */
struct MatchedFolds
{
  /** HaustralFold::label. */
  int             supineFold{ 0 };
  int             proneFold{ 0 };
  Eigen::Vector3d supinePoint{ Eigen::Vector3d::Zero() }; ///< their middles, LPS, mm
  Eigen::Vector3d pronePoint{ Eigen::Vector3d::Zero() };
  /** mm along the centrelines. */
  double supineArcLength{ 0.0 };
  double proneArcLength{ 0.0 };
  /** Of the supine position; "" where it is not known. */
  std::string segment;
  /** See FoldMatch. */
  double cost{ 0.0 };
  double residual{ 0.0 };
  double weight{ 0.0 };
  /** Correct or Wrong, where points tell. */
  FoldVerdict verdict{ FoldVerdict::Unknown };

  /** Whether the map follows it; else it contradicts its neighbours. */
  bool
  IsFollowed() const
  {
    return weight >= 0.5;
  }
};

/** Folds and their matches in a segment of the colon, as Table 4.1 of the dissertation counts them, but with folds
 * that stay alone apart from wrong pairs. Prone folds count where the prone landmarks put them. */
struct SegmentMatches
{
  std::string segment;
  int         supineFolds{ 0 };
  int         proneFolds{ 0 };
  /** Pairs by the segment of their supine fold. */
  int followed{ 0 };
  int contradicted{ 0 };
  int supineAlone{ 0 };
  int proneAlone{ 0 };
  /** Mean of the confidence where something is to be seen, 0 to 1; not a number where nothing is. */
  double confidence{ 0.0 };
  /** \name Where points tell the truth: pairs that are correct or wrong, and supine folds alone whose true partner was
   * found and is in no correct pair */
  ///@{
  int correct{ 0 };
  int wrong{ 0 };
  int unmatched{ 0 };
  ///@}
};

/** All that files and pictures hold. */
struct RegistrationResults
{
  /** The flat surface of one position with what the other one has there: point arrays mapped (LPS, mm, on the other
   * wall), mappedUv (mm of the other flat map), displacement (mapped less the point, mm), confidence (0 to 1) and
   * excluded (1 where nothing is to be seen in one of them). */
  SurfaceMesh supineToProne;
  SurfaceMesh proneToSupine;
  /** In the order of the supine folds. */
  std::vector<MatchedFolds>   matches;
  std::vector<SegmentMatches> segments;
  /** With known points: these, and the error of each. */
  std::vector<PointPair>  points;
  std::vector<PointError> errors;
  /** registration.json without provenance and warnings. */
  Json document;
};

/** \param truth points whose correspondence is known, for errors; may be empty. */
SupineProne_EXPORT RegistrationResults
MakeRegistrationResults(const ColonPositionFiles &      supine,
                        const ColonPositionFiles &      prone,
                        const SupineProneRegistration & registration,
                        const std::vector<PointPair> &  truth = {},
                        const Progress &                progress = {});
///@}
} // namespace shapeton

#endif
