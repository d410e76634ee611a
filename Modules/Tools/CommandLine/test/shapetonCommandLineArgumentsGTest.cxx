#include "shapetonToolProcess.h"

#include "gtest/gtest.h"

#include <iostream>
#include <locale>
#include <string>

namespace
{
using namespace tooltest;

const std::string absent = "(not given)";

/** GetString() of a parameter after parsing `options`. */
std::string
StringOf(const std::string & name, const Words & options)
{
  const auto outcome = RunWithOptions(options, [&name](shapeton::CommandLine & commandLine) {
    std::cout << (commandLine.IsGiven(name) ? "" : absent) << commandLine.GetString(name);
  });
  return outcome.status == 0 ? outcome.out : outcome.err;
}

double
GammaOf(const Words & options)
{
  const auto outcome = RunWithOptions(
    options, [](shapeton::CommandLine & commandLine) { std::printf("%.17g", commandLine.GetDouble("gamma")); });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.out.empty() ? 0.0 : std::stod(outcome.out);
}

/** Expects exit status 2, nothing on stdout, and one line on stderr: the program and `message`. */
void
ExpectUsageError(const Words & arguments, const std::string & message, const char * xml = Xml)
{
  const auto outcome = RunTool(
    arguments, [](shapeton::CommandLine &) { std::cout << "the body ran"; }, xml);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "TestTool: " + message + "\n");
  EXPECT_EQ(outcome.out, "");
}

void
ExpectBadOption(const Words & options, const std::string & message)
{
  Words arguments = { "in.nrrd", "out.nrrd" };
  arguments.insert(arguments.end(), options.begin(), options.end());
  ExpectUsageError(arguments, message);
}

TEST(CommandLineArguments, DefaultsHoldWhereNothingIsGiven)
{
  EXPECT_EQ(StringOf("gamma", {}), absent + "1.50");
  EXPECT_EQ(StringOf("solver", {}), absent + "chebyshev");
  EXPECT_EQ(StringOf("seriesUID", {}), absent);
  EXPECT_EQ(StringOf("untilSteady", {}), absent + "false");
  EXPECT_EQ(GammaOf({}), 1.5);
}

TEST(CommandLineArguments, LongFlagShortFlagAndEqualsFormAreTheSame)
{
  EXPECT_EQ(GammaOf({ "--gamma", "2.25" }), 2.25);
  EXPECT_EQ(GammaOf({ "--gamma=2.25" }), 2.25);
  EXPECT_EQ(GammaOf({ "-g", "2.25" }), 2.25);
}

TEST(CommandLineArguments, OptionsMayStandAnywhere)
{
  for (const Words & arguments : { Words{ "--gamma", "2", "in.nrrd", "out.nrrd" },
                                   Words{ "in.nrrd", "--gamma", "2", "out.nrrd" },
                                   Words{ "in.nrrd", "out.nrrd", "--gamma", "2" } })
  {
    const auto outcome = RunTool(arguments, [](shapeton::CommandLine & commandLine) {
      std::cout << commandLine.GetString("inputVolume") << ' ' << commandLine.GetString("outputVolume") << ' '
                << commandLine.GetDouble("gamma");
    });
    EXPECT_EQ(outcome.out, "in.nrrd out.nrrd 2");
  }
}

TEST(CommandLineArguments, PositionalsFollowTheirIndexNotTheOrderInTheXML)
{
  EXPECT_EQ(StringOf("inputVolume", {}), "in.nrrd");
  EXPECT_EQ(StringOf("outputVolume", {}), "out.nrrd");
}

TEST(CommandLineArguments, AValueMayContainEqualsSignsAndBlanks)
{
  EXPECT_EQ(StringOf("seriesUID", { "--seriesUID=a=b" }), "a=b");
  EXPECT_EQ(StringOf("seriesUID", { "--seriesUID", "a=b c" }), "a=b c");
  EXPECT_EQ(StringOf("seriesUID", { "--seriesUID=" }), "(not given)");
  EXPECT_EQ(StringOf("seriesUID", { "--seriesUID=--gamma" }), "--gamma");
}

TEST(CommandLineArguments, NegativeNumbersAreValues)
{
  EXPECT_EQ(GammaOf({ "--gamma", "-1" }), -1.0);
  EXPECT_EQ(GammaOf({ "-g", "-.5" }), -0.5);
  EXPECT_EQ(GammaOf({ "--gamma=-1e-1" }), -0.1);
  EXPECT_EQ(StringOf("window", { "--window", "-3,-1" }), "-3,-1");
}

