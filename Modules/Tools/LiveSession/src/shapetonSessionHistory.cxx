#include "shapetonSessionHistory.h"

#include "shapetonCsvTable.h"
#include "shapetonExceptions.h"
#include "shapetonSessionCommands.h"

namespace shapeton
{
namespace
{
/** The value of an option: a word, a number or two numbers. */
std::string
TextOf(const Json & value)
{
  return value.is_array()    ? "[" + TextOf(value[0]) + ", " + TextOf(value[1]) + "]"
         : value.is_number() ? CsvTable::Number(value.get<double>())
         : value.is_string() ? value.get<std::string>()
                             : "none";
}
} // namespace

std::string
ChangesBetween(const SessionValues & before, const SessionValues & after)
{
  std::string text;
  const auto  add = [&](const std::string & name, const Json & from, const Json & to, const std::string & unit) {
    if (from != to)
    {
      text += (text.empty() ? "" : ", ") + name + " " + TextOf(from) + " -> " + TextOf(to) + unit;
    }
  };
  const Json options = JsonOfOptions(after.options);
  const Json optionsBefore = JsonOfOptions(before.options);
  for (const auto & [name, value] : options.items())
  {
    add(name, optionsBefore[name], value, "");
  }
  add("time of heat", before.heatSteps, after.heatSteps, " steps");
  add("barrier", before.barrierVoxels, after.barrierVoxels, " voxels");
  return text;
}

void
SessionHistory::Add(const SessionValues & before, const std::string & kind)
{
  if (kind.empty() || kind != m_Kind)
  {
    m_Before.push_back(before);
  }
  m_After.clear();
  m_Kind = kind;
}

SessionValues
SessionHistory::Undo(const SessionValues & now)
{
  RequireParameter(!m_Before.empty(), "there is no change to undo");
  return this->Swap(now, m_Before, m_After);
}

SessionValues
SessionHistory::Redo(const SessionValues & now)
{
  RequireParameter(!m_After.empty(), "there is no change to redo");
  return this->Swap(now, m_After, m_Before);
}

SessionValues
SessionHistory::Swap(const SessionValues & now, std::vector<SessionValues> & from, std::vector<SessionValues> & to)
{
  to.push_back(now);
  const SessionValues values = from.back();
  from.pop_back();
  m_Kind.clear();
  return values;
}
} // namespace shapeton
