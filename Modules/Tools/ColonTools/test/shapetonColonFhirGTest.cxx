#include "shapetonColonFhir.h"

#include <gtest/gtest.h>

#include <regex>

namespace
{
using namespace shapeton;

const DicomCode lesion{ "52988006", "SCT", "Lesion" };
const DicomCode privateShape{ "SHAPE", "99SHAPETON", "Shape" };
const DicomCode round{ "ROUND", "99SHAPETON", "Round" };
const DicomCode mm{ "mm", "UCUM", "mm" };

/** A series of two files, of which the first has two frames, and one object. */
ColonFhirContent
Content()
{
  ColonFhirContent content;
  content.patientID = "P1";
  content.tool = "Tool";
  content.version = "1.0";
  content.series.uid = "1.2.3";
  content.series.studyUID = "1.2";
  content.series.modality = "CT";
  for (const char * const uid : { "1.2.3.1", "1.2.3.1", "1.2.3.2" })
  {
    DicomSlice slice;
    slice.sopClassUID = "1.2.840.10008.5.1.4.1.1.2.1";
    slice.sopInstanceUID = uid;
    content.series.slices.push_back(slice);
  }
  content.objects.push_back({ { "1.2.840.10008.5.1.4.1.1.66.4", "2.25.1", "2.25.2" }, "SEG", "heads" });
  DicomMeasurementGroup group;
  group.trackingID = "candidate 1";
  group.trackingUID = "2.25.7";
  group.finding = lesion;
  group.measurements.push_back({ { "81827009", "SCT", "Diameter" }, "7.25", mm, {} });
  group.evaluations.push_back({ privateShape, round, {} });
  content.candidates.groups.push_back(group);
  content.candidates.procedure = { "25045-6", "LN", "CT unspecified body region" };
  content.candidates.comments = { "first", "second" };
  return content;
}

/** The first resource of a type; null if there is none. */
Json
ResourceOf(const Json & bundle, const std::string & type)
{
  for (const Json & entry : bundle["entry"])
  {
    if (entry["resource"]["resourceType"] == type)
    {
      return entry["resource"];
    }
  }
  return {};
}

TEST(ColonFhir, ListsEachFileOnce)
{
  const Json study = ResourceOf(FhirBundleOf(Content()), "ImagingStudy");
  EXPECT_EQ(study["numberOfSeries"], 2);
  EXPECT_EQ(study["numberOfInstances"], 3);
  EXPECT_EQ(study["series"][0]["numberOfInstances"], 2);
  EXPECT_EQ(study["series"][0]["instance"][1]["uid"], "1.2.3.2");
  EXPECT_FALSE(study["series"][0].contains("description"));
  EXPECT_EQ(study["series"][1]["instance"][0]["sopClass"]["code"], "urn:oid:1.2.840.10008.5.1.4.1.1.66.4");
}

TEST(ColonFhir, StatesNumbersAndCodes)
{
  const Json observation = ResourceOf(FhirBundleOf(Content()), "Observation");
  const Json size = observation["component"][0];
  EXPECT_EQ(size["valueQuantity"]["value"].dump(), "7.25");
  EXPECT_EQ(size["valueQuantity"]["code"], "mm");
  EXPECT_EQ(size["code"]["coding"][0]["system"], "http://snomed.info/sct");
  const Json shape = observation["component"][1]; // private codes have no system, and remain as text
  EXPECT_EQ(shape["code"], Json({ { "text", "Shape" } }));
  EXPECT_EQ(shape["valueCodeableConcept"], Json({ { "text", "Round" } }));
  EXPECT_EQ(observation["valueCodeableConcept"]["coding"][0]["code"], lesion.value);
  EXPECT_FALSE(observation.contains("bodySite"));
}

TEST(ColonFhir, MakesNoIdentifierUp)
{
  ColonFhirContent content = Content();
  EXPECT_EQ(ResourceOf(FhirBundleOf(content), "Patient")["identifier"][0]["value"], "P1");
  content.patientID.clear();
  EXPECT_EQ(ResourceOf(FhirBundleOf(content), "Patient"), Json({ { "resourceType", "Patient" } }));
}

TEST(ColonFhir, KeepsTheReaderApart)
{
  ColonFhirContent content = Content();
  content.reader = content.candidates;
  content.reader->observer = "A^B";
  content.reader->evaluations = { { { "112222", "DCM", "Colon Overall Assessment" },
                                    DicomCode{ "112243", "DCM", "C3 - Polyp, Possibly Advanced Adenoma" },
                                    {} } };
  const Json        bundle = FhirBundleOf(content);
  std::vector<Json> reports;
  for (const Json & entry : bundle["entry"])
  {
    if (entry["resource"]["resourceType"] == "DiagnosticReport")
    {
      reports.push_back(entry["resource"]);
    }
  }
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_EQ(reports[0]["conclusion"], "first\nsecond");
  EXPECT_FALSE(reports[0].contains("conclusionCode"));
  EXPECT_FALSE(reports[0].contains("performer"));
  EXPECT_EQ(reports[1]["conclusionCode"][0]["coding"][0]["code"], "112243");
  EXPECT_EQ(reports[1]["performer"][0]["display"], "A^B");
  EXPECT_NE(reports[0]["result"], reports[1]["result"]);
}

TEST(ColonFhir, HasIdentifiersOfTheResults)
{
  ColonFhirContent content = Content();
  const Json       bundle = FhirBundleOf(content);
  EXPECT_EQ(bundle, FhirBundleOf(content));
  const std::regex form("urn:uuid:[0-9a-f]{8}-[0-9a-f]{4}-8[0-9a-f]{3}-8[0-9a-f]{3}-[0-9a-f]{12}");
  for (const Json & entry : bundle["entry"])
  {
    EXPECT_TRUE(std::regex_match(entry["fullUrl"].get<std::string>(), form)) << entry["fullUrl"];
  }
  content.objects[0].instance.sopInstanceUID = "2.25.9";
  const Json other = FhirBundleOf(content);
  EXPECT_EQ(other["entry"][0], bundle["entry"][0]); // the patient
  EXPECT_NE(other["identifier"], bundle["identifier"]);
}
} // namespace
