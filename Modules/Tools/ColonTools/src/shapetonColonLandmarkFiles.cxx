#include "shapetonToolSurfaces.h"
#include "shapetonColonLandmarkFiles.h"

#include "shapetonColorTable.h"
#include "shapetonCommandLine.h"
#include "shapetonExaminationFiles.h"
#include "shapetonJson.h"
#include "shapetonRegistrationFolder.h"
#include "shapetonSha256.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonExceptions.h"

#include <array>
#include <filesystem>

namespace shapeton
{
namespace
{
constexpr std::array<double, 3> yellow{ 1.0, 0.85, 0.2 };
constexpr std::array<double, 3> red{ 0.9, 0.2, 0.2 };
constexpr std::array<double, 3> green{ 0.25, 0.8, 0.35 };

/** Distances of the control points of markups, mm. */
constexpr double spacingOfTaeniae = 10.0;
constexpr double spacingOfFlexures = 5.0;

bool
EndsWith(const std::string & text, const std::string & end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

void
RemoveOld(const std::string & path)
{
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
}
} // namespace

ColonLandmarkFiles::ColonLandmarkFiles(CommandLine & commandLine, const std::string & folder)
  : m_CommandLine(commandLine), m_Folder(folder), m_Scene(commandLine, { { "wallModel", examination::segments.name } })
{
  commandLine.MakeFolder(folder);
  commandLine.RecordRun(this->PathOf("run.json"));
}

std::string
ColonLandmarkFiles::PathOf(const std::string & name) const
{
  return m_Folder + '/' + name;
}

void
ColonLandmarkFiles::WriteOrRemove(const std::string & name, const CurveSet & curves) const
{
  if (curves.curves.empty())
  {
    RemoveOld(this->PathOf(name));
    return;
  }
  CurveSet withFacts = curves;
  withFacts.facts = m_CommandLine.GetProvenance();
  WriteCurves(withFacts, m_CommandLine.Output(this->PathOf(name)));
}

void
ColonLandmarkFiles::WriteOrRemove(const std::string & name, const std::vector<Markup> & markups) const
{
  if (markups.empty())
  {
    RemoveOld(this->PathOf(name));
    return;
  }
  WriteMarkups(markups, m_CommandLine.Output(this->PathOf(name)));
}

void
ColonLandmarkFiles::WriteTaeniaMarkups(const CurveSet & taeniae) const
{
  std::vector<Markup> markups;
  for (std::size_t t = 0; t < taeniae.curves.size(); ++t)
  {
    markups.push_back(MarkupOfCurve(taeniae, t, Markup::Kind::Curve, spacingOfTaeniae));
    markups.back().name = "taenia-" + std::to_string(t + 1);
    markups.back().color = yellow;
  }
  this->WriteOrRemove(examination::taeniaMarkups.name, markups);
}

void
ColonLandmarkFiles::WriteFlexureMarkups(const ColonLandmarks & landmarks, const CurveSet & loops) const
{
  Markup points;
  points.name = "flexures";
  points.color = red;
  std::vector<Markup> markups;
  for (const SegmentBorder & border : landmarks.segments.borders)
  {
    if (border.number > 4)
    {
      continue;
    }
    points.points.push_back(border.point);
    points.labels.push_back(NameOfFlexure(border.number));
    points.descriptions.push_back("confidence " + std::to_string(static_cast<int>(100.0 * border.confidence)) + " %");
    markups.push_back(MarkupOfCurve(loops, markups.size(), Markup::Kind::ClosedCurve, spacingOfFlexures));
    markups.back().name = NameOfFlexure(border.number) + "-loop";
    markups.back().color = points.color;
  }
  if (!markups.empty())
  {
    markups.insert(markups.begin(), points);
  }
  this->WriteOrRemove(examination::flexureMarkups.name, markups);
}

void
ColonLandmarkFiles::WriteValveMarkup(const std::optional<IleocecalValve> & valve) const
{
  std::vector<Markup> markups;
  if (valve)
  {
    Markup & markup = markups.emplace_back();
    markup.name = "ileocecal-valve";
    markup.color = green;
    markup.points = { valve->position };
    markup.labels = { "ileocecal valve" };
    markup.descriptions = { "confidence " + std::to_string(static_cast<int>(100.0 * valve->confidence)) + " %" };
  }
  this->WriteOrRemove(examination::valveMarkup.name, markups);
}

void
ColonLandmarkFiles::WriteDocument(const ColonLandmarks & landmarks, const ColonPieces * pieces) const
{
  Json document = ColonLandmarksToJson(landmarks);
  if (pieces != nullptr)
  {
    document["pieces"] = ColonPiecesToJson(*pieces);
  }
  m_CommandLine.WriteDocument(document, m_CommandLine.Output(this->PathOf(examination::landmarks.name)));
}

void
ColonLandmarkFiles::WritePieces(const ColonPieces * pieces) const
{
  for (int segment = 1; pieces != nullptr && segment <= 6; ++segment)
  {
    const std::string  path = this->PathOf("segment-" + NameOfSegment(segment) + ".vtp");
    const ColonPiece * made = nullptr;
    for (const ColonPiece & piece : pieces->pieces)
    {
      made = piece.segment == segment ? &piece : made;
    }
    if (made != nullptr)
    {
      WriteSurface(made->flat, m_CommandLine.GetProvenance(), m_CommandLine.Output(path));
    }
    else
    {
      RemoveOld(path);
    }
  }
}

void
ColonLandmarkFiles::Write(const SurfaceMesh & flat, const ColonLandmarks & landmarks, const ColonPieces * pieces) const
{
  CurveSet taeniae = TaeniaCurves(landmarks.taeniae);
  if (landmarks.hindered)
  {
    MarkHindrances(*landmarks.hindered, taeniae);
  }
  const CurveSet loops = FlexureCurves(landmarks);
  this->WriteOrRemove(examination::taeniae.name, taeniae);
  this->WriteOrRemove(examination::flexures.name, loops);
  const std::string segments = m_CommandLine.Output(this->PathOf(examination::segments.name));
  WriteSurface(SegmentSurface(flat, landmarks), m_CommandLine.GetProvenance(), segments);
  m_Scene.Copy(examination::segments.name, segments);
  WriteSurface(FoldSurface(flat, landmarks),
               m_CommandLine.GetProvenance(),
               m_CommandLine.Output(this->PathOf(examination::foldsSurface.name)));
  this->WriteTaeniaMarkups(taeniae);
  this->WriteFlexureMarkups(landmarks, loops);
  this->WriteValveMarkup(landmarks.valve);
  this->WritePieces(pieces);
  this->WriteDocument(landmarks, pieces);
}

std::array<int, 3>
ReadTaeniaNumbers(CommandLine & commandLine, const std::string & parameter)
{
  const std::string path = commandLine.GetString(parameter);
  commandLine.AddInput(parameter, "sha256:" + Sha256OfFile(path));
  const auto numbers = TaeniaNumbersOfRegistration(path);
  if (!numbers)
  {
    throw InputError(
      '"' + path +
      "\" does not tell which taeniae of both positions are the same (taeniae.proneOfSupine); leave out the option "
      "--" +
      parameter + ", and both positions keep their own numbers");
  }
  return *numbers;
}

std::vector<Eigen::Vector3d>
ReadTaeniaMarkers(CommandLine & commandLine, const std::string & parameter)
{
  std::vector<Eigen::Vector3d> points;
  const std::string            path = commandLine.GetString(parameter);
  if (EndsWith(path, ".json"))
  {
    for (const Markup & markup : ReadMarkups(commandLine, parameter))
    {
      points.insert(points.end(), markup.points.begin(), markup.points.end());
    }
  }
  else
  {
    RequireParameter(EndsWith(path, ".vtp"),
                     "--" + parameter + " requires VTP points or markups of 3D Slicer (.mrk.json), not \"" + path +
                       '"');
    const CurveSet curves = ReadCurves(commandLine, parameter);
    for (Eigen::Index i = 0; i < curves.V.rows(); ++i)
    {
      points.push_back(curves.V.row(i).transpose());
    }
  }
  if (points.empty())
  {
    throw InputError('"' + path + "\" contains no marker points");
  }
  return points;
}
} // namespace shapeton
