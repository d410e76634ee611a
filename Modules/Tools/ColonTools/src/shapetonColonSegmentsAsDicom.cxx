#include "shapetonColonSegmentsAsDicom.h"

#include "shapetonColonLandmarkPictures.h"
#include "shapetonColonTerms.h"
#include "shapetonDicomText.h"
#include "shapetonLumenAlong.h"
#include "shapetonNumberText.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
namespace
{
constexpr unsigned short ileumLabel = 3;
constexpr unsigned short foldLabel = 4;

constexpr std::array<unsigned char, 3> colorOfGas{ 89, 153, 230 };
constexpr std::array<unsigned char, 3> colorOfFluid{ 242, 217, 77 };
constexpr std::array<unsigned char, 3> colorOfIleum{ 150, 110, 90 };
constexpr std::array<unsigned char, 3> colorOfHeads{ 200, 60, 60 };
constexpr std::array<unsigned char, 3> colorOfFolds{ 190, 140, 200 };

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

LumenMaskImage::Pointer
ColonMask(const DicomLabelImage * lumen)
{
  const auto mask = LumenMaskImage::New();
  mask->CopyInformation(lumen);
  mask->SetRegions(lumen->GetBufferedRegion());
  mask->Allocate();
  const unsigned short * const first = lumen->GetBufferPointer();
  std::transform(first,
                 first + lumen->GetBufferedRegion().GetNumberOfPixels(),
                 mask->GetBufferPointer(),
                 [](unsigned short label) { return label == 1 || label == 2; });
  return mask;
}

} // namespace

ColonSegmentsAsDicom::ColonSegmentsAsDicom(const ColonExamination & exam) : m_Exam(exam), m_Parts(exam.lumen)
{
  this->AddLumen();
  this->AddHeads(); // before folds, so a polyp on a fold remains a polyp
  this->AddFolds();
  this->AddColonSegments();
}

void
ColonSegmentsAsDicom::AddLumen()
{
  using namespace colonterms;
  this->Add("gas", substance, gas, "gas", m_Parts, 1, colorOfGas);
  this->Add("fluid", substance, fluid, "fluid", m_Parts, 2, colorOfFluid);
  this->Add("terminal ileum", anatomy, ileum, "ileum", m_Parts, ileumLabel, colorOfIleum);
}

void
ColonSegmentsAsDicom::AddHeads()
{
  if (!m_Exam.heads)
  {
    return;
  }
  const auto *      heads = m_Exam.heads->GetBufferPointer();
  auto *            parts = m_Parts->GetBufferPointer();
  const std::size_t voxels = m_Parts->GetBufferedRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < voxels; ++i)
  {
    if (heads[i] != 0 && parts[i] == 0)
    {
      parts[i] = static_cast<unsigned short>(foldLabel + heads[i]);
    }
  }
  for (const PolypCandidate & candidate : m_Exam.candidates)
  {
    this->Add("candidate " + std::to_string(candidate.number),
              colonterms::abnormal,
              colonterms::lesion,
              {},
              m_Parts,
              foldLabel + candidate.number,
              colorOfHeads);
    m_Segments.back().region = colonterms::CodeOfSegment(candidate.segment);
    m_Segments.back().trackingUID = this->TrackingUIDOfCandidate(candidate);
  }
}

void
ColonSegmentsAsDicom::AddFolds()
{
  if (m_Exam.folds.empty())
  {
    return;
  }
  const auto & spacing = m_Parts->GetSpacing();
  const double step = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });
  VoxelPainter painter(m_Parts, foldLabel);
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
  this->Add("haustral folds", colonterms::anatomy, colonterms::fold, "folds", m_Parts, foldLabel, colorOfFolds);
}

void
ColonSegmentsAsDicom::AddColonSegments()
{
  if (m_Exam.segments.empty())
  {
    return;
  }
  m_ColonSegments = LabelLumenAlong(ColonMask(m_Exam.lumen), m_Exam.centerline, [&](double arcLength) {
    const ColonSegmentExtent * const segment = FindSegment(m_Exam.segments, arcLength);
    return segment != nullptr ? static_cast<unsigned short>(segment->label) : 0;
  });
  for (const ColonSegmentExtent & segment : m_Exam.segments)
  {
    const auto color = ColorOfSegment(segment.label);
    this->Add(segment.name,
              colonterms::anatomy,
              colonterms::CodeOfSegment(segment.label),
              segment.name,
              m_ColonSegments,
              segment.label,
              { { color[0], color[1], color[2] } });
  }
}

void
ColonSegmentsAsDicom::Add(const std::string &                  name,
                          const DicomCode &                    category,
                          const DicomCode &                    type,
                          const std::string &                  role,
                          const DicomLabelImage *              labels,
                          int                                  label,
                          const std::array<unsigned char, 3> & color)
{
  DicomSegment segment;
  segment.name = name;
  segment.description = DicomResearchNote;
  segment.category = category;
  segment.type = type;
  segment.region = colonterms::colon;
  segment.trackingID = name;
  segment.trackingUID = this->UIDOf(role);
  segment.color = color;
  segment.labels = labels;
  segment.label = static_cast<unsigned short>(label);
  m_Segments.push_back(segment);
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

void
ColonSegmentsAsDicom::Write(const DicomSource &       source,
                            const DicomResultHeader & header,
                            const std::string &       path,
                            bool                      isDeflated)
{
  m_Written = WriteDicomSegmentation(source, m_Segments, header, path, isDeflated);
}

std::ptrdiff_t
ColonSegmentsAsDicom::PlaceOf(const std::string & trackingUID) const
{
  const auto found = std::find_if(m_Segments.begin(), m_Segments.end(), [&](const DicomSegment & segment) {
    return segment.trackingUID == trackingUID;
  });
  return found == m_Segments.end() ? -1 : found - m_Segments.begin();
}

int
ColonSegmentsAsDicom::NumberOf(const std::string & trackingUID) const
{
  const std::ptrdiff_t place = this->PlaceOf(trackingUID);
  return place < 0 ? 0 : m_Written.numbers[static_cast<std::size_t>(place)];
}

double
ColonSegmentsAsDicom::VolumeOf(const std::string & trackingUID) const
{
  const std::ptrdiff_t place = this->PlaceOf(trackingUID);
  const auto &         spacing = m_Parts->GetSpacing();
  const double         voxel = spacing[0] * spacing[1] * spacing[2] / 1000.0;
  return place < 0 ? 0.0 : voxel * static_cast<double>(m_Written.voxels[static_cast<std::size_t>(place)]);
}
} // namespace shapeton
