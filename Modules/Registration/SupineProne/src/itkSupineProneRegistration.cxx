#include "itkSupineProneRegistration.h"

#include "itkBeltramiProjection.h"
#include "itkColonSense.h"
#include "itkCylindricalWarping.h"
#include "itkRegistrationConfidence.h"
#include "itkSmoothCorrection.h"
#include "itkToolError.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace itk
{
namespace
{
constexpr int    angles = 48;    ///< rotations of the warping
constexpr double rowStep = 3.0;  ///< mm between its rows
constexpr int    mapAngles = 36; ///< of the final map
constexpr double mapStep = 4.0;  ///< mm

/** A map that moves rows as a whole, with a smooth correction. */
struct RowMap
{
  PiecewiseLine            s;
  PiecewiseLine            rotation;
  const SmoothCorrection * correction{ nullptr };
  double                   around{ 1.0 }; ///< of the target, mm

  CylinderPlace
  operator()(const CylinderPlace & place) const
  {
    CylinderPlace mapped{ s(place.s), place.turn + rotation(place.s) };
    if (correction)
    {
      const Eigen::Vector2d more = correction->At(place);
      mapped.s += more.x();
      mapped.turn += more.y() / around;
    }
    return mapped;
  }
};

class Registration
{
public:
  Registration(const ColonPosition & source, const ColonPosition & target, const SupineProneOptions & options)
    : m_Source(source), m_Target(target), m_Options(options)
  {
    m_Result.sourceGrid = source.grid;
    m_Result.targetGrid = target.grid;
    m_Result.source = std::make_shared<ColonCylinder>(*source.grid, source.centreline);
    m_Result.target = std::make_shared<ColonCylinder>(*target.grid, target.centreline);
    m_SourceFolds = FoldProbability(source);
    m_TargetFolds = FoldProbability(target);
  }

  SupineProneRegistration
  Run()
  {
    m_Result.confidence.senseMargin =
      RequireSameSense({ m_Source, *m_Result.source, m_SourceFolds }, { m_Target, *m_Result.target, m_TargetFolds });
    this->FindFrame();
    this->Warp();
    this->Correct();
    this->Project();
    this->Finish();
    return std::move(m_Result);
  }

private:
  const std::vector<float> &
  FoldsOf(const ColonPosition & position) const
  {
    return &position == &m_Target ? m_TargetFolds : m_SourceFolds;
  }

  void
  FindFrame()
  {
    m_Frame = FlexureFrame(m_Source, *m_Result.source, m_Target, *m_Result.target, m_Result.warnings);
    for (std::size_t i = 1; i + 1 < m_Frame.from.size(); ++i)
    {
      m_Result.flexures.emplace_back(m_Frame.from[i], m_Frame.to[i]);
      if (m_Options.isSegmentWise)
      {
        m_Breaks.push_back(m_Frame.from[i]);
      }
    }
    m_SourceTaeniae = AnglesOfTaeniae(m_Source, *m_Result.source, m_Result.warnings);
    m_TargetTaeniae = AnglesOfTaeniae(m_Target, *m_Result.target, m_Result.warnings);
    if (m_Result.flexures.empty() && !(m_SourceTaeniae.isKnown && m_TargetTaeniae.isKnown))
    {
      throw InputError("the positions have no landmarks in common, neither flexures nor taeniae: " + m_Source.name +
                       " and " + m_Target.name + "; find them with ColonLandmarks");
    }
  }

  /** Rows of the warping lie in the coordinate of the source. */
  CylinderPicture
  PictureOf(const PiecewiseLine * frame) const
  {
    const ColonPosition & position = frame ? m_Target : m_Source;
    CylinderPictureForm   form;
    form.begin = m_Result.source->Begin() + 0.5 * rowStep;
    form.step = frame ? 0.5 * rowStep : rowStep;
    form.rows = std::max(2, static_cast<int>((m_Result.source->End() - m_Result.source->Begin()) / form.step));
    form.angles = angles;
    form.smoothRows = frame ? 1.6 : 0.8;
    const PiecewiseLine back = frame ? frame->Inverse() : PiecewiseLine{ { 0.0, 1.0 }, { 0.0, 1.0 } };
    form.coordinate = [back](double s) { return back(s); };
    return MakeCylinderPicture(
      position, frame ? *m_Result.target : *m_Result.source, frame ? m_TargetFolds : m_SourceFolds, form);
  }

  /** A frame to try, and how far the path may leave it. */
  struct Trial
  {
    PiecewiseLine frame;
    double        band;
    double        deviation;
    /** Weights of slope and rotation. */
    double slope;
    double rotation;
    /** Any rotation, in case taeniae were lost somewhere. */
    bool isFree;
  };

  /** Flexures are found with errors of centimetres, and lengths are not quite proportional: neither is a frame that can
   * be trusted alone. Segments need the flexures themselves. */
  std::vector<Trial>
  Trials() const
  {
    std::vector<Trial>         trials;
    std::vector<PiecewiseLine> frames{ m_Frame };
    if (!m_Options.isSegmentWise)
    {
      frames.push_back(CautiousFrame(m_Frame, m_Source, m_Target));
      frames.push_back(EndFrame(m_Frame));
    }
    for (std::size_t i = 0; i < frames.size(); ++i)
    {
      const double band = 60.0 + 15.0 * static_cast<double>(i);
      const double deviation = 25.0 + 12.0 * static_cast<double>(i);
      trials.push_back({ frames[i], band, deviation, 0.3, 0.4, !this->AreTaeniaeKnown() });
      trials.push_back({ frames[i], band, deviation, 2.0, 1.0, !this->AreTaeniaeKnown() });
      if (this->AreTaeniaeKnown())
      {
        trials.push_back({ frames[i], band, deviation, 2.0, 1.0, true });
      }
    }
    return trials;
  }

  /** Of each trial the warp with the least energy, with the taeniae in each of the three ways they may correspond and
   * with any rotation, in case they were lost somewhere. Energy does not tell a path that is one fold too far from the
   * right one; how many pairs of folds a smooth map can follow does, so that decides between the trials. */
  void
  Warp()
  {
    const CylinderPicture source = this->PictureOf(nullptr);
    std::vector<double>   s;
    for (int row = 0; row < source.Rows(); ++row)
    {
      s.push_back(source.begin + row * source.step);
    }
    std::vector<double> energies(this->AreTaeniaeKnown() ? 3 : 0, std::numeric_limits<double>::infinity());
    CylindricalWarp     best;
    double              bestSupport = -std::numeric_limits<double>::infinity();
    for (const Trial & trial : this->Trials())
    {
      m_Warp = this->BestWarp(trial, source, s, energies);
      this->MatchAndCorrect();
      const double support = this->Support();
      if (support > bestSupport || best.s.empty())
      {
        bestSupport = support;
        best = m_Warp;
      }
    }
    m_Warp = best;
    this->MatchAndCorrect();
    this->JudgeWays(energies, s);
  }

  CylindricalWarp
  BestWarp(const Trial &               trial,
           const CylinderPicture &     source,
           const std::vector<double> & s,
           std::vector<double> &       energies) const
  {
    const CylinderPicture     target = this->PictureOf(&trial.frame);
    CylindricalWarpingOptions options;
    options.breaks = m_Breaks;
    options.band = trial.band;
    options.frameDeviation = trial.deviation;
    options.slopeWeight = trial.slope;
    options.rotationWeight = trial.rotation;
    CylindricalWarp best;
    best.energy = std::numeric_limits<double>::infinity();
    if (trial.isFree)
    {
      return WarpCylinder(source, target, trial.frame, {}, options);
    }
    for (int way = 0; way < static_cast<int>(energies.size()); ++way)
    {
      const std::vector<double> rotation = RotationOfTaeniae(m_SourceTaeniae, m_TargetTaeniae, trial.frame, way, s);
      const CylindricalWarp     warp = WarpCylinder(source, target, trial.frame, rotation, options);
      energies[way] = std::min(energies[way], warp.energy);
      best = warp.energy < best.energy ? warp : best;
    }
    return best;
  }

  /** Of pairs that the map follows, less those that it does not. */
  double
  Support() const
  {
    double support = 0.0;
    for (const double weight : m_PairWeights)
    {
      support += weight - 0.5;
    }
    return support;
  }

  /** Which taenia is which, and the frame that the registration is compared with. */
  void
  JudgeWays(const std::vector<double> & energies, const std::vector<double> & s)
  {
    RegistrationConfidence & confidence = m_Result.confidence;
    confidence.energies = energies;
    confidence.energy = energies.empty() ? m_Warp.energy : *std::min_element(energies.begin(), energies.end());
    confidence.margin = std::numeric_limits<double>::quiet_NaN();
    m_FrameRotation = m_Warp.rotation;
    if (!energies.empty())
    {
      std::vector<double> sorted = energies;
      std::sort(sorted.begin(), sorted.end());
      confidence.margin = sorted[1] - sorted[0];
      const auto way = static_cast<int>(std::min_element(energies.begin(), energies.end()) - energies.begin());
      m_FrameRotation = RotationOfTaeniae(m_SourceTaeniae, m_TargetTaeniae, m_Frame, way, s);
    }
  }

  RowMap
  MapOfWarp() const
  {
    return { { m_Warp.s, m_Warp.targetS }, { m_Warp.s, m_Warp.rotation }, nullptr, m_Result.target->Around() };
  }

  FoldFeature
  FeatureOf(const ColonCylinder & cylinder, const HaustralFold & fold, const RowMap * map) const
  {
    const CylinderPlace own = cylinder.PlaceOfUv(fold.centreUv);
    const double        s = map ? own.s : m_Frame.Inverse()(own.s);
    const auto          group = std::count_if(m_Breaks.begin(), m_Breaks.end(), [s](double at) { return s > at; });
    const CylinderPlace place = map ? (*map)(own) : own;
    return { place.s,
             place.turn * m_Result.target->Around(),
             std::max(1.0, fold.length),
             std::max(1.0, fold.area),
             static_cast<int>(group) };
  }

  void
  MatchAndCorrect()
  {
    RowMap map = this->MapOfWarp();
    for (int round = 0; round < 2; ++round)
    {
      std::vector<FoldFeature> source;
      std::vector<FoldFeature> target;
      for (const HaustralFold & fold : m_Source.folds)
      {
        source.push_back(this->FeatureOf(*m_Result.source, fold, &map));
      }
      for (const HaustralFold & fold : m_Target.folds)
      {
        target.push_back(this->FeatureOf(*m_Result.target, fold, nullptr));
      }
      FoldMatchingOptions options;
      options.method = m_Options.matching;
      m_Result.matching = MatchFolds(source, target, m_Result.target->Around(), options);
      this->Fit(this->ConstraintsOfTaeniae(map));
      map.correction = m_Correction.get();
    }
  }

  /** Where the middle and the ends of a fold are to move, more than the warp moves them. Ends are paired as they lie.
   */
  void
  AddConstraints(const HaustralFold &                  a,
                 const HaustralFold &                  b,
                 std::vector<DisplacementConstraint> & constraints) const
  {
    const RowMap warp = this->MapOfWarp();
    const auto   constraint = [&](const Eigen::Vector2d & from, const Eigen::Vector2d & to, double weight) {
      const CylinderPlace place = m_Result.source->PlaceOfUv(from);
      const CylinderPlace start = warp(place);
      const CylinderPlace goal = m_Result.target->PlaceOfUv(to);
      const double        around = TurnDifference(goal.turn, start.turn) * m_Result.target->Around();
      return DisplacementConstraint{ place, { goal.s - start.s, around }, weight };
    };
    const auto endsOf = [&](bool isTurned) {
      return std::array<DisplacementConstraint, 2>{ constraint(a.endUv[0], b.endUv[isTurned ? 1 : 0], 1.0),
                                                    constraint(a.endUv[1], b.endUv[isTurned ? 0 : 1], 1.0) };
    };
    const auto straight = endsOf(false);
    const auto turned = endsOf(true);
    const auto cost = [](const std::array<DisplacementConstraint, 2> & ends) {
      return ends[0].displacement.squaredNorm() + ends[1].displacement.squaredNorm();
    };
    constraints.push_back(constraint(a.centreUv, b.centreUv, 1.0));
    const auto & ends = cost(turned) < cost(straight) ? turned : straight;
    constraints.insert(constraints.end(), ends.begin(), ends.end());
  }

  bool
  AreTaeniaeKnown() const
  {
    return m_SourceTaeniae.isKnown && m_TargetTaeniae.isKnown;
  }

  /** Taeniae of the source are to come to lie on those of the target, where the map takes them along the colon. */
  std::vector<DirectionConstraint>
  ConstraintsOfTaeniae(const RowMap & map) const
  {
    constexpr double                 step = 6.0;      // mm
    constexpr double                 greatest = 15.0; // mm: farther away it is another one, or none
    constexpr double                 deviation = 3.0; // mm
    std::vector<DirectionConstraint> constraints;
    for (double s = m_Result.source->Begin(); this->AreTaeniaeKnown() && s < m_Result.source->End(); s += step)
    {
      for (int taenia = 0; taenia < 3; ++taenia)
      {
        const CylinderPlace place{ s, m_SourceTaeniae.At(taenia, s) };
        const CylinderPlace at = map(place);
        double              nearest = greatest;
        for (int other = 0; other < 3; ++other)
        {
          const double away = TurnDifference(m_TargetTaeniae.At(other, at.s), at.turn) * m_Result.target->Around();
          nearest = std::abs(away) < std::abs(nearest) ? away : nearest;
        }
        if (std::abs(nearest) < greatest && !IsExcluded(m_Source, *m_Result.source, place) &&
            !IsExcluded(m_Target, *m_Result.target, at))
        {
          const double sofar = map.correction ? map.correction->At(place).y() : 0.0;
          constraints.push_back(
            { place, Eigen::Vector2d::UnitY(), nearest + sofar, 1.0 / (deviation * deviation), true });
        }
      }
    }
    return constraints;
  }

  std::vector<DisplacementConstraint>
  ConstraintsOfFolds() const
  {
    std::vector<DisplacementConstraint> constraints;
    for (const auto & [i, j] : m_Result.matching.pairs)
    {
      this->AddConstraints(m_Source.folds[i], m_Target.folds[j], constraints);
    }
    return constraints;
  }

  /** Where the target's picture differs from the source's, linearised about the map (Gauss-Newton). */
  std::vector<DirectionConstraint>
  ConstraintsOfPictures(const CylinderPicture & source, const CylinderPicture & target, const RowMap & map) const
  {
    constexpr double                 weight = 0.04; // of a difference of one standard deviation
    const double                     along = 0.5 * rowStep;
    const double                     around = 0.5 / angles;
    std::vector<DirectionConstraint> constraints;
    for (int i = 0; i < source.Rows(); ++i)
    {
      for (int j = 0; j < angles && !source.isExcluded[i]; ++j)
      {
        const CylinderPlace place{ source.begin + i * source.step, (j + 0.5) / angles };
        const CylinderPlace to = map(place);
        if (IsExcluded(m_Target, *m_Result.target, to))
        {
          continue;
        }
        const Eigen::Vector2d gradient(
          (SampleOf(target, to.s + along, to.turn) - SampleOf(target, to.s - along, to.turn)) / (2.0 * along),
          (SampleOf(target, to.s, to.turn + around) - SampleOf(target, to.s, to.turn - around)) /
            (2.0 * around * m_Result.target->Around()));
        const double difference = source.values(i, j) - SampleOf(target, to.s, to.turn);
        constraints.push_back({ place, gradient, difference + gradient.dot(m_Correction->At(place)), weight, false });
      }
    }
    return constraints;
  }

  void
  Refine(RowMap & map)
  {
    for (const double blur : { 2.5, 1.5, 1.0 })
    {
      const CylinderPicture                  source = this->PlainPicture(m_Source, *m_Result.source, blur);
      const CylinderPicture                  target = this->PlainPicture(m_Target, *m_Result.target, blur);
      std::vector<DirectionConstraint>       directions = this->ConstraintsOfTaeniae(map);
      const std::vector<DirectionConstraint> pictures = this->ConstraintsOfPictures(source, target, map);
      directions.insert(directions.end(), pictures.begin(), pictures.end());
      this->Fit(directions);
      map.correction = m_Correction.get();
    }
  }

  /** In its own coordinate, for both positions alike. */
  CylinderPicture
  PlainPicture(const ColonPosition & position, const ColonCylinder & cylinder, double blur) const
  {
    CylinderPictureForm form;
    form.begin = cylinder.Begin() + 0.5 * rowStep;
    form.step = rowStep;
    form.rows = std::max(2, static_cast<int>((cylinder.End() - cylinder.Begin()) / rowStep));
    form.angles = angles;
    form.smoothRows = blur;
    form.smoothAngles = blur;
    form.coordinate = [](double s) { return s; };
    return MakeCylinderPicture(position, cylinder, FoldsOf(position), form);
  }

  void
  Fit(const std::vector<DirectionConstraint> & directions)
  {
    const std::vector<DisplacementConstraint> constraints = this->ConstraintsOfFolds();
    auto                                      correction =
      std::make_unique<SmoothCorrection>(m_Result.source->Begin(), m_Result.source->End(), m_Result.target->Around());
    const std::vector<double> weights = correction->Fit(constraints, directions);
    m_Correction = std::move(correction);
    m_PairWeights.clear();
    for (std::size_t pair = 0; pair < m_Result.matching.pairs.size(); ++pair)
    {
      m_PairWeights.push_back(weights[3 * pair]); // of the middle
    }
  }

  /** With the warp and the pairs that were taken. */
  void
  Correct()
  {
    if (m_Options.refines)
    {
      RowMap map = this->MapOfWarp();
      map.correction = m_Correction.get();
      this->Refine(map);
    }
  }

  CylinderNodes
  NodesOf(const RowMap & map) const
  {
    CylinderNodes nodes;
    const double  length = m_Result.source->End() - m_Result.source->Begin();
    const int     rows = std::max(2, static_cast<int>(std::ceil(length / mapStep)) + 1);
    nodes.begin = m_Result.source->Begin();
    nodes.step = length / (rows - 1);
    nodes.s.resize(rows, mapAngles);
    nodes.turn.resize(rows, mapAngles);
    for (int i = 0; i < rows; ++i)
    {
      for (int j = 0; j < mapAngles; ++j)
      {
        const CylinderPlace place = map({ nodes.begin + i * nodes.step, static_cast<double>(j) / mapAngles });
        nodes.s(i, j) = place.s;
        nodes.turn(i, j) = place.turn;
      }
    }
    return nodes;
  }

  void
  Project()
  {
    RowMap map = this->MapOfWarp();
    map.correction = m_Correction.get();
    BeltramiProjectionOptions options;
    options.greatest = m_Options.greatestDilatation;
    const BeltramiProjection projection =
      ProjectToBijection(this->NodesOf(map), m_Result.source->Around(), m_Result.target->Around(), options);
    m_Result.map = CylinderMap(projection.nodes);
    m_Result.figures.flips = m_Result.map.Flips();
    m_Result.figures.flipsBeforeProjection = projection.flipsBefore;
    m_Result.figures.greatestDilatation = projection.greatest;
    m_Result.frame =
      CylinderMap(this->NodesOf({ m_Frame, { m_Warp.s, m_FrameRotation }, nullptr, m_Result.target->Around() }));
  }

  int
  SegmentOf(double s) const
  {
    int segment = 0;
    for (const auto & flexure : m_Result.flexures)
    {
      segment += s > flexure.first;
    }
    return segment;
  }

  void
  Finish()
  {
    for (std::size_t pair = 0; pair < m_Result.matching.pairs.size(); ++pair)
    {
      const auto [i, j] = m_Result.matching.pairs[pair];
      const CylinderPlace from = m_Result.source->PlaceOfUv(m_Source.folds[i].centreUv);
      const CylinderPlace to = m_Result.target->PlaceOfUv(m_Target.folds[j].centreUv);
      const CylinderPlace mapped = m_Result.map.Forward(from);
      FoldMatch           match;
      match.source = i;
      match.target = j;
      match.cost = m_Result.matching.costs[pair];
      match.residual = std::hypot(mapped.s - to.s, TurnDifference(mapped.turn, to.turn) * m_Result.target->Around());
      match.weight = m_PairWeights[pair];
      match.segment = this->SegmentOf(from.s);
      m_Result.matches.push_back(match);
    }
    this->MarkExcluded();
    JudgeRegistration(m_Source, m_Target, m_Result);
  }

  static bool
  IsExcluded(const ColonPosition & position, const ColonCylinder & cylinder, const CylinderPlace & place)
  {
    const int column = cylinder.Grid().PixelOfUv(cylinder.UvOfPlace(place)).column;
    return !position.isExcluded.empty() && position.isExcluded[column] != 0;
  }

  void
  MarkExcluded()
  {
    const CylinderNodes & nodes = m_Result.map.Nodes();
    m_Result.isExcluded.setZero(nodes.Rows(), nodes.Angles());
    for (int i = 0; i < nodes.Rows(); ++i)
    {
      for (int j = 0; j < nodes.Angles(); ++j)
      {
        const CylinderPlace place{ nodes.begin + i * nodes.step, static_cast<double>(j) / nodes.Angles() };
        m_Result.isExcluded(i, j) =
          IsExcluded(m_Source, *m_Result.source, place) || IsExcluded(m_Target, *m_Result.target, nodes.At(i, j));
      }
    }
  }

  const ColonPosition &             m_Source;
  const ColonPosition &             m_Target;
  SupineProneOptions                m_Options;
  SupineProneRegistration           m_Result;
  PiecewiseLine                     m_Frame;
  TaeniaAngles                      m_SourceTaeniae;
  TaeniaAngles                      m_TargetTaeniae;
  CylindricalWarp                   m_Warp;
  std::vector<double>               m_FrameRotation;
  std::vector<double>               m_PairWeights;
  std::vector<float>                m_SourceFolds; ///< FoldProbability()
  std::vector<float>                m_TargetFolds;
  std::vector<double>               m_Breaks; ///< of the source, where segments are registered by themselves
  std::unique_ptr<SmoothCorrection> m_Correction;
};

void
RequireUsable(const ColonPosition & position)
{
  if (!position.grid)
  {
    throw InputError(position.name + ": there is no flat map");
  }
  if (position.folds.empty())
  {
    throw InputError(position.name + ": there are no haustral folds to register; see ColonFolds");
  }
  RequireUsage(position.isExcluded.empty() ||
                 position.isExcluded.size() == static_cast<std::size_t>(position.grid->Columns()),
               position.name + ": excluded columns are not those of the grid");
}

/** The node that is nearest to a place. */
std::pair<int, int>
NearestNode(const CylinderNodes & nodes, const CylinderPlace & place)
{
  const int row = static_cast<int>(std::lround((place.s - nodes.begin) / nodes.step));
  const int angle = static_cast<int>(std::lround((place.turn - std::floor(place.turn)) * nodes.Angles()));
  return { std::clamp(row, 0, nodes.Rows() - 1), angle % nodes.Angles() };
}
} // namespace

SupineProneRegistration
RegisterColonPositions(const ColonPosition & source, const ColonPosition & target, const SupineProneOptions & options)
{
  RequireUsable(source);
  RequireUsable(target);
  RequireUsage(options.greatestDilatation > 0.0 && options.greatestDilatation < 1.0,
               "the greatest dilatation must lie between 0 and 1");
  return Registration(source, target, options).Run();
}

Eigen::Vector2d
MapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & sourceUv)
{
  return registration.target->UvOfPlace(registration.map.Forward(registration.source->PlaceOfUv(sourceUv)));
}

Eigen::Vector2d
InverseMapUv(const SupineProneRegistration & registration, const Eigen::Vector2d & targetUv)
{
  const std::optional<CylinderPlace> place = registration.map.Inverse(registration.target->PlaceOfUv(targetUv));
  return place ? registration.source->UvOfPlace(*place)
               : Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()).eval();
}

double
ConfidenceAt(const SupineProneRegistration & registration, const CylinderPlace & place)
{
  const auto [row, angle] = NearestNode(registration.map.Nodes(), place);
  return registration.confidence.ofNodes(row, angle);
}

bool
IsExcludedAt(const SupineProneRegistration & registration, const CylinderPlace & place)
{
  const auto [row, angle] = NearestNode(registration.map.Nodes(), place);
  return registration.isExcluded(row, angle) != 0;
}
} // namespace itk
