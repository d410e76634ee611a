#include "shapetonColonExamination.h"
#include "shapetonExaminationInputs.h"

#include "shapetonFileBytes.h"
#include "shapetonTestColons.h"
#include "shapetonTestErrors.h"
#include "shapetonTestFolder.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
namespace fs = std::filesystem;
using namespace tubecolons;
using basetest::ErrorOf;
using shapeton::ExaminationFile;
using shapeton::ExaminationFolder;

/** The folder of an examination, and what reading it gives. */
struct ExamFolder
{
  explicit ExamFolder(const shapeton::ColonPositionFiles & files) { WriteExamination(files, folder / "."); }

  shapeton::ColonPositionFiles
  Read(const std::string & name) const
  {
    return shapeton::ReadColonPosition(ExaminationFolder(folder / ".", "ColonRegistration"), name);
  }

  basetest::Folder folder;
};
} // namespace

TEST(ExaminationFiles, HaveOneNameEach)
{
  std::set<std::string> paths;
  for (const ExaminationFile & file : shapeton::examination::all)
  {
    EXPECT_TRUE(paths.insert(file.Path()).second) << file.Path();
    EXPECT_TRUE(*file.stage == '\0' || std::string(file.stage) == "slicer" ||
                shapeton::ToolOfStage(file.stage) == file.tool)
      << file.Path();
  }
  EXPECT_EQ(shapeton::ToolOfStage("search"), "ColonPolyps");
  EXPECT_THROW(shapeton::ToolOfStage("slicer"), std::logic_error);
  EXPECT_EQ(shapeton::FilesAlwaysWrittenBy("viewer"), std::vector<std::string>{ "viewer.html" });
}

TEST(ExaminationFiles, AToolReadsNoResultsOfItsOwnStagesOrLaterOnes)
{
  // VirtualColonoscopy itself writes this file, before the viewer.
  std::set<std::string> earlier{ "limitations.json" }, tools;
  for (const auto & [stage, tool] : shapeton::colonoscopystage::stageTools)
  {
    const bool isFirst = tools.insert(tool).second;
    for (const std::string & path : isFirst ? shapeton::FilesReadBy(tool) : std::vector<std::string>())
    {
      EXPECT_EQ(earlier.count(path.substr(0, path.find('/'))), 1U) << tool << " reads " << path;
    }
    earlier.insert(stage);
  }
}

TEST(ExaminationFolder, GivesAToolOnlyTheFilesThatItIsDeclaredToRead)
{
  const basetest::Folder  folder;
  const ExaminationFolder exam(folder / ".", "ColonRegistration");
  const auto              paths = shapeton::FilesReadBy("ColonRegistration");
  for (const ExaminationFile & file : shapeton::examination::all)
  {
    const bool isDeclared = std::count(paths.begin(), paths.end(), file.Path()) > 0;
    EXPECT_EQ(isDeclared, file.IsReadBy("ColonRegistration"));
    if (isDeclared)
    {
      EXPECT_FALSE(exam.Has(file));
    }
    else
    {
      EXPECT_THROW(exam.Has(file), std::logic_error) << file.Path();
    }
  }
  EXPECT_FALSE(ExaminationFolder(folder / ".").Has(shapeton::examination::wall));
}

TEST(ExaminationFolder, OfAnotherVersionIsRefused)
{
  const basetest::Folder folder;
  const std::string      path = folder / "examination.json";
  EXPECT_EQ(ErrorOf([&] { ExaminationFolder exam(folder / "."); }), ""); // put together from results of single tools
  shapeton::WriteExaminationVersion(path);
  EXPECT_EQ(ErrorOf([&] { ExaminationFolder exam(folder / "."); }), "");
  for (const std::string text : { "{\"version\": 99}", "{\"version\": \"1\"}", "{}", "[1]" })
  {
    shapeton::WriteFileBytes(path, text);
    EXPECT_NE(ErrorOf([&] { ExaminationFolder exam(folder / "."); }).find("examination.json\" states the version"),
              std::string::npos)
      << text;
  }
}

TEST(ColonExamination, HasASecondPositionOnceItIsFlat)
{
  const basetest::Folder folder;
  fs::create_directories(folder / "second/flattening");
  EXPECT_EQ(shapeton::ColonExamination(folder / ".").GetPositions().size(), 1U);
  const std::string digest = shapeton::ColonExamination(folder / ".").Digest();
  shapeton::WriteFileBytes(folder / "second/flattening/flat.vtp", "x");
  const shapeton::ColonExamination exam(folder / ".");
  ASSERT_EQ(exam.GetPositions().size(), 2U);
  EXPECT_NE(exam.Digest(), digest);
  EXPECT_TRUE(exam.ReadCandidates().at(1).empty());
  EXPECT_EQ(shapeton::NameOfCandidate(1, 3), "second/3");
}

