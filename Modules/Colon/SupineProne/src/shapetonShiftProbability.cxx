#include "shapetonShiftProbability.h"

#include "shapetonParallelFor.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
/** Displacements along the target: up to 42 mm on both sides, which is farther than the next fold. */
constexpr double shiftStep = 3.0; // mm, as the warping
constexpr int    shifts = 14;     // on each side
/** Largest displacement (mm) that remains on the same fold: about half the distance between folds. */
constexpr double greatestNoShift = 15.0;

/** Log-likelihood per row and mean squared difference of the pictures, and costs per step of the displacement and of
 * the rotation. They were chosen for the lowest Brier score (0.091) on 9 phantoms (realistic 1 to 4, hard 1 to 4,
 * standard 1), with unseenEase = 0.1 and noncyclic displacements. The score is 0.091 with evidence = 1, 0.098 with
 * shiftCost = 0.6, and 0.092 with turnCost = 3. */
constexpr double evidence = 2.0;
constexpr double shiftCost = 1.0;
constexpr double turnCost = 2.0;
/** Factor for the costs where the wall is not visible. The Brier scores of hard 2, 3 and 4 are 0.137, 0.170 and 0.116;
 * with a factor of 0.1, they are 0.156, 0.174 and 0.122. */
constexpr double unseenEase = 0.4;

/** One value for each rotation (row) and displacement (column). */
using ShiftStates = Eigen::ArrayXXd;

/** Probabilities of changes by steps between cyclic states, up to a factor. */
Eigen::MatrixXd
CyclicKernel(int states, double cost)
{
  Eigen::MatrixXd kernel(states, states);
  for (int i = 0; i < states; ++i)
  {
    for (int j = 0; j < states; ++j)
    {
      const int steps = std::abs(i - j);
      kernel(i, j) = std::exp(-cost * std::min(steps, states - steps));
    }
  }
  return kernel;
}

/** Transition from one row to the next. Displacements are cyclic, too, so that all states have equally many neighbors;
 * otherwise, small displacements would be likely without evidence. */
struct ShiftTransition
{
  Eigen::MatrixXd ofTurns;
  Eigen::MatrixXd ofShifts;

  explicit ShiftTransition(double ease)
    : ofTurns(CyclicKernel(WarpAngles, ease * turnCost)), ofShifts(CyclicKernel(2 * shifts + 1, ease * shiftCost))
  {}

  ShiftStates
  operator()(const ShiftStates & states) const
  {
    const ShiftStates next = (ofTurns * states.matrix() * ofShifts).array();
    return next / next.sum();
  }
};

CylinderPicture
PictureOfRows(const ColonPosition &      position,
              const ColonCylinder &      cylinder,
              const std::vector<float> & folds,
              double                     step,
              int                        rows)
{
  constexpr double    smoothing = 0.8; // rows, as the warping
  CylinderPictureForm form;
  form.begin = cylinder.Begin();
  form.step = step;
  form.rows = rows;
  form.angles = WarpAngles;
  form.smoothRows = smoothing;
  form.coordinate = [](double s) { return s; };
  return MakeCylinderPicture(position, cylinder, folds, form);
}

/** Values of a picture at a distance along the colon, for all rotations of a start angle. */
Eigen::ArrayXd
RingOf(const CylinderPicture & picture, double s, double turn)
{
  const int            angles = picture.Angles();
  const double         row = std::clamp((s - picture.begin) / picture.step, 0.0, picture.Rows() - 1.0);
  const int            i = std::min(static_cast<int>(row), picture.Rows() - 2);
  const double         p = row - i;
  const Eigen::ArrayXd ring = (1.0 - p) * picture.values.row(i) + p * picture.values.row(i + 1);
  const double         angle = (turn - std::floor(turn)) * angles + angles - 0.5; // centers are at half a pixel
  const int            first = static_cast<int>(angle);
  const double         q = angle - first;
  Eigen::ArrayXd       rotated(angles);
  for (int k = 0; k < angles; ++k)
  {
    rotated[k] = (1.0 - q) * ring[(first + k) % angles] + q * ring[(first + k + 1) % angles];
  }
  return rotated;
}

