#include "shapetonOptions.h"

#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

namespace shapeton
{
OptionInfo &
OptionInfo::AtLeast(double value, const char * text)
{
  m_Least = { value, text, false };
  return *this;
}

OptionInfo &
OptionInfo::Above(double value, const char * text)
{
  m_Least = { value, text, true };
  return *this;
}

OptionInfo &
OptionInfo::AtMost(double value, const char * text)
{
  m_Most = { value, text, false };
  return *this;
}

OptionInfo &
OptionInfo::Below(double value, const char * text)
{
  m_Most = { value, text, true };
  return *this;
}

OptionInfo &
OptionInfo::Words(std::vector<const char *> words)
{
  m_Words = std::move(words);
  return *this;
}

void
OptionInfo::Check(double value) const
{
  const auto require = [&](bool condition, const std::string & reason) {
    std::ostringstream number;
    number << std::setprecision(std::numeric_limits<int>::digits10 + 1) << value;
    RequireParameter(condition, "the parameter \"" + std::string(m_Name) + "\": " + number.str() + " is " + reason);
  };
  require(std::isfinite(value), "not a finite number");
  require(value >= m_Least.value, std::string("less than the minimum ") + m_Least.text);
  require(value <= m_Most.value, std::string("more than the maximum ") + m_Most.text);
  require(!m_Least.isExcluded || value != m_Least.value, std::string("not more than ") + m_Least.text);
  require(!m_Most.isExcluded || value != m_Most.value, std::string("not less than ") + m_Most.text);
}

void
OptionInfo::Check(const std::string & word) const
{
  if (!m_Words.empty())
  {
    this->PositionOf(word);
  }
}

std::size_t
OptionInfo::PositionOf(const std::string & word) const
{
  const auto  found = std::find(m_Words.begin(), m_Words.end(), word);
  std::string list;
  for (const char * one : m_Words)
  {
    list += (list.empty() ? "" : ", ") + std::string(one);
  }
  RequireParameter(found != m_Words.end(),
                   "the parameter \"" + std::string(m_Name) + "\": \"" + word + "\" is not one of " + list);
  return static_cast<std::size_t>(found - m_Words.begin());
}
} // namespace shapeton
