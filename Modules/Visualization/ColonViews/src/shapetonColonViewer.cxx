#include "shapetonColonViewer.h"

#include "shapetonExceptions.h"
#include "shapetonFileBytes.h"
#include "shapetonHtmlReport.h"
#include "shapetonPolypSearch.h"
#include "shapetonReaderVerdicts.h"
#include "shapetonScriptPage.h"
#include "shapetonViewerPosition.h"
#include "shapetonVolume.h"
#include "shapetonWarningKinds.h"

#include <filesystem>

namespace shapeton
{
extern const char * const ViewerScript[];
extern const char * const ViewerStyle[];

namespace
{
bool
Exists(const std::string & path)
{
  return std::filesystem::exists(path);
}

/** Empty if the positions are not registered. */
std::string
RegistrationOf(const std::string & exam, const ColonViewerOptions & options)
{
  const std::string ofRun = exam + "/registration";
  return options.second.empty() && Exists(ofRun + "/map-supine-to-prone.vtp") ? ofRun : options.registration;
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

Json
Identity(Json & positions, const std::vector<std::string> & folders, bool isAnonymous)
{
  Json series = Json::array();
  for (auto & position : positions)
  {
    const std::string uid = SeriesOfIdentity(position["seriesUID"]);
    position.erase("seriesUID");
    if (!uid.empty() && !isAnonymous)
    {
      series.push_back(uid);
    }
  }
  return { { "seriesUIDs", series }, { "sha256", DigestOfPositions(folders) } };
}

/** Warnings that differ only in numbers, together. */
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
NameLesions(const std::vector<std::string> & folders, Json & positions)
{
  if (folders.size() < 2)
  {
    return;
  }
  const auto candidates = CandidatesOfPositions(folders);
  for (const PolypLesion & lesion : LesionsOfPositions(candidates[0], candidates[1]))
  {
    for (const std::size_t k : { 0, 1 })
    {
      for (Json & candidate : positions[k]["candidates"])
      {
        if (candidate["candidate"] == std::to_string(k == 0 ? lesion.first : lesion.second))
        {
          candidate["lesion"] = lesion.letter;
        }
      }
    }
  }
}

/** Adds both maps; false if there are none. */
bool
PutMaps(PageBlocks & blocks, const std::vector<std::string> & folders, const std::string & registration)
{
  if (folders.size() < 2 || registration.empty())
  {
    return false;
  }
  PutViewerMap(blocks, "0/", folders[0], registration + "/map-supine-to-prone.vtp");
  PutViewerMap(blocks, "1/", folders[1], registration + "/map-prone-to-supine.vtp");
  return true;
}
} // namespace

void
WriteColonViewer(const std::string &        exam,
                 const std::string &        folder,
                 const ColonViewerOptions & options,
                 const OutputPath &         outputPath)
{
  RequireParameter(options.bits == 8 || options.bits == 16, "the parameter \"bits\" must be 8 or 16");
  RequireParameter(options.near >= 0.0 && options.near <= 100.0, "the parameter \"near\" must be from 0 to 100 mm");
  RequireParameter(options.registration.empty() || !options.second.empty(),
                   "the parameter \"registration\" requires \"second\"");
  const std::vector<std::string> folders = PositionFoldersOf(exam, options.second);
  PageBlocks                     blocks(folder + "/data", options.isSingle, outputPath);
  Json                           positions = Json::array();
  for (std::size_t k = 0; k < folders.size(); ++k)
  {
    positions.push_back(PutViewerPosition(blocks, std::to_string(k) + "/", folders[k], options));
  }
  NameLesions(folders, positions);
  Json info;
  info["title"] = TitleOf(exam, options);
  info["exam"] = Identity(positions, folders, options.isAnonymous);
  info["bits"] = options.bits;
  info["isSecondReader"] = options.isSecondReader;
  info["warnings"] = WarningsForPage(options.warnings);
  info["hasMap"] = PutMaps(blocks, folders, RegistrationOf(exam, options));
  if (!options.verdicts.empty())
  {
    const ReaderVerdicts verdicts = ReadReaderVerdicts(options.verdicts, folders);
    info["verdicts"] = ReadJson(options.verdicts);
    WriteMarkups({ MarkupOfVerdicts(verdicts, CandidatesOfPositions(folders)) },
                 outputPath(folder + "/verdicts.mrk.json"));
  }
  info["positions"] = std::move(positions);
  blocks.PutJson("info", info);
  const ScriptPage page{ "Colon viewer",
                         PageText(ViewerStyle),
                         PageText(ViewerScript),
                         std::string("startColonViewer(") + (options.isSingle ? "null" : "'data'") + ");" };
  WriteFileBytes(outputPath(folder + "/viewer.html"), TextOf(page, blocks));
}
} // namespace shapeton