TEST(ColonPositionFiles, ReadsWhatTheFolderHolds)
{
  const shapeton::ColonPositionFiles written = MakeExamination("supine", 1, {});
  const shapeton::ColonPositionFiles read = ExamFolder(written).Read("supine");
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_EQ(read.position.flat->Surface().V, written.position.flat->Surface().V);
  EXPECT_EQ(read.position.flexures, written.position.flexures);
  EXPECT_EQ(read.position.taeniae.curves, written.position.taeniae.curves);
  EXPECT_EQ(read.position.curvature.size(), written.position.flat->Surface().V.rows());
  EXPECT_EQ(read.position.isExcluded.size(), static_cast<std::size_t>(read.position.flat->Grid().Columns()));
  ASSERT_EQ(read.segments.size(), written.segments.size());
  EXPECT_EQ(read.segments[2].name, "descending");
  ASSERT_EQ(read.position.folds.size(), written.position.folds.size());
  for (std::size_t i = 0; i < read.position.folds.size(); ++i)
  {
    const shapeton::HaustralFold & a = read.position.folds[i];
    const shapeton::HaustralFold & b = written.position.folds[i];
    EXPECT_EQ(a.label, b.label);
    EXPECT_EQ(a.centerUv, b.centerUv);
    EXPECT_EQ(a.endUv, b.endUv);
    EXPECT_EQ(a.center, b.center);
    EXPECT_EQ(a.ends, b.ends);
    EXPECT_EQ(a.length, b.length);
    EXPECT_EQ(a.area, b.area);
  }
}

TEST(ColonPositionFiles, EqualExaminationsHaveOneIdentity)
{
  const auto identity = [](const char * name, int patient) {
    return ExamFolder(MakeExamination(name, patient, {})).Read("supine").identity;
  };
  EXPECT_EQ(identity("a", 1), identity("b", 1));
  EXPECT_NE(identity("a", 1), identity("c", 2));
}

TEST(ColonPositionFiles, NamesWhatIsMissingAndWhoWritesIt)
{
  const auto faultWithout = [](const std::string & file) {
    const ExamFolder exam(MakeExamination("prone", 1, {}));
    fs::remove(exam.folder / file);
    return ErrorOf([&] { exam.Read("prone"); });
  };
  for (const auto & [file, tool] :
       { std::pair<const char *, const char *>{ "segmentation/centerline.vtp", "(ColonSegmentation)" },
         { "flattening/flat.vtp", "(ColonFlattening)" },
         { "landmarks/landmarks.json", "(ColonLandmarks)" },
         { "landmarks/folds-surface.vtp", "(ColonLandmarks)" },
         { "folds/folds.csv", "(ColonFolds)" } })
  {
    const std::string fault = faultWithout(file);
    EXPECT_NE(fault.find(std::string(file) + "\", written by the stage"), std::string::npos) << fault;
    EXPECT_NE(fault.find(tool), std::string::npos) << fault;
  }
  EXPECT_EQ(faultWithout("landmarks/taeniae.vtp"), "");
  EXPECT_NE(
    ErrorOf([] { ExaminationFolder("absent", "ColonRegistration"); }).find("the examination \"absent\" was not found"),
    std::string::npos);
}

TEST(ColonPositionFiles, WithoutTaeniaeThereIsAWarning)
{
  const ExamFolder exam(MakeExamination("prone", 1, {}));
  fs::remove(exam.folder / "landmarks/taeniae.vtp");
  const shapeton::ColonPositionFiles files = exam.Read("prone");
  ASSERT_EQ(files.warnings.size(), 1U);
  EXPECT_NE(files.warnings[0].find("no taeniae"), std::string::npos);
}

TEST(ColonPositionFiles, ExaminationsThatChangedPlacesAreTold)
{
  const auto warnings = [](const std::string & name, const std::string & lumen) {
    const ExamFolder exam(MakeExamination(name, 1, {}));
    shapeton::WriteFileBytes(exam.folder / "segmentation/quality.json", "{\"lumen\": {" + lumen + "}}");
    return exam.Read(name).warnings;
  };
  const std::string prone = "\"position\": \"prone\", \"gravitySource\": \"levels\"";
  EXPECT_TRUE(warnings("prone", prone).empty());
  ASSERT_EQ(warnings("supine", prone).size(), 1U);
  EXPECT_NE(warnings("supine", prone)[0].find("supine: the patient position of this examination is prone"),
            std::string::npos);
  EXPECT_TRUE(warnings("prone", "\"position\": \"supine\", \"gravitySource\": \"assumed\"").empty());
  EXPECT_TRUE(warnings("supine", "\"position\": \"leftDecubitus\", \"gravitySource\": \"levels\"").empty());
  EXPECT_TRUE(warnings("supine", "\"position\": 1").empty());
}

TEST(ColonPositionFiles, MalformedFilesAreRefused)
{
  const auto faultWith = [](const std::string & file, const std::string & bytes) {
    const ExamFolder exam(MakeExamination("prone", 1, {}));
    shapeton::WriteFileBytes(exam.folder / file, bytes);
    return ErrorOf([&] { exam.Read("prone"); });
  };
  EXPECT_NE(faultWith("landmarks/landmarks.json", "{}").find("not written by ColonLandmarks"), std::string::npos);
  EXPECT_NE(faultWith("folds/folds.csv", "fold,u\n1,2\n").find("folds.csv\", line 1"), std::string::npos);
  EXPECT_NE(faultWith("flattening/flat.vtp", "").find("flat.vtp"), std::string::npos);
}
