#include "shapetonExceptions.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{
const unsigned int lineOfThrow = __LINE__ + 6;

template <typename TException>
unsigned int
Throw(const std::string & description)
{
  throw TException(description);
}

template <typename TException>
void
ExpectWhole(const std::string & name)
{
  try
  {
    Throw<TException>("the message");
    FAIL() << "nothing was thrown";
  }
  catch (const itk::ExceptionObject & error) // as an ITK pipeline catches it
  {
    EXPECT_STREQ(error.what(), "the message");
    EXPECT_STREQ(error.GetDescription(), "the message");
    EXPECT_EQ(error.GetNameOfClass(), name);
    EXPECT_NE(std::string(error.GetFile()).find("ExceptionsGTest.cxx"), std::string::npos);
    EXPECT_EQ(error.GetLine(), lineOfThrow);
    EXPECT_EQ(std::string(error.GetLocation()).rfind("Throw", 0), 0U);
    std::ostringstream printed;
    printed << error;
    EXPECT_NE(printed.str().find(name), std::string::npos);
    EXPECT_NE(printed.str().find("the message"), std::string::npos);
    EXPECT_NE(printed.str().find("ExceptionsGTest.cxx"), std::string::npos);
  }
}

TEST(Exceptions, AreItkExceptionsThatNameTheirPlace)
{
  ExpectWhole<shapeton::ParameterError>("ParameterError");
  ExpectWhole<shapeton::InputError>("InputError");
  ExpectWhole<shapeton::OutputError>("OutputError");
}

TEST(Exceptions, AreToldApart)
{
  EXPECT_THROW(throw shapeton::InputError("a"), shapeton::Exception);
  bool isParameter = false;
  try
  {
    throw shapeton::InputError("a");
  }
  catch (const shapeton::ParameterError &)
  {
    isParameter = true;
  }
  catch (const shapeton::InputError &)
  {}
  EXPECT_FALSE(isParameter);
}

TEST(Exceptions, ARequirementNamesThePlaceThatRequires)
{
  EXPECT_NO_THROW(shapeton::RequireParameter(true, "a"));
  try
  {
    shapeton::RequireParameter(false, "p must be positive");
    FAIL() << "nothing was thrown";
  }
  catch (const shapeton::ParameterError & error)
  {
    EXPECT_STREQ(error.what(), "p must be positive");
    EXPECT_NE(std::string(error.GetFile()).find("ExceptionsGTest.cxx"), std::string::npos);
  }
}
} // namespace

TEST(Exceptions, ReferencesToParametersAreSpelledByTheCaller)
{
  const auto spelled = [](const std::string & text) {
    return shapeton::SpellParameters(
      text, [](const std::string & name, bool hasValue) { return '<' + name + (hasValue ? ":" : "") + '>'; });
  };
  EXPECT_EQ(spelled("give the parameter \"p\" = 2, or omit the parameter \"time_2\""), "give <p:>2, or omit <time_2>");
  EXPECT_EQ(spelled("the parameter \"\" and the parameter \"a b\" and the parameter \"end"),
            "the parameter \"\" and the parameter \"a b\" and the parameter \"end");
  EXPECT_EQ(spelled(""), "");
}

TEST(Exceptions, ThePrefixOfITKIsRemoved)
{
  EXPECT_EQ(shapeton::WithoutItkPrefix("/a/itkFoo.h:3:\nITK ERROR: Foo(0x55d0c0a8): no luck"), "no luck");
  EXPECT_EQ(shapeton::WithoutItkPrefix("no luck (0x1): here"), "no luck (0x1): here");
}
