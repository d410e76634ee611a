#include "shapetonColonReport.h"

#include "shapetonCsvTable.h"
#include "shapetonDistensionChart.h"
#include "shapetonLumenBox.h"

#include <cmath>

namespace shapeton
{
namespace
{
/** Writes a picture beside the page and into it. */
class PicturePages
{
public:
  PicturePages(HtmlReport & html, const std::string & folder, const OutputPath & outputPath)
    : m_Html(html), m_Folder(folder), m_OutputPath(outputPath)
  {}

  void
  Add(const std::string & name, const Picture * picture, const std::string & caption)
  {
    const std::string path = m_OutputPath(m_Folder + "/" + name);
    WritePng(picture, path);
    m_Html.AddPicture(path, caption);
  }

private:
  HtmlReport &       m_Html;
  std::string        m_Folder;
  const OutputPath & m_OutputPath;
};

std::string
Share(double share)
{
  return share < 0.0 ? std::string() : CsvTable::Rounded(std::round(100.0 * share), 3) + " %";
}

void
AddDistension(HtmlReport & html, PicturePages & pages, const ColonReportContent & content)
{
  html.AddHeading("Distension");
  pages.Add("distension.png",
            DrawDistensionChart(*content.colon.centreline, content.segments),
            "Calibre (twice the radius of the largest ball inside) along the centreline. The dashed line marks 10 mm.");
  if (content.segments.empty())
  {
    return;
  }
  CsvTable table({ "segment", "from, mm", "to, mm", "length, mm", "at least 10 mm wide" });
  for (const ColonSegment & segment : content.segments)
  {
    table.AddRow({ segment.name,
                   CsvTable::Rounded(std::round(segment.begin), 6),
                   CsvTable::Rounded(std::round(segment.end), 6),
                   CsvTable::Rounded(std::round(segment.end - segment.begin), 6),
                   Share(segment.distendedShare) });
  }
  html.AddTable(table, "Segments by distance from the anal verge, and the share of their centreline that is distended");
}

void
AddSurface(HtmlReport & html, PicturePages & pages, const ColonParts & colon)
{
  html.AddHeading("Surface");
  if (colon.centreline)
  {
    pages.Add(
      "inside-anterior.png",
      DrawColonWall(colon, PatientSide::Anterior, false),
      "The wall, see-through, from the front, and the centreline coloured by the distance from the anal verge.");
    pages.Add(
      "inside-left.png", DrawColonWall(colon, PatientSide::Left, false), "The same from the patient's left side.");
  }
  pages.Add("wall-anterior.png", DrawColonWall(colon, PatientSide::Anterior, true), "The wall from the front.");
}

void
AddProjections(HtmlReport & html, PicturePages & pages, const ColonParts & colon)
{
  html.AddHeading("Projections");
  for (const SlicePlane plane : { SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    pages.Add("projection-" + NameOf(plane) + ".png",
              DrawColonProjection(colon, plane),
              "Millimetres of gas and fluid behind each other, " + NameOf(plane) + " view" +
                (colon.centreline ? ", with the centreline." : "."));
  }
}

void
AddSlices(HtmlReport & html, PicturePages & pages, const ColonParts & colon)
{
  html.AddHeading("Slices");
  if (!colon.ct)
  {
    html.AddParagraph("The input is a mask of the lumen: there is no CT to show beneath the outlines.");
  }
  for (const SlicePlane plane : { SlicePlane::Axial, SlicePlane::Coronal, SlicePlane::Sagittal })
  {
    pages.Add("slices-" + NameOf(plane) + ".png",
              DrawColonSlices(colon, plane),
              "Outlines of gas and fluid in " + NameOf(plane) +
                " slices; one of them is the slice with the largest area of lumen.");
  }
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
  if (colon.centreline)
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
