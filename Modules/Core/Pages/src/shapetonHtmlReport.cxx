#include "shapetonHtmlReport.h"
#include "shapetonBase64Text.h"
#include "shapetonFileBytes.h"
#include "shapetonExceptions.h"
#include "shapetonReadableText.h"
#include "shapetonWarningKinds.h"

#include <optional>
#include <stdexcept>

namespace shapeton
{
extern const char * const PageStylePieces[];

namespace
{
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
      default: // control characters are not allowed in a page
        escaped += static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t' ? c : ' ';
    }
  }
  return escaped;
}

/** Whether a PNG file shows a picture that is taller than wide, according to its header. */
bool
IsTallPng(const std::string & bytes)
{
  constexpr std::size_t width = 16, height = 20, size = 4; // bytes; the numbers begin with their highest byte
  return bytes.size() >= height + size && bytes.compare(height, size, bytes, width, size) > 0;
}

std::string
Element(const std::string & tag, const std::string & text)
{
  return '<' + tag + '>' + Escaped(text) + "</" + tag + ">\n";
}

/** "#23cbac", the color of a class in a CsvTable. */
bool
IsColor(const std::string & text)
{
  constexpr std::size_t length = 7; // #rrggbb
  return text.size() == length && text[0] == '#' && text.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
}

/** Whether all nonempty cells of a column are numbers with one unit. */
struct ColumnStyle
{
  bool        isNumber{ false };
  std::string unit;
};

ColumnStyle
StyleOf(const CsvTable & table, std::size_t column)
{
  std::optional<ColumnStyle> style;
  for (const auto & row : table.GetRows())
  {
    if (row[column].empty())
    {
      continue;
    }
    const auto quantity = QuantityOf(row[column]);
    if (!quantity || (style && style->unit != quantity->unit))
    {
      return {};
    }
    style = ColumnStyle{ true, quantity->unit };
  }
  return style.value_or(ColumnStyle());
}

std::string
TableHead(const std::string & name, const ColumnStyle & style)
{
  const std::string text = ReadableText(name + (style.unit.empty() ? "" : ", " + style.unit));
  return (style.isNumber ? "<th class=\"number\">" : "<th>") + Escaped(text) + "</th>\n";
}

std::string
TableCell(const std::string & text, const ColumnStyle & style)
{
  if (style.isNumber)
  {
    const auto quantity = QuantityOf(text); // its unit is in the header
    return "<td class=\"number\">" + Escaped(quantity ? ReadableQuantity({ quantity->number, "" }) : text) + "</td>\n";
  }
  if (IsColor(text))
  {
    return "<td><span class=\"swatch\" title=\"" + text + "\" style=\"background:" + text + "\"></span></td>\n";
  }
  return Element("td", ReadableText(text));
}

/** Formats a value for display; options and inputs of a program ("option.faces") are unchanged. */
std::string
FactValue(const std::string & name, const std::string & value)
{
  if (name.find('.') != std::string::npos)
  {
    return value;
  }
  const auto quantity = QuantityOf(value);
  return quantity ? ReadableQuantity(*quantity) : ReadableText(value);
}
} // namespace

std::string
PageText(const char * const pieces[])
{
  std::string text;
  for (; *pieces != nullptr; ++pieces)
  {
    text += *pieces;
  }
  return text;
}

std::string
PageStyle()
{
  return PageText(PageStylePieces);
}

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
  this->AddHeading("Missing or doubtful results");
  this->AddWarnings(warnings);
  if (warnings.empty())
  {
    this->AddParagraph("No warnings of this step. Check the pictures nevertheless.");
  }
}

void
HtmlReport::AddWarnings(const std::vector<std::string> & warnings)
{
  for (const WarningKind & kind : KindsOf(warnings))
  {
    if (kind.warnings.size() == 1)
    {
      this->AddNote(kind.text);
      continue;
    }
    m_Body += "<details class=\"note\">" +
              Element("summary", ReadableText(std::to_string(kind.warnings.size()) + " times: " + kind.text)) +
              "<ul>\n";
    for (const std::string & warning : kind.warnings)
    {
      m_Body += Element("li", ReadableText(warning));
    }
    m_Body += "</ul></details>\n";
  }
}

