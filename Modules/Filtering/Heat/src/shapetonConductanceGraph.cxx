#include "shapetonConductanceGraph.h"

#include "shapetonDisjointSets.h"
#include "shapetonParallelFor.h"

#include <memory>
#include <numeric>
#include <utility>

namespace shapeton
{
namespace
{
// An edge is strong if its conductance is at least this fraction of that of the strongest edge at each of its ends.
// Measured on CT: with 0.5 the levels are so large that the run time grows by half; below 0.15 there are too many
// iterations.
constexpr float strong = 0.15F;

// Flag of a node of the current cell; the other bits are its number in the cell.
constexpr std::uint32_t inCell = std::uint32_t(1) << 31;

/** Number of nodes of a level per cell of the next one along each axis. */
std::array<std::size_t, 3>
StepsOf(const std::array<std::size_t, 3> & cells, const std::array<double, 3> & spacing)
{
  constexpr double alike = 1.5;
  double           smallest = HUGE_VAL;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    smallest = cells[axis] > 1 ? std::min(smallest, spacing[axis]) : smallest;
  }
  std::array<std::size_t, 3> steps{ { 1, 1, 1 } };
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    steps[axis] = cells[axis] > 1 && spacing[axis] <= alike * smallest ? 2 : 1;
  }
  return steps;
}

/** The aggregates of the nodes in one slice of coarse cells. */
template <typename TLevel>
class SliceAggregation
{
public:
  SliceAggregation(const TLevel &                     level,
                   const std::array<std::size_t, 3> & steps,
                   const ConductanceGraph &           coarse,
                   std::size_t                        slice,
                   std::vector<std::uint32_t> &       aggregateOf)
    : m_Level(level), m_Steps(steps), m_Coarse(coarse), m_AggregateOf(aggregateOf)
  {
    const std::size_t end = std::min(level.GetCells()[2], (slice + 1) * steps[2]);
    m_Places = level.GetPlacesOfSlices(slice * steps[2], end);
    this->SortByCell(slice * steps[2], end);
    for (std::size_t cell = 0; cell + 1 < m_FirstOfCell.size(); ++cell)
    {
      this->Aggregate(cell);
    }
  }

  /** The cell that contains each aggregate. */
  const std::vector<std::array<std::uint16_t, 2>> &
  GetCells() const
  {
    return m_Cells;
  }

  /** Calls body(node) for the nodes of an aggregate. */
  template <typename TBody>
  void
  ForEachNode(std::size_t aggregate, const TBody & body) const
  {
    std::for_each(
      m_Nodes.begin() + m_FirstOfAggregate[aggregate], m_Nodes.begin() + m_FirstOfAggregate[aggregate + 1], body);
  }

private:
  struct Edge
  {
    std::uint32_t a, b;
    float         conductance;
  };

  /** Nodes in the order of their cells, by counting. */
  void
  SortByCell(std::size_t firstSlice, std::size_t endSlice)
  {
    const auto forEach = [&](const auto & body) {
      for (std::size_t slice = firstSlice; slice < endSlice; ++slice)
      {
        m_Level.ForEachNode(slice, [&](std::size_t node, std::size_t column, std::size_t row) {
          body(node, row / m_Steps[1] * m_Coarse.cells[0] + column / m_Steps[0]);
        });
      }
    };
    m_FirstOfCell.assign(m_Coarse.cells[0] * m_Coarse.cells[1] + 1, 0);
    forEach([&](std::size_t, std::size_t cell) { ++m_FirstOfCell[cell + 1]; });
    std::partial_sum(m_FirstOfCell.begin(), m_FirstOfCell.end(), m_FirstOfCell.begin());
    m_Nodes.resize(m_FirstOfCell.back());
    auto next = m_FirstOfCell;
    forEach([&](std::size_t node, std::size_t cell) { m_Nodes[next[cell]++] = static_cast<std::uint32_t>(node); });
    m_FirstOfAggregate.push_back(0);
  }

