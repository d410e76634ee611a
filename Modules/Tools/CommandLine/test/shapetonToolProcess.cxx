#include "shapetonToolProcess.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <grp.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace tooltest
{
namespace
{
[[noreturn]] void
Work(const std::function<int()> & work)
{
  const rlimit none{ 0, 0 };
  setrlimit(RLIMIT_CORE, &none);
  const int status = work();
  std::cout.flush();
  std::fflush(stdout);
  std::fflush(stderr);
  _exit(status);
}

int
StatusOf(pid_t child)
{
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {}
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::string
ReadAll(FILE * file)
{
  std::string text;
  std::rewind(file);
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file))
  {
    text += static_cast<char>(c);
  }
  std::fclose(file);
  return text;
}

std::string
ReadUntilHangUp(int terminal)
{
  std::string            text;
  std::array<char, 4096> buffer{};
  for (ssize_t number = 0; (number = read(terminal, buffer.data(), buffer.size())) > 0;)
  {
    text.append(buffer.data(), number);
  }
  close(terminal);
  return text;
}

// Unflushed output of the parent would also be printed by the child.
pid_t
Fork()
{
  std::cout.flush();
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0)
  {
    throw std::runtime_error("cannot start a process");
  }
  return child;
}
} // namespace

Outcome
InProcess(const std::function<int()> & work)
{
  FILE * const out = std::tmpfile();
  FILE * const err = std::tmpfile();
  const pid_t  child = Fork();
  if (child == 0)
  {
    dup2(fileno(out), STDOUT_FILENO);
    dup2(fileno(err), STDERR_FILENO);
    Work(work);
  }
  const int status = StatusOf(child);
  return { status, ReadAll(out), ReadAll(err) };
}

Outcome
OnTerminal(const std::function<int()> & work, unsigned short columns)
{
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0)
  {
    throw std::runtime_error("cannot open a pseudo-terminal");
  }
  winsize size{};
  size.ws_col = columns;
  size.ws_row = columns ? 24 : 0;
  ioctl(terminal, TIOCSWINSZ, &size);
  FILE * const err = std::tmpfile();
  const pid_t  child = Fork();
  if (child == 0)
  {
    const int screen = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    close(terminal);
    dup2(screen, STDOUT_FILENO);
    close(screen);
    dup2(fileno(err), STDERR_FILENO);
    Work(work);
  }
  // Reading ends when the child closes the terminal, because it has the only open descriptor.
  std::string out = ReadUntilHangUp(terminal);
  const int   status = StatusOf(child);
  return { status, out, ReadAll(err) };
}

int
RunHere(const Words & arguments, const Body & body, const char * xml, const std::string & path)
{
  std::vector<const char *> argv{ path.c_str() };
  for (const auto & argument : arguments)
  {
    argv.push_back(argument.c_str());
  }
  argv.push_back(nullptr);
  return shapeton::CommandLine::Run(xml, static_cast<int>(argv.size()) - 1, argv.data(), body);
}

Outcome
RunTool(const Words & arguments, const Body & body, const char * xml)
{
  return InProcess([&] { return RunHere(arguments, body, xml); });
}

Outcome
RunWithOptions(const Words & options, const Body & body)
{
  Words arguments = { "in.nrrd", "out.nrrd" };
  arguments.insert(arguments.end(), options.begin(), options.end());
  return RunTool(arguments, body);
}

void
WriteText(const std::string & path, const std::string & text)
{
  std::ofstream os(path, std::ios::binary);
  os << text;
  os.close();
  if (!os)
  {
    throw std::runtime_error("cannot write " + path);
  }
}

