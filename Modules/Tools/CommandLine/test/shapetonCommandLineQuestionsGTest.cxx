#include "shapetonToolProcess.h"

#include "gtest/gtest.h"

#include <iostream>

namespace
{
using namespace tooltest;

std::string
Answer(const Words & arguments)
{
  const auto outcome = RunTool(arguments, [](shapeton::CommandLine &) { std::cout << "the body ran"; });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

bool
Contains(const std::string & text, const std::string & part)
{
  return text.find(part) != std::string::npos;
}

TEST(CommandLineQuestions, XmlIsExactlyTheDescription) { EXPECT_EQ(Answer({ "--xml" }), Xml); }

TEST(CommandLineQuestions, VersionIsOneLine) { EXPECT_EQ(Answer({ "--version" }), "1.2.3\n"); }

TEST(CommandLineQuestions, HelpSaysAllTheDescriptionSays)
{
  const std::string help = Answer({ "--help" });
  EXPECT_EQ(help, Answer({ "-h" }));
  EXPECT_EQ(help.find("Test Tool 1.2.3\nTests the contract.\n\n"
                      "Usage: TestTool <inputVolume> <outputVolume> [options]\n\n"
                      "  inputVolume                 Where from.\n"
                      "  outputVolume                Where to.\n\n"
                      "IO:\n"
                      "  --table <path>              A second output.\n"),
            0u)
    << help;
  for (const std::string line : { "\nSettings:\n  -g, --gamma <number>        Exponent & more. (-2 to 10) [1.50]\n",
                                  "  --offset <number>           Without a default.\n",
                                  "  --steps <integer>           A number. (at least 1) [100000]\n",
                                  "  --window <number,...>       Lower and upper intensity. [-1,2.50]\n",
                                  "  --solver <word>             How. (chebyshev | explicit) [chebyshev]\n",
                                  "  -u, --untilSteady           Whether.\n",
                                  "\nAll tools:\n  --quiet                     Print no progress.\n",
                                  "  --returnparameterfile <file>\n                              Write the return "
                                  "values as lines name = value.\n",
                                  "  -h, --help                  Print this text.\n",
                                  "\nExit status: 0 done, 2 wrong usage, 3 unsuitable input, 1 any other failure.\n",
                                  "Documentation: https://example.org/tool\n" })
  {
    EXPECT_TRUE(Contains(help, line)) << line << help;
  }
  EXPECT_FALSE(Contains(help, "meanHeat")) << "a return value is not an option";
}

TEST(CommandLineQuestions, AreAnsweredWhateverElseIsWrong)
{
  EXPECT_EQ(Answer({ "--nonsense", "--gamma", "abc", "--version" }), "1.2.3\n");
  EXPECT_EQ(Answer({ "--quiet", "--xml" }), Xml);
}

TEST(CommandLineQuestions, TheFirstOneIsAnswered)
{
  EXPECT_EQ(Answer({ "--version", "--xml", "--help" }), "1.2.3\n");
  EXPECT_EQ(Answer({ "--xml", "--version" }), Xml);
}

TEST(CommandLineQuestions, AfterTwoHyphensTheyAreFileNames)
{
  EXPECT_EQ(Answer({ "--", "--version", "--help" }), "the body ran");
}

TEST(CommandLineQuestions, AnAnswerThatCannotBeWrittenIsAFailure)
{
  for (const std::string question : { "--xml", "--help", "--version" })
  {
    const auto outcome = InProcess([&question] {
      return freopen("/dev/full", "w", stdout) ? RunHere({ question }, [](shapeton::CommandLine &) {}) : 99;
    });
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "TestTool: cannot write to the standard output; free some space or redirect it\n");
  }
}

TEST(CommandLineQuestions, AMalformedDescriptionIsAFailure)
{
  const auto outcome = RunTool(
    { "--version" }, [](shapeton::CommandLine &) {}, "<executable><title>T</executable>");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "TestTool: malformed module description: mismatched tag\n");
}

TEST(CommandLineQuestions, AProgramWithoutANameStillAnswers)
{
  for (const std::string path : { "", "/" })
  {
    const auto outcome = InProcess([&path] {
      return RunHere(
        { "--nonsense" }, [](shapeton::CommandLine &) {}, Xml, path);
    });
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, "tool: unknown option \"--nonsense\"; --help lists the options\n");
  }
  const auto outcome = InProcess([] {
    const char * const argv[] = { nullptr };
    return shapeton::CommandLine::Run(Xml, 0, argv, [](shapeton::CommandLine &) {});
  });
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "tool: the argument inputVolume is missing; --help shows the usage\n");
}
} // namespace
