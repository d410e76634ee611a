// Generates a phantom with ground truth and counts the voxels of each object.
// Usage: ExampleShapePhantom PRESET|SCENE.json
#include "shapetonShapePhantomImageSource.h"

#include <iostream>
#include <map>

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " PRESET|SCENE.json\n";
    return 2;
  }
  const auto phantom = shapeton::ShapePhantomImageSource::New(); // 64 x 64 x 64 voxels of 1 mm
  phantom->SetScene(shapeton::ShapeScene::Load(argv[1]));
  phantom->CenterOutput();
  phantom->SetBlur(0.5);
  phantom->SetNoise(20.0);
  phantom->Update(); // phantom->GetOutput() is the CT

  const auto * const                   labels = phantom->GetLabelOutput();
  std::map<unsigned int, unsigned int> voxels;
  for (std::size_t i = 0; i < labels->GetPixelContainer()->Size(); ++i)
  {
    ++voxels[labels->GetBufferPointer()[i]];
  }
  for (const auto & entry : voxels)
  {
    std::cout << "label " << entry.first << ": " << entry.second << " voxels\n";
  }
}
