#include "shapetonColonReport.h"

#include "shapetonCsvTable.h"
#include "shapetonDistensionChart.h"
#include "shapetonHtmlReport.h"
#include "shapetonLumenBox.h"

#include <cmath>

namespace shapeton
{
namespace
{
/** Writes pictures as files and embeds them into the page. */
class PicturePages
{
public:
  PicturePages(HtmlReport & html, const std::string & folder, const OutputPath & outputPath)
    : m_Html(html), m_Folder(folder), m_OutputPath(outputPath)
  {}

  struct Drawing
  {
    std::string                       name;
    std::function<Picture::Pointer()> draw;
    std::string                       caption;
  };

  void
  Add(const std::vector<Drawing> & drawings)
  {
    std::vector<PictureFile> files;
    for (const Drawing & drawing : drawings)
    {
      files.push_back({ m_OutputPath(m_Folder + "/" + drawing.name), drawing.draw });
    }
    WritePngs(files);
    for (std::size_t i = 0; i < files.size(); ++i)
    {
      m_Html.AddPicture(files[i].path, drawings[i].caption);
    }
  }

private:
  HtmlReport &       m_Html;
  std::string        m_Folder;
  const OutputPath & m_OutputPath;
};

void
AddDistension(HtmlReport & html, PicturePages & pages, const ColonReportContent & content)
{
  html.AddHeading("Distension");
  pages.Add(
    { { "distension.png",
        [&] { return DrawDistensionChart(*content.colon.centerline, {}); },
        "Caliber (diameter of the maximum inscribed sphere) along the centerline. The dashed line marks 10 mm." } });
}

void
AddSurface(HtmlReport & html, PicturePages & pages, const ColonParts & colon)
{
  html.AddHeading("Surface");
  std::vector<PicturePages::Drawing> drawings;
  if (colon.centerline)
  {
    drawings.push_back(
      { "inside-anterior.png",
        [&] { return DrawColonWall(colon, PatientSide::Anterior, false); },
        "The transparent wall from the front, with the centerline colored by the distance from the anal verge." });
    drawings.push_back({ "inside-left.png",
                         [&] { return DrawColonWall(colon, PatientSide::Left, false); },
                         "The same view from the patient's left side." });
  }
  drawings.push_back({ "wall-anterior.png",
                       [&] { return DrawColonWall(colon, PatientSide::Anterior, true); },
                       "The wall from the front." });
  pages.Add(drawings);
}

void
AddProjections(HtmlReport & html, PicturePages & pages, const ColonParts & colon)
{
  html.AddHeading("Projections");
  std::vector<PicturePages::Drawing> drawings;
  for (const SlicePlane plane : { SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    drawings.push_back({ "projection-" + NameOf(plane) + ".png",
                         [&colon, plane] { return DrawColonProjection(colon, plane); },
                         "Thickness of gas and fluid (mm), " + NameOf(plane) + " view" +
                           (colon.centerline ? ", with the centerline." : ".") });
  }
  pages.Add(drawings);
}

void
AddSlices(HtmlReport & html, PicturePages & pages, const ColonParts & colon)
{
  html.AddHeading("Slices");
  if (!colon.ct)
  {
    html.AddParagraph("The input is a lumen mask; the outlines are shown without a CT.");
  }
  std::vector<PicturePages::Drawing> drawings;
  for (const SlicePlane plane : { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    drawings.push_back(
      { "slices-" + NameOf(plane) + ".png",
        [&colon, plane] { return DrawColonSlices(colon, plane); },
        "Outlines of gas and fluid in " + NameOf(plane) + " slices, including the one with the largest lumen area." });
  }
  pages.Add(drawings);
}
} // namespace

void
WriteColonReport(const ColonReportContent & content, const std::string & folder, const OutputPath & outputPath)
{
  const ColonParts & colon = content.colon;
  CheckParts(colon);
  HtmlReport   html(content.title);
  PicturePages pages(html, folder, outputPath);
  html.AddHead(content.summary, content.warnings);
  if (colon.wall)
  {
    AddSurface(html, pages, colon);
  }
  if (colon.centerline)
  {
    AddDistension(html, pages, content);
  }
  AddProjections(html, pages, colon);
  AddSlices(html, pages, colon);
  html.AddHeading("Input");
  html.AddFacts(content.input);
  html.AddHeading("Parameters");
  html.AddFacts(content.parameters);
  html.AddHeading("Provenance");
  html.AddFacts(content.provenance);
  html.Write(outputPath(folder + "/index.html"));
}
} // namespace shapeton
