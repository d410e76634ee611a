#include "shapetonColonStructures.h"

#include "shapetonAbdomenParts.h"
#include "shapetonColonBody.h"
#include "shapetonColonStructurePart.h"
#include "shapetonDiverticulumBody.h"
#include "shapetonCatheterTube.h"
#include "shapetonForEachCell.h"
#include "shapetonLumenResidue.h"
#include "shapetonLungs.h"
#include "shapetonSigmoidContact.h"
#include "shapetonSmallBowel.h"
#include "shapetonPhantomIleum.h"
#include "shapetonThoraxParts.h"
#include "shapetonValveLips.h"

#include <Eigen/Geometry>

#include "itkImageRegionIterator.h"
#include "itkImageRegionIteratorWithIndex.h"

#include <algorithm>
#include <cmath>

namespace shapeton
{
namespace
{
using Eigen::Vector3d;
using PointType = PhantomBody::PointType;

constexpr double fatIntensity = -110.0; // HU
constexpr double behindBase = 3.0;      // mm; depth of the lips behind the wall
constexpr double flaskSlope = 1.5;      // at the junction of neck and sac
constexpr double stoolIntoWall = 0.35;  // mm; half a cell, so that no gas appears between stool and wall
constexpr double lipsSlope = 4.0;       // the distance to half ellipsoids may be too large by this factor

Vector3d
PlaceOf(const PointType & p)
{
  return { p[0], p[1], p[2] };
}

// The lips, including their part in the wall.
PhantomSolid
LipsSolid(const ColonValve & valve)
{
  const Vector3d  across = valve.direction.cross(valve.slit);
  const ValveLips lips{ valve.base, valve.direction, valve.slit, across, valve.length, valve.height, valve.thickness };
  const auto      distance = [lips](const PointType & p) { return lips.Distance(PlaceOf(p)).value; };
  const Vector3d  back = -valve.direction;
  const auto      above = HalfSpaceSolid(MakeVector(back[0], back[1], back[2]), back.dot(valve.base) + behindBase);
  return Both({ distance, lipsSlope }, above);
}

// A diverticulum beyond its mouth.
PhantomSolid
FlaskSolid(const ColonDiverticulum & diverticulum, double margin)
{
  const DiverticulumBody body = BodyOf(diverticulum);
  const auto             distance = [body](const PointType & p) { return body.Distance(PlaceOf(p)).value; };
  const Vector3d         back = (diverticulum.mouth - diverticulum.position).normalized();
  const auto             above = HalfSpaceSolid(MakeVector(back[0], back[1], back[2]), back.dot(diverticulum.mouth));
  return Both(Grown({ distance, flaskSlope }, margin), above);
}

// Volume (ml) of a solid within `reach` mm of an axis.
double
VolumeOf(const PhantomSolid & solid, const std::vector<Vector3d> & axis, double reach)
{
  constexpr double step = 1.5; // mm
  Vector3d         low = axis[0];
  Vector3d         high = axis[0];
  for (const Vector3d & point : axis)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  std::size_t count = 0;
  ForEachCell(MakePoint(low[0] - reach, low[1] - reach, low[2] - reach),
              MakePoint(high[0] + reach, high[1] + reach, high[2] + reach),
              step,
              [&](const PointType & p) { count += solid.distance(p) < 0.0 ? 1 : 0; });
  return static_cast<double>(count) * step * step * step / 1000.0;
}

CurveSet
CurvesOf(const std::vector<std::vector<Vector3d>> & lines, const std::vector<ColonStructure> & structures)
{
  CurveSet     curves;
  Eigen::Index count = 0;
  for (const auto & line : lines)
  {
    count += static_cast<Eigen::Index>(line.size());
  }
  curves.V.resize(count, 3);
  const auto   lineCount = static_cast<Eigen::Index>(lines.size());
  SurfaceArray structure{ "structure", SurfaceArray::ValueMatrix(lineCount, 1), true };
  int          next = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    structure.values(static_cast<Eigen::Index>(i), 0) = static_cast<double>(structures[i]);
    curves.curves.emplace_back();
    for (const Vector3d & point : lines[i])
    {
      curves.V.row(next) = point;
      curves.curves.back().push_back(next++);
    }
  }
  curves.cellArrays.push_back(structure);
  return curves;
}
} // namespace

ColonStructures::ColonStructures(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  if (HasWholeChest(anatomy.GetParameters()))
  {
    this->AddChest(anatomy, fluid);
  }
  const auto & parameters = anatomy.GetParameters();
  const bool   hasColon = Contains(parameters, "colon");
  const bool   hasIleum = hasColon && parameters.valve == "lips";
  const bool   hasContact = hasColon && Contains(parameters, "smallBowel") && parameters.sigmoidContact > 0.0;
  const auto   ileum = hasIleum ? MakePhantomIleum(anatomy, fluid) : PhantomIleum{};
  this->AddBowel(anatomy, fluid, hasContact ? MakeSigmoidContact(anatomy, ileum.axis) : SigmoidContactLoop{});
  if (hasColon)
  {
    this->AddColon(anatomy, fluid, ileum);
  }
}

