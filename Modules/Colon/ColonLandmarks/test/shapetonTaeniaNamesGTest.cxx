#include "shapetonTaeniaNames.h"
#include "shapetonSchematicColon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

namespace
{
using shapeton::TaeniaName;
constexpr double pi = 3.14159265358979323846;

/** The libera of a segment (3 descending, 4 transverse, 5 ascending): in front, or below and 30 degrees backward. */
Eigen::Vector3d
Libera(int segment)
{
  return segment == 4 ? Eigen::Vector3d(0.0, 0.5, -std::sqrt(0.75)) : Eigen::Vector3d(0.0, -1.0, 0.0);
}

struct NamedColon
{
  shapeton::CurveSet      centerline;
  shapeton::ColonSegments segments;
  shapeton::ColonTaeniae  taeniae;
};

/** Taeniae 20 mm from the centerline, in the row order of the flat map: libera, mesocolica, omentalis.
 * \param turned degrees by which each segment from the rectum is turned. */
NamedColon
MakeNamedColon(const std::array<double, 6> & turned = {})
{
  const SchematicColon schematic = MakeSchematicColon();
  NamedColon           colon;
  colon.centerline = schematic.centerline;
  for (int k = 0; k < 4; ++k)
  {
    colon.segments.borders.push_back({ k + 1, {}, schematic.flexures[k], 1.0, {} });
  }
  const shapeton::SurfaceArray::ValueMatrix & arc = colon.centerline.pointArrays[0].values;
  colon.segments.borders.push_back({ 5, {}, arc(arc.rows() - 1, 0) - 60.0, 1.0, {} });
  colon.taeniae.taeniae.resize(3);
  for (Eigen::Index i = 5; i + 5 < arc.rows(); ++i)
  {
    int segment = 1;
    for (const shapeton::SegmentBorder & border : colon.segments.borders)
    {
      segment += arc(i, 0) > border.arcLength;
    }
    const Eigen::Vector3d along = (colon.centerline.V.row(i + 5) - colon.centerline.V.row(i - 5)).normalized();
    const Eigen::Vector3d libera = (Libera(segment) - Libera(segment).dot(along) * along).normalized();
    for (int taenia = 0; taenia < 3; ++taenia)
    {
      const double angle = (-120.0 * taenia + turned[segment - 1]) * pi / 180.0;
      colon.taeniae.taeniae[taenia].points.emplace_back(colon.centerline.V.row(i).transpose() +
                                                        20.0 * (Eigen::AngleAxisd(angle, along) * libera));
      colon.taeniae.taeniae[taenia].arcLength.push_back(arc(i, 0));
    }
  }
  return colon;
}

shapeton::TaeniaNames
NamesOf(const NamedColon & colon)
{
  return shapeton::NameTaeniae(colon.taeniae, colon.centerline, colon.segments);
}
} // namespace

TEST(TaeniaNames, FollowFromTheDirections)
{
  const shapeton::TaeniaNames names = NamesOf(MakeNamedColon());
  ASSERT_TRUE(names.AreKnown()) << names.reason;
  EXPECT_EQ(names.names[0], TaeniaName::Libera);
  EXPECT_EQ(names.names[1], TaeniaName::Mesocolica);
  EXPECT_EQ(names.names[2], TaeniaName::Omentalis);
  ASSERT_EQ(names.evidence.size(), 3u);
  for (const shapeton::TaeniaNameEvidence & one : names.evidence)
  {
    EXPECT_GT(one.agreement[0], 0.95) << one.segment;
  }
  EXPECT_EQ(NameOf(TaeniaName::Mesocolica), "mesocolica");
}

/** In front of ascending and descending colon, the omentalis is lateral, the mesocolica medial. */
TEST(TaeniaNames, OmentalisIsLateral)
{
  const NamedColon colon = MakeNamedColon();
  const auto       middle = [&](int taenia, int border) {
    const auto & one = colon.taeniae.taeniae[taenia];
    const double s = 0.5 * (colon.segments.borders[border - 1].arcLength + colon.segments.borders[border].arcLength);
    const auto   at = std::lower_bound(one.arcLength.begin(), one.arcLength.end(), s) - one.arcLength.begin();
    return one.points[at];
  };
  EXPECT_GT(middle(2, 2).x(), middle(1, 2).x() + 20.0); // descending, on the left
  EXPECT_LT(middle(2, 4).x(), middle(1, 4).x() - 20.0); // ascending, on the right
  EXPECT_LT(middle(2, 3).y(), middle(1, 3).y() - 20.0); // transverse: in front
}

TEST(TaeniaNames, FollowTheNumbers)
{
  NamedColon colon = MakeNamedColon({ { 20.0, 20.0, 20.0, -20.0, 20.0, 20.0 } });
  std::rotate(colon.taeniae.taeniae.begin(), colon.taeniae.taeniae.begin() + 1, colon.taeniae.taeniae.end());
  const shapeton::TaeniaNames names = NamesOf(colon);
  ASSERT_TRUE(names.AreKnown()) << names.reason;
  EXPECT_EQ(names.names[0], TaeniaName::Mesocolica);
  EXPECT_EQ(names.names[1], TaeniaName::Omentalis);
  EXPECT_EQ(names.names[2], TaeniaName::Libera);
}

TEST(TaeniaNames, AreUnknownWithTheReason)
{
  const auto reasonOf = [](const NamedColon & colon) {
    const shapeton::TaeniaNames names = NamesOf(colon);
    EXPECT_FALSE(names.AreKnown());
    return names.reason;
  };
  EXPECT_EQ(reasonOf(MakeNamedColon({ { 0.0, 0.0, 0.0, 0.0, 120.0, 0.0 } })),
            "the descending and the ascending contradict each other");
  EXPECT_EQ(reasonOf(MakeNamedColon({ { 0.0, 0.0, 60.0, 0.0, 0.0, 0.0 } })),
            "the descending is turned halfway between two taeniae");
  NamedColon colon = MakeNamedColon();
  colon.segments.borders.resize(2);
  EXPECT_EQ(reasonOf(colon), "fewer than two of descending, transverse and ascending colon are known");
  colon.taeniae.taeniae.clear();
  EXPECT_EQ(reasonOf(colon), "no taeniae were found");
}
