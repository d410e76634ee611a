#include "shapetonColonSegmentsAsDicom.h"

#include "shapetonColonLandmarkPictures.h"
#include "shapetonColonTerms.h"
#include "shapetonColorTable.h"
#include "shapetonDicomText.h"
#include "shapetonLumenAlong.h"
#include "shapetonMappedImage.h"
#include "shapetonNumberText.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
/** Labels after those of gas and fluid, 1 and 2. */
constexpr unsigned short ileumLabel = 3;
constexpr unsigned short foldLabel = 4;

/** Labels of the anatomy after those of the segments of the colon, 1 to 6. */
constexpr unsigned short ileumOfAnatomy = 7;
constexpr unsigned short foldsOfAnatomy = 8;

constexpr std::array<unsigned char, 3> colorOfGas{ 89, 153, 230 };
constexpr std::array<unsigned char, 3> colorOfFluid{ 242, 217, 77 };
constexpr std::array<unsigned char, 3> colorOfIleum{ 150, 110, 90 };
constexpr std::array<unsigned char, 3> colorOfFolds{ 235, 90, 170 };

/** Tissue within this distance of a face belongs to its fold. */
constexpr double foldDepth = 2.0; // mm

/** Labels voxels that have no label yet. */
class VoxelPainter
{
public:
  VoxelPainter(DicomLabelImage * labels, unsigned short label) : m_Labels(labels), m_Label(label) {}

  void
  At(const Eigen::Vector3d & point)
  {
    const auto index = m_Labels->TransformPhysicalPointToIndex(itk::Point<double, 3>(point.data()));
    if (m_Labels->GetBufferedRegion().IsInside(index) && m_Labels->GetPixel(index) == 0)
    {
      m_Labels->SetPixel(index, m_Label);
    }
  }

private:
  DicomLabelImage * m_Labels;
  unsigned short    m_Label;
};

/** Sample points of a triangle at most `step` apart, each extended to both sides by the depth of a fold. Lumen voxels
 * stay lumen, so the side does not matter. */
void
PaintNear(const Eigen::Matrix3d & corners, double step, VoxelPainter & painter)
{
  const Eigen::Vector3d a = corners.col(0);
  const Eigen::Vector3d first = corners.col(1) - a;
  const Eigen::Vector3d second = corners.col(2) - a;
  const Eigen::Vector3d normal = first.cross(second).stableNormalized();
  const double          longest = std::max({ first.norm(), second.norm(), (second - first).norm() });
  const int             steps = static_cast<int>(std::ceil(longest / step));
  const int             layers = static_cast<int>(std::ceil(foldDepth / step));
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; i + j <= steps; ++j)
    {
      const Eigen::Vector3d place = a + (i * first + j * second) / std::max(steps, 1);
      for (int k = -layers; k <= layers; ++k)
      {
        painter.At(place + normal * (foldDepth * k / layers));
      }
    }
  }
}

std::array<unsigned char, 3>
ColorOfCandidate(int number)
{
  constexpr double greatest = 255.0;
  const auto       color = ColorOfLabel(number);
  const auto       byte = [](double share) { return static_cast<unsigned char>(std::lround(greatest * share)); };
  return { byte(color[0]), byte(color[1]), byte(color[2]) };
}
} // namespace

ColonSegmentsAsDicom::ColonSegmentsAsDicom(const DicomExamination & exam) : m_Exam(exam)
{
  m_Findings.labels = exam.lumen;
  this->AddColonSegments();
  this->AddLumen();
  this->AddHeads(); // before folds, so a polyp on a fold remains a polyp
  this->AddFolds();
}

void
ColonSegmentsAsDicom::AddLumen()
{
  using namespace colonterms;
  this->Add(m_Findings, "gas", substance, gas, "gas", 1, colorOfGas);
  this->Add(m_Findings, "fluid", substance, fluid, "fluid", 2, colorOfFluid);
  this->MoveToAnatomy(ileumLabel, ileumOfAnatomy);
  this->Add(m_Anatomy, "terminal ileum", anatomy, ileum, "ileum", ileumOfAnatomy, colorOfIleum);
}

void
ColonSegmentsAsDicom::MoveToAnatomy(unsigned short from, unsigned short to)
{
  unsigned short * const findings = m_Findings.labels->GetBufferPointer();
  unsigned short * const anatomy = m_Anatomy.labels->GetBufferPointer();
  const std::size_t      voxels = m_Findings.labels->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < voxels; ++i)
  {
    if (findings[i] == from)
    {
      anatomy[i] = to;
    }
  }
}

void
ColonSegmentsAsDicom::AddHeads()
{
  if (!m_Exam.heads)
  {
    return;
  }
  const auto *      heads = m_Exam.heads->GetBufferPointer();
  auto *            parts = m_Findings.labels->GetBufferPointer();
  const std::size_t voxels = m_Findings.labels->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < voxels; ++i)
  {
    if (heads[i] != 0 && parts[i] == 0)
    {
      parts[i] = static_cast<unsigned short>(foldLabel + heads[i]);
    }
  }
  for (const PolypCandidate & candidate : m_Exam.candidates)
  {
    this->Add(m_Findings,
              "candidate " + std::to_string(candidate.number),
              colonterms::abnormal,
              colonterms::lesion,
              {},
              foldLabel + candidate.number,
              ColorOfCandidate(candidate.number));
    m_Findings.segments.back().region = colonterms::CodeOfSegment(candidate.segment);
    m_Findings.segments.back().trackingUID = this->TrackingUIDOfCandidate(candidate);
  }
}

