#include "shapetonBodySampler.h"
#include "shapetonColonAbdomen.h"
#include "shapetonColonPhantomImageSource.h"
#include "shapetonDisjointSets.h"
#include "shapetonTestFrames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace
{
using Eigen::Vector3d;
using shapeton::ColonStructure;
using ChestSource = shapeton::ColonPhantomImageSource;
using ChestLabels = ChestSource::LabelImageType;

shapeton::ColonPhantomParameters
ChestParameters(const std::string & lungs, const std::string & position = "supine")
{
  auto parameters = shapeton::ColonPhantomPreset("standard");
  parameters.seed = 4;
  parameters.lungs = lungs;
  parameters.position = position;
  parameters.noise = 0.0;
  return parameters;
}

shapeton::ColonPhantomParameters
Without(shapeton::ColonPhantomParameters parameters, const std::string & organ)
{
  auto & contents = parameters.contents;
  contents.erase(std::remove(contents.begin(), contents.end(), organ), contents.end());
  return parameters;
}

bool
IsLobe(ColonStructure structure)
{
  return structure >= ColonStructure::RightUpperLobe && structure <= ColonStructure::LeftLowerLobe;
}

// Evaluates the intensities of a patient at points, with or without scanner blur.
class ScannedPatient
{
public:
  explicit ScannedPatient(const shapeton::ColonPhantomParameters & parameters)
    : m_Anatomy(parameters), m_Fluid(m_Anatomy), m_Structures(m_Anatomy, m_Fluid), m_Grid(ChestLabels::New())
  {
    m_Grid->SetRegions(itk::Size<3>{ { 2000, 2000, 2000 } });
    m_Grid->SetSpacing(ChestLabels::SpacingType(0.5));
    const double origin[3] = { -500.0, -500.0, -500.0 };
    m_Grid->SetOrigin(origin);
    const auto bodies = shapeton::MakeColonAbdomen(m_Anatomy, m_Fluid, m_Structures);
    for (const double blur : { 0.0, 0.75 })
    {
      m_Samplers.push_back(std::make_unique<shapeton::BodySampler>(
        bodies, m_Grid, std::array<double, 3>{ { blur, blur, blur } }, shapeton::airIntensity));
    }
  }

  ColonStructure
  LabelAt(const Vector3d & p) const
  {
    return m_Structures.At(p);
  }

  double
  IntensityAt(const Vector3d & p, bool blurred = false) const
  {
    const double        values[3] = { p[0], p[1], p[2] };
    itk::ImageRegion<3> voxel;
    voxel.SetIndex(m_Grid->TransformPhysicalPointToIndex(itk::Point<double, 3>(values)));
    voxel.SetSize({ { 1, 1, 1 } });
    return m_Samplers[blurred ? 1 : 0]->Sample(voxel).front();
  }

  // Calls visit(point) for lattice points (`step` mm) of lobes at least 2 mm from other structures.
  template <typename TVisitor>
  void
  VisitLungs(double step, const TVisitor & visit) const
  {
    for (double z = 62.0; z < 350.0; z += step)
    {
      for (double y = -98.0; y < 118.0; y += step)
      {
        for (double x = -148.0; x < 148.0; x += step)
        {
          const Vector3d p(x, y, z);
          const auto     label = this->LabelAt(p);
          bool           isDeep = IsLobe(label);
          for (unsigned int i = 0; i < 6 && isDeep; ++i)
          {
            isDeep = this->LabelAt(p + (i % 2 ? 2.0 : -2.0) * Vector3d::Unit(i / 2)) == label;
          }
          if (isDeep)
          {
            visit(p);
          }
        }
      }
    }
  }

private:
  shapeton::ColonAnatomy                              m_Anatomy;
  shapeton::ColonFluid                                m_Fluid;
  shapeton::ColonStructures                           m_Structures;
  ChestLabels::Pointer                                m_Grid;
  std::vector<std::unique_ptr<shapeton::BodySampler>> m_Samplers;
};

ChestSource::Pointer
MakeChest(const shapeton::ColonPhantomParameters & parameters,
          const ChestSource::SizeType &            size,
          const Vector3d &                         spacing,
          const Vector3d &                         center)
{
  const auto source = ChestSource::New();
  source->SetParameters(parameters);
  source->SetSize(size);
  source->SetSpacing(ChestSource::SpacingType(spacing.data()));
  const double values[3] = { center[0], center[1], center[2] };
  source->CenterOutput(itk::Point<double, 3>(values));
  return source;
}
} // namespace

