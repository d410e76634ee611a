#include "SensorNetworkSimulatorXML.h"

#include "shapetonCommandLine.h"
#include "shapetonCsvTable.h"
#include "shapetonGraphReader.h"
#include "shapetonReadOptions.h"
#include "shapetonSensorNetwork.h"
#include "shapetonExceptions.h"

#include <cstdio>
#include <filesystem>

namespace
{
using namespace shapeton;

/** Rejects a folder with files, which could mix with the steps of this run. */
void
RequireOwnFolder(const std::string & folder, int steps)
{
  std::error_code error;
  for (const auto & entry : std::filesystem::directory_iterator(folder, error))
  {
    const std::string name = entry.path().filename().string();
    int               step = -1;
    const bool        isStep = std::sscanf(name.c_str(), "step-%d.graphml", &step) == 1 && step >= 0 && step < steps;
    if (name[0] != '.' && name != "devices" && !isStep)
    {
      throw ParameterError('"' + folder + "\" holds \"" + name +
                           "\", which would become a step of the sequence; use an empty folder");
    }
  }
}

void
AddDevices(CsvTable & table, const SensorNetwork & network, int step)
{
  const auto & devices = network.GetDevices();
  for (std::size_t i = 0; i < devices.size(); ++i)
  {
    table.AddRow({ std::to_string(step),
                   SensorNetwork::NameOfDevice(static_cast<int>(i)),
                   CsvTable::Number(devices[i].x),
                   CsvTable::Number(devices[i].y),
                   CsvTable::Number(devices[i].power),
                   devices[i].inNetwork ? "1" : "0" });
  }
}

void
Simulate(CommandLine & commandLine)
{
  const std::string    folder = commandLine.GetString("outputFolder");
  const int            steps = commandLine.GetInteger("steps");
  SensorNetworkOptions options;
  ReadOptions(commandLine, options);
  SensorNetwork network(options);
  RequireOwnFolder(folder, steps);
  commandLine.MakeFolder(folder);
  commandLine.MakeFolder(folder + "/devices");
  commandLine.RecordRun(folder + "/devices/run.json");
  CsvTable table({ "step", "device", "x", "y", "power", "inNetwork" });
  for (int step = 0; step < steps; ++step)
  {
    if (step > 0)
    {
      network.Advance();
    }
    const Graph graph = network.GetGraph();
    if (graph.nodes == 0)
    {
      throw InputError("the network has no devices at step " + std::to_string(step) + "; use more devices");
    }
    char name[32];
    std::snprintf(name, sizeof(name), "/step-%04d.graphml", step);
    WriteGraphML(graph, commandLine.Output(folder + name));
    AddDevices(table, network, step);
    commandLine.Progress("Simulating", static_cast<double>(step + 1) / steps);
  }
  table.Write(commandLine.Output(folder + "/devices/devices.csv"));
}
} // namespace

int
main(int argc, char * argv[])
{
  return CommandLine::Run(ToolXML, argc, argv, Simulate);
}
