#include "shapetonGraphTestFiles.h"

#include "gtest/gtest.h"

using graphtest::AnswerTo;
using graphtest::ReadText;

TEST(GraphML, NodesEdgesLoopsAndMultipleEdges)
{
  const std::string text =
    "<?xml version=\"1.0\"?><graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">"
    "<key id=\"d0\" for=\"node\"/><graph edgedefault=\"undirected\"><edge source=\"b\" target=\"a\"/>"
    "<node id=\"a\"><data key=\"d0\">x</data></node><node id=\"b\"/><node id=\"c &amp; d\"/>"
    "<edge source=\"a\" target=\"b\"/><edge source=\"b\" target=\"b\"/></graph></graphml>";
  EXPECT_EQ("b-a a-b b-b (a b c & d)", AnswerTo("a.graphml", text));
  EXPECT_EQ("GraphML", ReadText("a.graphml", text).format);
}

TEST(GraphML, AnEdgeMayBeUndirectedInADirectedGraph)
{
  EXPECT_EQ("a-b (a b)",
            AnswerTo("a.graphml",
                     "<graphml><graph edgedefault=\"directed\"><node id=\"a\"/><node id=\"b\"/>"
                     "<edge directed=\"false\" source=\"a\" target=\"b\"/></graph></graphml>"));
}

TEST(GraphML, WrittenGraphReadsBack)
{
  const shapeton::Graph  graph{ 3, { { 0, 1 }, { 1, 2 }, { 2, 2 }, { 0, 1 } }, { "<a>", "b \"&\"", "c" } };
  const basetest::Folder folder;
  shapeton::WriteGraphML(graph, folder / "written.graphml");
  const shapeton::Graph read = shapeton::ReadGraph(folder / "written.graphml").graph;
  EXPECT_EQ(graph.names, read.names);
  EXPECT_EQ(graph.edges, read.edges);
}

TEST(Gml, NestedListsTextsAndComments)
{
  EXPECT_EQ(
    "7-3 3-3 (3 7)",
    AnswerTo("a.gml",
             "Creator \"me [ ] \"\n# a comment ]\ngraph\n[\n directed 0\n node [ id 3 label \"x ] y\" graphics [ x 1.5 "
             "fill [ a 2 ] ] ]\n edge [ source 7 target 3 value 2 ]\n node [ id 7 ]\n edge [ source 3 target 3 ] ]\n"));
}

TEST(Dot, ChainsSubgraphsPortsAndQuotes)
{
  EXPECT_EQ("a-b b-c c-d e f-a (a b c d e f)",
            AnswerTo("a.dot",
                     "// c\n#include\ngraph \"G\" { rankdir=LR; node [shape=box, x=\"1\"; y=2]; a -- b:p:n -- c [w=1]\n"
                     "c -- d; \"e\" + \" f\" -- a; }"));
  EXPECT_EQ("a-b a-c b-a b-b b-c (a b c)", AnswerTo("a.gv", "GRAPH { a -- { b c } subgraph s { b } -- {a; b\nc} }"));
  EXPECT_EQ("-1.5-<<b>x</b>> (-1.5 <<b>x</b>>)", AnswerTo("a.gv", "graph { -1.5 -- <<b>x</b>> /* c */ }"));
}

TEST(Dot, ListsOfNodes)
{
  EXPECT_EQ("a-c b-c (a b c)", AnswerTo("a.gv", "graph { a, b -- c }"));
  EXPECT_EQ("a-c a-d b-c b-d (a b c d e)", AnswerTo("a.gv", "graph { a, b:n -- c, \"d\" [w=1]; d, e [shape=box] }"));
  EXPECT_EQ("InputError", AnswerTo("a.gv", "graph { a, -- c }").substr(0, 10));
}

TEST(Dot, CommentsOfEachKind)
{
  EXPECT_EQ("a-b b-c (a b c)",
            AnswerTo("a.dot",
                     "# line 1 \"made.gv\"\n /* } */ graph { // }\n \t# }\r\n a -- b /* -- x\n # -- y */ -- c\n"
                     "#}\n}\n  # end"));
  EXPECT_NE(std::string::npos, AnswerTo("a.dot", "graph { a # b\n}").find("\"#\" is unexpected"));
  EXPECT_EQ("a#b-c (a#b c)", AnswerTo("a.dot", "graph {\n\"a#b\" -- c }"));
}

// Within quotes only a quote can be escaped; double backslashes are kept.
TEST(Dot, EscapesInQuotes)
{
  EXPECT_EQ("a\"b-c\\\\ (a\"b c\\\\)", AnswerTo("a.dot", "graph { \"a\\\"b\" -- \"c\\\\\" }"));
  EXPECT_EQ("abc-d\\n (abc d\\n)", AnswerTo("a.dot", "graph { \"a\\\nb\\\r\nc\" -- \"d\\n\" }"));
}

