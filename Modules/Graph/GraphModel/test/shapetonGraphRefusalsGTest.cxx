#include "shapetonGraphTestFiles.h"

#include "gtest/gtest.h"

using graphtest::AnswerTo;

namespace
{
struct Refusal
{
  const char * name;
  std::string  text;
  const char * message;
};

std::string
GraphMLOf(const std::string & content)
{
  return "<graphml>\n<graph edgedefault=\"undirected\">\n" + content + "\n</graph>\n</graphml>\n";
}

void
ExpectRefused(const std::vector<Refusal> & refusals)
{
  for (const Refusal & refusal : refusals)
  {
    const std::string answer = AnswerTo(refusal.name, refusal.text);
    EXPECT_EQ("InputError: ", answer.substr(0, 12)) << refusal.text;
    EXPECT_NE(std::string::npos, answer.find(refusal.name)) << answer;
    EXPECT_NE(std::string::npos, answer.find(refusal.message)) << answer << "\ninstead of " << refusal.message;
    EXPECT_EQ(std::string::npos, answer.find('\n')) << answer;
  }
}
} // namespace

TEST(GraphRefusals, EmptyAndBinaryFiles)
{
  ExpectRefused({ { "a.graphml", "", "the file is empty" },
                  { "a.edges", " \n\r\n", "the file is empty" },
                  { "a.dot", std::string("graph { a\0b }", 13), "the file is binary" },
                  { "a.g6", "\x89PNG\r\n\x1a\n\x01", "the file is binary" },
                  { "a.graphml", std::string("\xFF\xFE<\0g\0", 6), "the file is binary" },
                  { "a.unknown", "hello world\n", "is not recognized by extension or content" },
                  { "a.edges", "# nothing\n", "the graph has no nodes" } });
}

TEST(GraphRefusals, FormatsThatAreNotReadAreNamed)
{
  ExpectRefused({ { "a.net", "*Vertices 2\n1 \"a\"\n2 \"b\"\n*Edges\n1 2\n", "the format is Pajek" },
                  { "a.edges", "\n*network x\n*vertices 2\n", "with networkx" },
                  { "a.txt", "DL N = 2\nformat = edgelist1\ndata:\n1 2\n", "the format is DL of UCINET" },
                  { "a.dl", "dl n=2 format=edgelist1\ndata:\n1 2\n", "the format is DL of UCINET" },
                  { "a.vcg", "graph: { node: { title: \"a\" } }\n", "the format is VCG" },
                  { "a.d6", "&BP_\n", "the format is digraph6" },
                  { "a.graphml", "\x1F\x8B\x08", "the file is compressed; decompress it, for example with gunzip" },
                  { "a.dot", "BZh9", "with bunzip2" } });
  EXPECT_EQ(AnswerTo("a.edges", "dl &x\n&x b\n"), "dl-&x &x-b (dl &x b)"); // names, not formats
}

TEST(GraphRefusals, DirectedGraphs)
{
  ExpectRefused(
    { { "a.graphml",
        "<graphml><graph edgedefault=\"directed\"><node id=\"a\"/>\n<edge source=\"a\" "
        "target=\"a\"/></graph></graphml>",
        "line 2: the graph is directed" },
      { "a.graphml", GraphMLOf("<node id=\"a\"/><edge directed=\"true\" source=\"a\" target=\"a\"/>"), "is directed" },
      { "a.gml", "graph [\n directed 1 ]", "line 2: the graph is directed" },
      { "a.dot", "digraph { a -> b }", "line 1: the graph is directed" },
      { "a.dot", "graph { a -> b }", "is directed" },
      { "a.graph", "3 2\n2\n3\n2\n", "more often than the reverse" },
      { "a.gr", "p sp 2 1\na 1 2 3\n", "is directed" },
      { "a.g6", "&BP_", "is directed" } });
}

TEST(GraphRefusals, DuplicateAndMissingNodes)
{
  ExpectRefused(
    { { "a.graphml", GraphMLOf("<node id=\"a\"/>\n<node id=\"a\"/>"), "line 4: the node \"a\" is declared twice" },
      { "a.gml", "graph [ node [ id 1 ]\n node [ id 1 ] ]", "line 2: the node \"1\" is declared twice" },
      { "a.m", "mpc.bus = [ 1 1;\n 1 1 ];\nmpc.branch = [];", "line 2: the node \"1\" is declared twice" },
      { "a.graphml", GraphMLOf("<node id=\"a\"/>\n<edge source=\"a\" target=\"b\"/>"), "line 4: an edge refers to" },
      { "a.gml", "graph [ node [ id 1 ]\n edge [ source 1 target 2 ] ]", "line 2: an edge refers to the node \"2\"" },
      { "a.m", "mpc.bus = [ 1 1 ];\nmpc.branch = [ 1 2 ];", "line 2: an edge refers to the node \"2\"" },
      { "a.gr", "p tw 3 1\n1 4\n", "line 2: \"4\" is not a node" },
      { "a.gr", "p tw 3 1\n0 1\n", "line 2: \"0\" is not a node" },
      { "a.graph", "2 1\n3\n1\n", "line 2: node \"3\" does not exist" } });
}

