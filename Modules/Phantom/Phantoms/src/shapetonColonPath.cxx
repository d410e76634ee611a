#include "shapetonColonPath.h"

#include "shapetonColonAnatomy.h"
#include "shapetonColonNoise.h"
#include "shapetonColonRelaxation.h"
#include "shapetonPi.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shapeton
{
using Eigen::Vector3d;

namespace
{
constexpr int    c_Segments = 6;            // rectum to cecum
constexpr int    c_AscendingColon = 5;      // number of the segment
constexpr double c_RoomAroundIleum = 8.0;   // mm
constexpr double c_ShortestCurve = 15.0;    // mm, of a segment
constexpr double c_SpineBehind = 80.0;      // mm behind the middle of the abdomen
constexpr double c_SacralCurve = 40.0;      // mm, depth of the backward curve
constexpr int    c_RestRounds = 700;        // of relaxation, from the template to the patient
constexpr int    c_PositionRounds = 250;    // of relaxation, from rest to a position
constexpr double c_CecumByGravity = 0.4;    // relative to the move of the cecum to the side and along the body
constexpr double c_CaliberVariation = 0.11; // of the radius
constexpr double c_Contraction = 0.42;      // of the radius, in contracted stretches of the sigmoid
constexpr double c_LooseContraction = 0.35; // value of the noise at which a contraction starts
constexpr double c_FullContraction = 0.9;   // value of the noise at which it is complete
constexpr double c_CanalEnd = 22.0;         // mm from the anal verge
constexpr double c_AmpullaBegin = 55.0;     // mm from the anal verge
constexpr double c_Sag = 20.0;              // mm of mobile stretches along gravity
constexpr double c_MobileShift = 13.0;      // mm of mobile stretches in random directions
constexpr double c_FixedShift = 3.0;        // mm of all stretches, from the end of the ampulla

// Thickness (mm) of the septa at contacts.
constexpr DrawnRange c_Septa{ 1.0, 2.5 };
constexpr DrawnRange c_HardSepta{ 0.8, 1.8 };

// Template points of a colon, from drawings and CT of the abdomen; each segment starts at the end of the previous one.
struct TemplateSegment
{
  double                shortest; // mm
  double                longest;  // mm
  std::vector<Vector3d> points;
};

const std::vector<TemplateSegment> &
Template()
{
  static const std::vector<TemplateSegment> segments{
    { 150,
      165,
      { { 0, 50, -156 }, { 0, 43, -127 }, { 0, 54, -110 }, { -4, 66, -90 }, { 4, 60, -64 }, { 0, 36, -48 } } },
    { 500,
      760,
      { { 0, 36, -48 },
        { -28, 16, -40 },
        { -62, 0, -50 },
        { -72, -35, -40 },
        { -45, -62, -22 },
        { -5, -72, -32 },
        { 25, -62, -62 },
        { 26, -20, -85 },
        { 55, 0, -92 },
        { 88, 15, -75 },
        { 108, 44, -45 } } },
    { 255,
      330,
      { { 108, 44, -45 }, { 122, 48, -15 }, { 106, 58, 20 }, { 122, 56, 55 }, { 110, 62, 92 }, { 108, 44, 126 } } },
    { 620,
      900,
      { { 108, 44, 126 },
        { 82, 18, 130 },
        { 80, -24, 110 },
        { 84, -60, 65 },
        { 50, -74, 22 },
        { 14, -74, -5 },
        { -14, -72, 18 },
        { -44, -74, 2 },
        { -68, -66, 40 },
        { -80, -34, 68 },
        { -98, 8, 92 } } },
    { 200, 245, { { -98, 8, 92 }, { -114, 44, 84 }, { -112, 58, 45 }, { -122, 54, 5 }, { -114, 50, -35 } } },
    { 55, 65, { { -114, 50, -35 }, { -112, 36, -60 }, { -102, 18, -82 } } },
  };
  return segments;
}

constexpr int c_Sigmoid = 2; // number of the segment

// A sigmoid without a loop, along the pelvic floor; one point for each point of the template.
const std::vector<Vector3d> &
StraightSigmoid()
{
  static const std::vector<Vector3d> points{ { 0, 36, -48 },   { -4, 18, -58 },  { -2, 0, -70 },   { 6, -16, -80 },
                                             { 20, -26, -86 }, { 36, -28, -90 }, { 54, -20, -90 }, { 72, -6, -86 },
                                             { 88, 10, -76 },  { 100, 28, -62 }, { 108, 44, -45 } };
  return points;
}

// Points of a segment; those of the sigmoid include the shape of its loop.
std::vector<Vector3d>
PointsOf(const TemplateSegment & segment, int number, const ColonPhantomParameters & parameters)
{
  std::vector<Vector3d> points = segment.points;
  const double          last = static_cast<double>(points.size() - 1);
  for (std::size_t i = 0; number == c_Sigmoid && i < points.size(); ++i)
  {
    // Highest in the middle of the loop, with fixed ends.
    const double risen = std::sin(Pi * static_cast<double>(i) / last);
    points[i].z() += parameters.sigmoidRise * risen * risen;
    points[i] += parameters.sigmoidStraightness * (StraightSigmoid()[i] - points[i]);
  }
  return points;
}

Vector3d
CatmullRom(const std::vector<Vector3d> & points, double t)
{
  const int  last = static_cast<int>(points.size()) - 1;
  const int  i = std::min(static_cast<int>(t), last - 1);
  const auto at = [&](int k) {
    return k < 0 ? Vector3d(2 * points[0] - points[1])
                 : (k > last ? Vector3d(2 * points[last] - points[last - 1]) : points[k]);
  };
  const double   x = t - i;
  const Vector3d a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
  const Vector3d quadratic = 2 * a - 5 * b + 4 * c - d;
  return 0.5 * (2 * b + x * (c - a) + x * x * quadratic + x * x * x * (3 * b - a - 3 * c + d));
}

// Smooth lateral changes of the template, small where the colon is fixed.
Vector3d
PatientOffset(unsigned seed, double place, int segment)
{
  ColonRandom       random(seed, ColonStream::Template);
  const SmoothNoise x(random, 40, 4), y(random, 40, 4), z(random, 40, 4);
  const double      amplitude = segment == 1 ? 2.0 : (segment == 2 || segment == 4 ? 22.0 : 8.0);
  return amplitude * Vector3d(x(place), y(place), z(place));
}

// Length of a segment; the cecum extends beyond the end of the curve by its radius.
double
CurveLength(const ColonPhantomParameters & parameters, std::size_t segment, double ofTemplate)
{
  const double length = parameters.lengths[segment];
  if (length == 0.0)
  {
    return ofTemplate;
  }
  const double cap = segment == 5 ? 0.5 * parameters.caliber[segment] : 0.0;
  return std::max(length - cap, c_ShortestCurve);
}

// Radii (mm) at the start, the middle and the end of each segment, from the rectum to the cecum.
using RadiusTable = std::array<std::array<double, 3>, c_Segments>;
constexpr RadiusTable c_Radii{
  { { 22, 24, 15 }, { 14, 12, 14 }, { 15, 17, 19 }, { 20, 21, 22 }, { 22, 23.5, 25 }, { 25, 27, 27 } }
};

RadiusTable
RadiiOf(const SegmentValues & caliber)
{
  RadiusTable table = c_Radii;
  for (std::size_t k = 0; k < table.size(); ++k)
  {
    if (caliber[k] != 0.0)
    {
      table[k].fill(0.5 * caliber[k]);
    }
  }
  // Blends given values gradually.
  for (std::size_t k = 1; k < table.size(); ++k)
  {
    if (caliber[k] != 0.0 || caliber[k - 1] != 0.0)
    {
      table[k - 1][2] = table[k][0] = 0.5 * (table[k - 1][1] + table[k][1]);
    }
  }
  return table;
}

Vector3d
GravityOf(const std::string & position)
{
  static const Vector3d directions[] = { { 0, 1, 0 }, { 0, -1, 0 }, { 1, 0, 0 }, { -1, 0, 0 } };
  return directions[PositionNumber(position) - 1];
}

// Displacement of the cecum in a position: medially, up or down, and along gravity.
Vector3d
CecumMove(const ColonPhantomParameters & parameters)
{
  ColonRandom    random(parameters.seed, ColonStream::CecumMove, PositionNumber(parameters.position));
  const double   share = random.Uniform();
  const Vector3d aside(random.Uniform(0.2, 1.0), 0.0, random.Uniform(-0.4, 1.0));
  return parameters.cecumMobility * share * (aside + c_CecumByGravity * GravityOf(parameters.position)).normalized();
}

double
Mobility(int segment, double share)
{
  const bool mobile = segment == 2 || segment == 4;
  return mobile ? std::sin(Pi * share) : 0.0;
}

std::vector<double>
Mobilities(const ColonPath & path)
{
  std::vector<double> result(path.nodes.size());
  for (int segment = 1; segment <= 6; ++segment)
  {
    const auto range = std::equal_range(path.segment.begin(), path.segment.end(), segment);
    const auto first = range.first - path.segment.begin();
    const auto count = range.second - range.first;
    for (long i = 0; i < count; ++i)
    {
      result[first + i] = Mobility(segment, (i + 0.5) / count);
    }
  }
  return result;
}

// The hepatic flexure is the highest point of its bend. If the lengths of the patient stretch the template, relaxation
// moves it along the colon; the segment border follows.
void
MoveHepaticFlexureToHighest(ColonPath & path)
{
  constexpr long reach = 6; // nodes
  const auto     first = path.segment.begin();
  const long     border = std::lower_bound(first, path.segment.end(), c_AscendingColon) - first;
  const auto     heightAt = [&](long node) { return path.nodes[node].z(); };
  const long     step = heightAt(border + 1) > heightAt(border - 1) ? 1 : -1;
  long           highest = border;
  while (std::abs(highest - border) < reach && heightAt(highest + step) > heightAt(highest))
  {
    highest += step;
  }
  std::fill(first + std::min(border, highest),
            first + std::max(border, highest),
            step > 0 ? c_AscendingColon - 1 : c_AscendingColon);
}
} // namespace

unsigned
PositionNumber(const std::string & position)
{
  return position == "supine" ? 1 : (position == "prone" ? 2 : (position == "leftDecubitus" ? 3 : 4));
}

Vector3d
ColonAnatomy::SpineAxis(double z)
{
  // The sacrum curves backward behind the rectum and forward again at its tip.
  const double below = std::clamp((-50.0 - z) / 90.0, 0.0, 1.0);
  return { 0.0, c_SpineBehind + c_SacralCurve * std::sin(3.0 * below), z };
}

ColonPath
RestPath(const ColonPhantomParameters & parameters)
{
  const unsigned seed = parameters.seed;
  ColonPath      path;
  ColonRandom    random(seed, ColonStream::SegmentLengths);
  double         material = 0.0;
  double         place = 0.0;
  for (std::size_t k = 0; k < Template().size(); ++k)
  {
    const TemplateSegment & segment = Template()[k];
    const double            own = random.Uniform(segment.shortest, segment.longest);
    const double            length = CurveLength(parameters, k, own);
    const int               edges = static_cast<int>(std::lround(length / 10.0));
    const bool              isLast = k + 1 == Template().size();
    const double            knots = static_cast<double>(segment.points.size() - 1);
    const auto              points = PointsOf(segment, static_cast<int>(k) + 1, parameters);
    for (int i = 0; i < edges + (isLast ? 1 : 0); ++i)
    {
      const double t = knots * i / edges;
      path.nodes.push_back(CatmullRom(points, t) + PatientOffset(seed, place + t, static_cast<int>(k) + 1));
      path.material.push_back(material + length * i / edges);
      path.segment.push_back(static_cast<int>(k) + 1);
    }
    material += length;
    place += knots;
  }
  const std::vector<double> radius = RestRadius(path, parameters, static_cast<int>(path.nodes.size()));
  ColonRelaxation           relaxation(path, radius);
  relaxation.SetMobility(Mobilities(path));
  relaxation.Run(c_RestRounds);
  path.nodes = relaxation.GetNodes();
  if (parameters.lengths != SegmentValues())
  {
    MoveHepaticFlexureToHighest(path);
  }
  // The patient is defined by the lengths that remain after smoothing and after fitting into the available space.
  for (std::size_t i = 1; i < path.nodes.size(); ++i)
  {
    path.material[i] = path.material[i - 1] + (path.nodes[i] - path.nodes[i - 1]).norm();
  }
  return path;
}

namespace
{
/** A contracted stretch of the sigmoid; empty if begin == end. */
struct Spasm
{
  double begin; ///< mm of material length
  double end;
  double radius; ///< mm

  double
  ShareAt(double material) const
  {
    constexpr double transition = 20.0; // mm at each end
    return end <= begin
             ? 0.0
             : SmoothStep(begin - transition, begin, material) * SmoothStep(-end - transition, -end, -material);
  }
};

// `ends` are the ends of the segments; their index starts at 1.
Spasm
SpasmOf(const ColonPhantomParameters & parameters, const std::vector<double> & ends)
{
  constexpr DrawnRange radius{ 4.75, 6.05 }; // mm; distension varies the caliber to 8 to 14 mm
  constexpr double     margin = 20.0;        // mm to other segments
  ColonRandom          random(parameters.seed, ColonStream::Spasm);
  const double         first = ends[c_Sigmoid - 1] + margin;
  const double         room = ends[c_Sigmoid] - margin - first;
  const double         length = std::min(parameters.spasm, room);
  const double         start = first + random.Uniform() * (room - length);
  return { start, start + length, random.Uniform(radius) };
}
} // namespace

std::vector<double>
RestRadius(const ColonPath & path, const ColonPhantomParameters & parameters, int count)
{
  const auto &        caliber = parameters.caliber;
  const RadiusTable   table = RadiiOf(caliber);
  ColonRandom         random(parameters.seed, ColonStream::Radius);
  const SmoothNoise   slow(random, path.Length(), 70.0);
  const SmoothNoise   narrow(random, path.Length(), 30.0);
  std::vector<double> begin(c_Segments + 1, 0.0);
  for (int segment = 1; segment <= c_Segments; ++segment)
  {
    const auto next = std::upper_bound(path.segment.begin(), path.segment.end(), segment) - path.segment.begin();
    begin[segment] = next < static_cast<long>(path.material.size()) ? path.material[next] : path.Length();
  }
  const Spasm         spasm = SpasmOf(parameters, begin);
  const double        widest = std::max(28.0, 0.55 * *std::max_element(caliber.begin(), caliber.end()));
  const double        canal = 0.5 * parameters.catheterBore + parameters.catheterWall;
  std::vector<double> radius(count);
  for (int i = 0; i < count; ++i)
  {
    const double m = path.Length() * i / (count - 1);
    int          segment = 1;
    while (segment < c_Segments && m >= begin[segment])
    {
      ++segment;
    }
    const auto & r = table[segment - 1];
    const double x = 2.0 * (m - begin[segment - 1]) / (begin[segment] - begin[segment - 1]);
    double       value = x < 1 ? r[0] + x * (r[1] - r[0]) : r[1] + (x - 1) * (r[2] - r[1]);
    value *= 1.0 + c_CaliberVariation * slow(m);
    // Contracted stretches of the sigmoid.
    value *= 1.0 - (segment == 2 ? c_Contraction : 0.0) * SmoothStep(c_LooseContraction, c_FullContraction, narrow(m));
    value += spasm.ShareAt(m) * (spasm.radius - value);
    // From the anal canal, as wide as the catheter, to the ampulla.
    radius[i] = canal + (std::min(value, widest) - canal) * SmoothStep(c_CanalEnd, c_AmpullaBegin, m);
  }
  return radius;
}

ColonPath
PositionedPath(const ColonPath & rest, const std::vector<double> & radius, const ColonPhantomParameters & parameters)
{
  ColonPath         path = rest;
  const unsigned    position = PositionNumber(parameters.position);
  ColonRandom       random(parameters.seed, ColonStream::Displacement, position);
  const SmoothNoise x(random, rest.Length(), 130.0), y(random, rest.Length(), 130.0), z(random, rest.Length(), 130.0);
  const auto        mobility = Mobilities(rest);
  const Vector3d    gravity = GravityOf(parameters.position);
  const Vector3d    move = CecumMove(parameters);
  const auto        right =
    std::lower_bound(path.segment.begin(), path.segment.end(), c_AscendingColon) - path.segment.begin();
  for (std::size_t i = 0; i < path.nodes.size(); ++i)
  {
    const double   m = rest.material[i];
    const Vector3d random3(x(m), y(m), z(m));
    const double   free = SmoothStep(60.0, 140.0, m);
    path.nodes[i] += mobility[i] * (c_Sag * gravity + c_MobileShift * random3) + c_FixedShift * free * random3;
    path.nodes[i] += SmoothStep(rest.material[right], rest.Length(), m) * move;
  }
  ColonRelaxation     relaxation(path, radius);
  std::vector<double> held(path.nodes.size(), 0.0);
  relaxation.SetMobility(held);
  if (parameters.valve == "lips")
  {
    const auto cecum = std::lower_bound(path.segment.begin(), path.segment.end(), c_Segments) - path.segment.begin();
    relaxation.LeaveRoomAt(static_cast<int>(cecum), parameters.ileumBore + c_RoomAroundIleum);
  }
  relaxation.Run(c_PositionRounds);
  const bool  isHard = parameters.preset == "hard";
  ColonRandom septa(parameters.seed, ColonStream::Septa, position);
  path.contacts = relaxation.FindContacts(parameters.fakeHandles);
  for (ColonPath::Contact & contact : path.contacts)
  {
    contact.septum = septa.Uniform(isHard ? c_HardSepta : c_Septa);
  }
  relaxation.DrawTogether(path.contacts);
  relaxation.Run(c_PositionRounds);
  path.nodes = relaxation.GetNodes();
  return path;
}
} // namespace shapeton
