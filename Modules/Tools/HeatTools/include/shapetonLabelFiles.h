#ifndef shapetonLabelFiles_h
#define shapetonLabelFiles_h

#include "ShapetonHeatToolsExport.h"

#include "shapetonHeatClasses.h"
#include "shapetonProvenance.h"
#include "shapetonSegmentFileOptions.h"
#include "shapetonSegments.h"
#include "shapetonShapeQuantity.h"

#include "itkImage.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;
class DicomOutput;

/** Writes the labels of classes, as a segmentation with their names and colors (see SegmentMetadata()). Throws as
 * WriteVolume(). \ingroup ShapetonHeatTools */
ShapetonHeatTools_EXPORT void
WriteClassLabels(const itk::Image<unsigned char, 3> * labels,
                 const std::vector<HeatClass> &       classes,
                 const ShapeQuantity &                quantity,
                 const std::string &                  path,
                 const Provenance &                   provenance);

/** \class SegmentFiles
 * \brief The files of a tool that finds segments: a label map with names and colors for 3D Slicer, and by its options
 * dicom, labelMap, surfaces and surfaceFormat a DICOM segmentation of the input series and surfaces.
 *
 * Surfaces are those of SurfacesOfLabels(); segments without voxels of their own have none. The label map is the same
 * with and without the other files.
 * \ingroup ShapetonHeatTools */
class ShapetonHeatTools_EXPORT SegmentFiles
{
public:
  using LabelImage = itk::Image<unsigned short, 3>;

  /** Registers the outputs; `labelsParameter` names the label map. Throws ParameterError if options do not fit together
   * or the input is not a DICOM series but a DICOM segmentation is requested, and the exceptions of ReadDicomSource().
   */
  SegmentFiles(CommandLine & commandLine, const std::string & labelsParameter);

  /** Writes the files of objects: label i shows the object `objects[i - 1]`. Throws as WriteVolume(),
   * WriteDicomSegmentation() and WriteSurface(). */
  void
  WriteObjects(const LabelImage * labels, const std::vector<int> & objects) const;

  /** Writes the files of labels grown from seeds. Segments keep names, colors and terms of the segments of the seeds;
   * others are named by their labels. Throws as WriteObjects(). */
  void
  WriteSeeded(const LabelImage *                  labels,
              const std::vector<unsigned short> & labelValues,
              const std::vector<Segment> &        ofSeeds) const;

private:
  void
  Write(const LabelImage * labels, const std::vector<Segment> & segments, bool isSemiautomatic) const;
  void
  WriteSurfaces(const LabelImage * labels, const std::vector<Segment> & segments) const;

  CommandLine &                      m_CommandLine;
  SegmentFileOptions                 m_Options;
  std::string                        m_Labels;
  std::shared_ptr<const DicomOutput> m_Dicom;
};
} // namespace shapeton

#endif