void
HtmlReport::AddHeading(const std::string & text)
{
  m_Body += Element("h2", text);
}

void
HtmlReport::AddSubheading(const std::string & text)
{
  m_Body += Element("h3", text);
}

void
HtmlReport::BeginDetails(const std::string & title)
{
  m_Body += "<details>" + Element("summary", title) + "\n";
}

void
HtmlReport::EndDetails()
{
  m_Body += "</details>\n";
}

void
HtmlReport::AddParagraph(const std::string & text)
{
  m_Body += Element("p", ReadableText(text));
}

void
HtmlReport::AddLink(const std::string & path, const std::string & text)
{
  m_Body += "<nav><a href=\"" + Escaped(path) + "\">" + Escaped(text) + "</a></nav>\n";
}

void
HtmlReport::AddNumberedList(const std::vector<LinkedItem> & items)
{
  m_Body += "<ol>\n";
  for (const LinkedItem & item : items)
  {
    m_Body += "<li>" + Escaped(ReadableText(item.text));
    m_Body += item.path.empty() ? "" : " <a href=\"" + Escaped(item.path) + "\">" + Escaped(item.linkText) + "</a>";
    m_Body += "</li>\n";
  }
  m_Body += "</ol>\n";
}

void
HtmlReport::BeginPage()
{
  m_Body += "<section class=\"page\">\n";
}

void
HtmlReport::EndPage()
{
  m_Body += "</section>\n";
}

void
HtmlReport::AddNote(const std::string & text)
{
  m_Body += "<p class=\"note\">" + Escaped(ReadableText(text)) + "</p>\n";
}

void
HtmlReport::AddPicture(const std::string & pngPath, const std::string & caption)
{
  const std::string bytes = ReadFileBytes(pngPath);
  if (!IsPng(bytes))
  {
    throw InputError("the picture \"" + pngPath + "\" is not a PNG file; convert it");
  }
  this->AddPictureBytes(bytes, caption);
}

void
HtmlReport::AddPictureBytes(const std::string & png, const std::string & caption)
{
  if (!IsPng(png))
  {
    throw std::invalid_argument("these bytes are not a PNG file");
  }
  m_Body += std::string(IsTallPng(png) ? "<figure class=\"tall\">" : "<figure>") + "<img alt=\"" + Escaped(caption) +
            "\" src=\"data:image/png;base64," + Base64(png) + "\"/>\n" + Element("figcaption", ReadableText(caption)) +
            "</figure>\n";
}

void
HtmlReport::AddTable(const CsvTable & table, const std::string & caption)
{
  std::vector<ColumnStyle> styles;
  m_Body += "<div class=\"table\"><table>" + Element("caption", ReadableText(caption)) + "<tr>";
  for (const auto & column : table.GetColumns())
  {
    styles.push_back(StyleOf(table, styles.size()));
    m_Body += TableHead(column, styles.back());
  }
  m_Body += "</tr>\n";
  for (const auto & row : table.GetRows())
  {
    m_Body += "<tr>";
    for (std::size_t column = 0; column < row.size(); ++column)
    {
      m_Body += TableCell(row[column], styles[column]);
    }
    m_Body += "</tr>\n";
  }
  m_Body += "</table></div>\n";
}

void
HtmlReport::AddFacts(const std::vector<std::pair<std::string, std::string>> & facts)
{
  m_Body += "<div class=\"table\"><table class=\"facts\">\n";
  for (const auto & [name, value] : facts)
  {
    m_Body += "<tr>" + Element("th", ReadableText(name)) + Element("td", FactValue(name, value)) + "</tr>\n";
  }
  m_Body += "</table></div>\n";
}

void
HtmlReport::AddMarkup(const std::string & markup)
{
  m_Body += markup;
}

void
HtmlReport::AddStyle(const std::string & rules)
{
  m_Style += rules;
}

void
HtmlReport::Write(const std::string & path) const
{
  WriteFileBytes(path,
                 "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n" +
                   Element("title", m_Title) + "<style>\n" + PageStyle() + m_Style + "</style>\n</head>\n<body>\n" +
                   Element("h1", m_Title) + m_Body + "</body>\n</html>\n");
}
} // namespace shapeton
