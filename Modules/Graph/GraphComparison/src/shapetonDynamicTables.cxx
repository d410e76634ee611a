#include "shapetonDynamicTables.h"

#include "shapetonCarriedRotation.h"
#include "shapetonGraphComparison.h"
#include "shapetonGraphStructure.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
std::string
NumberOrNothing(double value)
{
  return std::isfinite(value) ? CsvTable::Number(value) : std::string();
}

double
SmallestRadius(const EmbeddingCertificate & certificate)
{
  return *std::min_element(certificate.nodeRadii.begin(), certificate.nodeRadii.begin() + certificate.graph.nodes);
}

/** Changes of a step since the previous one; empty for the first step. */
GraphChanges
ChangesOf(const DynamicSequence & sequence, std::size_t i)
{
  if (i > 0)
  {
    return sequence.steps[i].changes;
  }
  GraphChanges none{};
  none.meanDisplacement = none.largestDisplacement = std::numeric_limits<double>::quiet_NaN();
  return none;
}

int
NodeOfName(const Graph & graph, const std::string & name)
{
  for (int v = 0; v < graph.nodes; ++v)
  {
    if (NameOfNode(graph, v) == name)
    {
      return v;
    }
  }
  return -1;
}

void
AddPresence(std::vector<std::string> &   row,
            const EmbeddingCertificate & certificate,
            const Incidence &            incidence,
            int                          node)
{
  const Graph & graph = certificate.graph;
  const int     coordinates = CoordinatesOf(certificate.geometry);
  for (int i = 0; i < 3; ++i)
  {
    row.push_back(i < coordinates ? CsvTable::Number(certificate.nodePositions[coordinates * node + i]) : "");
  }
  row.push_back(CsvTable::Number(certificate.nodeRadii[node]));
  row.push_back(std::to_string(incidence.Degree(node)));
  std::string neighbors;
  for (int i = incidence.start[node]; i < incidence.start[node + 1]; ++i)
  {
    const int h = incidence.halfEdges[i];
    neighbors += (neighbors.empty() ? "" : " ") + NameOfNode(graph, graph.edges[h / 2][1 - h % 2]);
  }
  row.push_back(neighbors);
}
} // namespace

CsvTable
TableOfSteps(const DynamicSequence & sequence)
{
  CsvTable table({ "step",
                   "file",
                   "nodes",
                   "edges",
                   "addedNodes",
                   "removedNodes",
                   "addedEdges",
                   "removedEdges",
                   "changedNodes",
                   "genus",
                   "embeddedAnew",
                   "meanDisplacement",
                   "largestDisplacement",
                   "smallestRadius" });
  for (std::size_t i = 0; i < sequence.steps.size(); ++i)
  {
    const DynamicStep &          step = sequence.steps[i];
    const EmbeddingCertificate & certificate = step.certificate;
    const GraphChanges           changes = ChangesOf(sequence, i);
    table.AddRow({ std::to_string(i),
                   sequence.files[i],
                   std::to_string(certificate.graph.nodes),
                   std::to_string(certificate.graph.edges.size()),
                   std::to_string(changes.addedNodes.size()),
                   std::to_string(changes.removedNodes.size()),
                   std::to_string(changes.addedEdges.size()),
                   std::to_string(changes.removedEdges.size()),
                   std::to_string(changes.changedNodes.size()),
                   std::to_string(certificate.genus),
                   step.embeddedAnew ? "1" : "0",
                   NumberOrNothing(changes.meanDisplacement),
                   NumberOrNothing(changes.largestDisplacement),
                   CsvTable::Number(SmallestRadius(certificate)) });
  }
  return table;
}

CsvTable
TableOfTrackedNodes(const DynamicSequence & sequence, const std::vector<std::string> & names)
{
  CsvTable          table({ "step", "file", "node", "present", "x", "y", "z", "radius", "degree", "neighbors" });
  std::vector<bool> found(names.size(), false);
  for (std::size_t i = 0; i < sequence.steps.size(); ++i)
  {
    const EmbeddingCertificate & certificate = sequence.steps[i].certificate;
    const Incidence              incidence(certificate.graph);
    for (std::size_t k = 0; k < names.size(); ++k)
    {
      const int                node = NodeOfName(certificate.graph, names[k]);
      std::vector<std::string> row{ std::to_string(i), sequence.files[i], names[k], node < 0 ? "0" : "1" };
      if (node >= 0)
      {
        found[k] = true;
        AddPresence(row, certificate, incidence, node);
      }
      row.resize(table.GetColumns().size());
      table.AddRow(std::move(row));
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    RequireParameter(found[k], "no step has a node \"" + names[k] + "\"; use node ids of the files");
  }
  return table;
}

Json
SequenceToJson(const DynamicSequence & sequence)
{
  Json   steps = Json::array();
  double sum = 0.0;
  double largest = 0.0;
  int    measured = 0;
  int    anew = 0;
  for (std::size_t i = 0; i < sequence.steps.size(); ++i)
  {
    const DynamicStep & step = sequence.steps[i];
    Json                entry{ { "file", sequence.files[i] },
                { "nodes", step.certificate.graph.nodes },
                { "edges", step.certificate.graph.edges.size() },
                { "genus", step.certificate.genus },
                { "embeddedAnew", step.embeddedAnew } };
    if (i > 0)
    {
      entry["changes"] = ChangesToJson(step.changes, sequence.steps[i - 1].certificate.graph, step.certificate.graph);
      anew += step.embeddedAnew ? 1 : 0;
      if (std::isfinite(step.changes.meanDisplacement))
      {
        sum += step.changes.meanDisplacement;
        largest = std::max(largest, step.changes.largestDisplacement);
        ++measured;
      }
    }
    steps.push_back(std::move(entry));
  }
  const double none = std::numeric_limits<double>::quiet_NaN(); // written as null
  return { { "stability",
             { { "measuredSteps", measured },
               { "meanDisplacement", measured > 0 ? sum / measured : none },
               { "largestDisplacement", measured > 0 ? largest : none },
               { "embeddedAnew", anew } } },
           { "steps", std::move(steps) } };
}
} // namespace shapeton
