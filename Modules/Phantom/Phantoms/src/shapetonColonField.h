#ifndef shapetonColonField_h
#define shapetonColonField_h

#include "shapetonColonCurve.h"
#include "shapetonColonDistance.h"
#include "shapetonColonRelief.h"
#include "shapetonDiverticulumBody.h"
#include "shapetonValveLips.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace shapeton
{
/** A polyp in a position. */
struct PolypBody
{
  bool            isPedunculated;
  Eigen::Vector3d base;
  Eigen::Vector3d axis; ///< unit vector into the lumen
  Eigen::Vector3d head; ///< center of the head
  double          radius;
  double          height; ///< half axis of the head along `axis`
  double          stalkRadius;
  double          t; ///< position on the curve
  double          angle;
};

/** \class ColonField
 * \brief Signed distance to the wall of the colon in a position.
 *
 * Bodies of tissue, each with a distance and gradient, are joined with fillets. The result is divided by the length of
 * its gradient to be first-order accurate near the wall. */
class ColonField
{
public:
  ColonField(const ColonPath & path, const ColonPlan & plan, const ColonPhantomParameters & parameters, double reach);

  struct Place
  {
    ColonDistance distance;
    double        t;
    double        angle;
  };

  /** Returns false if no wall is within reach. */
  bool
  Evaluate(const Eigen::Vector3d & point, Place & place) const;

  /** The first intersection of a ray from the centerline with the wall, and its distance. */
  Eigen::Vector3d
  WallPoint(double t, double angle, double & radius) const;
  /** The first intersection of any ray with the wall. */
  Eigen::Vector3d
  WallAlong(const Eigen::Vector3d & from, const Eigen::Vector3d & direction, double & distance) const;

  const ColonCurve &
  GetCurve() const
  {
    return m_Curve;
  }
  const ColonRelief &
  GetRelief() const
  {
    return m_Relief;
  }
  /** The polyps of the plan in order, then the ileocecal valve if it is a bump. */
  const std::vector<PolypBody> &
  GetPolyps() const
  {
    return m_Polyps;
  }
  /** The diverticula of the plan that fit in this position. */
  const std::vector<DiverticulumBody> &
  GetDiverticula() const
  {
    return m_Diverticula;
  }
  /** Null if the valve is a bump. */
  const std::optional<ValveLips> &
  GetLips() const
  {
    return m_Lips;
  }

private:
  struct Local; // a point relative to one stretch
  void
  Locate(const Eigen::Vector3d & point, double t, Local & local) const;
  ColonDistance
  WallDistance(const Local & local) const;
  void
  AddFolds(const Local & local, ColonDistance & distance) const;
  void
  AddPolyps(const Eigen::Vector3d & point, double t, ColonDistance & distance) const;
  void
  AddSeptum(const Local &         here,
            const ColonDistance & own,
            const Local &         there,
            const ColonDistance & other,
            ColonDistance &       distance) const;
  bool
  EvaluateTube(const Eigen::Vector3d & point, Place & place) const;
  bool
  AddDiverticula(const Eigen::Vector3d & point, bool isNearTube, Place & place) const;
  void
  AddLips(const Eigen::Vector3d & point, double t, ColonDistance & distance) const;
  PolypBody
  MakeValve(const ColonPlan & plan) const;
  void
  PlaceLips(const ColonPlan & plan);
  void
  PlacePolyps(const ColonPlan & plan);
  void
  FillSepta(const ColonPath & path, double least);

  ColonCurve                    m_Curve;
  ColonRelief                   m_Relief;
  double                        m_Reach;
  double                        m_BetweenFolds; ///< mm, fillet between folds; 0 to join folds individually
  std::vector<double>           m_Septum;       ///< at each step
  std::vector<PolypBody>        m_Polyps;
  std::vector<std::vector<int>> m_PolypsNear;
  std::vector<DiverticulumBody> m_Diverticula;
  std::optional<ValveLips>      m_Lips;
  double                        m_LipsAt{ 0.0 }; ///< position on the curve
};

/** Places the diverticula of a patient in a position; the field must not contain diverticula yet. If a sac is too close
 * to the wall of the colon, another sac, the spine or the body wall, it is tilted or made smaller; if it still does not
 * fit, it is omitted. */
std::vector<DiverticulumBody>
PlaceDiverticula(const ColonField & field, const std::vector<DiverticulumPlan> & plans);
} // namespace shapeton

#endif
