// A tool that reads a graph of any format, embeds it, and writes a report with an interactive view.
// Usage: ExampleGraphTools GRAPH REPORT.html
#include "shapetonCommandLine.h"
#include "shapetonGraphEmbedding.h"
#include "shapetonGraphGenus.h"
#include "shapetonGraphReport.h"
#include "shapetonToolGraphs.h"

#include <iostream>

static const char xml[] = R"(<?xml version="1.0" encoding="utf-8"?>
<executable><category>Examples</category><title>Graph</title><description>Embeds a graph.</description>
<version>1.0.0</version><license>Apache-2.0</license><contributor>Shapeton</contributor>
<parameters><label>IO</label><description>Graph and report.</description>
<file><name>graph</name><label>Graph</label><description>GraphML, GML, DOT, ...</description>
<channel>input</channel><index>0</index></file>
<file fileExtensions=".html"><name>report</name><label>Report</label><description>One HTML file.</description>
<channel>output</channel><index>1</index></file>
</parameters></executable>)";

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(xml, argc, argv, [](shapeton::CommandLine & commandLine) {
    const std::string                report = commandLine.OutputOf("report");
    const shapeton::Graph            graph = shapeton::ReadGraph(commandLine, "graph");
    const shapeton::SurfaceEmbedding surface = shapeton::FindEmbedding(graph);
    shapeton::EmbeddingCertificate   certificate = shapeton::EmbedGraph(graph, surface.map);
    certificate.provenance = commandLine.GetProvenance();

    shapeton::GraphReport content;
    content.title = "An embedded graph";
    content.views.push_back({ "The graph", &certificate, {}, true });
    content.facts = shapeton::FactsOf(certificate);
    shapeton::WriteGraphReport(content, report);
    std::cout << graph.nodes << " nodes, " << graph.edges.size() << " edges, genus " << certificate.genus << ", "
              << content.facts.size() << " facts\n";
  });
}
