#ifndef shapetonColonFlatteningReport_h
#define shapetonColonFlatteningReport_h

#include "ColonToolsExport.h"
#include "shapetonRemarks.h"
#include "shapetonColonFlattening.h"
#include "shapetonFlatColonPictures.h"

#include "shapetonHtmlReport.h"

namespace shapeton
{
class CommandLine;

/** The handles of a flattening as marks, numbered from 1 on. \ingroup ColonTools */
ColonTools_EXPORT std::vector<FlatAnnotation>
                  AnnotationsOfHandles(const ColonFlattening & flattening);

/** What a report on a flattening tells beside the flattening itself. \ingroup ColonTools */
struct ColonFlatteningReportContent
{
  using Facts = std::vector<std::pair<std::string, std::string>>;

  const ColonFlattening * flattening{ nullptr };
  /** Of the flat surface of this flattening. */
  FlatColonParts parts;
  Remarks        warnings;
  Facts          provenance;
};

/** Writes a report into an existing folder: index.html, which holds its pictures, and these as files: flat-volume.png
 * where there is a CT, flat-relief.png, flat-curvature.png, triangle-quality.png. Their pixels are 1/200 of the
 * circumference. Equal content gives equal bytes. Throws OutputError, and as FlatColonPictures does.
 * \ingroup ColonTools */
ColonTools_EXPORT void
WriteColonFlatteningReport(const ColonFlatteningReportContent & content,
                           const std::string &                  folder,
                           const OutputPath &                   outputPath);

/** \class ColonFlatteningViews
 * \brief Picture, coordinate map and report of the tool ColonFlattening.
 *
 * The tool's XML declares picture, coloring (auto, volume, curvature, relief), pixelSize (mm), coordinateMap and
 * report. \ingroup ColonTools */
class ColonTools_EXPORT ColonFlatteningViews
{
public:
  /** Asks for the outputs and makes the folder. Throws ParameterError and OutputError. */
  explicit ColonFlatteningViews(CommandLine & commandLine);

  /** Whether a picture of any kind is wanted. */
  bool
  ArePicturesWanted() const;

  /** The centreline may have no curve. `ct` may be null. */
  void
  Write(const ColonFlattening & flattening, const CurveSet & centreline, const itk::Image<float, 3> * ct) const;

private:
  FlatColoring
  ColoringFor(const itk::Image<float, 3> * ct) const;

  CommandLine & m_CommandLine;
  std::string   m_Picture;
  std::string   m_CoordinateMap;
  std::string   m_Report;
};
} // namespace shapeton

#endif
