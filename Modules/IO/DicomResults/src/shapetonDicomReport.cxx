#include "shapetonDicomReport.h"

#include "shapetonDicomResultObject.h"
#include "shapetonExceptions.h"
#include "shapetonPrintable.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
const char *
ValueTypeOf(DicomContent::Kind kind)
{
  switch (kind)
  {
    case DicomContent::Kind::Container:
      return "CONTAINER";
    case DicomContent::Kind::Text:
      return "TEXT";
    case DicomContent::Kind::Code:
      return "CODE";
    case DicomContent::Kind::Number:
      return "NUM";
    case DicomContent::Kind::UID:
      return "UIDREF";
    case DicomContent::Kind::PersonName:
      return "PNAME";
    case DicomContent::Kind::Image:
      return "IMAGE";
    case DicomContent::Kind::PixelPoint:
    case DicomContent::Kind::PixelLine:
      return "SCOORD";
    default:
      return "SCOORD3D";
  }
}

void
PutImage(DicomItem item, const DicomContent & content)
{
  DicomItem reference = item.Add(DCM_ReferencedSOPSequence)
                          .Text(DCM_ReferencedSOPClassUID, content.instance.sopClassUID)
                          .Text(DCM_ReferencedSOPInstanceUID, content.instance.sopInstanceUID);
  if (content.segment > 0)
  {
    reference.Integers(DCM_ReferencedSegmentNumber, { static_cast<Uint32>(content.segment) });
  }
  if (content.frame > 0)
  {
    reference.Text(DCM_ReferencedFrameNumber, std::to_string(content.frame));
  }
}

void
PutContainer(DicomItem item, const DicomContent & content)
{
  item.Text(DCM_ContinuityOfContent, "SEPARATE");
  if (!content.text.empty())
  {
    item.Add(DCM_ContentTemplateSequence).Text(DCM_MappingResource, "DCMR").Text(DCM_TemplateIdentifier, content.text);
  }
}

void
PutPoint(DicomItem item, const DicomContent & content, const std::string & frameOfReferenceUID)
{
  const bool         isLine = content.kind == DicomContent::Kind::PixelLine;
  std::vector<float> values(content.point.begin(), content.point.end());
  if (content.kind == DicomContent::Kind::SpacePoint)
  {
    item.Text(DCM_ReferencedFrameOfReferenceUID, frameOfReferenceUID);
  }
  else
  {
    values.pop_back();
  }
  if (isLine)
  {
    values.insert(values.end(), content.end.begin(), content.end.begin() + 2);
  }
  item.Text(DCM_GraphicType, isLine ? "POLYLINE" : "POINT").Floats(DCM_GraphicData, values);
}

void
PutValue(DicomItem item, const DicomContent & content, const std::string & frameOfReferenceUID)
{
  switch (content.kind)
  {
    case DicomContent::Kind::Container:
      return PutContainer(item, content);
    case DicomContent::Kind::Text:
      item.Text(DCM_TextValue, content.text);
      return;
    case DicomContent::Kind::Code:
      item.Code(DCM_ConceptCodeSequence, content.code);
      return;
    case DicomContent::Kind::Number:
      item.Add(DCM_MeasuredValueSequence)
        .Text(DCM_NumericValue, content.text)
        .Code(DCM_MeasurementUnitsCodeSequence, content.code);
      return;
    case DicomContent::Kind::UID:
      item.Text(DCM_UID, content.text);
      return;
    case DicomContent::Kind::PersonName:
      item.Text(DCM_PersonName, content.text);
      return;
    case DicomContent::Kind::Image:
      return PutImage(item, content);
    default:
      return PutPoint(item, content, frameOfReferenceUID);
  }
}

void
PutContent(DicomItem item, const DicomContent & content, const std::string & frameOfReferenceUID)
{
  if (!content.relationship.empty())
  {
    item.Text(DCM_RelationshipType, content.relationship);
  }
  item.Text(DCM_ValueType, ValueTypeOf(content.kind));
  if (!content.name.value.empty())
  {
    item.Code(DCM_ConceptNameCodeSequence, content.name);
  }
  PutValue(item, content, frameOfReferenceUID);
  for (const DicomContent & child : content.children)
  {
    PutContent(item.Add(DCM_ContentSequence), child, frameOfReferenceUID);
  }
}

void
PutInstance(DicomItem series, const std::string & sopClassUID, const std::string & sopInstanceUID)
{
  series.Add(DCM_ReferencedSOPSequence)
    .Text(DCM_ReferencedSOPClassUID, sopClassUID)
    .Text(DCM_ReferencedSOPInstanceUID, sopInstanceUID);
}

void
PutEvidence(DicomItem root, const DicomSource & source, const std::vector<DicomInstance> & others)
{
  DicomItem study =
    root.Add(DCM_CurrentRequestedProcedureEvidenceSequence).Text(DCM_StudyInstanceUID, source.series.studyUID);
  DicomItem   slices = study.Add(DCM_ReferencedSeriesSequence).Text(DCM_SeriesInstanceUID, source.series.uid);
  std::string last;
  for (const DicomSlice & slice : source.series.slices)
  {
    if (slice.sopInstanceUID != last) // the frames of one instance are consecutive
    {
      last = slice.sopInstanceUID;
      PutInstance(slices, slice.sopClassUID, slice.sopInstanceUID);
    }
  }
  for (const DicomInstance & other : others)
  {
    PutInstance(study.Add(DCM_ReferencedSeriesSequence).Text(DCM_SeriesInstanceUID, other.seriesUID),
                other.sopClassUID,
                other.sopInstanceUID);
  }
}