TEST(CommandLineArguments, NegativeNumbersAndASingleHyphenMayBePositional)
{
  for (const std::string first : { "-1", "-.5", "-1,2,3", "-" })
  {
    const auto outcome = RunTool({ first, "out.nrrd" }, [](shapeton::CommandLine & commandLine) {
      std::cout << commandLine.GetString("inputVolume");
    });
    EXPECT_EQ(outcome.out, first) << outcome.err;
  }
  ExpectUsageError({ "-.", "out.nrrd" }, "unknown option \"-.\"; --help lists the options");
}

TEST(CommandLineArguments, TwoHyphensEndTheOptions)
{
  const auto outcome = RunTool({ "--gamma", "2", "--", "--gamma", "--" }, [](shapeton::CommandLine & commandLine) {
    std::cout << commandLine.GetString("inputVolume") << ' ' << commandLine.GetString("outputVolume") << ' '
              << commandLine.GetString("gamma");
  });
  EXPECT_EQ(outcome.out, "--gamma -- 2") << outcome.err;
}

TEST(CommandLineArguments, AnOptionIsGivenOnce)
{
  ExpectUsageError({ "in.nrrd", "out.nrrd", "--gamma", "2", "-g", "3" }, "--gamma is given twice; give it once");
  ExpectUsageError({ "--gamma", "1.5", "in.nrrd", "out.nrrd", "--gamma", "1.5" },
                   "--gamma is given twice; give it once");
  ExpectUsageError({ "in.nrrd", "out.nrrd", "-u", "--untilSteady=false" },
                   "--untilSteady is given twice; give it once");
}

TEST(CommandLineArguments, OptionsOfModuleHosts)
{
  const auto outcome =
    RunWithOptions({ "--processinformationaddress", "0", "--echo", "--tag", "a", "--tag=b", "-u" },
                   [](shapeton::CommandLine & commandLine) { std::cout << commandLine.GetFlag("untilSteady"); });
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(
    outcome.out,
    "Command Line Arguments\n    outputVolume: out.nrrd\n    inputVolume: in.nrrd\n    table: \n    shape: \n"
    "    gamma: 1.5\n    offset: \n    steps: 100000\n    window: -1,2.5\n    size: \n    names: \n    tag: a,b\n"
    "    seriesUID: \n    source: \n    solver: chebyshev\n    untilSteady: true\n    ignoreSpacing: false\n"
    "    threads: 0\n    meanHeat: 0\n    remark: \n1");
  ExpectUsageError({ "in.nrrd", "out.nrrd", "--processinformationaddress", "x" },
                   "--processinformationaddress: \"x\" is not an address, a whole number");
}

TEST(CommandLineArguments, AMultipleOptionKeepsAllItsValues)
{
  const auto outcome =
    RunWithOptions({ "--tag", "one", "-t", "two,three", "--tag=" }, [](shapeton::CommandLine & commandLine) {
      for (const auto & tag : commandLine.GetStrings("tag"))
      {
        std::cout << '[' << tag << ']';
      }
    });
  EXPECT_EQ(outcome.out, "[one][two,three][]") << outcome.err;
}

TEST(CommandLineArguments, Booleans)
{
  const auto flagOf = [](const Words & options) {
    const auto outcome = RunWithOptions(options, [](shapeton::CommandLine & commandLine) {
      std::cout << commandLine.GetFlag("untilSteady") << commandLine.IsGiven("untilSteady");
    });
    return outcome.out + outcome.err;
  };
  EXPECT_EQ(flagOf({}), "00");
  EXPECT_EQ(flagOf({ "--untilSteady" }), "11");
  EXPECT_EQ(flagOf({ "-u" }), "11");
  EXPECT_EQ(flagOf({ "--untilSteady=true" }), "11");
  EXPECT_EQ(flagOf({ "--untilSteady=false" }), "01");
  ExpectBadOption({ "--untilSteady=yes" }, "--untilSteady: \"yes\" is neither true nor false");
  ExpectBadOption({ "--untilSteady=" }, "--untilSteady: \"\" is neither true nor false");
  ExpectBadOption({ "--untilSteady", "true" }, "unexpected argument \"true\"; --help shows the usage");
}