void
ColonSegmentsAsDicom::AddFolds()
{
  if (m_Exam.folds.empty())
  {
    return;
  }
  const auto & spacing = m_Findings.labels->GetSpacing();
  const double step = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });
  VoxelPainter painter(m_Findings.labels, foldLabel);
  for (std::size_t face = 0; face < m_Exam.folds.size(); ++face)
  {
    if (m_Exam.folds[face] != 0)
    {
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k)
      {
        corners.col(k) = m_Exam.flat.V.row(m_Exam.flat.F(static_cast<Eigen::Index>(face), k)).transpose();
      }
      PaintNear(corners, step, painter);
    }
  }
  this->MoveToAnatomy(foldLabel, foldsOfAnatomy);
  this->Add(m_Anatomy, "haustral folds", colonterms::anatomy, colonterms::fold, "folds", foldsOfAnatomy, colorOfFolds);
}

void
ColonSegmentsAsDicom::AddColonSegments()
{
  if (m_Exam.segments.empty())
  {
    m_Anatomy.labels = NewImageOn<DicomLabelImage>(m_Exam.lumen, true);
    return;
  }
  const auto colon = MapVoxels<LumenMaskImage::PixelType>(
    m_Exam.lumen.GetPointer(), [](unsigned short label) { return label == 1 || label == 2; });
  m_Anatomy.labels = LabelLumenAlong(colon, m_Exam.centerline, [&](double arcLength) {
    const ColonSegmentExtent * const segment = FindSegment(m_Exam.segments, arcLength);
    return segment != nullptr ? static_cast<unsigned short>(segment->label) : 0;
  });
  for (const ColonSegmentExtent & segment : m_Exam.segments)
  {
    const auto color = ColorOfSegment(segment.label);
    this->Add(m_Anatomy,
              segment.name,
              colonterms::anatomy,
              colonterms::CodeOfSegment(segment.label),
              segment.name,
              segment.label,
              { { color[0], color[1], color[2] } });
  }
}

void
ColonSegmentsAsDicom::Add(File &                               file,
                          const std::string &                  name,
                          const DicomCode &                    category,
                          const DicomCode &                    type,
                          const std::string &                  role,
                          int                                  label,
                          const std::array<unsigned char, 3> & color)
{
  DicomSegment segment{ name, DicomResearchNote, category, type,        colonterms::colon,
                        name, this->UIDOf(role), color,    file.labels, static_cast<unsigned short>(label) };
  file.segments.push_back(segment);
}

std::string
ColonSegmentsAsDicom::UIDOf(const std::string & role) const
{
  return MakeDicomUID("segment " + ConcatenateTexts({ m_Exam.seriesUID, role }));
}

std::string
ColonSegmentsAsDicom::TrackingUIDOfCandidate(const PolypCandidate & candidate) const
{
  return this->TrackingUIDAt("candidate", candidate.position);
}

std::string
ColonSegmentsAsDicom::TrackingUIDAt(const std::string & kind, const Eigen::Vector3d & place) const
{
  return this->UIDOf(kind + " at " + NumberText(place[0]) + ' ' + NumberText(place[1]) + ' ' + NumberText(place[2]));
}

bool
ColonSegmentsAsDicom::HasAnatomy() const
{
  const unsigned short * const first = m_Anatomy.labels->GetBufferPointer();
  const unsigned short * const last = first + m_Anatomy.labels->GetBufferedRegion().GetNumberOfPixels();
  return std::any_of(first, last, [](unsigned short label) { return label != 0; });
}

DicomInstance
ColonSegmentsAsDicom::Write(Part                      part,
                            const DicomSource &       source,
                            const DicomResultHeader & header,
                            const std::string &       path,
                            DicomSegmentationFormat   format)
{
  File & file = part == Part::Findings ? m_Findings : m_Anatomy;
  file.written = WriteDicomSegmentation(source, file.segments, header, path, format);
  return file.written.instance;
}

std::vector<DicomSegment>
ColonSegmentsAsDicom::Segments() const
{
  std::vector<DicomSegment> all = m_Findings.segments;
  all.insert(all.end(), m_Anatomy.segments.begin(), m_Anatomy.segments.end());
  return all;
}

ColonSegmentsAsDicom::Place
ColonSegmentsAsDicom::PlaceOf(const std::string & trackingUID) const
{
  const auto & spacing = m_Findings.labels->GetSpacing();
  const double voxel = spacing[0] * spacing[1] * spacing[2] / 1000.0; // ml
  for (const File * const file : { &m_Findings, &m_Anatomy })
  {
    const auto found = std::find_if(file->segments.begin(), file->segments.end(), [&](const DicomSegment & segment) {
      return segment.trackingUID == trackingUID;
    });
    const auto k = static_cast<std::size_t>(found - file->segments.begin());
    if (k < file->written.numbers.size()) // a file that was not written has none
    {
      return { file->written.instance,
               file->written.numbers[k],
               voxel * static_cast<double>(file->written.voxels[k]),
               file->written.centers[k] };
    }
  }
  return {};
}
} // namespace shapeton
