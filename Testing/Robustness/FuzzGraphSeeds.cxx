#include "FuzzGraphSeeds.h"

#include "shapetonCertificateFixtures.h"
#include "shapetonFileBytes.h"

namespace
{
std::string
TextOf(const shapeton::EmbeddingCertificate & certificate, const std::string & folder)
{
  const std::string path = folder + "/seed.json";
  shapeton::WriteEmbeddingCertificate(certificate, path);
  return shapeton::ReadFileBytes(path);
}
} // namespace

std::vector<FuzzSeed>
MakeGraphSeeds(const std::string & folder)
{
  return {
    { ".graphml",
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
      "<key id=\"d0\" for=\"node\" attr.name=\"label\" attr.type=\"string\"/>\n<graph id=\"G\" "
      "edgedefault=\"undirected\">\n"
      "<node id=\"n0\"><data key=\"d0\">a</data></node>\n<node id=\"n1\"/>\n<node id=\"n&#50;\"/>\n"
      "<edge id=\"e0\" source=\"n0\" target=\"n1\"/>\n<edge directed=\"false\" source=\"n1\" "
      "target=\"n2\"/>\n</graph>\n</graphml>\n" },
    { ".gml",
      "Creator \"me\"\ngraph\n[\n directed 0\n node [ id 1 label \"a\" graphics [ x 1.5 y -2e3 ] ]\n node [ id 2 ]\n "
      "node [ id 3 ]\n"
      " edge [ source 1 target 2 value 0.5 ]\n edge [ source 2 target 3 ]\n edge [ source 3 target 3 ]\n]\n" },
    { ".dot",
      "/* comment */ strict graph \"G\" {\n rankdir=LR; node [shape=box, label=\"a\\\"b\"];\n a -- b:port:n -- c "
      "[w=1.5];\n"
      " subgraph cluster0 { d; e -- f } -- \"g\" + \" h\";\n { 1 -2.5 } -- <b<i>x</i>> // end\n}\n" },
    { ".dot",
      "# 1 \"made.gv\"\nSTRICT graph \"x \\\ny\" { graph [rankdir=LR];\n /* c */ a -- b -- c -- a; // chain\n # line "
      "}\n"
      " a:n -- \"b\\\\\":s [label=<<b>\"q\"</b>>];\n subgraph { d; e } -- f\n {g h} -- \"i\" + \"j\" ; }\n" },
    { ".gml",
      "graph [ node [ id 1\n label \"id 1\" ]\n node [ id 2 ]\n edge [ source 1\n target 2\n graphics [ source 3 ] "
      "source 2 ] ]\n" },
    { ".edges", "# nodes\na b 0.5\nb,c\nc;c 1 2 3\nd\te {'weight': 2}\n" },
    { ".graph", "% comment\n5 5 011 1\n7 2 1 3 1\n8 1 1 3 1 4 2\n9 1 1 2 1 5 4\n1 2 2\n2 3 4\n" },
    { ".m",
      "function mpc = case3\n% a comment\nmpc.version = '2';\nmpc.baseMVA = 100;\nmpc.bus = [\n\t1 3 0 Inf;\n\t2 1 0 "
      "0;\n\t30 1 0 0\n];\n"
      "mpc.branch = [\n\t1 2 0.01 0.1 0 0 0 0 0 0 1 -360 360;\n\t2 30 0.01 0.1 0 0 0 0 0 0 0 -360 360;\n];\n"
      "mpc.bus_name = { 'a'; 'b [c]'; };\n" },
    { ".gr", "c a comment\np tw 5 4\n1 2\n2 3\n3 4\n4 5\n" },
    { ".col", "c a comment\np edge 4 3\ne 1 2\ne 2 3\ne 4 1\n" },
    { ".g6", ">>graph6<<IheA@GUAo\n" },
    { ".s6", ":Fa@x^\n" },
    { ".json", TextOf(certificatetest::PathInTetrahedron(), folder) },
    { ".json", TextOf(certificatetest::TorusGrid(3, 3), folder) },
    { ".json", TextOf(certificatetest::Octagon(), folder) },
  };
}