TEST(CommandLineArguments, Vectors)
{
  const auto outcome = RunWithOptions({ "--size", "3,4,5", "--names=a,,b" }, [](shapeton::CommandLine & commandLine) {
    EXPECT_EQ(commandLine.GetIntegers("size"), std::vector<int>({ 3, 4, 5 }));
    EXPECT_EQ(commandLine.GetDoubles("window"), std::vector<double>({ -1.0, 2.5 }));
    EXPECT_EQ(commandLine.GetStrings("names"), Words({ "a", "", "b" }));
    EXPECT_TRUE(commandLine.GetStrings("tag").empty());
    std::cout << (testing::Test::HasFailure() ? "wrong" : "right");
  });
  EXPECT_EQ(outcome.out, "right");
}

TEST(CommandLineArguments, AVectorThatWasNotGivenIsEmpty)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    std::cout << commandLine.GetIntegers("size").size() << commandLine.GetStrings("names").size();
  });
  EXPECT_EQ(outcome.out, "00");
}

TEST(CommandLineArguments, WholeNumbersMayBeWrittenAsNumbers)
{
  const auto stepsOf = [](const std::string & text) {
    return RunWithOptions({ "--steps", text },
                          [](shapeton::CommandLine & commandLine) { std::cout << commandLine.GetInteger("steps"); })
      .out;
  };
  EXPECT_EQ(stepsOf("1e5"), "100000");
  EXPECT_EQ(stepsOf("+7.0"), "7");
  EXPECT_EQ(stepsOf("2147483647"), "2147483647");
}

TEST(CommandLineArguments, NumbersThatAreNone)
{
  for (const std::string text :
       { "nan", "-nan", "NaN(1)", "inf", "-inf", "infinity", "abc", "1x", "x1",  " 1",    "1 ",      "0x10",
         "1,5", "--1",  "+-1",    "++1", "-",    "+",        ".",   "1e", "1e+", "1_000", "\xD9\xA1" })
  {
    const std::string argument = "--gamma=" + text;
    ExpectBadOption({ argument }, "--gamma: \"" + text + "\" is not a number");
  }
  ExpectBadOption({ "--gamma=" }, "--gamma: the value is empty; give a number");
  ExpectBadOption({ "--gamma=1e999" }, "--gamma: \"1e999\" is too large or too small for a number");
  ExpectBadOption({ "--gamma=1e-999" }, "--gamma: \"1e-999\" is too large or too small for a number");
}

TEST(CommandLineArguments, WholeNumbersThatAreNone)
{
  for (const std::string text : { "2147483648", "-2147483648", "1e10", "1.5", "1e300" })
  {
    ExpectBadOption({ "--steps=" + text }, "--steps: \"" + text + "\" is not a whole number below 2^31");
  }
}

TEST(CommandLineArguments, Constraints)
{
  EXPECT_EQ(GammaOf({ "--gamma=-2" }), -2.0);
  EXPECT_EQ(GammaOf({ "--gamma=10" }), 10.0);
  ExpectBadOption({ "--gamma=-2.001" }, "--gamma: -2.001 is less than the minimum -2");
  ExpectBadOption({ "-g", "10.001" }, "--gamma: 10.001 is more than the maximum 10");
  ExpectBadOption({ "--steps=0" }, "--steps: 0 is less than the minimum 1");
  ExpectBadOption({ "--size", "3,1,3" }, "--size: 1 is less than the minimum 2");
}

TEST(CommandLineArguments, VectorsThatAreNone)
{
  ExpectBadOption({ "--window=" }, "--window: the value is empty; give a number");
  ExpectBadOption({ "--window=1," }, "--window: \"\" is not a number");
  ExpectBadOption({ "--window=1,,2" }, "--window: \"\" is not a number");
  ExpectBadOption({ "--window", "1;2" }, "--window: \"1;2\" is not a number");
  ExpectBadOption({ "--size=3,3.5" }, "--size: \"3.5\" is not a whole number below 2^31");
}

TEST(CommandLineArguments, Enumerations)
{
  EXPECT_EQ(StringOf("solver", { "--solver", "explicit" }), "explicit");
  ExpectBadOption({ "--solver", "Explicit" }, "--solver: \"Explicit\" is not one of chebyshev, explicit");
  ExpectBadOption({ "--solver=" }, "--solver: \"\" is not one of chebyshev, explicit");
}