ColonStructures::~ColonStructures() = default;

void
ColonStructures::AddColon(const ColonAnatomy & anatomy, const ColonFluid & fluid, const PhantomIleum & ileum)
{
  if (anatomy.GetParameters().valve == "lips")
  {
    this->AddValve(anatomy);
    this->AddIleum(anatomy, ileum);
  }
  this->AddDiverticula(anatomy, fluid);
  const LumenResidue residue = MakeLumenResidue(anatomy, fluid);
  m_Parts.insert(m_Parts.end(), residue.parts.begin(), residue.parts.end());
  m_Residue = residue.truth;
  if (anatomy.GetParameters().catheter != "none")
  {
    this->AddCatheter(anatomy, fluid);
  }
}

void
ColonStructures::AddChest(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  if (Contains(anatomy.GetParameters(), "heart"))
  {
    const auto heart = Without(Heart(), Grown(DiaphragmDome(), 3.0));
    m_Parts.push_back({ ColonStructure::Heart, heart, nullptr, false, true });
  }
  if (Contains(anatomy.GetParameters(), "lungs"))
  {
    const auto parts = MakeLungParts(anatomy, MakeVector(fluid.Down()[0], fluid.Down()[1], fluid.Down()[2]));
    m_Parts.insert(m_Parts.end(), parts.begin(), parts.end());
  }
}

// Painted with the abdomen, except for the loop that touches the sigmoid.
void
ColonStructures::AddBowel(const ColonAnatomy & anatomy, const ColonFluid & fluid, const SigmoidContactLoop & contact)
{
  const auto & p = anatomy.GetParameters();
  const auto   down = MakeVector(fluid.Down()[0], fluid.Down()[1], fluid.Down()[2]);
  if (Contains(p, "stomach"))
  {
    m_Parts.push_back({ ColonStructure::Stomach, StomachLumen(anatomy), nullptr, false });
  }
  if (Contains(p, "smallBowel"))
  {
    const bool hasContact = !contact.axis.empty();
    const auto loops = MakeSmallBowel(p.seed, down, p.smallBowelTagged).lumen;
    const auto lumen = hasContact ? Without(loops, contact.outer) : loops;
    m_Parts.push_back({ ColonStructure::SmallBowel, AwayFromColon(lumen, anatomy, bowelWall), nullptr, false });
  }
  if (contact.axis.empty())
  {
    return;
  }
  m_Parts.push_back({ ColonStructure::None, contact.outer, MakeSolidBody(contact.outer, softTissueIntensity), true });
  m_Parts.push_back(
    { ColonStructure::SmallBowel, contact.lumen, MakeSolidBody(contact.lumen, contact.truth.intensity), true });
  m_SigmoidContact = std::make_unique<ColonContact>(contact.truth);
  m_Axes.push_back(contact.axis);
  m_AxisOf.push_back(ColonStructure::SmallBowel);
}

// Fat is below the mucosa, the 2 mm wall of the colon.
void
ColonStructures::AddValve(const ColonAnatomy & anatomy)
{
  const PhantomSolid lips = LipsSolid(anatomy.Valve());
  const double       fat = anatomy.GetParameters().valveFat;
  const double       core = softTissueIntensity + fat * (fatIntensity - softTissueIntensity);
  m_Parts.push_back({ ColonStructure::Valve, AwayFromColon(lips, anatomy, 0.0), MakeSolidBody(lips, core), true });
}

void
ColonStructures::AddIleum(const ColonAnatomy & anatomy, const PhantomIleum & ileum)
{
  m_Parts.push_back({ ColonStructure::IleumWall, ileum.wall, MakeSolidBody(ileum.wall, softTissueIntensity), false });
  if (ileum.content != "collapsed")
  {
    m_Parts.push_back({ ColonStructure::Ileum,
                        AwayFromColon(ileum.lumen, anatomy, 0.0),
                        MakeSolidBody(ileum.lumen, ileum.intensity),
                        false });
  }
  if (ileum.fluid.distance)
  {
    m_Parts.push_back({ ColonStructure::None, ileum.fluid, MakeSolidBody(ileum.fluid, ileum.fluidIntensity), false });
  }
  const bool   isEmpty = ileum.content == "collapsed";
  const double volume = isEmpty ? 0.0 : VolumeOf(AwayFromColon(ileum.lumen, anatomy, 0.0), ileum.axis, ileum.bore);
  m_Ileum = std::make_unique<ColonIleum>(ColonIleum{ ileum.content,
                                                     ileum.isOpen,
                                                     ileum.fluid.distance != nullptr,
                                                     ileum.slitWidth,
                                                     ileum.bore,
                                                     ileum.length,
                                                     volume,
                                                     ileum.intensity });
  m_Axes.push_back(ileum.axis);
  m_AxisOf.push_back(ColonStructure::Ileum);
}