  /** Finds the aggregates of a cell and sorts its nodes by aggregate. */
  void
  Aggregate(std::size_t cell)
  {
    const auto begin = m_Nodes.begin() + m_FirstOfCell[cell];
    const auto number = static_cast<std::uint32_t>(m_FirstOfCell[cell + 1] - m_FirstOfCell[cell]);
    if (number == 0)
    {
      return;
    }
    this->GatherEdges(begin, number);
    this->JoinStrong(number);
    m_AggregateOfNode.assign(number, noAggregate);
    const auto first = static_cast<std::uint32_t>(m_Cells.size());
    for (std::uint32_t i = 0; i < number; ++i)
    {
      std::uint32_t & ofRoot = m_AggregateOfNode[m_Sets.Find(i)];
      if (ofRoot == noAggregate)
      {
        ofRoot = static_cast<std::uint32_t>(m_Cells.size());
        m_Cells.push_back({ { static_cast<std::uint16_t>(cell % m_Coarse.cells[0]),
                              static_cast<std::uint16_t>(cell / m_Coarse.cells[0]) } });
      }
      m_AggregateOf[begin[i]] = ofRoot;
    }
    std::stable_sort(
      begin, begin + number, [&](std::uint32_t a, std::uint32_t b) { return m_AggregateOf[a] < m_AggregateOf[b]; });
    std::uint32_t i = 0;
    for (auto aggregate = first; aggregate < m_Cells.size(); ++aggregate)
    {
      for (; i < number && m_AggregateOf[begin[i]] == aggregate; ++i)
      {}
      m_FirstOfAggregate.push_back(m_FirstOfCell[cell] + i);
    }
  }

  /** The edges within a cell, and the strongest edge of each of its nodes. */
  void
  GatherEdges(std::vector<std::uint32_t>::const_iterator begin, std::uint32_t number)
  {
    for (std::uint32_t i = 0; i < number; ++i)
    {
      m_AggregateOf[begin[i]] = inCell | i;
    }
    m_Edges.clear();
    m_Strongest.assign(number, 0.0F);
    for (std::uint32_t i = 0; i < number; ++i)
    {
      m_Level.ForEachEdge(begin[i], [&](std::size_t neighbor, float conductance) {
        m_Strongest[i] = std::max(m_Strongest[i], conductance);
        if (neighbor > begin[i] && neighbor < m_Places[1]) // each edge once; other threads process the other slices
        {
          const std::uint32_t mark = m_AggregateOf[neighbor];
          if (mark != noAggregate && (mark & inCell) != 0)
          {
            m_Edges.push_back({ i, mark & ~inCell, conductance });
          }
        }
      });
    }
  }

  /** Joins nodes over edges that are strong for both. Each remaining single node then joins its strongest neighbor
   * in the cell if the edge is strong for this node, so an insulated node joins its surroundings. */
  void
  JoinStrong(std::uint32_t number)
  {
    m_Sets = DisjointSets<std::uint32_t>(number);
    m_IsJoined.assign(number, 0);
    for (const Edge & edge : m_Edges)
    {
      if (edge.conductance >= strong * std::max(m_Strongest[edge.a], m_Strongest[edge.b]))
      {
        m_Sets.Join(edge.a, edge.b);
        m_IsJoined[edge.a] = m_IsJoined[edge.b] = 1;
      }
    }
    m_Best.assign(number, Edge{ 0, 0, 0.0F });
    for (const Edge & edge : m_Edges)
    {
      for (const auto & [node, other] : { std::pair(edge.a, edge.b), std::pair(edge.b, edge.a) })
      {
        if (!m_IsJoined[node] && edge.conductance >= strong * m_Strongest[node] &&
            edge.conductance > m_Best[node].conductance)
        {
          m_Best[node] = { node, other, edge.conductance };
        }
      }
    }
    for (const Edge & edge : m_Best)
    {
      if (edge.conductance > 0.0F)
      {
        m_Sets.Join(edge.a, edge.b);
      }
    }
  }

  const TLevel &                            m_Level;
  const std::array<std::size_t, 3>          m_Steps;
  const ConductanceGraph &                  m_Coarse;
  std::vector<std::uint32_t> &              m_AggregateOf;
  std::array<std::size_t, 2>                m_Places{};
  std::vector<std::uint32_t>                m_FirstOfCell;
  std::vector<std::uint32_t>                m_Nodes;
  std::vector<std::uint32_t>                m_FirstOfAggregate;
  std::vector<std::array<std::uint16_t, 2>> m_Cells;
  // State of the current cell.
  std::vector<Edge>           m_Edges;
  std::vector<Edge>           m_Best;
  std::vector<float>          m_Strongest;
  std::vector<char>           m_IsJoined;
  std::vector<std::uint32_t>  m_AggregateOfNode;
  DisjointSets<std::uint32_t> m_Sets;
};

/** Edges and leaks of the aggregates of one slice. */
struct SliceEdges
{
  std::vector<std::uint64_t>                    ends; ///< end of the edges of each aggregate
  std::vector<std::pair<std::uint32_t, double>> edges;
  std::vector<float>                            leak;
};