/** Whether all texts of the tree are ASCII. */
bool
HasOnlyAscii(const DicomContent & content)
{
  return IsAscii(content.text + content.code.meaning + content.name.meaning) &&
         std::all_of(content.children.begin(), content.children.end(), HasOnlyAscii);
}
} // namespace

DicomContent
ContainerContent(const std::string &       relationship,
                 const DicomCode &         name,
                 std::vector<DicomContent> children,
                 const std::string &       templateID)
{
  DicomContent content{ DicomContent::Kind::Container, relationship, name };
  content.children = std::move(children);
  content.text = templateID;
  return content;
}

DicomContent
TextContent(const std::string & relationship, const DicomCode & name, const std::string & text)
{
  return { DicomContent::Kind::Text, relationship, name, text };
}

DicomContent
CodeContent(const std::string & relationship, const DicomCode & name, const DicomCode & value)
{
  return { DicomContent::Kind::Code, relationship, name, {}, value };
}

DicomContent
NumberContent(const std::string & relationship,
              const DicomCode &   name,
              const std::string & digits,
              const DicomCode &   unit)
{
  return { DicomContent::Kind::Number, relationship, name, digits, unit };
}

DicomContent
UIDContent(const std::string & relationship, const DicomCode & name, const std::string & uid)
{
  return { DicomContent::Kind::UID, relationship, name, uid };
}

DicomContent
PersonContent(const std::string & relationship, const DicomCode & name, const std::string & person)
{
  const std::string end = person.find('^') == std::string::npos ? "^" : ""; // otherwise an obsolete form
  return { DicomContent::Kind::PersonName, relationship, name, person + end };
}

DicomContent
SegmentContent(const std::string & relationship, const DicomCode & name, const DicomInstance & instance, int segment)
{
  return { DicomContent::Kind::Image, relationship, name, {}, {}, instance, segment };
}

DicomContent
SliceContent(const std::string & relationship, const DicomSlice & slice)
{
  const DicomInstance instance{ slice.sopClassUID, slice.sopInstanceUID, {} };
  const int           frame = slice.isMultiFrame ? static_cast<int>(slice.frame) + 1 : 0;
  return { DicomContent::Kind::Image, relationship, {}, {}, {}, instance, 0, frame };
}

DicomContent
SpacePointContent(const std::string & relationship, const DicomCode & name, const std::array<double, 3> & point)
{
  return { DicomContent::Kind::SpacePoint, relationship, name, {}, {}, {}, 0, 0, point };
}

DicomContent
PixelPointContent(const std::string &           relationship,
                  const DicomCode &             name,
                  const std::array<double, 3> & point,
                  const DicomSource &           source)
{
  const auto index = source.grid->TransformPhysicalPointToContinuousIndex<double>(itk::Point<double, 3>(point.data()));
  const auto last = static_cast<double>(source.series.slices.size() - 1);
  const auto slice = static_cast<std::size_t>(std::clamp(std::round(index[2]), 0.0, last));
  DicomContent content{ DicomContent::Kind::PixelPoint, relationship, name };
  content.point = { index[0] + 0.5, index[1] + 0.5, 0.0 }; // 0 is the outer corner of the first pixel
  content.children.push_back(SliceContent("SELECTED FROM", source.series.slices[slice]));
  return content;
}

DicomContent
PixelLineContent(const std::string &           relationship,
                 const DicomCode &             name,
                 const std::array<double, 3> & center,
                 double                        length,
                 const DicomSource &           source)
{
  DicomContent content = PixelPointContent(relationship, name, center, source);
  const double half = 0.5 * length / source.grid->GetSpacing()[0]; // pixels
  content.kind = DicomContent::Kind::PixelLine;
  content.end = { content.point[0] + half, content.point[1], 0.0 };
  content.point[0] -= half;
  return content;
}

void
RequireDicomPersonName(const std::string & parameter, const std::string & name)
{
  constexpr std::size_t longest = 64; // characters of a component group, DICOM PS3.5 6.2
  constexpr std::size_t mostCarets = 4;
  const auto            characters = std::count_if(
    name.begin(), name.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }); // of UTF-8
  RequireParameter(Printable(name) == name && !name.empty() && static_cast<std::size_t>(characters) <= longest &&
                     name.find_first_of("\\=") == std::string::npos &&
                     static_cast<std::size_t>(std::count(name.begin(), name.end(), '^')) <= mostCarets,
                   "the parameter \"" + parameter +
                     "\" must be a person name such as Family^Given: one line of at most 64 characters, without "
                     "backslash and equals sign");
}

DicomInstance
WriteDicomReport(const DicomSource &                source,
                 DicomReportKind                    kind,
                 const DicomContent &               root,
                 const std::vector<DicomInstance> & others,
                 const DicomResultHeader &          header,
                 const std::string &                path,
                 DicomCompletion                    completion)
{
  const char * const sopClass =
    kind == DicomReportKind::ColonCAD ? UID_ColonCADSRStorage : UID_Comprehensive3DSRStorage;
  DicomResultObject object(source, sopClass, "SR", header);
  if (!HasOnlyAscii(root))
  {
    object.ConvertToUtf8();
  }
  object.Root()
    .NoItems(DCM_ReferencedPerformedProcedureStepSequence)
    .NoItems(DCM_PerformedProcedureCodeSequence)
    .Text(DCM_CompletionFlag, completion == DicomCompletion::Complete ? "COMPLETE" : "PARTIAL")
    .Text(DCM_VerificationFlag, "UNVERIFIED")
    .Text(DCM_PreliminaryFlag, "PRELIMINARY");
  PutEvidence(object.Root(), source, others);
  PutContent(object.Root(), root, source.series.frameOfReferenceUID);
  return object.Save(path);
}
} // namespace shapeton
