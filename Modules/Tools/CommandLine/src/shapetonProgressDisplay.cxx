#include "shapetonProgressDisplay.h"
#include "shapetonOperatingSystem.h"
#include "shapetonPrintable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace shapeton
{
namespace
{
std::string
EscapedXML(const std::string & text)
{
  std::string escaped;
  for (const char c : Printable(text))
  {
    escaped += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return escaped;
}

void
PrintElement(const char * tag, const std::string & content)
{
  std::printf("<%s>%s</%s>\n", tag, EscapedXML(content).c_str(), tag);
}

// With a decimal point in every locale.
std::string
Decimal(double value)
{
  char       text[32];
  const auto end = std::to_chars(text, text + sizeof(text), value, std::chars_format::fixed, 6);
  return std::string(text, end.ptr);
}

std::string
Remaining(double elapsed, double fraction)
{
  constexpr double enough = 0.02;                   // for an estimate
  constexpr long   minute = 60, hour = 60 * minute; // s
  if (fraction < enough || fraction >= 1.0)
  {
    return "";
  }
  const auto seconds = static_cast<long>(std::ceil(elapsed * (1.0 - fraction) / fraction));
  const long hours = seconds / hour;
  char       text[64];
  hours > 0
          ? std::snprintf(text, sizeof(text), "%ld:%02ld:%02ld left", hours, seconds % hour / minute, seconds % minute)
          : std::snprintf(text, sizeof(text), "%ld:%02ld left", seconds / minute, seconds % minute);
  return text;
}

double
Forwards(double value, double previous)
{
  return value > previous ? std::min(value, 1.0) : previous; // also for NaN
}
} // namespace

ProgressDisplay::Mode
ProgressDisplay::ModeOfStdout()
{
  return IsTerminal() ? Mode::Bar : Mode::XML;
}

void
ProgressDisplay::StartStage(const std::string & stage)
{
  m_Stage = stage;
  m_StageStart = Clock::now();
  m_StageFraction = 0.0;
  m_ShownFraction = m_ShownStageFraction = -1.0;
  if (m_Mode == Mode::XML)
  {
    std::printf("<filter-start>\n");
    PrintElement("filter-name", stage);
    PrintElement("filter-comment", stage);
    std::printf("</filter-start>\n");
  }
}

void
ProgressDisplay::EndStage()
{
  const std::chrono::duration<double> elapsed = Clock::now() - m_StageStart;
  this->CountStage(elapsed.count());
  if (m_Mode == Mode::XML && !m_Stage.empty())
  {
    std::printf("<filter-end>\n");
    PrintElement("filter-name", m_Stage);
    PrintElement("filter-time", Decimal(elapsed.count()));
    std::printf("</filter-end>\n");
    std::fflush(stdout);
  }
  m_Stage.clear();
}

void
ProgressDisplay::CountStage(double seconds)
{
  const auto stage = std::find_if(
    m_StageSeconds.begin(), m_StageSeconds.end(), [this](const auto & other) { return other.first == m_Stage; });
  if (stage != m_StageSeconds.end())
  {
    stage->second += seconds;
  }
  else if (!m_Stage.empty())
  {
    m_StageSeconds.emplace_back(m_Stage, seconds);
  }
}

void
ProgressDisplay::ClearBar()
{
  if (m_BarWidth > 0)
  {
    std::printf("\r%s\r", std::string(m_BarWidth, ' ').c_str()); // works on any terminal
    m_BarWidth = 0;
  }
}

void
ProgressDisplay::DrawBar()
{
  constexpr int     width = 40;
  const int         filled = static_cast<int>(m_Fraction * width);
  const double      elapsed = std::chrono::duration<double>(Clock::now() - m_Start).count();
  const std::string percent = std::to_string(static_cast<int>(m_Fraction * 100.0));
  std::string       line = '[' + std::string(filled, '=') + std::string(width - filled, ' ') + "] " +
                     std::string(3 - percent.size(), ' ') + percent + " %  " + m_Stage;
  const std::string remaining = Remaining(elapsed, m_Fraction);
  line += remaining.empty() ? "" : "  " + remaining;
  const std::size_t columns = TerminalColumns() > 0 ? TerminalColumns() : 80;
  line.resize(std::min(line.size(), columns - 1)); // a wrapped line could not be cleared

  this->ClearBar();
  m_BarWidth = line.size();
  std::fputs(line.c_str(), stdout);
  std::fflush(stdout);
}

// stdout is slow: limit the output to about 100 lines.
bool
ProgressDisplay::IsNews() const
{
  constexpr double percent = 0.01;
  const bool       isStageDone = m_StageFraction >= 1.0 && m_ShownStageFraction < 1.0;
  return isStageDone || m_ShownFraction < 0.0 || m_Fraction - m_ShownFraction >= percent;
}

void
ProgressDisplay::Update(const std::string & stage, double stageFraction, double fraction)
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  m_HasReports = true;
  if (!stage.empty() && stage != m_Stage)
  {
    this->EndStage();
    this->StartStage(stage);
  }
  if (m_Mode == Mode::Off)
  {
    return;
  }
  m_Fraction = Forwards(fraction, m_Fraction);
  m_StageFraction = Forwards(stageFraction, m_StageFraction);
  if (m_Fraction < 1.0 && this->IsNews())
  {
    this->Show();
  }
}

void
ProgressDisplay::Show()
{
  m_ShownFraction = m_Fraction;
  m_ShownStageFraction = m_StageFraction;
  if (m_Mode == Mode::Bar)
  {
    this->DrawBar();
    return;
  }
  PrintElement("filter-progress", Decimal(m_Fraction));
  PrintElement("filter-stage-progress", Decimal(m_StageFraction));
  std::fflush(stdout);
}

void
ProgressDisplay::Complete()
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  if (m_Mode != Mode::Off && m_HasReports)
  {
    m_Fraction = m_StageFraction = 1.0;
    this->Show();
  }
}

void
ProgressDisplay::Comment(const std::string & text)
{
  this->Print("Note: " + text);
  const std::lock_guard<std::mutex> lock(m_Mutex);
  if (m_Mode == Mode::XML)
  {
    PrintElement("filter-comment", text);
    std::fflush(stdout);
  }
}

void
ProgressDisplay::Print(const std::string & line)
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  if (m_Mode == Mode::Bar)
  {
    this->ClearBar();
    std::printf("%s\n", Printable(line).c_str());
    std::fflush(stdout);
  }
}

void
ProgressDisplay::End()
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  this->ClearBar();
  this->EndStage();
  std::fflush(stdout);
}
} // namespace shapeton