template <typename TLevel>
SliceEdges
JoinAggregates(const TLevel &                     level,
               const SliceAggregation<TLevel> &   slice,
               std::uint32_t                      first,
               const std::vector<std::uint32_t> & aggregateOf)
{
  SliceEdges                                    result;
  std::vector<std::pair<std::uint32_t, double>> row;
  for (std::size_t i = 0; i < slice.GetCells().size(); ++i)
  {
    row.clear();
    double leak = 0.0;
    slice.ForEachNode(i, [&](std::size_t node) {
      leak += level.GetLeak(node);
      level.ForEachEdge(node, [&](std::size_t neighbor, float conductance) {
        if (aggregateOf[neighbor] != first + i)
        {
          row.emplace_back(aggregateOf[neighbor], conductance);
        }
      });
    });
    std::sort(row.begin(), row.end());
    for (const auto & edge : row)
    {
      if (result.edges.size() > (result.ends.empty() ? 0 : result.ends.back()) &&
          result.edges.back().first == edge.first)
      {
        result.edges.back().second += edge.second;
      }
      else
      {
        result.edges.push_back(edge);
      }
    }
    result.ends.push_back(result.edges.size());
    result.leak.push_back(static_cast<float>(leak));
  }
  return result;
}

/** Copies the edges of a slice into the graph. */
void
Store(const SliceEdges & slice, std::uint64_t firstNode, std::uint64_t firstEdge, ConductanceGraph & graph)
{
  std::uint64_t edge = 0;
  for (std::size_t i = 0; i < slice.ends.size(); ++i)
  {
    double sum = slice.leak[i];
    for (; edge < slice.ends[i]; ++edge)
    {
      graph.neighbors[firstEdge + edge] = slice.edges[edge].first;
      graph.conductances[firstEdge + edge] = static_cast<float>(slice.edges[edge].second);
      sum += slice.edges[edge].second;
    }
    graph.firstEdge[firstNode + i + 1] = firstEdge + edge;
    graph.leak[firstNode + i] = slice.leak[i];
    graph.inverse[firstNode + i] = sum > 0.0 ? static_cast<float>(1.0 / sum) : 0.0F;
  }
}
} // namespace

template <typename TLevel>
ConductanceGraph
Coarsen(const TLevel & level, std::vector<std::uint32_t> & aggregateOf)
{
  ConductanceGraph coarse;
  const auto       steps = StepsOf(level.GetCells(), level.GetSpacing());
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    coarse.cells[axis] = (level.GetCells()[axis] + steps[axis] - 1) / steps[axis];
    coarse.spacing[axis] = level.GetSpacing()[axis] * static_cast<double>(steps[axis]);
  }
  aggregateOf.assign(level.GetNumberOfPlaces(), noAggregate);
  const std::size_t                                            slices = coarse.cells[2];
  std::vector<std::unique_ptr<const SliceAggregation<TLevel>>> aggregations(slices);
  ParallelFor(slices, [&](std::size_t z) {
    aggregations[z] = std::make_unique<const SliceAggregation<TLevel>>(level, steps, coarse, z, aggregateOf);
  });
  coarse.firstOfSlice.push_back(0);
  for (const auto & slice : aggregations)
  {
    coarse.firstOfSlice.push_back(coarse.firstOfSlice.back() + slice->GetCells().size());
    coarse.cellOf.insert(coarse.cellOf.end(), slice->GetCells().begin(), slice->GetCells().end());
  }
  ParallelFor(slices, [&](std::size_t z) {
    for (std::size_t i = 0; i < aggregations[z]->GetCells().size(); ++i)
    {
      const auto aggregate = static_cast<std::uint32_t>(coarse.firstOfSlice[z] + i);
      aggregations[z]->ForEachNode(i, [&](std::size_t node) { aggregateOf[node] = aggregate; });
    }
  });
  std::vector<SliceEdges> edges(slices);
  ParallelFor(slices, [&](std::size_t z) {
    edges[z] = JoinAggregates(level, *aggregations[z], static_cast<std::uint32_t>(coarse.firstOfSlice[z]), aggregateOf);
    aggregations[z].reset();
  });
  std::vector<std::uint64_t> firstEdge{ 0 };
  for (const SliceEdges & slice : edges)
  {
    firstEdge.push_back(firstEdge.back() + slice.edges.size());
  }
  coarse.neighbors.resize(firstEdge.back());
  coarse.conductances.resize(firstEdge.back());
  coarse.firstEdge.assign(coarse.cellOf.size() + 1, 0);
  coarse.leak.resize(coarse.cellOf.size());
  coarse.inverse.resize(coarse.cellOf.size());
  ParallelFor(slices, [&](std::size_t z) { Store(edges[z], coarse.firstOfSlice[z], firstEdge[z], coarse); });
  return coarse;
}

template ConductanceGraph
Coarsen(const ConductanceField &, std::vector<std::uint32_t> &);
template ConductanceGraph
Coarsen(const ConductanceGraph &, std::vector<std::uint32_t> &);
} // namespace shapeton
