// A tool that runs heat diffusion on a volume and writes a report: histogram, shape classes, slices, rendering.
// Usage: ExampleHeatTools VOLUME REPORT
#include "shapetonCommandLine.h"
#include "shapetonCumulativeHeatDiffusionImageFilter.h"
#include "shapetonHeatClassification.h"
#include "shapetonHeatReport.h"
#include "shapetonVolumeReader.h"

#include <iostream>

static const char xml[] = R"(<?xml version="1.0" encoding="utf-8"?>
<executable><category>Examples</category><title>Heat</title><description>Reports the shapes in a volume.</description>
<version>1.0.0</version><license>Apache-2.0</license><contributor>Shapeton</contributor>
<parameters><label>IO</label><description>Volume and report.</description>
<image><name>volume</name><label>Volume</label><description>DICOM, NRRD, NIfTI or MetaImage.</description>
<channel>input</channel><index>0</index></image>
<directory><name>report</name><label>Report</label><description>A folder.</description>
<channel>output</channel><index>1</index></directory>
</parameters></executable>)";

int
main(int argc, char * argv[])
{
  return shapeton::CommandLine::Run(xml, argc, argv, [](shapeton::CommandLine & commandLine) {
    commandLine.MakeFolder(commandLine.GetString("report"));
    const shapeton::Volume volume = shapeton::ReadVolume(commandLine.GetString("volume"));
    commandLine.AddInput("volume", volume.identity);
    const auto diffusion = shapeton::CumulativeHeatDiffusionImageFilter<shapeton::Volume::ImageType>::New();
    diffusion->SetInput(volume.image);
    diffusion->SetP(7.0);
    diffusion->SetTimeSteps(100000);
    diffusion->SetHistogramSteps({ 1, 10, 100, 1000, 10000, 100000 });
    diffusion->WantComponentsOn();
    commandLine.Watch(diffusion, "Diffusing heat", 0.0, 0.9);
    diffusion->Update();

    const auto classification = shapeton::ClassifyHeat(diffusion->GetOutput(), diffusion->GetResult().components);
    shapeton::HeatReportContent content =
      shapeton::MakeReportContent(diffusion->GetResult(), volume.image, diffusion->GetOutput());
    content.classes = classification.classes;
    content.provenance = commandLine.GetProvenance();
    shapeton::WriteHeatReport(content, commandLine.GetString("report"), [&](const std::string & path) {
      return commandLine.Output(path); // a temporary name; the file is renamed at the end
    });
    std::cout << content.classes.size() - 1 << " classes without the background\n";
  });
}