TEST(Dot, StrictGraphsWithPortsClustersAndHtml)
{
  const shapeton::Graph graph =
    ReadText("a.dot",
             "strict graph \"x y\" { graph [rankdir=LR]; node [shape=box];\n /* c */ a -- b -- "
             "c -- a; // chain\n # preprocessor\n a:n -- \"b\":s [label=<<b>\"q\"</b>>];\n"
             "subgraph cluster_0 { d; e } -- f\n {g h} -- \"i\" + \"j\" ; }")
      .graph;
  EXPECT_EQ("a-b b-c c-a d-f e-f g-ij h-ij (a b c d e f g h ij)", graphtest::Shown(graph));
}

TEST(Dot, StrictGraphsHaveNoRepeatedEdges)
{
  const shapeton::GraphFile strict = ReadText("a.dot", "strict graph { a -- b; b -- a; a -- a; a -- b }");
  EXPECT_EQ("a-b a-a (a b)", graphtest::Shown(strict.graph));
  ASSERT_EQ(1u, strict.notes.size());
  EXPECT_NE(std::string::npos, strict.notes[0].find("2 repeated edges"));
  EXPECT_EQ("a-b b-a a-a a-b (a b)", AnswerTo("a.dot", "graph { a -- b; b -- a; a -- a; a -- b }"));
}

TEST(EdgeList, WeightsCommentsAndSeparators)
{
  EXPECT_EQ("a-b b-c c-c b-c (a b c)",
            AnswerTo("a.edges", "# nodes\n% too\na b 0.5 17\r\nb,c\n\nc;c\nb\tc {'weight': 3}\n"));
}

TEST(EdgeList, NamesOfColumnsAreNoEdge)
{
  const shapeton::GraphFile file = ReadText("a.csv", "Source,Target,2\na,b,1\nsource,target\n");
  EXPECT_EQ("a-b source-target (a b source target)", graphtest::Shown(file.graph));
  ASSERT_EQ(1u, file.notes.size());
  EXPECT_EQ("line 1 has column names and was skipped", file.notes[0]);
}

TEST(Metis, EdgesAtBothEndsWithWeights)
{
  EXPECT_EQ("1-2 1-3 2-3 (1 2 3 4)", AnswerTo("a.graph", "% c\n4 3\n2 3\n1 3\n1 2\n\n"));
  EXPECT_EQ("1-2 1-2 2-2 (1 2)", AnswerTo("a.metis", "2 3\n2 2\n1 2 1 2\n"));
  EXPECT_EQ("1-2 (1 2)", AnswerTo("a.graph", "2 1 111 2\n9 5 5 2 8\n9 5 5 1 8\n"));
}

TEST(Matpower, BusesBranchesAndThoseOutOfService)
{
  const shapeton::GraphFile file =
    ReadText("case.m",
             "function mpc = case3\n% mpc.bus = [ 9 9 ]\nmpc.bus = [\n 10 1 0;\n 7 2 Inf\n 3 1 0 ];\n"
             "mpc.gen = [ 1 2 ];\nmpc.branch = [\n10 7 0 0 0 0 0 0 0 0 1; 10 7 0 0 0 0 0 0 0 0 1\n"
             "7 3 0 0 0 0 0 0 0 0 0;\n];\nmpc.bus_name = { 'a [b]' };\n");
  EXPECT_EQ("10-7 10-7 (10 7 3)", graphtest::Shown(file.graph));
  ASSERT_EQ(1u, file.notes.size());
  EXPECT_EQ("1 branches that are out of service were skipped", file.notes[0]);
}

TEST(Pace, PlainAndDimacsEdges)
{
  EXPECT_EQ("1-2 3-3 (1 2 3)", AnswerTo("a.gr", "c hello\np tw 3 2\n1 2\nc more\n3 3\n"));
  EXPECT_EQ("1-2 2-3 (1 2 3)", AnswerTo("a.col", "p edge 3 2\ne 1 2\ne 2 3\n"));
}

/** The examples of McKay's format description, and the Petersen graph of nauty's geng. */
TEST(Graph6, ExamplesOfTheFormat)
{
  EXPECT_EQ("0-2 1-3 0-4 3-4 (0 1 2 3 4)", AnswerTo("a.g6", "DQc\n"));
  const shapeton::Graph petersen = ReadText("a.g6", ">>graph6<<IheA@GUAo\n").graph;
  EXPECT_EQ(10, petersen.nodes);
  EXPECT_EQ(15u, petersen.edges.size());
  EXPECT_EQ("0-1 0-2 1-2 5-6 (0 1 2 3 4 5 6)", AnswerTo("a.s6", ":Fa@x^\n"));
}

TEST(GraphReader, TheContentDecidesWhereItIsUnmistakable)
{
  EXPECT_EQ("GML", ReadText("a.txt", "graph [ node [ id 1 ] ]").format);
  EXPECT_EQ("DOT", ReadText("a.txt", "graph { a }").format);
  EXPECT_EQ("GraphML", ReadText("a.graph", "\xEF\xBB\xBF<graphml><graph><node id=\"a\"/></graph></graphml>").format);
  EXPECT_EQ("PACE", ReadText("noextension", "c x\np tw 1 0\n").format);
  EXPECT_EQ("METIS", ReadText("a.graph", "2 1\n2\n1\n").format);
  EXPECT_EQ("edge list", ReadText("a.txt", "2 1\n2 3\n1 3\n").format);
}