// At least 3000 points with a standard deviation below 60 HU: the sample mean is accurate to about 1 HU.
TEST(ColonChest, LungsHaveTheDensityAskedFor)
{
  struct Case
  {
    const char * lungs;
    double       density;
    double       wanted;
  };
  for (const Case & one : { Case{ "inspiration", shapeton::lungDensityOfState, -865.0 },
                            Case{ "quietBreathing", shapeton::lungDensityOfState, -765.0 },
                            Case{ "emphysema", shapeton::lungDensityOfState, -940.0 },
                            Case{ "quietBreathing", -620.0, -620.0 } })
  {
    auto parameters = ChestParameters(one.lungs);
    parameters.lungDensity = one.density;
    const ScannedPatient patient(parameters);
    double               sum = 0.0;
    double               highest = -1000.0;
    std::size_t          count = 0;
    std::size_t          holes = 0;
    patient.VisitLungs(9.3, [&](const Vector3d & p) {
      const double value = patient.IntensityAt(p);
      sum += value;
      highest = std::max(highest, value);
      holes += value < -985.0;
      ++count;
    });
    EXPECT_GT(count, 3000U);
    EXPECT_NEAR(sum / static_cast<double>(count), one.wanted, 4.0) << one.lungs;
    // Labeled lung must not contain liver (62 HU), muscle or bone; thin vessels (42 HU) are allowed.
    EXPECT_LT(highest, 50.0) << one.lungs;
    EXPECT_EQ(holes > count / 50, one.lungs == std::string("emphysema")) << holes;
  }
}

TEST(ColonChest, TheDependentSideIsDenser)
{
  for (const char * position : { "supine", "prone" })
  {
    const ScannedPatient patient(ChestParameters("quietBreathing", position));
    double               sums[2] = { 0.0, 0.0 };
    double               counts[2] = { 0.0, 0.0 };
    patient.VisitLungs(14.0, [&](const Vector3d & p) {
      const int side = p[1] > 10.0 ? 1 : 0;
      sums[side] += patient.IntensityAt(p);
      counts[side] += 1.0;
    });
    const double posteriorMinusAnterior = sums[1] / counts[1] - sums[0] / counts[0];
    EXPECT_GT(position == std::string("supine") ? posteriorMinusAnterior : -posteriorMinusAnterior, 40.0) << position;
  }
}

// On lines through the lungs, two lobes are separated by a fissure, which is a thin line in the image.
TEST(ColonChest, FissuresDivideTheLobes)
{
  const ScannedPatient  patient(ChestParameters("inspiration"));
  std::set<std::string> kinds;
  int                   faint = 0;
  int                   fissures = 0;
  for (double x = -110.0; x < 120.0; x += 16.0)
  {
    for (double y = -60.0; y < 90.0; y += 20.0)
    {
      ColonStructure lobe = ColonStructure::None;
      double         left = 0.0; // z of the end of the lobe
      for (double z = 160.0; z < 330.0; z += 0.1)
      {
        const ColonStructure label = patient.LabelAt({ x, y, z });
        if (IsLobe(label))
        {
          if (IsLobe(lobe) && label != lobe && z - left < 1.5)
          {
            ++fissures;
            kinds.insert(std::to_string(static_cast<int>(lobe)) + '-' + std::to_string(static_cast<int>(label)));
            EXPECT_GT(z - left, 0.3);
            const double inside = patient.IntensityAt({ x, y, 0.5 * (left + z) }, true);
            const double beside =
              std::max(patient.IntensityAt({ x, y, left - 4.0 }, true), patient.IntensityAt({ x, y, z + 4.0 }, true));
            faint += inside < beside + 60.0;
          }
          lobe = label;
          left = z;
        }
        else if (label != ColonStructure::None)
        {
          lobe = ColonStructure::None;
        }
      }
    }
  }
  EXPECT_EQ(kinds, (std::set<std::string>{ "13-12", "14-12", "14-13", "16-15" }));
  EXPECT_GT(fissures, 60);
  EXPECT_LT(faint, fissures / 10); // next to a vessel
}