TEST(CommandLineArguments, MissingAndUnexpected)
{
  ExpectUsageError({}, "the argument inputVolume is missing; --help shows the usage");
  ExpectUsageError({ "in.nrrd" }, "the argument outputVolume is missing; --help shows the usage");
  ExpectUsageError({ "a", "b", "c" }, "unexpected argument \"c\"; --help shows the usage");
  ExpectUsageError({ "", "b" }, "inputVolume: the name is empty");
  ExpectBadOption({ "--table=" }, "--table: the name is empty");
  ExpectBadOption({ "--returnparameterfile=" }, "--returnparameterfile: the name is empty");
  ExpectBadOption({ "--gamma" }, "--gamma requires a value");
  ExpectBadOption({ "-g" }, "-g requires a value");
  ExpectBadOption({ "--returnparameterfile" }, "--returnparameterfile requires a value");
}

TEST(CommandLineArguments, AForgottenValueIsNotTakenFromTheNextOption)
{
  ExpectBadOption({ "--table", "--untilSteady" },
                  "--table requires a value; a value that begins with two hyphens is written --table=VALUE");
  ExpectBadOption({ "--table", "--" },
                  "--table requires a value; a value that begins with two hyphens is written --table=VALUE");
}

TEST(CommandLineArguments, UnknownOptions)
{
  for (const std::string option : { "--g", "-x", "-g2", "-g=2", "--meanHeat" })
  {
    ExpectBadOption({ option }, "unknown option \"" + option + "\"; --help lists the options");
  }
  for (const std::string option : { "--gama", "--Gamma", "-gamma", "---gamma", "--gam", "--ggamma" })
  {
    ExpectBadOption({ option }, "unknown option \"" + option + "\"; did you mean --gamma? --help lists the options");
  }
  ExpectBadOption({ "--gama=3" }, "unknown option \"--gama\"; did you mean --gamma? --help lists the options");
  ExpectBadOption({ "--=3" }, "unknown option \"--\"; --help lists the options");
  ExpectBadOption({ "--help=now" }, "unknown option \"--help\"; --help lists the options");
}

TEST(CommandLineArguments, ANumberWithoutDefaultThatTheBodyNeedsIsMissing)
{
  const auto outcome =
    RunWithOptions({}, [](shapeton::CommandLine & commandLine) { std::cout << commandLine.GetDouble("offset"); });
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "TestTool: --offset is missing; it has no default\n");
}

TEST(CommandLineArguments, VeryLongArguments)
{
  const std::string million(1000000, 'x');
  EXPECT_EQ(StringOf("seriesUID", { "--seriesUID", million }), million);
  ExpectBadOption({ "--gamma", million }, "--gamma: \"" + million.substr(0, 100) + "...\" is not a number");
  ExpectBadOption({ "--" + million },
                  "unknown option \"--" + million.substr(0, 98) + "...\"; --help lists the options");
}

TEST(CommandLineArguments, MessagesAreOneLineWithoutControlCharacters)
{
  ExpectBadOption({ "--gamma",
                    "a\nb\t\x1B[31mc\xC2\x9B"
                    "d\xFF" },
                  "--gamma: \"a b [31mc d?\" is not a number");
}

TEST(CommandLineArguments, MalformedUTF8InMessagesBecomesQuestionMarks)
{
  const std::pair<std::string, std::string> cases[] = {
    { "\xC3\xA4\xE2\x82\xAC\xF0\x9F\xA6\xB4", "\xC3\xA4\xE2\x82\xAC\xF0\x9F\xA6\xB4" }, // characters of 2, 3, 4 bytes
    { "\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF",
      "\xED\x9F\xBF\xEE\x80\x80\xF4\x8F\xBF\xBF" }, // adjacent to surrogates
    { "\x80|\xBF|\xFE|\xFF", "?|?|?|?" },
    { "\xC3|\xE2\x82|\xF0\x9F\xA6", "?|??|???" },                            // truncated
    { "\xC0\xAF|\xC1\xBF|\xE0\x80\xAF|\xF0\x80\x80\xAF", "??|??|???|????" }, // overlong encoding
    { "\xED\xA0\x80|\xF4\x90\x80\x80|\xF5\x80\x80\x80", "???|????|????" },   // not a character
  };
  for (const auto & [text, shown] : cases)
  {
    ExpectBadOption({ "--gamma", text }, "--gamma: \"" + shown + "\" is not a number");
  }
}

