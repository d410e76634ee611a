#include "NewtonFlattening.h"

#include "shapetonPi.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

namespace
{
constexpr double flatEnough = 1e-9; // radians
constexpr int    mostIterations = 40;
constexpr int    mostHalvings = 30;

using Sparse = Eigen::SparseMatrix<double>;

/** Lengths, cotangents, areas and angle defects for given scale factors. */
struct State
{
  Eigen::VectorXd                    lengths;
  std::vector<std::array<double, 3>> cotangents; ///< opposite to the edge from corner k to the next one
  Eigen::VectorXd                    weights;
  Eigen::VectorXd                    defects;
  double                             area{ 0.0 };
  bool                               isSound{ true };
};

class Newton
{
public:
  Newton(const shapeton::SurfaceConnectivity & connectivity,
         const shapeton::FaceMatrix &          F,
         const Eigen::VectorXd &               lengths)
    : m_Connectivity(connectivity), m_F(F), m_Lengths(lengths), m_Flat(connectivity.NumberOfVertices())
  {
    m_Flat.setConstant(shapeton::TwoPi);
    for (const auto & loop : connectivity.BoundaryLoops())
    {
      for (const int v : loop)
      {
        m_Flat[v] = shapeton::Pi;
      }
    }
    this->MakePattern();
  }

  State
  Evaluate(const Eigen::VectorXd & scales) const
  {
    State state;
    state.lengths.resize(m_Lengths.size());
    for (int e = 0; e < m_Connectivity.NumberOfEdges(); ++e)
    {
      const auto & [a, b] = m_Connectivity.VerticesOfEdge(e);
      state.lengths[e] = m_Lengths[e] * std::exp(0.5 * (scales[a] + scales[b]));
    }
    state.cotangents.resize(m_F.rows());
    state.weights = Eigen::VectorXd::Zero(m_Lengths.size());
    state.defects = m_Flat;
    for (int f = 0; f < m_F.rows(); ++f)
    {
      this->AddFace(f, state);
    }
    return state;
  }

  /** The step -L^-1 defects with the last vertex fixed. */
  Eigen::VectorXd
  Step(const State & state)
  {
    Eigen::Map<Eigen::VectorXd> values(m_Matrix.valuePtr(), m_Matrix.nonZeros());
    values.setZero();
    const Eigen::Index free = m_Matrix.rows();
    for (int e = 0; e < m_Connectivity.NumberOfEdges(); ++e)
    {
      const auto & [a, b] = m_Connectivity.VerticesOfEdge(e);
      const double weight = state.weights[e];
      if (m_PlaceOfEdge[e] != -1)
      {
        values[m_PlaceOfEdge[e]] = -weight;
      }
      for (const int v : { a, b })
      {
        if (v < free)
        {
          values[m_PlaceOfVertex[v]] += weight;
        }
      }
    }
    m_Solver.factorize(m_Matrix);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(m_Flat.size());
    step.head(free) = m_Solver.solve(-state.defects.head(free));
    return step;
  }

private:
  void
  MakePattern()
  {
    const int                           free = m_Connectivity.NumberOfVertices() - 1;
    std::vector<Eigen::Triplet<double>> triplets;
    for (int v = 0; v < free; ++v)
    {
      triplets.emplace_back(v, v, 1.0);
    }
    for (int e = 0; e < m_Connectivity.NumberOfEdges(); ++e)
    {
      const auto & [a, b] = m_Connectivity.VerticesOfEdge(e);
      if (std::max(a, b) < free)
      {
        triplets.emplace_back(std::max(a, b), std::min(a, b), 1.0);
      }
    }
    m_Matrix.resize(free, free);
    m_Matrix.setFromTriplets(triplets.begin(), triplets.end());
    m_Solver.analyzePattern(m_Matrix);
    const auto placeOf = [&](int row, int column) {
      const int * const begin = m_Matrix.innerIndexPtr() + m_Matrix.outerIndexPtr()[column];
      const int * const end = m_Matrix.innerIndexPtr() + m_Matrix.outerIndexPtr()[column + 1];
      return static_cast<int>(std::lower_bound(begin, end, row) - m_Matrix.innerIndexPtr());
    };
    for (int v = 0; v < free; ++v)
    {
      m_PlaceOfVertex.push_back(placeOf(v, v));
    }
    for (int e = 0; e < m_Connectivity.NumberOfEdges(); ++e)
    {
      const auto & [a, b] = m_Connectivity.VerticesOfEdge(e);
      m_PlaceOfEdge.push_back(std::max(a, b) < free ? placeOf(std::max(a, b), std::min(a, b)) : -1);
    }
  }

