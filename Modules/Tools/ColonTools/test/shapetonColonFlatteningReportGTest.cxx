#include "shapetonColonFlatteningReport.h"

#include "shapetonColonTube.h"
#include "shapetonFlatTestColon.h"
#include "shapetonPictureTestUtilities.h"
#include "shapetonTestFolder.h"
#include "shapetonTestReports.h"

namespace
{
const shapeton::OutputPath inPlace = [](const std::string & path) { return path; };

/** A tube with two handles, flattened. */
shapeton::ColonFlattening
Flattened()
{
  testsurfaces::ColonTubeOptions options;
  options.faces = 6000;
  options.length = 750.0;
  options.handles = 2;
  return shapeton::FlattenColon(testsurfaces::MakeColonTube(options).mesh, "tube");
}
} // namespace

TEST(ColonFlatteningReport, HoldsPicturesTablesAndWarnings)
{
  const shapeton::ColonFlattening        flattening = Flattened();
  const shapeton::FlatColon              flat(flattening.map.flat);
  shapeton::ColonFlatteningReportContent content;
  content.flattening = &flattening;
  content.parts.flat = &flat;
  content.parts.annotations = AnnotationsOfHandles(flattening);
  content.warnings = { "a <warning>" };
  content.provenance = { { "tool", "a & b" } };
  ASSERT_EQ(flattening.handles.handles.size(), 2U);
  ASSERT_EQ(content.parts.annotations.size(), 2U);
  EXPECT_EQ(content.parts.annotations[1].text, "2");

  const basetest::Folder folder;
  WriteColonFlatteningReport(content, folder / ".", inPlace);
  EXPECT_EQ(basetest::FilesIn(folder / "."),
            (std::set<std::string>{ "index.html", "flat-relief.png", "flat-curvature.png", "triangle-quality.png" }));
  const std::string html = shapeton::ReadFileBytes(folder / "index.html");
  EXPECT_EQ(basetest::CountOf(html, "data:image/png;base64,"), 3U);
  for (const char * text : { "For research use. This is not a diagnosis",
                             "a &lt;warning&gt;",
                             "a &amp; b",
                             "heat diffusion distance of all eigenpairs, t = ",
                             "Quasi-conformal dilatation",
                             "Handles by the Gauss-Bonnet theorem" })
  {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
  const std::string again = html;
  WriteColonFlatteningReport(content, folder / ".", inPlace);
  EXPECT_EQ(shapeton::ReadFileBytes(folder / "index.html"), again);
  EXPECT_EQ(again.find("Blind pouches"), std::string::npos);
}

TEST(ColonFlatteningReport, ListsCaps)
{
  shapeton::ColonFlattening flattening = Flattened();
  flattening.cutOffAreaFraction = 0.0125;
  flattening.caps = { { 12.5, 345.0, { 1.0, 2.0, 3.0 } } };
  const shapeton::FlatColon              flat(flattening.map.flat);
  shapeton::ColonFlatteningReportContent content;
  content.flattening = &flattening;
  content.parts.flat = &flat;
  const basetest::Folder folder;
  WriteColonFlatteningReport(content, folder / ".", inPlace);
  const std::string html = shapeton::ReadFileBytes(folder / "index.html");
  for (const char * text : { "Blind pouches", "1.25 % of the wall", "1, 2, 3", "12.5", "345" })
  {
    EXPECT_NE(html.find(text), std::string::npos) << text;
  }
}

TEST(FlatColonPictures, DistancesComeFromTheSurfaceElseFromTheCenterline)
{
  shapeton::SurfaceMesh wall = flatcolon::Wall();
  shapeton::CurveSet    line;
  const Eigen::Index    points = 25;
  line.V = shapeton::VertexMatrix::Zero(points, 3);
  line.curves.emplace_back();
  flattubes::AddArray(line.pointArrays, "arcLength", points, 1);
  for (int i = 0; i < points; ++i)
  {
    line.V(i, 2) = 10.0 * i;
    line.curves[0].push_back(i);
    line.pointArrays[0].values(i, 0) = 500.0 + 10.0 * i;
  }
  const shapeton::FlatColon flat(wall);
  shapeton::FlatColonParts  parts;
  parts.flat = &flat;
  parts.centerline = &line;
  const shapeton::FlatColonPictures pictures(parts, 1.0);
  const double                      u = 100.5 * pictures.Grid().PixelSize();
  EXPECT_NEAR(pictures.Distances()[100], 10.0 + u, 1e-6);
  wall.pointArrays.pop_back();
  const shapeton::FlatColon withoutDistance(wall);
  parts.flat = &withoutDistance;
  EXPECT_NEAR(shapeton::FlatColonPictures(parts, 1.0).Distances()[100], 500.0 + u, 2.0);
  parts.centerline = nullptr;
  EXPECT_TRUE(shapeton::FlatColonPictures(parts, 1.0).Distances().empty());
}

TEST(FlatColonPictures, AVolumeRenderingNeedsACt)
{
  const shapeton::FlatColon flat(flatcolon::Wall());
  shapeton::FlatColonParts  parts;
  parts.flat = &flat;
  const shapeton::FlatColonPictures pictures(parts, 1.0);
  EXPECT_THROW(pictures.Draw(shapeton::FlatColoring::Volume, ""), std::invalid_argument);
  EXPECT_EQ(shapeton::NameOf(shapeton::FlatColoring::Volume), "volume");
}

TEST(FlatColonPictures, TwoByTwoSamplesForEachPixel)
{
  const shapeton::FlatColon flat(flatcolon::Wall());
  shapeton::FlatColonParts  parts;
  parts.flat = &flat;
  const shapeton::FlatColonPictures pictures(parts, 1.0);
  shapeton::FlatColonGridOptions    options;
  options.pixelSize = 0.5 * pictures.Grid().PixelSize();
  options.curvatureLength = 2.0;
  options.normalLength = 1.0;
  const auto                     strip = PaintFlatRelief(flat.Grid(options), flat.Axis(options));
  shapeton::FlatColonPageOptions page;
  page.title = "Folds";
  const auto plain =
    DrawFlatColonPage(shapeton::ReduceStrip(strip, 2, pictures.Grid().Columns(), pictures.Grid().Rows()),
                      pictures.Grid(),
                      pictures.Distances(),
                      {},
                      page);
  const auto drawn = pictures.Draw(shapeton::FlatColoring::Relief, "Folds");
  // Identical except for the note below the title, which moves the rest down.
  const auto sizes = plain->GetBufferedRegion().GetSize();
  const int  shift = static_cast<int>(drawn->GetBufferedRegion().GetSize()[1] - sizes[1]);
  ASSERT_EQ(shift, 60); // three lines of 20 on a narrow page
  for (int y = 60; y < static_cast<int>(sizes[1]); ++y)
  {
    for (int x = 0; x < static_cast<int>(sizes[0]); ++x)
    {
      ASSERT_EQ(shapeton::At(plain, x, y), shapeton::At(drawn, x, y + shift)) << x << " " << y;
    }
  }
}
