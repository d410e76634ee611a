#include "shapetonColonoscopyPresentation.h"

#include "shapetonColonoscopyReport.h"
#include "shapetonContentIdentity.h"
#include "shapetonFlatColonStrip.h"
#include "shapetonJson.h"
#include "shapetonPdfFile.h"
#include "shapetonPolypSearch.h"
#include "shapetonSha256.h"
#include "shapetonExceptions.h"
#include "shapetonToolDevice.h"

namespace shapeton
{
namespace
{
class Presenter
{
public:
  Presenter(CommandLine & commandLine, const ColonoscopyPresentation & presentation)
    : m_CommandLine(commandLine), m_Presentation(presentation), m_Folder(presentation.folder)
  {}

  void
  Update()
  {
    const Json signature = this->Signature();
    if (!this->IsUnchanged(signature))
    {
      this->Write(signature);
    }
  }

private:
  Json
  Signature() const
  {
    Json signature;
    for (const auto & [key, value] : m_Presentation.provenance)
    {
      signature[key] = value;
    }
    signature["failure"] = m_Presentation.failure;
    signature["warnings"] = m_Presentation.warnings;
    for (const StageResult & stage : m_Presentation.stages)
    {
      std::string files;
      for (const auto & [name, hash] : stage.files)
      {
        files += name + ' ' + hash + '\n';
      }
      signature["stages"][stage.name] = stage.version + ' ' + Sha256OfBytes(files);
    }
    return signature;
  }

  bool
  IsUnchanged(const Json & signature) const
  {
    try
    {
      const Json record = ReadJson(m_Folder + "/stages/report.json");
      bool       isUnchanged = record.at("signature") == signature;
      for (const auto & file : record.at("files").items())
      {
        isUnchanged = isUnchanged && IdentityOf(m_Folder + '/' + file.key()) == file.value();
      }
      return isUnchanged;
    }
    catch (const InputError &) // a file is missing
    {
      return false;
    }
    catch (const Json::exception &)
    {
      return false;
    }
  }

  void
  Write(const Json & signature)
  {
    m_CommandLine.Progress("report", 0.94);
    ColonoscopyResults results = ReadColonoscopyResults(m_Folder, m_Presentation.stages);
    results.isSecond = m_Presentation.isSecond;
    if (results.isSecond)
    {
      results.polypsOfOther = ExaminationFolder(m_Folder + "/..").ReadCandidates();
    }
    if (results.ct)
    {
      results.device = ChooseFlatVolumeDevice(results.ct, ReadDevice(m_CommandLine));
      m_CommandLine.AddRunFact("device", results.device.Describe());
    }
    ColonoscopyReportContent content{ &results,
                                      MeasureColonoscopyQuality(results),
                                      m_Presentation.failure,
                                      m_Presentation.warnings,
                                      m_Presentation.provenance };
    Json                     record;
    record["signature"] = signature;
    const auto publish = [&](const std::string & name) {
      m_CommandLine.Publish(m_Folder + '/' + name); // keep the report even if the run fails
      record["files"][name] = IdentityOf(m_Folder + '/' + name);
    };
    const std::string page = m_Folder + '/' + examination::report.name;
    WriteColonoscopyReport(content, m_CommandLine.Output(page), m_Folder + "/.report.part");
    publish(examination::report.name);
    const OutputPath outputPath = [&](const std::string & path) { return m_CommandLine.Output(path); };
    const Remarks    notPrinted = PrintPage(page, m_Folder + '/' + examination::printedReport.name, outputPath);
    m_CommandLine.Warn(notPrinted);
    if (notPrinted.empty())
    {
      publish(examination::printedReport.name);
    }
    if (!content.quality.segments.empty())
    {
      TableOfSegmentQuality(content.quality.segments)
        .Write(outputPath(m_Folder + '/' + examination::segmentQuality.name));
      publish(examination::segmentQuality.name);
    }
    m_CommandLine.MakeFolder(m_Folder + "/slicer");
    for (const std::string & name : WriteColonoscopySlicerFiles(results, m_Folder + "/slicer", outputPath))
    {
      publish("slicer/" + name);
    }
    WriteJson(record, m_CommandLine.Output(m_Folder + "/stages/report.json"));
    m_CommandLine.Publish(m_Folder + "/stages/report.json");
  }

  CommandLine &                   m_CommandLine;
  const ColonoscopyPresentation & m_Presentation;
  std::string                     m_Folder;
};
} // namespace

void
Present(CommandLine & commandLine, const ColonoscopyPresentation & presentation)
{
  Presenter(commandLine, presentation).Update();
}
} // namespace shapeton
