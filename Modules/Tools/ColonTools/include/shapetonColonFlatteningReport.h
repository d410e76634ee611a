#ifndef shapetonColonFlatteningReport_h
#define shapetonColonFlatteningReport_h

#include "ShapetonColonToolsExport.h"
#include "shapetonRemarks.h"
#include "shapetonColonFlattening.h"
#include "shapetonFlatColonPictures.h"

#include "shapetonOutputPath.h"

namespace shapeton
{
class CommandLine;

/** Handles of a flattening as annotations, numbered from 1. \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT std::vector<FlatAnnotation>
                          AnnotationsOfHandles(const ColonFlattening & flattening);

/** Additional content of a report on a flattening. \ingroup ShapetonColonTools */
struct ColonFlatteningReportContent
{
  using Facts = std::vector<std::pair<std::string, std::string>>;

  const ColonFlattening * flattening{ nullptr };
  /** Parts of the flat surface. */
  FlatColonParts parts;
  Remarks        warnings;
  Facts          provenance;
};

/** Writes a report into an existing folder: a self-contained index.html, and its pictures as files: flat-volume.png
 * (if there is a CT), flat-relief.png, flat-curvature.png, triangle-quality.png. The pixel size is 1/200 of the
 * circumference. Equal content gives equal bytes. Throws OutputError and the exceptions of FlatColonPictures.
 * \ingroup ShapetonColonTools */
ShapetonColonTools_EXPORT void
WriteColonFlatteningReport(const ColonFlatteningReportContent & content,
                           const std::string &                  folder,
                           const OutputPath &                   outputPath);

/** \class ColonFlatteningViews
 * \brief Picture, coordinate map and report of the tool ColonFlattening.
 *
 * The tool's XML declares picture, coloring (auto, volume, curvature, relief), pixelSize (mm), coordinateMap and
 * report. \ingroup ShapetonColonTools */
class ShapetonColonTools_EXPORT ColonFlatteningViews
{
public:
  /** Registers the outputs and creates the folder. Throws ParameterError and OutputError. */
  explicit ColonFlatteningViews(CommandLine & commandLine);

  /** Whether any picture is requested. */
  bool
  ArePicturesWanted() const;

  /** The centerline may be empty. `ct` may be null. */
  void
  Write(const ColonFlattening & flattening, const CurveSet & centerline, const itk::Image<float, 3> * ct) const;

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
