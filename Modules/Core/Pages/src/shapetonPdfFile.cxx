#include "shapetonPdfFile.h"

#include "shapetonExceptions.h"
#include "shapetonOperatingSystem.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace shapeton
{
namespace
{
constexpr const char * printer = "weasyprint";

/** Path of the printer, or an empty string. */
std::string
FindPrinter()
{
  const char * const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    const std::string program = folder + '/' + printer;
    if (!folder.empty() && ErrorOfAccess(program, FileAccess::execute) == 0)
    {
      return program;
    }
  }
  return "";
}

/** Runs a program and collects its output. */
ChildProcess::End
RunQuietly(const std::string & program, const std::vector<std::string> & arguments, std::string & messages)
{
  Pipe         out, err;
  ChildProcess child = ChildProcess::StartTool(program, arguments, out, err);
  out.CloseInput();
  err.CloseInput();
  const auto take = [&](const char * bytes, std::size_t size) { messages.append(bytes, size); };
  ReadPipes(out, take, err, take);
  return child.Wait();
}
} // namespace

bool
HasPdfWriter()
{
  return !FindPrinter().empty();
}

void
WritePdf(const std::string & htmlPath, const std::string & pdfPath)
{
  const std::string program = FindPrinter();
  if (program.empty())
  {
    throw OutputError("\"" + pdfPath + "\" cannot be written, because " + printer +
                      " is not installed; install the package weasyprint");
  }
  std::string messages;
  try
  {
    // Python orders sets by hashes, and the file records the time: both are fixed for reproducible output.
    const ChildProcess::End end =
      RunQuietly("/usr/bin/env",
                 { "PYTHONHASHSEED=0", "SOURCE_DATE_EPOCH=0", program, "-q", "-e", "utf-8", htmlPath, pdfPath },
                 messages);
    if (end.isSignal || end.number != 0)
    {
      throw OutputError("\"" + pdfPath + "\" cannot be written: " + printer + " failed (" +
                        (messages.empty() ? "status " + std::to_string(end.number)
                                          : messages.substr(messages.rfind('\n', messages.size() - 2) + 1)) +
                        "); print \"" + htmlPath + "\" with a browser");
    }
  }
  catch (const std::system_error & error)
  {
    throw OutputError("cannot start " + std::string(printer) + " (" + error.code().message() +
                      "); close other programs");
  }
}

Remarks
PrintPage(const std::string & htmlPath, const std::string & pdfPath, const OutputPath & outputPath)
{
  if (HasPdfWriter())
  {
    WritePdf(htmlPath, outputPath(pdfPath));
    return {};
  }
  std::error_code error;
  std::filesystem::remove(pdfPath, error);
  return { std::filesystem::path(pdfPath).filename().string() +
           " was not written, because WeasyPrint is not installed; install the package weasyprint" };
}
} // namespace shapeton
