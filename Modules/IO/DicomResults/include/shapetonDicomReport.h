#ifndef shapetonDicomReport_h
#define shapetonDicomReport_h

#include "shapetonDicomCode.h"
#include "shapetonDicomSource.h"

#include <array>
#include <string>
#include <vector>

namespace shapeton
{
/** \class DicomContent
 * \brief A node of the content tree of a DICOM Structured Report: its relationship to the parent, concept, value, and
 * child nodes. Created by the functions below.
 * \ingroup ShapetonDicomResults */
struct DicomContent
{
  enum class Kind
  {
    Container,
    Text,
    Code,
    Number,
    UID,
    /** "Family^Given". */
    PersonName,
    /** A reference to an instance, optionally with a frame or segment. */
    Image,
    /** A point in pixel coordinates of the image in its child node. */
    PixelPoint,
    /** A line between two such points. */
    PixelLine,
    /** A point in the frame of reference, LPS, mm. */
    SpacePoint
  };
  Kind        kind{ Kind::Container };
  std::string relationship;
  DicomCode   name{};
  /** Value of Text, UID and PersonName; digits of Number; template identifier of a Container, such as "1500". */
  std::string text{};
  /** Value of Code, unit of Number. */
  DicomCode code{};
  /** The referenced instance of Image. */
  DicomInstance instance{};
  int           segment{ 0 };
  int           frame{ 0 };
  /** Coordinates of PixelPoint and SpacePoint, and of the first end of PixelLine. */
  std::array<double, 3> point{ { 0.0, 0.0, 0.0 } };
  /** The other end of PixelLine. */
  std::array<double, 3>     end{ { 0.0, 0.0, 0.0 } };
  std::vector<DicomContent> children{};
};

/** \defgroup DicomContents Nodes of a content tree
 * `relationship` is the DICOM relationship type, such as "CONTAINS".
 * \ingroup ShapetonDicomResults */
///@{
ShapetonDicomResults_EXPORT DicomContent
ContainerContent(const std::string &       relationship,
                 const DicomCode &         name,
                 std::vector<DicomContent> children,
                 const std::string &       templateID = {});
ShapetonDicomResults_EXPORT DicomContent
TextContent(const std::string & relationship, const DicomCode & name, const std::string & text);
ShapetonDicomResults_EXPORT DicomContent
CodeContent(const std::string & relationship, const DicomCode & name, const DicomCode & value);
/** `digits` is a decimal number of at most 16 characters. */
ShapetonDicomResults_EXPORT DicomContent
NumberContent(const std::string & relationship,
              const DicomCode &   name,
              const std::string & digits,
              const DicomCode &   unit);
ShapetonDicomResults_EXPORT DicomContent
UIDContent(const std::string & relationship, const DicomCode & name, const std::string & uid);
/** `person` is "Family^Given" or a single name, see RequireDicomPersonName(). */
ShapetonDicomResults_EXPORT DicomContent
PersonContent(const std::string & relationship, const DicomCode & name, const std::string & person);
ShapetonDicomResults_EXPORT DicomContent
SegmentContent(const std::string & relationship, const DicomCode & name, const DicomInstance & instance, int segment);
/** A reference to a slice of a source. */
ShapetonDicomResults_EXPORT DicomContent
SliceContent(const std::string & relationship, const DicomSlice & slice);
/** LPS, mm. */
ShapetonDicomResults_EXPORT DicomContent
SpacePointContent(const std::string & relationship, const DicomCode & name, const std::array<double, 3> & point);
/** The pixel position of a point (LPS, mm) on the nearest slice of the source. */
ShapetonDicomResults_EXPORT DicomContent
PixelPointContent(const std::string &           relationship,
                  const DicomCode &             name,
                  const std::array<double, 3> & point,
                  const DicomSource &           source);
/** A line along the rows of the slice nearest to its center (LPS, mm). */
ShapetonDicomResults_EXPORT DicomContent
PixelLineContent(const std::string &           relationship,
                 const DicomCode &             name,
                 const std::array<double, 3> & center,
                 double                        length,
                 const DicomSource &           source);
///@}

/** The kinds of reports. \ingroup ShapetonDicomResults */
enum class DicomReportKind
{
  Comprehensive3D,
  ColonCAD
};

/** Whether a report contains everything that it is meant to contain. \ingroup ShapetonDicomResults */
enum class DicomCompletion
{
  Partial,
  Complete
};

/** Throws ParameterError unless the text is a one-line DICOM person name: 1 to 64 characters, no backslashes, equals
 * signs or control characters, with at most four carets between its components. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT void
RequireDicomPersonName(const std::string & parameter, const std::string & name);

/** Writes a Structured Report: unverified and preliminary, partial by default. The evidence lists all slices of the
 * source and `others`. A report with non-ASCII characters is written in UTF-8. Output is deterministic. Throws
 * OutputError. \ingroup ShapetonDicomResults */
ShapetonDicomResults_EXPORT DicomInstance
WriteDicomReport(const DicomSource &                source,
                 DicomReportKind                    kind,
                 const DicomContent &               root,
                 const std::vector<DicomInstance> & others,
                 const DicomResultHeader &          header,
                 const std::string &                path,
                 DicomCompletion                    completion = DicomCompletion::Partial);
} // namespace shapeton

#endif
