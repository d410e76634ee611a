#ifndef shapetonPlainNewton_h
#define shapetonPlainNewton_h

#include "shapetonSurfaceConnectivity.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <optional>

/** Oracle: conformal equivalence of triangle meshes (Springborn, Schroeder, Pinkall 2008) by Newton's method without
 * flips, written independently of the library: angles by the law of cosines, halved steps. Returns the edge lengths of
 * the metric with these angle sums up to scale, or nothing if no step keeps the triangle inequalities. */
inline std::optional<Eigen::VectorXd>
PlainNewton(const shapeton::SurfaceMesh & mesh, const Eigen::VectorXd & angleSums)
{
  const shapeton::SurfaceConnectivity connectivity(mesh);
  const int                           n = mesh.NumberOfVertices();
  const auto                          lengthsFor = [&](const Eigen::VectorXd & u) {
    Eigen::VectorXd lengths(connectivity.NumberOfEdges());
    for (int e = 0; e < lengths.size(); ++e)
    {
      const auto & [a, b] = connectivity.VerticesOfEdge(e);
      lengths[e] = (mesh.V.row(a) - mesh.V.row(b)).norm() * std::exp(0.5 * (u[a] + u[b]));
    }
    return lengths;
  };
  const auto evaluate = [&](const Eigen::VectorXd & lengths, std::vector<Eigen::Triplet<double>> * hessian) {
    Eigen::VectorXd error = -angleSums;
    for (int f = 0; f < mesh.NumberOfFaces(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double opposite = lengths[connectivity.EdgeOfFace(f, (k + 1) % 3)];
        const double b = lengths[connectivity.EdgeOfFace(f, k)], c = lengths[connectivity.EdgeOfFace(f, (k + 2) % 3)];
        const double angle = std::acos((b * b + c * c - opposite * opposite) / (2 * b * c)); // NaN if none
        error[mesh.F(f, k)] += angle;
        const int i = mesh.F(f, (k + 1) % 3), j = mesh.F(f, (k + 2) % 3);
        if (hessian)
        {
          const double weight = 0.5 / std::tan(angle);
          hessian->insert(hessian->end(), { { i, i, weight }, { j, j, weight }, { i, j, -weight }, { j, i, -weight } });
        }
      }
    }
    return error;
  };
  Eigen::VectorXd u = Eigen::VectorXd::Zero(n), lengths = lengthsFor(u);
  for (int step = 0; step < 50; ++step)
  {
    std::vector<Eigen::Triplet<double>> entries;
    const Eigen::VectorXd               error = evaluate(lengths, &entries);
    if (error.cwiseAbs().maxCoeff() < 1e-12)
    {
      return lengths;
    }
    Eigen::SparseMatrix<double> hessian(n, n);
    hessian.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseMatrix<double>                        grounded = hessian.topLeftCorner(n - 1, n - 1);
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(grounded);
    Eigen::VectorXd                                    direction = Eigen::VectorXd::Zero(n);
    direction.head(n - 1) = solver.solve(error.head(n - 1));
    bool isBetter = false;
    for (double part = 1.0; part > 1e-6 && !isBetter; part *= 0.5)
    {
      const Eigen::VectorXd next = lengthsFor(u + part * direction);
      const double          norm = evaluate(next, nullptr).norm();
      isBetter = norm < error.norm(); // false for NaN
      if (isBetter)
      {
        u += part * direction;
        lengths = next;
      }
    }
    if (!isBetter)
    {
      return error.cwiseAbs().maxCoeff() < 1e-9 ? std::optional<Eigen::VectorXd>(lengths) : std::nullopt;
    }
  }
  return std::nullopt;
}

#endif
