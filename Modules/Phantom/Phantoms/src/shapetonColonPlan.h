#ifndef shapetonColonPlan_h
#define shapetonColonPlan_h

#include "shapetonColonCurve.h"
#include "shapetonColonPath.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** Wraps an angle to (-pi, pi]. */
double
WrapAngle(double angle);

/** A fold at rest. The coordinate u is -1 and 1 at the ends. */
struct FoldPlan
{
  double material;  ///< mm
  double angle;     ///< angle of the middle
  double halfAngle; ///< half angle from the middle to an end, < pi
  double height;    ///< mm
  double thickness; ///< mm
  double slant;     ///< mm, offset of the end u = 1 along the colon
  double bow;       ///< mm, offset of both ends from the middle along the colon
  double wave;      ///< mm
  double wavePhase;
};

/** A polyp at rest. */
struct PolypPlan
{
  std::string kind;
  double      diameter;
  double      height; ///< height of the head, or of a polyp without a stalk
  double      stalk;  ///< length, 0 without a stalk
  double      stalkRadius;
  double      material;
  double      angle;
  int         fold; ///< -1: on the wall
};

/** A diverticulum at rest: a sac with a neck through the wall; lengths in mm. */
struct DiverticulumPlan
{
  double material;
  double angle;
  double neck;       ///< inner diameter
  double neckLength; ///< from the surface of the wall to the sac
  double diameter;   ///< diameter of the sac
  double stool;      ///< HU of the stool; 0 if filled like the lumen
};

/** The ileocecal valve at rest. */
struct ValvePlan
{
  double material; ///< mm
  double angle;
  bool   hasLips;   ///< otherwise a bump
  double length;    ///< of the lips around the colon, mm
  double height;    ///< mm
  double thickness; ///< of each lip, mm
  double behind;    ///< entry angle of the ileum toward the back, relative to the center of the abdomen, radians
};

/** The angle at which the wall best faces a direction, accurate to 0.1. */
double
AngleTowards(const ColonCurve & curve, double t, const Eigen::Vector3d & direction);

/** The angle at which the wall faces the ileum in a position. */
double
AngleOfIleum(const ColonCurve & curve, const ValvePlan & valve);

/** \class ColonPlan
 * \brief Patient-specific features in material coordinates (position along the colon at rest, mm, and angle). */
class ColonPlan
{
public:
  ColonPlan(const ColonPath & rest, const ColonPhantomParameters & parameters);

  /** Angle of taenia 0, 1 or 2. */
  double
  TaeniaAngle(int taenia, double material) const;

  /** Angle of taenia 0 without drift. */
  double
  StartOfTaeniae() const
  {
    return m_StartOfTaeniae;
  }

  /** Prominence of the three taeniae coli and the haustra in between, 0 to 1. */
  double
  HaustraStrength(double material) const;

  int
  SegmentAt(double material) const;
  double
  RadiusAt(double material) const;
  double
  Length() const
  {
    return m_Length;
  }

  std::vector<FoldPlan>         folds;
  std::vector<PolypPlan>        polyps;
  std::vector<DiverticulumPlan> diverticula;
  ValvePlan                     valve{};

private:
  void
  PlanTaeniae(const ColonPath & rest, const ColonPhantomParameters & parameters);
  void
  PlanFolds(unsigned seed);
  void
  PlanLevel(double material, int level, class ColonRandom & random);
  void
  PlanValves(class ColonRandom & random);
  FoldPlan
  MakeFold(double material, double angle, double halfAngle, class ColonRandom & random) const;
  void
  PlanPolyps(unsigned seed, int count);
  void
  PlanValve(const ColonPath & rest, const ColonPhantomParameters & parameters);
  bool
  IsNearValve(double material, double angle, double halfAngle, double margin) const;
  bool
  PlacePolyp(class ColonRandom & random, PolypPlan & polyp) const;
  bool
  IsClearOfFolds(const PolypPlan & polyp) const;

  double                             m_Length;
  std::vector<double>                m_SegmentBegin; ///< start of the six segments, then the length
  std::vector<double>                m_Radius;
  std::array<std::vector<double>, 3> m_Taenia; ///< every 2 mm
  double                             m_StartOfTaeniae{ 0.0 };
};

/** Places up to `count` diverticula, as space permits, in rows next to the taeniae coli, away from the folds, the
 * polyps and the valve of the plan. The result for a smaller count is a prefix of the result for a larger count. */
std::vector<DiverticulumPlan>
PlanDiverticula(const ColonPlan & plan, unsigned seed, int count);
} // namespace shapeton

#endif
