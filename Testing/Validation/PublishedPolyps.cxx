// Polyp candidates by shapetons (dissertation 3.5.2): few or many visits?
#include "Tables.h"
#include "ValidationReport.h"
#include "PolypPair.h"
#include "PolypTrial.h"

#include "shapetonPolypShapeDiffusion.h"

#include <algorithm>

using namespace shapeton;

namespace
{
constexpr double spacing = 1.4;       // mm; coarse, because the walk of the whole colon is slow
constexpr double leastDiameter = 6.0; // mm; smaller polyps are not counted
constexpr double anySensitivity = 1.0;
constexpr double anyScore = 1e-9;

struct Search
{
  std::string                                                   name;
  std::function<std::vector<PolypCandidate>(const ColonExam &)> find;
  double                                                        score; ///< of a candidate that counts
  std::vector<PolypExam>                                        exams;
};

std::vector<PolypCandidate>
FindByVisits(const ColonExam & exam, VisitedWall visited)
{
  PublishedPolypOptions options;
  options.sensitivity = anySensitivity;
  options.visited = visited;
  return FindPublishedPolypCandidates(exam.wall, exam.lumen, exam.ct, options);
}

std::vector<Search>
Searches()
{
  return {
    { "published: few visits",
      [](const ColonExam & exam) { return FindByVisits(exam, VisitedWall::Least); },
      anyScore,
      {} },
    { "many visits", [](const ColonExam & exam) { return FindByVisits(exam, VisitedWall::Most); }, anyScore, {} },
    { "default preset",
      [](const ColonExam & exam) { return FindJudgedCandidates(exam, defaultPolypSensitivity); },
      1.0 - defaultPolypSensitivity,
      {} }
  };
}

double
FalsePerExam(const Search & search)
{
  double falses = 0.0;
  for (const PolypExam & exam : search.exams)
  {
    falses += CountFrom(exam.falseScores, search.score);
  }
  return falses / static_cast<double>(std::max<std::size_t>(1, search.exams.size()));
}
} // namespace

void
ValidatePublishedPolyps(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("First synthetic patient of each preset (" + settings.SeedsInWords() +
                 "), supine, wall and cleansed CT computed from CT of 1.4 mm. Few visits is the end of the color scale "
                 "that shows the polyp in Figure 3.10 of the dissertation (blue, see 3.4). Both ends list all their "
                 "candidates, the default preset those of its default sensitivity. Polyps below 6 mm and in collapsed "
                 "sections are not counted. Found: see `colon-polyps`.");
  std::vector<Search> searches = Searches();
  for (const std::string & preset : settings.presets)
  {
    const LandmarkCase one = ValidationCase(preset, settings.Seeds(1, preset).front(), "supine", spacing, true);
    ValidationReport::Progress(preset + ": " + NameOfCase(one));
    const ColonExam exam = MakeColonExam(one);
    report.AddText(preset + ", " + NameOfCase(one) + " is modeled: " + report.Check(exam.failure.empty()));
    for (Search & search : searches)
    {
      search.exams.push_back(
        ComparePolyps(one, *exam.anatomy, exam.failure.empty() ? search.find(exam) : std::vector<PolypCandidate>()));
    }
  }
  CsvTable table(
    Columns("search | sessile and pedunculated polyps >= 6 mm found | flat polyps >= 6 mm found | false per exam"));
  for (const Search & search : searches)
  {
    const auto found = [&](bool isFlat) {
      return ShareWithBound(CountFound(search.exams, { isFlat, leastDiameter, 1000.0 }, search.score));
    };
    table.AddRow({ search.name, found(false), found(true), Rounded(FalsePerExam(search)) });
  }
  report.AddTable(table);
}
