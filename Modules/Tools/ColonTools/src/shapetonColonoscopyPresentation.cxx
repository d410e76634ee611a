#include "shapetonColonoscopyPresentation.h"

#include "shapetonColonoscopyLimitations.h"
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
Json
SignatureOf(const ColonoscopyPresentation & presentation)
{
  Json signature;
  for (const auto & [key, value] : presentation.provenance)
  {
    signature[key] = value;
  }
  signature["failure"] = presentation.failure;
  signature["warnings"] = presentation.warnings;
  for (const StageResult & stage : presentation.stages)
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

/** Files of one page in the folder of a series, with a record of what they were made from. */
class RecordedFiles
{
public:
  RecordedFiles(CommandLine & commandLine, const ColonoscopyPresentation & presentation, const std::string & name)
    : m_CommandLine(commandLine)
    , m_Folder(presentation.folder)
    , m_Record(presentation.folder + "/stages/" + name)
    , m_Signature(SignatureOf(presentation))
  {}

  bool
  AreUnchanged() const
  {
    try
    {
      const Json record = ReadJson(m_Record);
      bool       areUnchanged = record.at("signature") == m_Signature;
      for (const auto & file : record.at("files").items())
      {
        areUnchanged = areUnchanged && IdentityOf(m_Folder + '/' + file.key()) == file.value();
      }
      return areUnchanged;
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

  /** Keeps a written file even if the run fails. */
  void
  Publish(const std::string & name)
  {
    m_CommandLine.Publish(m_Folder + '/' + name);
    m_Files[name] = IdentityOf(m_Folder + '/' + name);
  }

  void
  WriteRecord() const
  {
    WriteJson({ { "signature", m_Signature }, { "files", m_Files } }, m_CommandLine.Output(m_Record));
    m_CommandLine.Publish(m_Record);
  }

private:
  CommandLine & m_CommandLine;
  std::string   m_Folder;
  std::string   m_Record;
  Json          m_Signature;
  Json          m_Files = Json::object();
};
} // namespace

void
ColonoscopyPresenter::Read(const ColonoscopyPresentation & presentation)
{
  if (!m_Results)
  {
    m_Results = std::make_shared<ColonoscopyResults>(ReadColonoscopyResults(presentation.folder, presentation.stages));
    m_Results->isSecond = presentation.isSecond;
    if (presentation.isSecond)
    {
      m_Results->polypsOfOther = ExaminationFolder(presentation.folder + "/..").ReadCandidates();
    }
    if (m_Results->ct)
    {
      m_Results->device = ChooseFlatVolumeDevice(m_Results->ct, ReadDevice(m_CommandLine));
      m_CommandLine.AddRunFact("device", m_Results->device.Describe());
    }
    m_Quality = MeasureColonoscopyQuality(*m_Results);
  }
  m_Results->stages = presentation.stages;
}

void
ColonoscopyPresenter::WriteLimitations(const ColonoscopyPresentation & presentation)
{
  RecordedFiles files(m_CommandLine, presentation, "limitations.json");
  if (files.AreUnchanged())
  {
    return;
  }
  this->Read(presentation);
  WriteJson(LimitationsToJson(*m_Results, m_Quality),
            m_CommandLine.Output(presentation.folder + '/' + examination::limitations.name));
  files.Publish(examination::limitations.name);
  files.WriteRecord();
}

void
ColonoscopyPresenter::WriteReport(const ColonoscopyPresentation & presentation)
{
  RecordedFiles files(m_CommandLine, presentation, "report.json");
  if (files.AreUnchanged())
  {
    return;
  }
  m_CommandLine.Progress("report", 0.94);
  this->Read(presentation);
  const std::string &            folder = presentation.folder;
  const ColonoscopyReportContent content{
    m_Results.get(), m_Quality, presentation.failure, presentation.warnings, presentation.provenance
  };
  const std::string page = folder + '/' + examination::report.name;
  WriteColonoscopyReport(content, m_CommandLine.Output(page), folder + "/.report.part");
  files.Publish(examination::report.name);
  const OutputPath outputPath = [this](const std::string & path) { return m_CommandLine.Output(path); };
  const Remarks    notPrinted = PrintPage(page, folder + '/' + examination::printedReport.name, outputPath);
  m_CommandLine.Warn(notPrinted);
  if (notPrinted.empty())
  {
    files.Publish(examination::printedReport.name);
  }
  if (!content.quality.segments.empty())
  {
    TableOfSegmentQuality(content.quality.segments).Write(outputPath(folder + '/' + examination::segmentQuality.name));
    files.Publish(examination::segmentQuality.name);
  }
  m_CommandLine.MakeFolder(folder + "/slicer");
  for (const std::string & name : WriteColonoscopySlicerFiles(*m_Results, folder + "/slicer", outputPath))
  {
    files.Publish("slicer/" + name);
  }
  files.WriteRecord();
}
} // namespace shapeton
