#include "shapetonColonViewer.h"

#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonHtmlReport.h"
#include "shapetonPolypSearch.h"
#include "shapetonReaderVerdicts.h"
#include "shapetonRegistrationFolder.h"
#include "shapetonScriptPage.h"
#include "shapetonViewerPosition.h"
#include "shapetonWarningKinds.h"

#include <filesystem>

namespace shapeton
{
extern const char * const ViewerScript[];
extern const char * const ViewerStyle[];

namespace
{
constexpr const char * colonViewerName = "ColonViewer"; // the tool, for the files that it is declared to read

/** Empty if the positions are not registered. */
std::string
RegistrationOf(const ExaminationFolder & exam, const ColonViewerOptions & options)
{
  const std::string ofRun = exam.GetFolder() + '/' + examination::registration.stage;
  return options.second.empty() && exam.Has(examination::supineToProne) ? ofRun : options.registration;
}

std::string
NameOfFolder(const std::string & path)
{
  return std::filesystem::weakly_canonical(path).filename().string();
}

std::string
TitleOf(const std::string & exam, const ColonViewerOptions & options)
{
  if (options.isAnonymous)
  {
    return "Examination";
  }
  return NameOfFolder(exam) + (options.second.empty() ? "" : " and " + NameOfFolder(options.second));
}

/** Takes the patient from the positions; named once if all agree. */
std::string
PatientOfAll(Json & positions, bool isAnonymous)
{
  std::string all;
  for (auto & position : positions)
  {
    const std::string patient = position["patient"];
    position.erase("patient");
    if (!isAnonymous && !patient.empty() && all != patient)
    {
      all += (all.empty() ? "" : " / ") + patient;
    }
  }
  return all;
}

Json
Identity(Json & positions, const ColonExamination & exam, bool isAnonymous)
{
  Json series = Json::array();
  for (auto & position : positions)
  {
    const std::string uid = position["seriesUID"];
    position.erase("seriesUID");
    if (!uid.empty() && !isAnonymous)
    {
      series.push_back(uid);
    }
  }
  return { { "seriesUIDs", series }, { "sha256", exam.Digest() } };
}

/** What the reports of the positions of one run state that it does not show; that of the second one with its name. */
Json
StatedBy(const std::vector<ExaminationFolder> & folders, const Json & positions)
{
  Json stated{ { "note", "" }, { "limitations", Json::array() } };
  for (std::size_t k = 0; k < folders.size(); ++k)
  {
    if (!folders[k].Has(examination::limitations))
    {
      continue;
    }
    const Json one = ReadJson(folders[k].PathOf(examination::limitations));
    stated["note"] = k == 0 ? one.at("note") : stated["note"];
    for (const Json & text : one.at("limitations"))
    {
      const std::string name = positions[k].at("name");
      stated["limitations"].push_back((k == 0 ? "" : name + ": ") + text.get<std::string>());
    }
  }
  return stated;
}

/** Combines warnings that differ only in numbers. */
Json
WarningsForPage(const std::vector<std::string> & warnings)
{
  Json kinds = Json::array();
  for (const WarningKind & kind : KindsOf(warnings))
  {
    kinds.push_back({ { "text", kind.text }, { "warnings", kind.warnings } });
  }
  return kinds;
}

/** Names the lesions of candidates of two positions. */
void
NameLesions(const ColonExamination & exam, Json & positions)
{
  if (positions.size() < 2)
  {
    return;
  }
  const auto candidates = exam.ReadCandidates();
  for (const PolypLesion & lesion : LesionsOfPositions(candidates[0], candidates[1]))
  {
    for (const std::size_t k : { 0, 1 })
    {
      for (Json & candidate : positions[k]["candidates"])
      {
        if (candidate["candidate"] == std::to_string(k == 0 ? lesion.first : lesion.second))
        {
          candidate["lesion"] = lesion.letter;
          candidate["lesionSize"] = lesion.size;
        }
      }
    }
  }
}

/** The valve decided from both positions, as in the report: it may be unknown although one position shows a place. */
void
PlaceValves(const std::string & registration, Json & positions)
{
  for (std::size_t k = 0; k < positions.size(); ++k)
  {
    if (const auto search = ValveOfRegistration(registration, static_cast<int>(k)))
    {
      const auto & valve = search->valve;
      positions[k]["valve"] =
        valve ? Json{ valve->position.x(), valve->position.y(), valve->position.z() } : Json(nullptr);
    }
  }
}

/** Orders the taeniae of the second position as those of the first, so that both have the same colors. */
void
OrderTaeniae(const std::string & registration, Json & positions)
{
  const auto numbers = TaeniaNumbersOfRegistration(registration + '/' + examination::registration.name);
  const Json taeniae = positions[1]["taeniae"];
  for (std::size_t i = 0; numbers && i < taeniae.size(); ++i)
  {
    positions[1]["taeniae"][i] = taeniae[(*numbers)[i] - 1];
  }
}

/** Adds both maps; false if there are none. */
bool
PutMaps(PageBlocks & blocks, const std::vector<ExaminationFolder> & positions, const std::string & registration)
{
  if (positions.size() < 2 || registration.empty())
  {
    return false;
  }
  PutViewerMap(blocks, "0/", positions[0], registration + '/' + examination::supineToProne.name);
  PutViewerMap(blocks, "1/", positions[1], registration + '/' + examination::proneToSupine.name);
  return true;
}
} // namespace

void
WriteColonViewer(const std::string &        folderOfExam,
                 const std::string &        folder,
                 const ColonViewerOptions & options,
                 const OutputPath &         outputPath)
{
  RequireParameter(options.bits == 8 || options.bits == 16, "the parameter \"bits\" must be 8 or 16");
  RequireParameter(options.near >= 0.0 && options.near <= 100.0, "the parameter \"near\" must be from 0 to 100 mm");
  RequireParameter(options.registration.empty() || !options.second.empty(),
                   "the parameter \"registration\" requires \"second\"");
  const ColonExamination exam(folderOfExam, options.second, colonViewerName);
  PageBlocks             blocks(folder + "/data", options.isSingle, outputPath);
  Json                   positions = Json::array();
  for (const ExaminationFolder & position : exam.GetPositions())
  {
    positions.push_back(PutViewerPosition(blocks, std::to_string(positions.size()) + "/", position, options));
  }
  NameLesions(exam, positions);
  Json info;
  info["title"] = TitleOf(folderOfExam, options);
  info["patient"] = PatientOfAll(positions, options.isAnonymous);
  info["exam"] = Identity(positions, exam, options.isAnonymous);
  info["bits"] = options.bits;
  info["isSecondReader"] = options.isSecondReader;
  info["warnings"] = WarningsForPage(options.warnings);
  info["stated"] = StatedBy(options.second.empty() ? exam.GetPositions() : std::vector<ExaminationFolder>(), positions);
  const std::string registration = RegistrationOf(exam.GetPositions().front(), options);
  info["hasMap"] = PutMaps(blocks, exam.GetPositions(), registration);
  if (info["hasMap"].get<bool>())
  {
    PlaceValves(registration, positions);
    OrderTaeniae(registration, positions);
  }
  if (!options.verdicts.empty())
  {
    const ReaderVerdicts verdicts = ReadReaderVerdicts(options.verdicts, exam);
    info["verdicts"] = ReadJson(options.verdicts);
    WriteMarkups({ MarkupOfVerdicts(verdicts, exam.ReadCandidates()) }, outputPath(folder + "/verdicts.mrk.json"));
  }
  info["positions"] = std::move(positions);
  blocks.PutJson("info", info);
  const ScriptPage page{ "Colon viewer",
                         PageText(ViewerStyle),
                         PageText(ViewerScript),
                         std::string("startColonViewer(") + (options.isSingle ? "null" : "'data'") + ");" };
  WriteFileBytes(outputPath(folder + '/' + examination::viewerPage.name), TextOf(page, blocks));
}
} // namespace shapeton
