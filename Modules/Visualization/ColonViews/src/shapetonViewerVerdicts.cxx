#include "shapetonViewerVerdicts.h"

#include "shapetonExceptions.h"

namespace shapeton
{
namespace
{
[[noreturn]] void
Refuse(const std::string & path, const std::string & fault)
{
  throw InputError("the verdicts \"" + path + "\" " + fault);
}

/** Candidates of the second position have the ids "second/1", "second/2", ... */
std::string
IdOf(std::size_t position, const Json & candidate)
{
  return (position == 0 ? "" : "second/") + candidate.at("candidate").get<std::string>();
}

Eigen::Vector3d
PlaceOf(const Json & lps)
{
  return { lps.at(0).get<double>(), lps.at(1).get<double>(), lps.at(2).get<double>() };
}

void
Add(Markup & markup, const Eigen::Vector3d & place, const std::string & label, const Json & entry)
{
  markup.points.push_back(place);
  markup.labels.push_back(label);
  markup.descriptions.push_back(entry.value("note", std::string()));
}

void
AddCandidate(Markup & markup, const Json & verdict, const Json & positions)
{
  const auto id = verdict.at("id").get<std::string>();
  for (std::size_t position = 0; position < positions.size(); ++position)
  {
    for (const auto & candidate : positions[position].at("candidates"))
    {
      if (IdOf(position, candidate) == id)
      {
        Add(markup,
            PlaceOf({ candidate.at("x"), candidate.at("y"), candidate.at("z") }),
            "candidate " + id + ": " + verdict.at("verdict").get<std::string>(),
            verdict);
      }
    }
  }
}
} // namespace

Json
ReadVerdicts(const std::string & path, const Json & exam)
{
  Json verdicts = ReadJson(path);
  try
  {
    if (verdicts.at("version") != 1 && verdicts.at("version") != 2)
    {
      Refuse(path, "have an unsupported version; save them again");
    }
    if (verdicts.at("exam").at("sha256") != exam.at("sha256"))
    {
      Refuse(path, "belong to another examination; use verdicts saved for this one");
    }
    MarkupOfVerdicts(verdicts, Json::array());
  }
  catch (const Json::exception &)
  {
    Refuse(path, "were not saved by the viewer; save them again");
  }
  return verdicts;
}

Markup
MarkupOfVerdicts(const Json & verdicts, const Json & positions)
{
  Markup markup;
  markup.name = "Verdicts";
  for (const auto & verdict : verdicts.at("candidates"))
  {
    AddCandidate(markup, verdict, positions);
  }
  for (const auto & finding : verdicts.at("findings"))
  {
    Add(markup, PlaceOf(finding.at("lps")), "finding " + finding.at("id").get<std::string>(), finding);
  }
  return markup;
}
} // namespace shapeton
