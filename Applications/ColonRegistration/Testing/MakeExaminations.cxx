// Writes folders of examinations and points for the tests: MakeExaminations FOLDER
#include "shapetonTestColons.h"

#include "shapetonRegistrationFiles.h"

namespace
{
using namespace tubecolons;

/** A synthetic part of the wall that bridges a gap. */
shapeton::ColonPositionFiles
WithCollapse(shapeton::ColonPositionFiles files, double begin, double end)
{
  shapeton::SurfaceMesh flat = files.position.flat->Surface();
  for (Eigen::Index face = 0; face < flat.F.rows(); ++face)
  {
    const double u = flat.V(flat.F(face, 0), 2);
    flat.cellArrays[0].values(face, 0) = u > begin && u < end;
  }
  files.position.flat = std::make_shared<shapeton::FlatColon>(std::move(flat));
  auto & folds = files.position.folds;
  folds.erase(std::remove_if(folds.begin(),
                             folds.end(),
                             [&](const shapeton::HaustralFold & fold) {
                               return fold.centerUv.x() > begin && fold.centerUv.x() < end;
                             }),
              folds.end());
  return files;
}

shapeton::ColonPositionFiles
WithoutLandmarks(shapeton::ColonPositionFiles files)
{
  files.position.flexures.fill(std::numeric_limits<double>::quiet_NaN());
  return files;
}

/** Also works if the tests are repeated. */
void
CopyWithout(const std::string & from, const std::string & to, const std::string & file)
{
  std::filesystem::remove_all(to);
  std::filesystem::copy(from, to, std::filesystem::copy_options::recursive);
  std::filesystem::remove(to + '/' + file);
}

void
WritePoints(const Movement & movement, const std::string & path)
{
  shapeton::CsvTable table({ "sx", "sy", "sz", "px", "py", "pz" });
  for (const shapeton::PointPair & pair : KnownPoints(movement))
  {
    std::vector<std::string> cells;
    for (const Eigen::Vector3d & point : { pair.source, pair.target })
    {
      for (int k = 0; k < 3; ++k)
      {
        cells.push_back(shapeton::CsvTable::Number(point[k]));
      }
    }
    table.AddRow(cells);
  }
  table.Write(path);
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc != 2)
  {
    return 2;
  }
  const std::string folder = argv[1];
  const Movement    movement{ 0.37, 8.0 };
  WriteExamination(MakeExamination("supine", 1, {}), folder + "/supine");
  WriteExamination(WithCollapse(MakeExamination("prone", 1, movement), 330.0, 390.0), folder + "/prone");
  WriteExamination(MakeExamination("prone", 8, movement), folder + "/otherPatient");
  WriteExamination(MakeExamination("prone", 1, movement, true), folder + "/reversed");
  WriteExamination(WithoutLandmarks(MakeExamination("prone", 1, movement)), folder + "/noFlexures");
  CopyWithout(folder + "/noFlexures", folder + "/noLandmarks", "landmarks/taeniae.vtp");
  CopyWithout(folder + "/prone", folder + "/noTaeniae", "landmarks/taeniae.vtp");
  CopyWithout(folder + "/prone", folder + "/noFolds", "folds/folds.csv");
  WritePoints(movement, folder + "/points.csv");
  return 0;
}
