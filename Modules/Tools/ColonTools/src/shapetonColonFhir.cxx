#include "shapetonColonFhir.h"

#include "shapetonColonFigures.h"
#include "shapetonSha256.h"

#include <map>
#include <set>

namespace shapeton
{
namespace
{
constexpr const char * uriScheme = "urn:ietf:rfc:3986";
constexpr const char * ucum = "http://unitsofmeasure.org";
constexpr const char * dcm = "http://dicom.nema.org/resources/ontology/DCM";

/** A UUID of version 8 (RFC 9562) as URN, derived from a name. */
std::string
UuidUrn(const std::string & name)
{
  constexpr std::size_t version = 12; // digit
  constexpr std::size_t variant = 16; // digit
  std::string           digits = Sha256OfBytes(name).substr(0, 32);
  digits[version] = '8';
  digits[variant] = '8';
  for (const std::size_t hyphen : { 20, 16, 12, 8 }) // from the end, so that positions stay valid
  {
    digits.insert(hyphen, "-");
  }
  return "urn:uuid:" + digits;
}

std::string
OidUrn(const std::string & uid)
{
  return "urn:oid:" + uid;
}

Json
DicomIdentifier(const std::string & uid)
{
  return Json::array({ { { "system", "urn:dicom:uid" }, { "value", OidUrn(uid) } } });
}

Json
ConceptOf(const DicomCode & code)
{
  static const std::map<std::string, std::string> systems{ { "SCT", "http://snomed.info/sct" },
                                                           { "DCM", dcm },
                                                           { "LN", "http://loinc.org" } };
  Json                                            result{ { "text", code.meaning } };
  const auto                                      system = systems.find(code.scheme);
  if (system != systems.end())
  {
    result["coding"] =
      Json::array({ { { "system", system->second }, { "code", code.value }, { "display", code.meaning } } });
  }
  return result;
}

Json
ReferenceTo(const std::string & urn)
{
  return { { "reference", urn } };
}

Json
ComponentOf(const DicomMeasurement & measurement)
{
  Json code = ConceptOf(measurement.name);
  if (measurement.derivation)
  {
    code["text"] = measurement.name.meaning + ", " + measurement.derivation->meaning;
  }
  return { { "code", code },
           { "valueQuantity",
             { { "value", Json::parse(measurement.digits) },
               { "unit", measurement.unit.meaning },
               { "system", ucum },
               { "code", measurement.unit.value } } } };
}

Json
ComponentOf(const DicomEvaluation & evaluation)
{
  Json component{ { "code", ConceptOf(evaluation.name) } };
  if (evaluation.code)
  {
    component["valueCodeableConcept"] = ConceptOf(*evaluation.code);
  }
  else
  {
    component["valueString"] = evaluation.text;
  }
  return component;
}

Json
SeriesOf(const std::string & uid, const std::string & modality, const std::string & description, const Json & instances)
{
  Json series{ { "uid", uid },
               { "modality", { { "system", dcm }, { "code", modality } } },
               { "numberOfInstances", instances.size() },
               { "instance", instances } };
  if (!description.empty())
  {
    series["description"] = description;
  }
  return series;
}

Json
InstanceOf(const std::string & sopClassUID, const std::string & sopInstanceUID)
{
  return { { "uid", sopInstanceUID }, { "sopClass", { { "system", uriScheme }, { "code", OidUrn(sopClassUID) } } } };
}

class FhirBundle
{
public:
  explicit FhirBundle(const ColonFhirContent & content)
    : m_Content(content)
    , m_Seed(content.series.uid + '/' + content.objects.front().instance.sopInstanceUID)
    , m_Patient(UuidUrn("Patient/" + (content.patientID.empty() ? content.series.studyUID : content.patientID)))
    , m_Device(UuidUrn("Device/" + content.tool + '/' + content.version))
    , m_Study(this->Urn("ImagingStudy"))
  {}

  Json
  Make()
  {
    this->AddPatient();
    this->AddDevice();
    this->AddStudy();
    this->AddReport("program", m_Content.candidates);
    if (m_Content.reader)
    {
      this->AddReport("reader", *m_Content.reader);
    }
    return { { "resourceType", "Bundle" },
             { "identifier", { { "system", uriScheme }, { "value", this->Urn("Bundle") } } },
             { "type", "collection" },
             { "entry", m_Entries } };
  }

private:
  std::string
  Urn(const std::string & role) const
  {
    return UuidUrn(m_Seed + '/' + role);
  }

  void
  Add(const std::string & urn, const Json & resource)
  {
    m_Entries.push_back({ { "fullUrl", urn }, { "resource", resource } });
  }

  void
  AddPatient()
  {
    Json patient{ { "resourceType", "Patient" } };
    if (!m_Content.patientID.empty())
    {
      patient["identifier"] = Json::array({ { { "value", m_Content.patientID } } });
    }
    this->Add(m_Patient, patient);
  }

