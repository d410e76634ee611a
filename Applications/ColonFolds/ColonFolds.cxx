#include "ColonFoldsXML.h"

#include "shapetonCommandLine.h"
#include "shapetonHaustralFoldFiles.h"
#include "shapetonHaustralFoldPicture.h"
#include "shapetonReadOptions.h"
#include "shapetonToolSurfaces.h"
#include "shapetonExceptions.h"

namespace
{
using namespace shapeton;

void
CheckUsage(const CommandLine & commandLine)
{
  const bool isPublished = commandLine.GetString("scheme") == "published";
  RequireParameter(isPublished || !(commandLine.IsGiven("publishedLow") || commandLine.IsGiven("publishedHigh")),
                   "--publishedLow and --publishedHigh require --scheme published");
  RequireParameter(!isPublished || !commandLine.IsGiven("smoothness"), "--smoothness requires --scheme graphCut");
  RequireFoldLabelsName(commandLine.GetString("outputLabels"));
}

/** Optional output files; a name is empty if the file is not requested. */
class FoldFiles
{
public:
  explicit FoldFiles(CommandLine & commandLine)
    : m_CommandLine(commandLine)
    , m_Labels(commandLine.MainOutput("outputLabels"))
    , m_Features(commandLine.OutputOf("features"))
    , m_Table(commandLine.OutputOf("table"))
    , m_Picture(commandLine.OutputOf("picture"))
    , m_Markups(commandLine.OutputOf("markups"))
    , m_ColorTable(commandLine.OutputOf("colorTable"))
  {}

  void
  Write(const HaustralFolds & folds, const FlatColonGrid & grid) const
  {
    WriteFoldLabels(folds, grid, m_Labels, ProvenanceMetadata(m_CommandLine.GetProvenance()));
    if (!m_Features.empty())
    {
      WriteFoldFeatures(folds, m_CommandLine.GetProvenance(), m_Features);
    }
    if (!m_Table.empty())
    {
      TableOfFolds(folds).Write(m_Table);
    }
    if (!m_Markups.empty())
    {
      WriteMarkups(MarkupsOfFolds(folds), m_Markups);
    }
    if (!m_ColorTable.empty())
    {
      WriteColorTable(ColorsOfFolds(folds), m_ColorTable);
    }
  }

  void
  WritePicture(const HaustralFoldPictureContent & content, double pixelSize) const
  {
    if (!m_Picture.empty())
    {
      WritePng(DrawHaustralFolds(content, 0.5 * pixelSize, "Haustral folds"), m_Picture);
    }
  }

private:
  CommandLine & m_CommandLine;
  std::string   m_Labels;
  std::string   m_Features;
  std::string   m_Table;
  std::string   m_Picture;
  std::string   m_Markups;
  std::string   m_ColorTable;
};

void
FindFolds(CommandLine & commandLine)
{
  CheckUsage(commandLine);
  const FoldFiles files(commandLine);

  commandLine.Progress("Reading", 0.0);
  const std::string    what = '"' + commandLine.GetString("inputFlat") + '"';
  const Surface        surface = ReadSurface(commandLine, "inputFlat");
  HaustralFoldSettings settings;
  ReadOptions(commandLine, settings);
  CurveSet taeniae;
  if (commandLine.IsGiven("taeniae"))
  {
    taeniae = ReadCurves(commandLine, "taeniae");
    settings.taeniae = &taeniae;
  }
  FlatColonGridOptions gridOptions;
  ReadOptions(commandLine, gridOptions);
  const FlatColon flat(surface.mesh, gridOptions, what);

  commandLine.Progress("Folds", 0.2);
  const HaustralFolds folds = FindHaustralFolds(flat, settings);
  commandLine.Warn(folds.warnings);

  commandLine.Progress("Writing", 0.7);
  files.Write(folds, flat.Grid());
  commandLine.Progress("Painting", 0.8);
  files.WritePicture({ &flat, &folds, settings.taeniae, {} }, flat.Grid().PixelSize());
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, FindFolds);
}
