#include "shapetonSphereAlignment.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Vector = Eigen::Vector3d;
using RowMatrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
} // namespace

std::array<double, 9>
BestRotation(const std::vector<std::array<double, 3>> & points, const std::vector<std::array<double, 3>> & images)
{
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    covariance += Vector(images[i].data()) * Vector(points[i].data()).transpose();
  }
  RowMatrix rotation = RowMatrix::Identity();
  if (!points.empty())
  {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    rotation = svd.matrixU() * Vector(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose();
  }
  std::array<double, 9> result{};
  Eigen::Map<RowMatrix>(result.data()) = rotation;
  return result;
}

namespace
{
using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int    motionSteps = 30;     // chosen; the most iterations
constexpr double smallestStep = 1e-13; // near the rounding error; ends the iteration
// Distances below this threshold (radians) have equal weight.
constexpr double leastDistance = 1e-6;
constexpr double longestStep = 0.3;

Vector4
CapOf(const double * center, double radius)
{
  Vector4 cap;
  cap << Vector(center) / std::sin(radius), std::cos(radius) / std::sin(radius);
  return cap;
}

/** Motion with boost b and rotation w: exp of the generator, computed by its series, because the step is short. */
Matrix4
MotionOf(const Vector6 & step)
{
  Matrix4 generator = Matrix4::Zero();
  generator.block<3, 1>(0, 3) = step.head<3>();
  generator.block<1, 3>(3, 0) = step.head<3>().transpose();
  const Vector turn = step.tail<3>();
  generator.block<3, 3>(0, 0) << 0.0, -turn[2], turn[1], turn[2], 0.0, -turn[0], -turn[1], turn[0], 0.0;
  Matrix4 motion = Matrix4::Identity();
  Matrix4 term = Matrix4::Identity();
  for (int k = 1; k <= 20; ++k)
  {
    term = (term * generator / k).eval();
    motion += term;
  }
  return motion;
}

/** Derivative of a point with respect to the six parameters. */
Eigen::Matrix<double, 3, 6>
DerivativeAt(const Vector & p)
{
  Eigen::Matrix<double, 3, 6> derivative;
  derivative.leftCols<3>() = Eigen::Matrix3d::Identity() - p * p.transpose();
  derivative.rightCols<3>() << 0.0, p[2], -p[1], -p[2], 0.0, p[0], p[1], -p[0], 0.0;
  return derivative;
}

/** Step that minimizes the sum of distances, each bounded by a quadratic form that touches it at the current points. */
Vector6
StepTo(const std::vector<Vector> & targets, const std::vector<Vector4> & caps, const Matrix4 & motion)
{
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
  Vector6                     right = Vector6::Zero();
  for (std::size_t i = 0; i < caps.size(); ++i)
  {
    const Vector p = (motion * caps[i]).head<3>().normalized();
    const Vector gap = targets[i] - p;
    const auto   derivative = DerivativeAt(p);
    const double weight = 1.0 / std::max(gap.norm(), leastDistance);
    normal += weight * derivative.transpose() * derivative;
    right += weight * derivative.transpose() * gap;
  }
  const Vector6 step = normal.ldlt().solve(right);
  return step * std::min(1.0, longestStep / std::max(step.norm(), 1e-300));
}
} // namespace

SphereMotion
BestMotion(const EmbeddingCertificate & a, const EmbeddingCertificate & b, const std::vector<int> & image)
{
  std::vector<Vector>                targets;
  std::vector<Vector4>               caps;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 3>> places;
  for (int v = 0; v < a.graph.nodes; ++v)
  {
    if (const int partner = image[v]; partner >= 0)
    {
      places.push_back(PlaceOnSphere(a, v));
      points.push_back(PlaceOnSphere(b, partner));
      targets.emplace_back(places.back().data());
      caps.push_back(CapOf(points.back().data(), b.nodeRadii[partner]));
    }
  }
  const std::array<double, 9> rotation = BestRotation(points, places);
  Matrix4                     motion = Matrix4::Identity();
  motion.block<3, 3>(0, 0) = Eigen::Map<const RowMatrix>(rotation.data());
  for (int i = 0; i < motionSteps && !caps.empty(); ++i)
  {
    const Vector6 step = StepTo(targets, caps, motion);
    motion = (MotionOf(step) * motion).eval();
    if (step.norm() < smallestStep)
    {
      break;
    }
  }
  SphereMotion result{};
  Eigen::Map<Matrix4>(result.data()) = motion;
  return result;
}

void
MoveEmbedding(EmbeddingCertificate & certificate, const SphereMotion & motion)
{
  const Eigen::Map<const Matrix4> move(motion.data());
  const auto                      moveAll = [&move](std::vector<double> & places, std::vector<double> & radii) {
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      const Vector4 cap = move * CapOf(places.data() + 3 * i, radii[i]);
      Eigen::Map<Vector>(places.data() + 3 * i) = cap.head<3>().normalized();
      radii[i] = std::atan2(1.0, cap[3]);
    }
  };
  moveAll(certificate.nodePositions, certificate.nodeRadii);
  moveAll(certificate.facePositions, certificate.faceRadii);
}

std::array<double, 3>
PlaceOnSphere(const EmbeddingCertificate & certificate, int node)
{
  const double * place = certificate.nodePositions.data() + 3 * static_cast<std::size_t>(node);
  return { place[0], place[1], place[2] };
}

double
AngleBetween(const std::array<double, 3> & a, const std::array<double, 3> & b)
{
  const Vector u(a.data());
  const Vector v(b.data());
  return 2.0 * std::atan2((u - v).norm(), (u + v).norm());
}
} // namespace shapeton
