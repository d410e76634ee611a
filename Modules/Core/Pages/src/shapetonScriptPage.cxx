#include "shapetonScriptPage.h"

#include "shapetonHtmlReport.h"

namespace shapeton
{
std::string
TextOf(const ScriptPage & page, const PageBlocks & blocks)
{
  std::string text = "<!doctype html>\n<html lang=\"en\" class=\"dark\">\n<meta charset=\"utf-8\">\n";
  // Prevents scripts from sending data.
  text +=
    "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline' 'self' "
    "file:; worker-src blob:; style-src 'unsafe-inline'; img-src data: blob:" +
    (page.connections.empty() ? "" : "; connect-src " + page.connections) + "\">\n";
  text += "<title>" + page.title + "</title>\n<style>\n" + PageStyle() + page.style + "</style>\n<body>\n";
  text += "<script>\n" + page.script + "</script>\n" + blocks.Inline();
  return text + "<script>" + page.start + "</script>\n</body>\n</html>\n";
}
} // namespace shapeton