TEST(GraphRefusals, KeysOfGmlThatStandTwice)
{
  const std::string nodes = "graph [\n node [ id 1 ]\n node [ id 2 ]\n";
  ExpectRefused(
    { { "a.gml",
        nodes + " edge [ source 1\n target 2\n source 2 ] ]",
        "line 6: the edge has a second \"source\"; the first one is in line 4" },
      { "a.gml",
        nodes + " edge [ source 1\n target 2\n target 2 ] ]",
        "line 6: the edge has a second \"target\"; the first one is in line 5" },
      { "a.gml", "graph [ node [ id 1\nid 1 ] ]", "line 2: the node has a second \"id\"; the first one is in line 1" },
      { "a.gml", "graph [ directed 0\ndirected 0 ]", "line 2: the graph has a second \"directed\"" },
      { "a.gml",
        "graph [ node [ id 1 ] ]\ngraph [ ]",
        "line 2: the file contains a second graph; the first one starts in line 1" } });
  // A key in a nested list is a different key.
  EXPECT_EQ(
    "1-2 (1 2)",
    AnswerTo("a.gml",
             nodes + "edge [ source 1 target 2 graphics [ source 7 target 8 ] label \"source\" label \"x\" ] ]"));
}

TEST(GraphRefusals, TruncatedFiles)
{
  ExpectRefused({ { "a.graphml", "<graphml>\n<graph>\n<node id=\"a\"/>\n<no", "line 4: the XML is not well-formed" },
                  { "a.gml", "graph [ node [ id 1 ]", "no closing bracket" },
                  { "a.gml", "graph [ node [ id", "the file ends after the key \"id\"" },
                  { "a.dot", "graph {\n a -- b", "found \"the end of the file\"" },
                  { "a.dot", "graph {\n a -- \"b", "line 2: a quoted string is not closed" },
                  { "a.edges", "a b\nc", "line 2: the line has only one word" },
                  { "a.graph", "3 2\n2\n1 3\n", "the file ends at node 2 of 3" },
                  { "a.m", "mpc.bus = [ 1 1 ];\nmpc.branch = [ 1 1\n", "the matrix \"branch\" is not terminated" },
                  { "a.m", "mpc.bus = [ 1 1 ];\n", "the matrix \"branch\" is missing" },
                  { "a.gr", "p tw 3 2\n1 2\n", "the file ends after 1 edges, but its line \"p\" states 2" },
                  { "a.g6", "IheA@G", "needs 8 bytes of edges, but 5 follow" },
                  { "a.s6", ":", "the number of nodes is truncated" } });
}

TEST(GraphRefusals, MalformedFiles)
{
  ExpectRefused({ { "a.xml", "<html></html>", "the outermost element is \"html\", not graphml" },
                  { "a.graphml", GraphMLOf("<node id=\"a\"><graph/></node>"), "one inside a node" },
                  { "a.graphml", GraphMLOf("<hyperedge/>"), "a hyperedge" },
                  { "a.graphml", GraphMLOf("<node/>"), "a node has no id" },
                  { "a.gml", "graph [ ] graph [ ]", "a second graph" },
                  { "a.gml", "graph [ node [ id x ] ]", "\"x\" is not an integer" },
                  { "a.gml", "graph [ node [ label \"x\" ] ]", "the node has no id" },
                  { "a.dot", "graph { a [b=] }", "expected the value of an attribute, found \"]\"" },
                  { "a.dot", "graph { a } graph { b }", "follows the end of the graph" },
                  { "a.dot", "graph { a -- ? }", "\"?\" is unexpected" },
                  { "a.dot", "graph " + std::string(5000, '{'), "200 deep" },
                  { "a.edges", "a b c\n", "\"c\" after the two nodes of an edge is not a number" },
                  { "a.graph", "2 2\n2\n1\n", "has 1 edges, but its first line states 2" },
                  { "a.graph", "2 1 7\n2\n1\n", "must consist of the digits 0 and 1" },
                  { "a.graph", "2 1\n2\n1\n1\n", "continues after the last" },
                  { "a.graph", "2000000000 1\n", "more than 10 million" },
                  { "a.gr", "1 2\n", "precedes the line \"p tw" },
                  { "a.gr", "p tw 2 0\np tw 2 0\n", "line 2: a second line \"p\"" },
                  { "a.m", "mpc.bus = [ 1.5 1 ];\nmpc.branch = [];", "\"1.5\" is not a bus number" },
                  { "a.g6", "DQc\nDQc\n", "a second graph" },
                  { "a.g6", "D Q", "is invalid in this format" } });
}