// With voxels of 0.9 mm, adjacent vessels are one component, and the large components start at the hila.
TEST(ColonChest, VesselsAreTreesFromTheHila)
{
  const auto source =
    MakeChest(ChestParameters("inspiration"), { { 320, 240, 310 } }, { 0.9, 0.9, 0.9 }, { 0, 5, 210 });
  source->TruthOnlyOn();
  source->Update();
  const auto * const labels = source->GetStructureOutput();
  const auto         size = labels->GetLargestPossibleRegion().GetSize();
  const auto * const pixels = labels->GetBufferPointer();
  const auto        isVessel = [&](std::size_t i) { return pixels[i] == static_cast<int>(ColonStructure::LungVessel); };
  const std::size_t strides[3] = { 1, size[0], size[0] * size[1] };
  const std::size_t count = strides[2] * size[2];
  shapeton::DisjointSets<std::size_t> pieces(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto index = labels->ComputeIndex(static_cast<itk::OffsetValueType>(i));
    for (int k = 14; k < 27 && isVessel(i); ++k)
    {
      const int step[3] = { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 };
      bool      isInside = true;
      auto      other = static_cast<std::ptrdiff_t>(i);
      for (unsigned int a = 0; a < 3; ++a)
      {
        isInside = isInside && index[a] + step[a] >= 0 && index[a] + step[a] < static_cast<int>(size[a]);
        other += step[a] * static_cast<std::ptrdiff_t>(strides[a]);
      }
      if (isInside && isVessel(static_cast<std::size_t>(other)))
      {
        pieces.Join(i, static_cast<std::size_t>(other));
      }
    }
  }
  std::vector<char> reachesHilum(count, 0);
  std::size_t       lungs = 0;
  std::size_t       vessels = 0;
  std::size_t       connected = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = labels->GetOrigin()[0] + 0.9 * static_cast<double>(i % size[0]);
    lungs += IsLobe(static_cast<ColonStructure>(pixels[i]));
    if (isVessel(i) && std::abs(x) < 42.0)
    {
      reachesHilum[pieces.Find(i)] = 1;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    vessels += isVessel(i);
    connected += isVessel(i) && reachesHilum[pieces.Find(i)];
  }
  EXPECT_GT(static_cast<double>(connected), 0.97 * static_cast<double>(vessels));
  const double share = static_cast<double>(vessels) / static_cast<double>(lungs + vessels);
  EXPECT_GT(share, 0.02);
  EXPECT_LT(share, 0.15);
}

// Changes are limited to the organ, its wall of at most 4 mm (more at edges), half a voxel diagonal and the blur.
TEST(ColonChest, LeavingAnOrganOutChangesNothingElse)
{
  struct Case
  {
    const char *             organ;
    std::set<ColonStructure> labels; // other than the lumen
    Vector3d                 center;
  };
  const std::set<ColonStructure> lung{ ColonStructure::RightUpperLobe, ColonStructure::RightMiddleLobe,
                                       ColonStructure::RightLowerLobe, ColonStructure::LeftUpperLobe,
                                       ColonStructure::LeftLowerLobe,  ColonStructure::Airway,
                                       ColonStructure::AirwayWall,     ColonStructure::LungVessel };
  for (const Case & one : { Case{ "colon", { ColonStructure::Valve }, { -60, -20, 20 } },
                            Case{ "stomach", { ColonStructure::Stomach }, { 58, -38, 100 } },
                            Case{ "smallBowel", { ColonStructure::SmallBowel }, { 0, -30, -30 } },
                            Case{ "lungs", lung, { -70, 10, 190 } },
                            Case{ "heart", { ColonStructure::Heart }, { 20, -30, 195 } } })
  {
    const auto whole = ChestParameters("inspiration");
    const auto with = MakeChest(whole, { { 36, 36, 36 } }, { 2.4, 2.4, 2.4 }, one.center);
    const auto without = MakeChest(Without(whole, one.organ), { { 36, 36, 36 } }, { 2.4, 2.4, 2.4 }, one.center);
    with->Update();
    without->Update();
    const bool isColon = one.organ == std::string("colon");
    const auto isPart = [&](const itk::Index<3> & index) {
      return (isColon && with->GetLumenOutput()->GetPixel(index) != 0) ||
             one.labels.count(static_cast<ColonStructure>(with->GetStructureOutput()->GetPixel(index))) > 0;
    };
    std::size_t changed = 0;
    std::size_t outside = 0;
    std::size_t left = 0;
    basetest::ForVoxels(with->GetOutput(), [&](const auto & index, const auto &) {
      left += one.labels.count(static_cast<ColonStructure>(without->GetStructureOutput()->GetPixel(index)));
      left += isColon && without->GetLumenOutput()->GetPixel(index) != 0;
      if (with->GetOutput()->GetPixel(index) == without->GetOutput()->GetPixel(index) || index[0] < 5 || index[1] < 5 ||
          index[2] < 5 || index[0] > 30 || index[1] > 30 || index[2] > 30)
      {
        return;
      }
      ++changed;
      bool isNear = false;
      for (int k = 0; k < 1331 && !isNear; ++k)
      {
        const itk::Offset<3> offset{ { k % 11 - 5, k / 11 % 11 - 5, k / 121 - 5 } };
        const double distance = 2.4 * std::sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
        isNear = distance < 11.0 && isPart(index + offset);
      }
      outside += !isNear;
    });
    EXPECT_GT(changed, 400U) << one.organ;
    EXPECT_EQ(outside, 0U) << one.organ;
    EXPECT_EQ(left, 0U) << one.organ;
  }
}