/** Mean rotation (turns) of a row of nodes. */
double
RotationOf(const CylinderNodes & nodes, int row)
{
  return nodes.turn.row(row).mean() - 0.5 * (nodes.Angles() - 1.0) / nodes.Angles();
}

/** Likelihood of each state of a row, up to a factor; 1 if there is no evidence. */
ShiftStates
LikelihoodOfRow(const CylinderPicture & source, const CylinderPicture & target, const CylinderMap & map, int row)
{
  ShiftStates  squares = ShiftStates::Zero(WarpAngles, 2 * shifts + 1);
  const double rotation = RotationOf(map.Nodes(), row);
  for (int angle = 0; angle < WarpAngles && !source.isExcluded[row]; ++angle)
  {
    const double        turn = (angle + 0.5) / WarpAngles;
    const CylinderPlace to = map.Forward({ source.begin + row * source.step, turn });
    for (int shift = -shifts; shift <= shifts; ++shift)
    {
      const Eigen::ArrayXd ring = RingOf(target, to.s + shift * shiftStep, to.turn - rotation);
      squares.col(shift + shifts) += (ring - source.values(row, angle)).square();
    }
  }
  return (-0.5 * evidence / WarpAngles * (squares - squares.minCoeff())).exp();
}

/** 1 for the states of a row that are on the same fold, 0 for the others. */
ShiftStates
NoShift(const CylinderNodes & nodes, int row, double around)
{
  ShiftStates  states(WarpAngles, 2 * shifts + 1);
  const double rotation = RotationOf(nodes, row);
  for (int angle = 0; angle < WarpAngles; ++angle)
  {
    const double away = TurnDifference(static_cast<double>(angle) / WarpAngles, rotation) * around;
    for (int shift = -shifts; shift <= shifts; ++shift)
    {
      states(angle, shift + shifts) = std::hypot(shift * shiftStep, away) <= greatestNoShift ? 1.0 : 0.0;
    }
  }
  return states;
}
} // namespace

Eigen::VectorXd
ProbabilityOfNoShift(const ColonPair & pair, const SupineProneRegistration & registration)
{
  const CylinderMap &   map = registration.map;
  const CylinderNodes & nodes = map.Nodes();
  const int             rows = nodes.Rows();
  const ColonCylinder & there = *pair.targetCylinder;
  const int             targetRows = std::max(2, static_cast<int>((there.End() - there.Begin()) / shiftStep));
  const CylinderPicture source = PictureOfRows(pair.source, *pair.sourceCylinder, pair.sourceFolds, nodes.step, rows);
  const CylinderPicture target = PictureOfRows(pair.target, there, pair.targetFolds, shiftStep, targetRows);
  std::vector<ShiftStates> likelihood(rows);
  ParallelFor(rows,
              [&](std::size_t row) { likelihood[row] = LikelihoodOfRow(source, target, map, static_cast<int>(row)); });
  const ShiftTransition seen(1.0);
  const ShiftTransition unseen(unseenEase);
  const auto            isUnseen = [&](int row) { return registration.isExcluded.row(row).minCoeff() != 0; };
  const auto            between = [&](int row) -> const ShiftTransition & {
    return isUnseen(row - 1) || isUnseen(row) ? unseen : seen;
  };
  std::vector<ShiftStates> forward{ likelihood[0] };
  for (int row = 1; row < rows; ++row)
  {
    forward.push_back(between(row)(forward[row - 1]) * likelihood[row]);
  }
  ShiftStates     backward = ShiftStates::Ones(WarpAngles, 2 * shifts + 1);
  Eigen::VectorXd probability(rows);
  for (int row = rows - 1; row >= 0; --row)
  {
    const ShiftStates both = forward[row] * backward;
    probability[row] = (both * NoShift(nodes, row, pair.Around())).sum() / both.sum();
    backward = row > 0 ? between(row)(backward * likelihood[row]) : backward;
  }
  return probability;
}
} // namespace shapeton
