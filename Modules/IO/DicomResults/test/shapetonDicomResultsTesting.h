#ifndef shapetonDicomResultsTesting_h
#define shapetonDicomResultsTesting_h

#include "shapetonDicomSource.h"
#include "shapetonVolumeTesting.h"

namespace shapeton
{
/** The series of a fixture with patient data, saved and read as a source. */
inline DicomSource
SourceOf(const DicomFixture & fixture, const std::string & folder, const char * timeZone = "+0100")
{
  auto files = fixture.MakeSeries();
  for (const auto & file : files)
  {
    SetText(*file, DCM_PatientName, "Doe^Jane");
    SetText(*file, DCM_PatientID, "P1");
    SetText(*file, DCM_PatientAge, "064Y");
    SetText(*file, DCM_StudyInstanceUID, "1.2.3");
    SetText(*file, DCM_FrameOfReferenceUID, "1.2.4");
    SetText(*file, DCM_StudyDate, "20010203");
    SetText(*file, DCM_AcquisitionDate, "20010204");
    SetText(*file, DCM_AcquisitionTime, "101112");
    SetText(*file, DCM_TimezoneOffsetFromUTC, timeZone);
    SetText(*file, DCM_InstitutionName, "not to be taken over");
  }
  SaveDicom(files, folder);
  return ReadDicomSource(folder);
}

/** Axes, spacings and sizes differ. */
inline DicomFixture
ObliqueFixture()
{
  DicomFixture fixture;
  fixture.direction = DicomFixture::ObliqueDirection();
  return fixture;
}

inline DicomResultHeader
HeaderOfTest()
{
  return { "Test", "1.0", 300, "Research: test" };
}

inline DcmFileFormat
Loaded(const std::string & path)
{
  DcmFileFormat file;
  EXPECT_TRUE(file.loadFile(path.c_str()).good()) << path;
  file.loadAllDataIntoMemory();
  return file;
}

/** The value of the first matching attribute, including nested ones. */
inline std::string
ValueOf(DcmFileFormat & file, const DcmTagKey & tag)
{
  OFString value;
  file.getDataset()->findAndGetOFStringArray(tag, value, OFTrue);
  return value.c_str();
}

/** Whether a call throws an InputError whose message contains these words. */
inline ::testing::AssertionResult
Refuses(const std::function<void()> & call, const std::string & words)
{
  const std::string message = InputErrorOf(call);
  return Contains(message, words) ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << message;
}

/** Fixture for tests of results of a series, which are written to the folder of the test. */
class ResultsOfASeries : public ::testing::Test
{
protected:
  std::string folder = TestFolder();
  DicomSource source = SourceOf(ObliqueFixture(), folder);
};
} // namespace shapeton

#endif