TEST(ColonChest, TheTableIsUnderThePatient)
{
  const auto           parameters = ChestParameters("plain");
  const ScannedPatient with(parameters);
  const ScannedPatient without(Without(parameters, "table"));
  EXPECT_NEAR(with.IntensityAt({ 0, 152, 0 }), -920.0, 1.0);
  EXPECT_NEAR(without.IntensityAt({ 0, 152, 0 }), -1000.0, 1.0);
}

/** Expects that voxels of two volumes with the same point have the same label, except for a few, and nearly the same
 * intensity. */
void
ExpectSamePatient(ChestSource * one, ChestSource * other, std::size_t mostOtherLabels, double tolerance)
{
  one->Update();
  other->Update();
  double      largest = 0.0;
  std::size_t otherLabels = 0;
  basetest::ForVoxels(one->GetOutput(), [&](const auto & index, const auto & point) {
    itk::Index<3> same;
    if (other->GetOutput()->TransformPhysicalPointToIndex(point, same))
    {
      otherLabels += one->GetStructureOutput()->GetPixel(index) != other->GetStructureOutput()->GetPixel(same) ||
                     one->GetLumenOutput()->GetPixel(index) != other->GetLumenOutput()->GetPixel(same);
      largest =
        std::max(largest, std::abs(1.0 * one->GetOutput()->GetPixel(index) - other->GetOutput()->GetPixel(same)));
    }
  });
  EXPECT_LE(otherLabels, mostOtherLabels);
  EXPECT_LE(largest, tolerance);
}

// Axes z, -x, -y of the first grid, with three different spacings and the same voxels in space.
TEST(ColonChest, GridsWithOtherAxesShowTheSamePatient)
{
  for (const auto & [lungs, height] : { std::pair("emphysema", 240.0), { "plain", 0.0 } })
  {
    const auto                 parameters = ChestParameters(lungs);
    const Vector3d             center(10.0, 0.0, height);
    const auto                 straight = MakeChest(parameters, { { 24, 20, 28 } }, { 9, 8, 7 }, center);
    const auto                 turned = MakeChest(parameters, { { 28, 24, 20 } }, { 7, 9, 8 }, center);
    ChestSource::DirectionType direction;
    direction.Fill(0.0);
    direction(2, 0) = 1.0;
    direction(0, 1) = -1.0;
    direction(1, 2) = -1.0;
    turned->SetDirection(direction);
    turned->CenterOutput(itk::Point<double, 3>(center.data()));
    ExpectSamePatient(turned, straight, 3, 2.0);
  }
}

// Shifted by two voxels along x and three along z.
TEST(ColonChest, AMovedVolumeShowsTheSamePatient)
{
  const auto parameters = ChestParameters("inspiration");
  ExpectSamePatient(MakeChest(parameters, { { 20, 16, 18 } }, { 8, 8, 8 }, { 16, 0, 224 }),
                    MakeChest(parameters, { { 20, 16, 18 } }, { 8, 8, 8 }, { 0, 0, 200 }),
                    0,
                    1.0);
}

TEST(ColonChest, AnObliqueGridSamplesTheSameChest)
{
  const auto source = MakeChest(ChestParameters("inspiration"), { { 30, 30, 30 } }, { 3, 4, 5 }, { 0, 0, 0 });
  source->SetDirection(basetest::Rotation(1, std::asin(0.6)));
  const double center[3] = { -60.0, 0.0, 230.0 };
  source->CenterOutput(itk::Point<double, 3>(center));
  source->TruthOnlyOn();
  source->Update();
  const auto * const labels = source->GetStructureOutput();
  std::set<int>      seen;
  basetest::ForVoxels(labels, [&](const auto & index, const auto & point) {
    EXPECT_EQ(static_cast<int>(source->GetStructures().At(basetest::ToEigen(point))), labels->GetPixel(index));
    seen.insert(labels->GetPixel(index));
  });
  EXPECT_GE(seen.size(), 6U);
}