  void
  AddFace(int f, State & state) const
  {
    const std::array<int, 3> edges{ m_Connectivity.EdgeOfFace(f, 0),
                                    m_Connectivity.EdgeOfFace(f, 1),
                                    m_Connectivity.EdgeOfFace(f, 2) };
    const double             a = state.lengths[edges[0]], b = state.lengths[edges[1]], c = state.lengths[edges[2]];
    const double             product = (a + b + c) * (a + b - c) * (b + c - a) * (c + a - b);
    state.isSound = state.isSound && product > 0.0;
    const double area = 0.25 * std::sqrt(std::max(product, 1e-300));
    state.area += area;
    const double squares = a * a + b * b + c * c;
    for (int k = 0; k < 3; ++k)
    {
      const double side = state.lengths[edges[k]];
      const double cotangent = (squares - 2.0 * side * side) / (4.0 * area);
      state.cotangents[f][k] = cotangent;
      state.weights[edges[k]] += 0.5 * cotangent;
      state.defects[m_F(f, (k + 2) % 3)] -= std::atan2(1.0, cotangent);
    }
  }

  const shapeton::SurfaceConnectivity & m_Connectivity;
  const shapeton::FaceMatrix &          m_F;
  const Eigen::VectorXd &               m_Lengths;
  Eigen::VectorXd                       m_Flat;
  Sparse                                m_Matrix; ///< lower triangle
  std::vector<int>                      m_PlaceOfVertex, m_PlaceOfEdge;
  Eigen::SimplicialLDLT<Sparse>         m_Solver;
};

/** Lays out faces one by one from the first, without crossing the cut. */
Eigen::MatrixX2d
LayOut(const shapeton::SurfaceConnectivity & connectivity, const shapeton::CutSurface & cut, const State & state)
{
  const shapeton::FaceMatrix & F = cut.mesh.F;
  Eigen::MatrixX2d             uv = Eigen::MatrixX2d::Zero(cut.mesh.V.rows(), 2);
  std::vector<char>            isPlaced(uv.rows(), 0), isDone(F.rows(), 0);
  uv(F(0, 1), 0) = state.lengths[connectivity.EdgeOfFace(0, 0)];
  isPlaced[F(0, 0)] = isPlaced[F(0, 1)] = 1;
  std::deque<std::array<int, 2>> queue{ { 0, 0 } };
  isDone[0] = 1;
  while (!queue.empty())
  {
    const auto [f, k] = queue.front(); // the edge that starts at corner k is placed
    queue.pop_front();
    const int a = F(f, k), b = F(f, (k + 1) % 3), c = F(f, (k + 2) % 3);
    if (!isPlaced[c])
    {
      const Eigen::RowVector2d along = uv.row(b) - uv.row(a);
      const Eigen::RowVector2d across(-along[1], along[0]);
      const double             atA = state.cotangents[f][(k + 1) % 3];
      const double             atB = state.cotangents[f][(k + 2) % 3];
      uv.row(c) = uv.row(a) + (atA * along + across) / (atA + atB);
      isPlaced[c] = 1;
    }
    for (int j = 0; j < 3; ++j)
    {
      for (const int g : connectivity.FacesOfEdge(connectivity.EdgeOfFace(f, j)))
      {
        for (int i = 0; i < 3 && !isDone[g]; ++i)
        {
          if (F(g, i) == F(f, (j + 1) % 3) && F(g, (i + 1) % 3) == F(f, j))
          {
            isDone[g] = 1;
            queue.push_back({ g, i });
          }
        }
      }
    }
  }
  return uv;
}

double
LengthOfLoop(const shapeton::SurfaceConnectivity & connectivity, const std::vector<int> & loop, const State & state)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    sum += state.lengths[connectivity.FindEdge(loop[i], loop[(i + 1) % loop.size()])];
  }
  return sum;
}
} // namespace

NewtonFlattening
FlattenByNewton(const shapeton::SurfaceConnectivity & connectivity,
                const shapeton::FaceMatrix &          F,
                const Eigen::VectorXd &               edgeLengths,
                const shapeton::TubeEnds &            ends,
                const shapeton::CutSurface &          cut)
{
  NewtonFlattening result;
  Newton           newton(connectivity, F, edgeLengths);
  Eigen::VectorXd  scales = Eigen::VectorXd::Zero(connectivity.NumberOfVertices());
  State            state = newton.Evaluate(scales);
  for (; result.iterations < mostIterations; ++result.iterations)
  {
    result.hasConverged = state.defects.cwiseAbs().maxCoeff() < flatEnough;
    if (result.hasConverged)
    {
      break;
    }
    const Eigen::VectorXd step = newton.Step(state);
    double                part = 1.0;
    bool                  isBetter = false;
    for (int i = 0; i < mostHalvings && !isBetter; ++i, part *= 0.5)
    {
      State next = newton.Evaluate(scales + part * step);
      isBetter = next.isSound && next.defects.norm() < state.defects.norm();
      if (isBetter)
      {
        scales += part * step;
        state = std::move(next);
      }
    }
    if (!isBetter)
    {
      return result; // would require edge flips
    }
  }
  const double circumference = LengthOfLoop(connectivity, ends.first, state);
  result.modulus = circumference * circumference / state.area;
  result.uv = LayOut(connectivity, cut, state);
  return result;
}
