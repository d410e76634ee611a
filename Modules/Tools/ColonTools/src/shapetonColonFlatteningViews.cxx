#include "shapetonColonFlatteningReport.h"

#include "shapetonCommandLine.h"
#include "shapetonFlatCoordinateMap.h"
#include "shapetonExceptions.h"
#include "shapetonToolDevice.h"

namespace shapeton
{
ColonFlatteningViews::ColonFlatteningViews(CommandLine & commandLine) : m_CommandLine(commandLine)
{
  const std::string coloring = commandLine.GetString("coloring");
  RequireParameter(coloring != "volume" || commandLine.IsGiven("volume"), "--coloring volume requires --volume CT");
  RequireCoordinateMapName(commandLine.GetString("coordinateMap"));
  RequireDeviceForCt(commandLine, commandLine.IsGiven("volume"));
  m_Picture = commandLine.OutputOf("picture");
  m_CoordinateMap = commandLine.OutputOf("coordinateMap");
  m_Report = commandLine.GetString("report");
  RequireParameter(!commandLine.IsGiven("volume") || this->ArePicturesWanted(),
                   "--volume requires --picture or --report");
  commandLine.MakeFolderOf("report");
}

bool
ColonFlatteningViews::ArePicturesWanted() const
{
  return !m_Picture.empty() || !m_Report.empty();
}

FlatColoring
ColonFlatteningViews::ColoringFor(const itk::Image<float, 3> * ct) const
{
  const std::string coloring = m_CommandLine.GetString("coloring");
  if (coloring == "auto")
  {
    return ct ? FlatColoring::Volume : FlatColoring::Curvature;
  }
  return coloring == "volume"      ? FlatColoring::Volume
         : coloring == "curvature" ? FlatColoring::Curvature
                                   : FlatColoring::Relief;
}

void
ColonFlatteningViews::Write(const ColonFlattening &      flattening,
                            const CurveSet &             centerline,
                            const itk::Image<float, 3> * ct) const
{
  const double    pixelSize = m_CommandLine.GetDouble("pixelSize");
  const FlatColon flat(flattening.map.flat);
  FlatColonParts  parts;
  parts.flat = &flat;
  parts.centerline = centerline.curves.empty() ? nullptr : &centerline;
  parts.ct = ct;
  if (ct && (!m_Report.empty() || this->ColoringFor(ct) == FlatColoring::Volume))
  {
    parts.device = ChooseFlatVolumeDevice(ct, ReadDevice(m_CommandLine));
    m_CommandLine.AddRunFact("device", parts.device.Describe());
  }
  parts.annotations = AnnotationsOfHandles(flattening);
  if (!m_CoordinateMap.empty())
  {
    FlatColonGridOptions options;
    options.pixelSize = pixelSize;
    WriteFlatCoordinateMap(flat.Grid(options), m_CoordinateMap, ProvenanceMetadata(m_CommandLine.GetProvenance()));
  }
  if (!m_Picture.empty())
  {
    WritePng(FlatColonPictures(parts, pixelSize).Draw(this->ColoringFor(ct), "Flat colon"), m_Picture);
  }
  if (!m_Report.empty())
  {
    const ColonFlatteningReportContent content{
      &flattening, parts, m_CommandLine.GetWarnings(), m_CommandLine.GetProvenance()
    };
    WriteColonFlatteningReport(content, m_Report, [&](const std::string & path) { return m_CommandLine.Output(path); });
  }
}
} // namespace shapeton
