#include "itkSphereAlignment.h"

#include <Eigen/Dense>

#include <cmath>

namespace itk
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

void
TurnEmbedding(EmbeddingCertificate & certificate, const std::array<double, 9> & rotation)
{
  const Eigen::Map<const RowMatrix> turn(rotation.data());
  for (std::vector<double> * places : { &certificate.nodePositions, &certificate.facePositions })
  {
    for (std::size_t i = 0; i + 2 < places->size(); i += 3)
    {
      Eigen::Map<Vector> place(places->data() + i);
      place = (turn * place).eval().normalized();
    }
  }
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
} // namespace itk
