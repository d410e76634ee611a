#ifndef shapetonReaderTestExam_h
#define shapetonReaderTestExam_h

#include "shapetonBase64Text.h"
#include "shapetonJson.h"
#include "shapetonPolypSearch.h"
#include "shapetonReaderVerdicts.h"

#include <filesystem>
#include <string>
#include <vector>

namespace readertest
{
/** Bytes of a one-pixel PNG file. */
inline std::string
OnePixelPng()
{
  return *shapeton::BytesOfBase64(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==");
}

/** Writes the candidates of a run: in this order, candidates of 12, 7 and 4 mm in the sigmoid, 10, 20 and 30 cm from
 * the anal verge. */
inline void
WriteCandidates(const std::string & folder)
{
  constexpr double                      sizes[] = { 12.0, 7.0, 4.0 };
  std::vector<shapeton::PolypCandidate> candidates;
  for (int i = 0; i < 3; ++i)
  {
    shapeton::PolypCandidate candidate;
    candidate.number = i + 1;
    candidate.score = 0.9 - 0.1 * i;
    candidate.position = { 1.0 * i, 2.0, 3.0 };
    candidate.segment = 2;
    candidate.arcLength = 100.0 * (i + 1);
    candidate.diameter = sizes[i];
    candidate.morphology = shapeton::PolypMorphology::Sessile;
    candidates.push_back(candidate);
  }
  std::filesystem::create_directories(folder + "/polyps");
  shapeton::TableOfPolypCandidates(candidates).Write(folder + "/polyps/candidates.csv");
}

/** Version 2 verdicts on this run: candidate 1 is a 9 mm pedunculated polyp, 2 is unsure, 3 is unread; an 11 mm
 * finding; a bookmark; category C3. */
inline shapeton::Json
Verdicts(const std::string & folder)
{
  using shapeton::Json;
  Json verdicts;
  verdicts["version"] = 2;
  verdicts["exam"] = { { "seriesUIDs", Json::array() }, { "sha256", shapeton::ColonExamination(folder).Digest() } };
  verdicts["secondReader"] = true;
  verdicts["assessment"] = { { "colonic", "C3" }, { "extracolonic", "" }, { "note", "" } };
  verdicts["candidates"] = {
    { { "id", "1" },
      { "verdict", "polyp" },
      { "note", "on a <fold>" },
      { "size", 9 },
      { "morphology", "pedunculated" } },
    { { "id", "2" }, { "verdict", "unsure" }, { "note", "" }, { "size", nullptr }, { "morphology", "" } },
    { { "id", "3" }, { "verdict", "unread" }, { "note", "" } }
  };
  verdicts["findings"] = { { { "id", "F1" },
                             { "position", 0 },
                             { "lps", { 4, 5, 6 } },
                             { "uv", { 7, 8 } },
                             { "diameter", 11.0 },
                             { "note", "" },
                             { "segment", "cecum" },
                             { "arcLength", 1400.5 },
                             { "morphology", "flat" } } };
  verdicts["bookmarks"] = { { { "id", "B1" },
                              { "position", 0 },
                              { "lps", { 4, 5, 6 } },
                              { "label", "behind the valve" },
                              { "picture", "data:image/png;base64," + shapeton::Base64(OnePixelPng()) } } };
  return verdicts;
}
} // namespace readertest

#endif