  void
  AddDevice()
  {
    this->Add(m_Device,
              { { "resourceType", "Device" },
                { "manufacturer", "Shapeton" },
                { "deviceName", Json::array({ { { "name", m_Content.tool }, { "type", "model-name" } } }) },
                { "version", Json::array({ { { "value", m_Content.version } } }) } });
  }

  /** The files of the series; a file with several slices is listed once. */
  Json
  SourceInstances() const
  {
    Json                  instances = Json::array();
    std::set<std::string> known;
    for (const DicomSlice & slice : m_Content.series.slices)
    {
      if (known.insert(slice.sopInstanceUID).second)
      {
        instances.push_back(InstanceOf(slice.sopClassUID, slice.sopInstanceUID));
      }
    }
    return instances;
  }

  void
  AddStudy()
  {
    const DicomSeries & source = m_Content.series;
    const Json          slices = this->SourceInstances();
    Json                series = Json::array({ SeriesOf(source.uid, source.modality, {}, slices) });
    for (const WrittenDicom & object : m_Content.objects)
    {
      const Json instances = Json::array({ InstanceOf(object.instance.sopClassUID, object.instance.sopInstanceUID) });
      series.push_back(SeriesOf(object.instance.seriesUID, object.modality, object.description, instances));
    }
    this->Add(m_Study,
              { { "resourceType", "ImagingStudy" },
                { "identifier", DicomIdentifier(source.studyUID) },
                { "status", "available" },
                { "subject", ReferenceTo(m_Patient) },
                { "numberOfSeries", series.size() },
                { "numberOfInstances", slices.size() + m_Content.objects.size() },
                { "series", series } });
  }

  /** The reader has only a name; the program is a device. */
  void
  PutObserver(const DicomMeasurementReport & report, Json & observation) const
  {
    if (report.observer.empty())
    {
      observation["device"] = ReferenceTo(m_Device);
    }
    else
    {
      observation["performer"] = Json::array({ { { "display", report.observer } } });
    }
  }

  Json
  ObservationOf(const DicomMeasurementGroup & group, const DicomMeasurementReport & report) const
  {
    Json code = ConceptOf({ "121071", "DCM", "Finding" });
    code["text"] = group.trackingID;
    Json observation{ { "resourceType", "Observation" },
                      { "identifier", DicomIdentifier(group.trackingUID) },
                      { "status", "preliminary" },
                      { "code", code },
                      { "subject", ReferenceTo(m_Patient) },
                      { "derivedFrom", Json::array({ ReferenceTo(m_Study) }) },
                      { "valueCodeableConcept", ConceptOf(group.finding) } };
    this->PutObserver(report, observation);
    if (!group.sites.empty())
    {
      observation["bodySite"] = ConceptOf(group.sites.front());
    }
    for (const DicomMeasurement & measurement : group.measurements)
    {
      observation["component"].push_back(ComponentOf(measurement));
    }
    for (const DicomEvaluation & evaluation : group.evaluations)
    {
      observation["component"].push_back(ComponentOf(evaluation));
    }
    for (const std::string & comment : group.comments)
    {
      observation["note"].push_back({ { "text", comment } });
    }
    return observation;
  }

  /** Evaluations and comments of a report; FHIR has no other place for them. */
  static void
  PutConclusion(const DicomMeasurementReport & report, Json & resource)
  {
    resource["conclusion"] = Joined(report.comments, "\n");
    for (const DicomEvaluation & evaluation : report.evaluations)
    {
      if (evaluation.code)
      {
        resource["conclusionCode"].push_back(ConceptOf(*evaluation.code));
      }
    }
  }

  void
  AddReport(const std::string & role, const DicomMeasurementReport & report)
  {
    const Json category{ { "system", "http://terminology.hl7.org/CodeSystem/v2-0074" }, { "code", "CT" } };
    Json       resource{ { "resourceType", "DiagnosticReport" },
                   { "status", "partial" },
                   { "category", Json::array({ { { "coding", Json::array({ category }) } } }) },
                   { "code", ConceptOf(report.procedure) },
                   { "subject", ReferenceTo(m_Patient) },
                   { "imagingStudy", Json::array({ ReferenceTo(m_Study) }) } };
    if (!report.observer.empty())
    {
      resource["performer"] = Json::array({ { { "display", report.observer } } });
    }
    PutConclusion(report, resource);
    Json observations = Json::array();
    for (const DicomMeasurementGroup & group : report.groups)
    {
      const std::string urn = this->Urn(role + '/' + group.trackingUID);
      resource["result"].push_back(ReferenceTo(urn));
      observations.push_back({ { "fullUrl", urn }, { "resource", this->ObservationOf(group, report) } });
    }
    this->Add(this->Urn(role), resource);
    m_Entries.insert(m_Entries.end(), observations.begin(), observations.end());
  }

  const ColonFhirContent & m_Content;
  std::string              m_Seed;
  std::string              m_Patient;
  std::string              m_Device;
  std::string              m_Study;
  Json                     m_Entries = Json::array();
};
} // namespace

Json
FhirBundleOf(const ColonFhirContent & content)
{
  return FhirBundle(content).Make();
}
} // namespace shapeton
