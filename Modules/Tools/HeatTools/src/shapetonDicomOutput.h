#ifndef shapetonDicomOutput_h
#define shapetonDicomOutput_h

#include "shapetonDicomSegmentation.h"
#include "shapetonSegments.h"

#include "itkImage.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
class CommandLine;

/** \class DicomOutput
 * \brief An optional output of a tool as a DICOM object that references the input series. */
class DicomOutput
{
public:
  /** `parameter` names the file. Reads the headers of the series, to reject unsuitable input before the run. Throws
   * ParameterError if the input is not DICOM, and the exceptions of ReadDicomSource(). */
  DicomOutput(CommandLine & commandLine, const std::string & parameter);
  ~DicomOutput();

  /** Writes a Parametric Map if requested. `code` is in the scheme 99SHAPETON, `meaning` is its text. Values are
   * dimensionless. */
  void
  WriteMap(const itk::Image<float, 3> * image, const std::string & code, const std::string & meaning) const;
  /** Writes counts, which 32-bit floats represent exactly up to 2^24. */
  void
  WriteMap(const itk::Image<unsigned int, 3> * image, const std::string & code, const std::string & meaning) const;

  /** Writes a segmentation if requested, with the terms that the tags of the segments state. \param isSemiautomatic
   * whether a person guided the computation */
  void
  WriteSegments(const DicomLabelImage *      labels,
                const std::vector<Segment> & segments,
                bool                         isSemiautomatic,
                DicomSegmentationFormat      format) const;

private:
  const CommandLine &          m_CommandLine;
  std::string                  m_Path;
  std::unique_ptr<DicomSource> m_Source;
};
} // namespace shapeton

#endif
