// Runs a tool of Shapeton as a stage in a separate folder, twice; the second run reuses the results.
// Usage: ExampleStagedRun SURFACE FOLDER
#include "shapetonJson.h"
#include "shapetonStagedRun.h"

#include <filesystem>
#include <iostream>

int
main(int argc, char * argv[])
{
  if (argc != 3)
  {
    std::cerr << "Usage: " << argv[0] << " SURFACE FOLDER\n";
    return 2;
  }
  std::filesystem::create_directories(argv[2]);
  shapeton::StagedRun run(argv[2], shapeton::FolderOfThisProgram()); // the tools are next to this program
  shapeton::Stage     stage("inspection", "SurfaceInspector");
  stage.Input("", argv[1]).Output("json", "surface.json").Option("unit", "mm").Idle("threads", "1");
  for (int i = 0; i < 2; ++i)
  {
    const shapeton::StageResult result = run.Run(stage);
    std::cout << result.program << ' ' << result.version << ": status " << result.status << ", " << result.files.size()
              << " file" << (i == 1 && result.isResumed ? ", kept" : "") << '\n';
    if (result.status != 0)
    {
      std::cerr << result.message << '\n';
      return result.status;
    }
  }
  const shapeton::Json document = shapeton::ReadJson(run.PathOf("inspection", "surface.json"));
  std::cout << "genus " << document["surface"]["genus"] << '\n';
}