std::string
ReadText(const std::string & path)
{
  std::ifstream is(path, std::ios::binary);
  if (!is)
  {
    return "no file " + path;
  }
  return std::string((std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>());
}

Words
NamesIn(const std::string & folder)
{
  Words names;
  for (const auto & entry : fs::directory_iterator(folder))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void
BecomeNobody()
{
  constexpr uid_t nobody = 65534;
  if (geteuid() == 0 && (setgroups(0, nullptr) != 0 || setgid(nobody) != 0 || setuid(nobody) != 0))
  {
    throw std::runtime_error("cannot drop root privileges");
  }
}

const char * const Xml = R"(<?xml version="1.0" encoding="utf-8"?>
<executable>
  <category>Testing</category>
  <title>Test Tool</title>
  <description><![CDATA[Tests
    the contract.]]></description>
  <version>1.2.3</version>
  <documentation-url>https://example.org/tool</documentation-url>
  <license>Apache-2.0</license>
  <contributor>Nobody</contributor>
  <parameters>
    <label>IO</label>
    <description><![CDATA[Input and output.]]></description>
    <image><name>outputVolume</name><label>Output</label><description>Where to.</description><channel>output</channel>
      <index>1</index></image>
    <image><name>inputVolume</name><label>Input</label><description>Where from.</description><channel>input</channel>
      <index>0</index></image>
    <file><name>table</name><longflag>table</longflag><label>Table</label><description>A second output.</description>
      <channel>output</channel></file>
    <file><name>shape</name><longflag>shape</longflag><label>Shape</label><description>A second input.</description>
      <channel>input</channel></file>
  </parameters>
  <parameters advanced="true">
    <label>Settings</label>
    <description><![CDATA[All kinds.]]></description>
    <double><name>gamma</name><flag>-g</flag><longflag>--gamma</longflag><label>Gamma</label>
      <description><![CDATA[Exponent & more.]]></description><default>1.50</default>
      <constraints><minimum>-2</minimum><maximum>10</maximum><step>0.01</step></constraints></double>
    <double><name>offset</name><longflag>offset</longflag><label>Offset</label>
      <description>Without a default.</description></double>
    <integer><name>steps</name><longflag>steps</longflag><label>Steps</label><description>A number.</description>
      <default>100000</default><constraints><minimum>1</minimum></constraints></integer>
    <double-vector><name>window</name><longflag>window</longflag><label>Window</label>
      <description>Lower and upper intensity.</description><default>-1,2.50</default></double-vector>
    <integer-vector><name>size</name><longflag>size</longflag><label>Size</label><description>Voxels.</description>
      <constraints><minimum>2</minimum></constraints></integer-vector>
    <string-vector><name>names</name><longflag>names</longflag><label>Names</label>
      <description>Some names.</description></string-vector>
    <string multiple="true"><name>tag</name><flag>t</flag><longflag>tag</longflag><label>Tag</label>
      <description>May be repeated.</description></string>
    <string><name>seriesUID</name><longflag>seriesUID</longflag><label>Series</label>
      <description>Which one.</description></string>
    <string><name>source</name><longflag>source</longflag><label>Source</label>
      <description>A name, or a file.</description></string>
    <string-enumeration><name>solver</name><longflag>solver</longflag><label>Solver</label>
      <description>How.</description><element>chebyshev</element><element>explicit</element>
      <default>chebyshev</default></string-enumeration>
    <boolean><name>untilSteady</name><flag>u</flag><longflag>untilSteady</longflag><label>Steady</label>
      <description>Whether.</description><default>false</default></boolean>
    <boolean><name>ignoreSpacing</name><longflag>ignoreSpacing</longflag><label>Ignore</label>
      <description>Whether.</description><default>false</default></boolean>
    <integer><name>threads</name><longflag>threads</longflag><label>Threads</label><description>0: all.</description>
      <default>0</default><constraints><minimum>0</minimum></constraints></integer>
    <double><name>meanHeat</name><label>Mean</label><channel>output</channel>
      <description>Told after the run.</description><default>0</default></double>
    <string><name>remark</name><label>Remark</label><channel>output</channel>
      <description>Told after the run.</description></string>
  </parameters>
</executable>
)";
} // namespace tooltest
