#include "shapetonHtmlReport.h"
#include "shapetonFileBytes.h"
#include "shapetonExceptions.h"

namespace shapeton
{
namespace
{
const char * const styles = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, sans-serif; color: #1a1a1a; background: #fff; max-width: 62rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; margin-bottom: .3rem; }
h2 { font-size: 1.25rem; margin-top: 2.2rem; border-bottom: 1px solid #ddd; padding-bottom: .2rem; }
figure { margin: 1rem 0; }
img { max-width: 100%; height: auto; border: 1px solid #ddd; }
figcaption { color: #555; font-size: .92rem; }
table { border-collapse: collapse; font-size: .92rem; margin: .5rem 0; }
caption { text-align: left; color: #555; padding-bottom: .3rem; }
th, td { text-align: left; padding: .25rem .8rem .25rem 0; border-bottom: 1px solid #eee; vertical-align: top; overflow-wrap: anywhere; }
th { font-weight: 600; }
.note { background: #fff6df; border-left: 4px solid #e0a100; padding: .5rem .8rem; margin: .6rem 0; }
)";

std::string
Escaped(const std::string & text)
{
  std::string escaped;
  for (const char c : text)
  {
    switch (c)
    {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default: // control characters have no place in a page
        escaped += static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t' ? c : ' ';
    }
  }
  return escaped;
}

std::string
Element(const std::string & tag, const std::string & text)
{
  return '<' + tag + '>' + Escaped(text) + "</" + tag + ">\n";
}

std::string
Base64(const std::string & bytes)
{
  static const char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string       text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    const auto byte = [&](std::size_t k) -> unsigned {
      return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0;
    };
    const unsigned triple = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    text += alphabet[triple >> 18];
    text += alphabet[triple >> 12 & 63];
    text += i + 1 < bytes.size() ? alphabet[triple >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? alphabet[triple & 63] : '=';
  }
  return text;
}
} // namespace

HtmlReport::HtmlReport(const std::string & title) : m_Title(title) {}

HtmlReport::~HtmlReport() = default;

void
HtmlReport::AddResearchNote()
{
  this->AddParagraph("For research use. This is not a diagnosis and not a medical device.");
}

void
HtmlReport::AddHead(const std::vector<std::pair<std::string, std::string>> & summary,
                    const std::vector<std::string> &                         warnings)
{
  this->AddResearchNote();
  this->AddHeading("Summary");
  this->AddFacts(summary);
  this->AddHeading("What is missing or doubtful");
  for (const std::string & warning : warnings)
  {
    this->AddNote(warning);
  }
  if (warnings.empty())
  {
    this->AddParagraph("Nothing was found missing or doubtful. Look at the pictures all the same.");
  }
}

void
HtmlReport::AddHeading(const std::string & text)
{
  m_Body += Element("h2", text);
}

void
HtmlReport::AddParagraph(const std::string & text)
{
  m_Body += Element("p", text);
}

void
HtmlReport::AddNote(const std::string & text)
{
  m_Body += "<p class=\"note\">" + Escaped(text) + "</p>\n";
}

void
HtmlReport::AddPicture(const std::string & pngPath, const std::string & caption)
{
  const std::string bytes = ReadFileBytes(pngPath);
  if (bytes.compare(0, 8, "\x89PNG\r\n\x1A\n") != 0)
  {
    throw InputError("the picture \"" + pngPath + "\" is not a PNG file; convert it");
  }
  m_Body += "<figure><img alt=\"" + Escaped(caption) + "\" src=\"data:image/png;base64," + Base64(bytes) + "\"/>\n" +
            Element("figcaption", caption) + "</figure>\n";
}

void
HtmlReport::AddTable(const CsvTable & table, const std::string & caption)
{
  m_Body += "<table>" + Element("caption", caption) + "<tr>";
  for (const auto & column : table.GetColumns())
  {
    m_Body += Element("th", column);
  }
  m_Body += "</tr>\n";
  for (const auto & row : table.GetRows())
  {
    m_Body += "<tr>";
    for (const auto & cell : row)
    {
      m_Body += Element("td", cell);
    }
    m_Body += "</tr>\n";
  }
  m_Body += "</table>\n";
}

void
HtmlReport::AddFacts(const std::vector<std::pair<std::string, std::string>> & facts)
{
  m_Body += "<table>\n";
  for (const auto & fact : facts)
  {
    m_Body += "<tr>" + Element("th", fact.first) + Element("td", fact.second) + "</tr>\n";
  }
  m_Body += "</table>\n";
}

void
HtmlReport::AddMarkup(const std::string & markup)
{
  m_Body += markup;
}

void
HtmlReport::Write(const std::string & path) const
{
  WriteFileBytes(path,
                 "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n" +
                   Element("title", m_Title) + "<style>" + styles + "</style>\n</head>\n<body>\n" +
                   Element("h1", m_Title) + m_Body + "</body>\n</html>\n");
}
} // namespace shapeton
