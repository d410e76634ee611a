#include "shapetonColonReport.h"

#include "shapetonColonFigures.h"
#include "shapetonCsvTable.h"
#include "shapetonDistensionChart.h"
#include "shapetonHtmlReport.h"
#include "shapetonLumenBox.h"

namespace shapeton
{
namespace
{
void
AddDistension(HtmlReport & html, const OutputPath & pathOf, const ColonReportContent & content)
{
  html.AddHeading("Distension");
  AddPictures(
    html,
    { { pathOf("distension.png"),
        [&] { return DrawDistensionChart(*content.colon.centerline, {}); },
        "Caliber (diameter of the maximum inscribed sphere) along the centerline. The dashed line marks 10 mm." } });
}

void
AddSurface(HtmlReport & html, const OutputPath & pathOf, const ColonParts & colon)
{
  html.AddHeading("Surface");
  std::vector<PictureFile> drawings;
  if (colon.centerline)
  {
    drawings.push_back(
      { pathOf("inside-anterior.png"),
        [&] { return DrawColonWall(colon, PatientSide::Anterior, false); },
        "The transparent wall from the front, with the centerline colored by the distance from the anal verge." });
    drawings.push_back({ pathOf("inside-left.png"),
                         [&] { return DrawColonWall(colon, PatientSide::Left, false); },
                         "The same view from the patient's left side." });
  }
  drawings.push_back({ pathOf("wall-anterior.png"),
                       [&] { return DrawColonWall(colon, PatientSide::Anterior, true); },
                       "The wall from the front." });
  AddPictures(html, drawings);
}

void
AddProjections(HtmlReport & html, const OutputPath & pathOf, const ColonParts & colon)
{
  html.AddHeading("Projections");
  std::vector<PictureFile> drawings;
  for (const SlicePlane plane : { SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    drawings.push_back({ pathOf("projection-" + NameOf(plane) + ".png"),
                         [&colon, plane] { return DrawColonProjection(colon, plane); },
                         "Thickness of gas and fluid (mm), " + NameOf(plane) + " view" +
                           (colon.centerline ? ", with the centerline." : ".") });
  }
  AddPictures(html, drawings);
}

void
AddSlices(HtmlReport & html, const OutputPath & pathOf, const ColonParts & colon)
{
  html.AddHeading("Slices");
  if (!colon.ct)
  {
    html.AddParagraph("The input is a lumen mask; the outlines are shown without a CT.");
  }
  std::vector<PictureFile> drawings;
  for (const SlicePlane plane : { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    drawings.push_back(
      { pathOf("slices-" + NameOf(plane) + ".png"),
        [&colon, plane] { return DrawColonSlices(colon, plane); },
        "Outlines of gas and fluid in " + NameOf(plane) + " slices, including the one with the largest lumen area." });
  }
  AddPictures(html, drawings);
}
} // namespace

void
WriteColonReport(const ColonReportContent & content, const std::string & folder, const OutputPath & outputPath)
{
  const ColonParts & colon = content.colon;
  CheckParts(colon);
  HtmlReport       html(content.title);
  const OutputPath pathOf = [&](const std::string & name) { return outputPath(folder + '/' + name); };
  html.AddHead(content.summary, content.warnings);
  if (colon.wall)
  {
    AddSurface(html, pathOf, colon);
  }
  if (colon.centerline)
  {
    AddDistension(html, pathOf, content);
  }
  AddProjections(html, pathOf, colon);
  AddSlices(html, pathOf, colon);
  html.AddHeading("Input");
  html.AddFacts(content.input);
  html.AddHeading("Parameters");
  html.AddFacts(content.parameters);
  html.AddHeading("Provenance");
  html.AddFacts(content.provenance);
  html.Write(outputPath(folder + "/index.html"));
}
} // namespace shapeton
