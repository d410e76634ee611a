#include "shapetonToolProcess.h"

#include "itkObject.h"
#include "itkObjectFactory.h"
#include "shapetonExceptions.h"

#include "gtest/gtest.h"

#include <iostream>
#include <new>
#include <stdexcept>

#include <unistd.h>

namespace
{
using namespace tooltest;

/** Runs a body that throws; stdout must stay empty. */
Outcome
Fail(const Body & body)
{
  auto outcome = RunWithOptions({}, body);
  EXPECT_EQ(outcome.out, "");
  return outcome;
}

TEST(CommandLineFailures, EachClassHasItsExitStatus)
{
  const auto usage = Fail([](shapeton::CommandLine &) { throw shapeton::ParameterError("--a contradicts --b"); });
  EXPECT_EQ(usage.status, 2);
  EXPECT_EQ(usage.err, "TestTool: --a contradicts --b\n");

  const auto input =
    Fail([](shapeton::CommandLine &) { throw shapeton::InputError("\"in.nrrd\" is empty; give another"); });
  EXPECT_EQ(input.status, 3);
  EXPECT_EQ(input.err, "TestTool: \"in.nrrd\" is empty; give another\n");

  const auto output =
    Fail([](shapeton::CommandLine &) { throw shapeton::OutputError("the disk is full; free some space"); });
  EXPECT_EQ(output.status, 1);
  EXPECT_EQ(output.err, "TestTool: the disk is full; free some space\n");
}

TEST(CommandLineFailures, ParametersAreNamedAsOptions)
{
  const auto usage = Fail([](shapeton::CommandLine &) {
    throw shapeton::ParameterError("give the parameter \"count\" = 2 or leave the parameter \"size\" out");
  });
  EXPECT_EQ(usage.status, 2);
  EXPECT_EQ(usage.err, "TestTool: give --count 2 or leave --size out\n");
  EXPECT_EQ(shapeton::CommandLine::InOptions("the parameter of \"x\" stays"), "the parameter of \"x\" stays");
}

TEST(CommandLineFailures, OtherExceptionsEndWithStatusOne)
{
  const auto standard = Fail([](shapeton::CommandLine &) { throw std::out_of_range("index 7"); });
  EXPECT_EQ(standard.status, 1);
  EXPECT_EQ(standard.err, "TestTool: index 7\n");

  const auto unknown = Fail([](shapeton::CommandLine &) { throw 42; });
  EXPECT_EQ(unknown.status, 1);
  EXPECT_EQ(unknown.err, "TestTool: an unknown failure; report this as a bug\n");
}

/** An ITK object with custom messages, because the messages of ITK's classes differ between versions. */
class FailingObject : public itk::Object
{
public:
  using Self = FailingObject;
  using Pointer = itk::SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

  void
  Fail() const
  {
    itkExceptionMacro("A spacing of 0 is not allowed: Spacing is [0, 0, 0]");
  }
};

TEST(CommandLineFailures, MemoryThatIsNotThereHasOneMessage)
{
  const std::string message = "TestTool: not enough memory; use a smaller volume or fewer outputs at once\n";

  const auto standard = Fail([](shapeton::CommandLine &) { throw std::bad_alloc(); });
  EXPECT_EQ(standard.status, 1);
  EXPECT_EQ(standard.err, message);

  const auto ofITK =
    Fail([](shapeton::CommandLine &) { throw itk::MemoryAllocationError(__FILE__, __LINE__, "Failed", "here"); });
  EXPECT_EQ(ofITK.status, 1);
  EXPECT_EQ(ofITK.err, message);
}

TEST(CommandLineFailures, MessagesOfITKLoseLocationClassAndPointer)
{
  const auto macro = Fail([](shapeton::CommandLine &) { itkGenericExceptionMacro("File not found: a (b): c"); });
  EXPECT_EQ(macro.status, 1);
  EXPECT_EQ(macro.err, "TestTool: File not found: a (b): c\n");

  const auto fromObject = Fail([](shapeton::CommandLine &) { FailingObject::New()->Fail(); });
  EXPECT_EQ(fromObject.status, 1);
  EXPECT_EQ(fromObject.err, "TestTool: A spacing of 0 is not allowed: Spacing is [0, 0, 0]\n");

  const auto rethrown = Fail([](shapeton::CommandLine &) {
    throw itk::ExceptionObject(
      "/there/itkFoo.h", 7, "Exception in a thread\n/there/itkBar.hxx:12:\nITK ERROR: Bar(0x7ffd10): no luck", "loc");
  });
  EXPECT_EQ(rethrown.err, "TestTool: no luck\n");

  const auto nested = Fail([](shapeton::CommandLine &) {
    itkGenericExceptionMacro("Foo(0x7ffd20): not done:\nITK ERROR: Bar(0x7ffd10): no luck");
  });
  EXPECT_EQ(nested.err, "TestTool: no luck\n");

  const auto noObject = Fail([](shapeton::CommandLine &) { itkGenericExceptionMacro("the offset (0x10): too large"); });
  EXPECT_EQ(noObject.err, "TestTool: the offset (0x10): too large\n");

  const auto plain = Fail(
    [](shapeton::CommandLine &) { throw itk::ExceptionObject("/there/itkFoo.h", 7, "  plain \n\n words ", "loc"); });
  EXPECT_EQ(plain.err, "TestTool: plain words\n");

  const auto passedOn = Fail([](shapeton::CommandLine &) {
    throw std::runtime_error("/there/itkBar.hxx:12:\nITK ERROR: Bar(0x7ffd10): no luck");
  });
  EXPECT_EQ(passedOn.err, "TestTool: no luck\n");
}

TEST(CommandLineFailures, WarningsOfITKDoNotReachStderrOfARunThatSucceeds)
{
  const auto outcome = RunWithOptions({}, [](shapeton::CommandLine &) { itkGenericOutputMacro("a remark"); });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err, "");
}

TEST(CommandLineFailures, TextThatCannotBeWrittenIsAFailure)
{
  const auto outcome = InProcess([] {
    if (!freopen("/dev/full", "w", stdout))
    {
      return 99;
    }
    return RunHere({ "in", "out" }, [](shapeton::CommandLine &) { std::cout << "the result"; });
  });
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "TestTool: cannot write to the standard output; free some space or redirect it\n");
}

TEST(CommandLineFailures, AClosedStdoutIsNoOutputFile)
{
  const Scratch scratch;
  const auto    outcome = InProcess([] {
    close(STDIN_FILENO);
    close(STDOUT_FILENO);
    close(STDERR_FILENO);
    return RunHere({ "in", "out.txt" }, [](shapeton::CommandLine & commandLine) {
      WriteText(commandLine.OutputOf("outputVolume"), "content");
      commandLine.Progress("Working", 0.5);
      std::cout << "result" << std::flush;
    });
  });
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(ReadText("out.txt"), "content");
}
} // namespace
