#include "shapetonStage.h"

namespace shapeton
{
namespace
{
using Kind = Stage::Argument::Kind;
} // namespace

Stage::Stage(const std::string & name, const std::string & program) : m_Name(name), m_Program(program) {}

Stage &
Stage::Option(const std::string & flag, const std::string & value)
{
  m_Arguments.push_back({ Kind::Option, flag, value, {}, {} });
  return *this;
}

Stage &
Stage::Idle(const std::string & flag, const std::string & value)
{
  m_Arguments.push_back({ Kind::Idle, flag, value, {}, {} });
  return *this;
}

Stage &
Stage::Input(const std::string & flag, const std::string & path, const Identity & identity)
{
  m_Arguments.push_back({ Kind::Input, flag, path, identity, {} });
  return *this;
}

Stage &
Stage::InputFolder(const std::string & flag, const std::string & path, const std::vector<std::string> & files)
{
  m_Arguments.push_back({ Kind::Input, flag, path, {}, files });
  return *this;
}

Stage &
Stage::Output(const std::string & flag, const std::string & name)
{
  m_Arguments.push_back({ Kind::Output, flag, name, {}, {} });
  return name.empty() ? *this : this->Expect({ name });
}

Stage &
Stage::Expect(const std::vector<std::string> & names)
{
  m_Expected.insert(m_Expected.end(), names.begin(), names.end());
  return *this;
}

std::vector<std::string>
Stage::CommandIn(const std::string & folder) const
{
  std::vector<std::string> positional{ "--" }; // a path may begin with a hyphen
  std::vector<std::string> command;
  for (const Argument & argument : m_Arguments)
  {
    const bool        isInFolder = argument.kind == Kind::Output;
    const std::string value = !isInFolder              ? argument.value
                              : argument.value.empty() ? folder
                                                       : folder + '/' + argument.value;
    if (argument.flag.empty())
    {
      positional.push_back(value);
    }
    else
    {
      command.push_back("--" + argument.flag + '=' + value);
    }
  }
  command.insert(command.end(), positional.begin(), positional.end());
  return command;
}
} // namespace shapeton
