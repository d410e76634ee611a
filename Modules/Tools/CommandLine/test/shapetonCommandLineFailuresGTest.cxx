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

/** Expects that a body that throws results in this exit status, nothing on stdout, and one line on stderr: the program
 * and `message`. */
void
ExpectFailure(int status, const std::string & message, const Body & body)
{
  const auto outcome = RunWithOptions({}, body);
  EXPECT_EQ(outcome.status, status);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "TestTool: " + message + "\n");
}

TEST(CommandLineFailures, EachClassHasItsExitStatus)
{
  ExpectFailure(
    2, "--a contradicts --b", [](shapeton::CommandLine &) { throw shapeton::ParameterError("--a contradicts --b"); });
  ExpectFailure(3, "\"in.nrrd\" is empty; give another", [](shapeton::CommandLine &) {
    throw shapeton::InputError("\"in.nrrd\" is empty; give another");
  });
  ExpectFailure(1, "the disk is full; free some space", [](shapeton::CommandLine &) {
    throw shapeton::OutputError("the disk is full; free some space");
  });
}

TEST(CommandLineFailures, ParametersAreNamedAsOptions)
{
  ExpectFailure(2, "give --count 2 or leave --size out", [](shapeton::CommandLine &) {
    throw shapeton::ParameterError("give the parameter \"count\" = 2 or leave the parameter \"size\" out");
  });
  EXPECT_EQ(shapeton::CommandLine::InOptions("the parameter of \"x\" stays"), "the parameter of \"x\" stays");
}

TEST(CommandLineFailures, OtherExceptionsEndWithStatusOne)
{
  ExpectFailure(1, "index 7", [](shapeton::CommandLine &) { throw std::out_of_range("index 7"); });
  ExpectFailure(1, "an unknown failure; report this as a bug", [](shapeton::CommandLine &) { throw 42; });
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
  const std::string message = "not enough memory; use a smaller volume or fewer outputs at once";
  ExpectFailure(1, message, [](shapeton::CommandLine &) { throw std::bad_alloc(); });
  ExpectFailure(1, message, [](shapeton::CommandLine &) {
    throw itk::MemoryAllocationError(__FILE__, __LINE__, "Failed", "here");
  });
}

TEST(CommandLineFailures, MessagesOfITKLoseLocationClassAndPointer)
{
  ExpectFailure(1, "File not found: a (b): c", [](shapeton::CommandLine &) {
    itkGenericExceptionMacro("File not found: a (b): c");
  });
  ExpectFailure(1, "A spacing of 0 is not allowed: Spacing is [0, 0, 0]", [](shapeton::CommandLine &) {
    FailingObject::New()->Fail();
  });
  ExpectFailure(1, "no luck", [](shapeton::CommandLine &) {
    throw itk::ExceptionObject(
      "/there/itkFoo.h", 7, "Exception in a thread\n/there/itkBar.hxx:12:\nITK ERROR: Bar(0x7ffd10): no luck", "loc");
  });
  ExpectFailure(1, "no luck", [](shapeton::CommandLine &) {
    itkGenericExceptionMacro("Foo(0x7ffd20): not done:\nITK ERROR: Bar(0x7ffd10): no luck");
  });
  ExpectFailure(1, "the offset (0x10): too large", [](shapeton::CommandLine &) {
    itkGenericExceptionMacro("the offset (0x10): too large");
  });
  ExpectFailure(1, "plain words", [](shapeton::CommandLine &) {
    throw itk::ExceptionObject("/there/itkFoo.h", 7, "  plain \n\n words ", "loc");
  });
  ExpectFailure(1, "no luck", [](shapeton::CommandLine &) {
    throw std::runtime_error("/there/itkBar.hxx:12:\nITK ERROR: Bar(0x7ffd10): no luck");
  });
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