TEST(CommandLineArguments, AnOptionLeftAtItsDefaultIsNotGiven)
{
  const auto isGiven = [](const std::vector<std::string> & options) {
    return RunWithOptions(options,
                          [](shapeton::CommandLine & commandLine) { std::cout << commandLine.IsGiven("gamma"); })
      .out;
  };
  const std::string theDefault =
    RunWithOptions({}, [](shapeton::CommandLine & commandLine) { std::cout << commandLine.GetString("gamma"); }).out;
  ASSERT_FALSE(theDefault.empty());
  EXPECT_EQ(isGiven({}), "0");
  EXPECT_EQ(isGiven({ "--gamma", theDefault }), "0");
  EXPECT_EQ(isGiven({ "--gamma", theDefault + (theDefault.find('.') == std::string::npos ? ".0" : "0") }), "0");
  EXPECT_EQ(isGiven({ "--gamma", "0.125" }), "1");
}

TEST(CommandLineArguments, NamesThatTheXMLLacksAreMistakesOfTheProgram)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine & commandLine) {
    std::cout << commandLine.Declares("gamma") << commandLine.Declares("delta");
    std::cout << commandLine.IsGiven("delta");
  });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "10");
  EXPECT_EQ(outcome.err, "TestTool: the module description has no parameter \"delta\"\n");
}

TEST(CommandLineArguments, IntegersAreOnlyThoseOfIntegerParameters)
{
  const Body         bodies[] = { [](shapeton::CommandLine & commandLine) { commandLine.GetInteger("gamma"); },
                          [](shapeton::CommandLine & commandLine) { commandLine.GetIntegers("window"); } };
  const char * const names[] = { "gamma", "window" };
  for (int i = 0; i < 2; ++i)
  {
    const auto outcome = RunWithOptions({}, bodies[i]);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, std::string("TestTool: \"") + names[i] + "\" is not an integer parameter\n");
  }
}

const char * const multipleXml = R"(<executable><title>T</title><version>1</version><parameters>
  <image><name>reference</name><index>0</index></image>
  <image multiple="true"><name>inputs</name><index>1</index></image>
</parameters></executable>)";

TEST(CommandLineArguments, AMultiplePositionalTakesAllThatFollow)
{
  const auto outcome = RunTool(
    { "r", "a", "-1", "--", "--c" },
    [](shapeton::CommandLine & commandLine) {
      std::cout << commandLine.GetString("reference");
      for (const auto & input : commandLine.GetStrings("inputs"))
      {
        std::cout << '|' << input;
      }
    },
    multipleXml);
  EXPECT_EQ(outcome.out, "r|a|-1|--c") << outcome.err;
  ExpectUsageError({ "r" }, "the argument inputs is missing; --help shows the usage", multipleXml);
}

const char * const pointsXml = R"(<executable><title>T</title><version>1</version><parameters>
  <point multiple="true" coordinateSystem="lps"><name>seed</name><longflag>seed</longflag></point>
</parameters></executable>)";

TEST(CommandLineArguments, PointsMayBeGivenSeveralTimes)
{
  const auto print = [](shapeton::CommandLine & commandLine) {
    for (const auto & point : commandLine.GetPoints("seed"))
    {
      std::cout << point[0] << ' ' << point[1] << ' ' << point[2] << '|';
    }
    for (const auto & fact : commandLine.GetProvenance())
    {
      std::cout << (fact.first == "option.seed" ? fact.second : "");
    }
  };
  EXPECT_EQ(RunTool({ "--seed", "-1.50,2,+3", "--seed=4,5e0,6" }, print, pointsXml).out,
            "-1.5 2 3|4 5 6|-1.5,2,3,4,5,6");
  EXPECT_EQ(RunTool({}, print, pointsXml).out, "");
  ExpectUsageError({ "--seed", "1,2" },
                   "--seed: \"1,2\" is not a point; use three coordinates, LPS in mm, for example -12.5,40,310",
                   pointsXml);
  ExpectUsageError({ "--seed", "1,2,a" }, "--seed: \"a\" is not a number", pointsXml);
}

TEST(CommandLineArguments, NumbersDoNotDependOnTheLocale)
{
  const auto outcome = InProcess([] {
    std::locale::global(std::locale(std::locale::classic(), new Comma));
    return RunHere({ "in", "out", "--gamma", "2.5", "--steps", "1234567" }, [](shapeton::CommandLine & commandLine) {
      std::printf("%d", commandLine.GetDouble("gamma") == 2.5);
      for (const auto & fact : commandLine.GetProvenance())
      {
        std::printf(" %s=%s", fact.first.c_str(), fact.second.c_str());
      }
    });
  });
  EXPECT_EQ(outcome.out.substr(0, 1), "1");
  EXPECT_NE(outcome.out.find(" option.gamma=2.5 option.steps=1234567 "), std::string::npos) << outcome.out;
}
} // namespace