// Walls, gas and fluid are painted with the colon.
void
ColonStructures::AddDiverticula(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  m_Diverticula = anatomy.Diverticula();
  for (ColonDiverticulum & one : m_Diverticula)
  {
    const bool holdsStool = one.content == "stool";
    const bool isWet = fluid.DepthBelowLevel(one.position, one.arcLength) > 0.0;
    one.content = holdsStool ? "stool" : (isWet ? "fluid" : "gas");
    const auto stool = WithinColon(FlaskSolid(one, stoolIntoWall), anatomy, stoolIntoWall);
    m_Parts.push_back({ ColonStructure::Diverticulum,
                        WithinColon(FlaskSolid(one, 0.0), anatomy, 0.0),
                        holdsStool ? MakeSolidBody(stool, one.intensity) : nullptr,
                        false });
  }
}

void
ColonStructures::AddCatheter(const ColonAnatomy & anatomy, const ColonFluid & fluid)
{
  const CatheterTube catheter = MakeCatheterTube(anatomy, fluid);
  m_Parts.insert(m_Parts.end(), catheter.parts.begin(), catheter.parts.end());
  m_Catheter = std::make_unique<ColonCatheter>(catheter.truth);
  m_Axes.push_back(catheter.axis);
  m_AxisOf.push_back(ColonStructure::Catheter);
}

CurveSet
ColonStructures::Axes() const
{
  return CurvesOf(m_Axes, m_AxisOf);
}

ColonStructure
ColonStructures::At(const Vector3d & point) const
{
  const auto p = MakePoint(point[0], point[1], point[2]);
  const auto part = std::find_if(m_Parts.rbegin(), m_Parts.rend(), [&](const Part & one) {
    return one.label != ColonStructure::None && one.solid.distance(p) < 0.0;
  });
  return part == m_Parts.rend() ? ColonStructure::None : part->label;
}

void
ColonStructures::Fill(LabelImageType * image, const itk::ImageRegion<3> & region) const
{
  std::vector<const Part *> all;
  for (const Part & part : m_Parts)
  {
    if (part.label != ColonStructure::None)
    {
      all.push_back(&part);
    }
  }
  for (itk::ImageRegionIterator<LabelImageType> it(image, region); !it.IsAtEnd(); ++it)
  {
    it.Set(0);
  }
  this->FillBlock(image, region, all);
}

// Bisects the block until it is small or nothing is near.
void
ColonStructures::FillBlock(LabelImageType *                  image,
                           const itk::ImageRegion<3> &       block,
                           const std::vector<const Part *> & above) const
{
  itk::ContinuousIndex<double, 3> middle;
  double                          squared = 0.0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const double half = 0.5 * (static_cast<double>(block.GetSize(i)) - 1.0);
    middle[i] = static_cast<double>(block.GetIndex(i)) + half;
    squared += half * half * image->GetSpacing()[i] * image->GetSpacing()[i];
  }
  PointType center;
  image->TransformContinuousIndexToPhysicalPoint(middle, center);
  constexpr double          forRounding = 1.001;
  std::vector<const Part *> near;
  std::copy_if(above.begin(), above.end(), std::back_inserter(near), [&](const Part * part) {
    return part->solid.distance(center) <= forRounding * part->solid.slope * std::sqrt(squared);
  });
  if (near.empty())
  {
    return;
  }
  const auto size = block.GetSize();
  const auto axis = static_cast<unsigned int>(std::max_element(size.begin(), size.end()) - size.begin());
  if (size[axis] > 4)
  {
    itk::ImageRegion<3> half = block;
    half.SetSize(axis, size[axis] / 2);
    this->FillBlock(image, half, near);
    half.SetSize(axis, size[axis] - size[axis] / 2);
    half.SetIndex(axis, block.GetIndex(axis) + static_cast<itk::IndexValueType>(size[axis] / 2));
    this->FillBlock(image, half, near);
    return;
  }
  for (itk::ImageRegionIteratorWithIndex<LabelImageType> it(image, block); !it.IsAtEnd(); ++it)
  {
    PointType point;
    image->TransformIndexToPhysicalPoint(it.GetIndex(), point);
    for (const Part * part : near)
    {
      if (part->solid.distance(point) < 0.0)
      {
        it.Set(static_cast<unsigned char>(part->label));
      }
    }
  }
}
} // namespace shapeton
