// Numbers and names of taeniae in two positions of patients whose taeniae are where anatomy has them.
#include "BoundTable.h"
#include "RegistrationTrial.h"

using namespace shapeton;

namespace
{
LandmarkExam
MakeAnatomicalExam(unsigned int seed, const std::string & position)
{
  LandmarkCase one = ValidationCase("realistic", seed, position, 0.8, false);
  one.parameters.anatomicalTaeniae = true;
  ValidationReport::Progress("colon-taeniae: " + NameOfCase(one));
  return MakeLandmarkExam(one);
}

/** "right", "wrong", or why unknown. */
std::string
InWords(bool areKnown, bool areRight, const std::string & reason)
{
  return areKnown ? areRight ? "right" : "wrong" : "unknown" + (reason.empty() ? "" : ": " + reason);
}

/** Counts of one kind of answer. */
struct Answers
{
  int right{ 0 };
  int wrong{ 0 };
  int all{ 0 };

  void
  Add(bool areKnown, bool areRight)
  {
    right += areKnown && areRight;
    wrong += areKnown && !areRight;
    ++all;
  }
};

void
Summarize(const Answers & numbers, const Answers & names, ValidationReport & report)
{
  BoundTable table(report, true);
  table.AddShare("patients with the same numbers in both positions", AtLeast(0.95), numbers.right, numbers.all);
  table.AddBounded("patients with wrong numbers", "0", std::to_string(numbers.wrong), {}, numbers.wrong == 0);
  table.AddBounded("positions with wrong names", "0", std::to_string(names.wrong), {}, names.wrong == 0);
  table.AddFact("positions with right names", RatioOf(names.right, names.all));
  table.Write("measures");
}
} // namespace

void
ValidateTaeniae(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText("Synthetic patients (preset realistic, " + settings.SeedsInWords() +
                 ") with the parameter anatomicalTaeniae: the libera is in front of ascending and descending and below "
                 "the transverse colon, up to torsion and drift. True lumen in voxels of 0.8 mm.");
  CsvTable table(Columns("patient | numbers | probability | share | names, supine | names, prone"));
  Answers  numbers;
  Answers  names;
  for (const unsigned int seed : settings.Seeds(20, "realistic"))
  {
    const RegistrationScore score =
      TryRegistration(MakeAnatomicalExam(seed, "supine"), MakeAnatomicalExam(seed, "prone"), false, false);
    std::vector<std::string> row{ "seed " + std::to_string(seed),
                                  InWords(score.taeniae.areKnown, score.taeniae.areRight, score.failure),
                                  Rounded(score.taeniae.probability),
                                  Rounded(score.taeniae.share) };
    numbers.Add(score.taeniae.areKnown, score.taeniae.areRight);
    for (const TaeniaNameScore & one : score.names)
    {
      row.push_back(InWords(one.areKnown, one.areRight, one.reason));
      names.Add(one.areKnown, one.areRight);
    }
    ValidationReport::Progress("  " + row[1] + ", " + row[4] + ", " + row[5]);
    table.AddRow(row);
  }
  Summarize(numbers, names, report);
  report.AddRows("patients", table);
}
