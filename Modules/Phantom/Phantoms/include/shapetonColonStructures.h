#ifndef shapetonColonStructures_h
#define shapetonColonStructures_h

#include "ShapetonPhantomsExport.h"
#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"

#include "itkImage.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
struct PhantomIleum;
struct SigmoidContactLoop;

/** Ground-truth structure of a voxel, other than the lumen of the colon. \ingroup ShapetonPhantoms */
enum class ColonStructure : unsigned char
{
  None,
  Valve,          ///< the tissue of the lips, or the bump
  Ileum,          ///< the lumen of the terminal ileum, up to the mouth of the valve
  IleumWall,      ///< including a collapsed ileum
  Catheter,       ///< wall and bore
  Balloon,        ///< wall and content
  Stool,          ///< including enclosed gas
  Bubble,         ///< gas in fluid
  Foam,           ///< bubbles and films
  SmallBowel,     ///< the lumen of the other loops
  Stomach,        ///< its lumen
  Diverticulum,   ///< neck and sac, including the content
  RightUpperLobe, ///< parenchyma of the lobe; this and the following only in a whole chest
  RightMiddleLobe,
  RightLowerLobe,
  LeftUpperLobe,
  LeftLowerLobe,
  Airway,     ///< the lumen of trachea and bronchi
  AirwayWall, ///< including bronchi thinner than their wall
  LungVessel, ///< pulmonary arteries and veins, starting at the heart
  Heart       ///< excluding its fat
};

/** Stool, a bubble or a patch of foam in the lumen. LPS, mm. \ingroup ShapetonPhantoms */
struct ColonResidue
{
  ColonStructure  structure;
  Eigen::Vector3d position;  ///< its center
  double          diameter;  ///< nominal diameter
  double          intensity; ///< HU; for foam, HU of the films
  std::string     kind;      ///< plain or mottled (with gas) stool, bubble, foam
};

/** The terminal ileum of a valve with lips. LPS, mm. \ingroup ShapetonPhantoms */
struct ColonIleum
{
  std::string content;    ///< collapsed, gas or fluid
  bool        isOpen;     ///< whether the lumen is connected to the colon
  bool        isRefluxed; ///< filled by reflux, with some fluid at the lowest places
  double      slitWidth;
  double      bore;
  double      length;    ///< along the axis
  double      volume;    ///< ml, of the lumen; 0 if collapsed
  double      intensity; ///< HU of the content; 0 if collapsed
};

/** Contact of a loop of tagged ileum with the sigmoid from outside. \ingroup ShapetonPhantoms */
struct ColonContact
{
  std::array<double, 2> arcLength; ///< mm, ends of the stretch of the sigmoid beside the loop
  double                bore;      ///< mm, inner diameter of the loop
  double                length;    ///< mm of contact along the sigmoid
  double                intensity; ///< HU of the content
};

/** The rectal catheter. LPS, mm. \ingroup ShapetonPhantoms */
struct ColonCatheter
{
  std::string     kind;      ///< central, rigid or soft
  double          bore;      ///< inner diameter
  double          wall;      ///< thickness
  double          intensity; ///< HU of the wall
  int             sideHoles;
  Eigen::Vector3d tip;     ///< last point of the axis
  std::string     balloon; ///< none, gas, fluid or deflated
  Eigen::Vector3d balloonCenter{ 0.0, 0.0, 0.0 };
  double          balloonDiameter{ 0.0 }; ///< including the wall
};

/** \class ColonStructures
 * \brief Structures other than the colon wall, with ground truth: lungs, heart, small bowel, stomach, valve, terminal
 * ileum, residue in the lumen, rectal catheter.
 *
 * The label of a voxel depends only on its position.
 *
 * \ingroup ShapetonPhantoms */
class ShapetonPhantoms_EXPORT ColonStructures
{
public:
  using LabelImageType = itk::Image<unsigned char, 3>;

  /** Anatomy and fluid must outlive this object. */
  ColonStructures(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  ~ColonStructures();
  ColonStructures(const ColonStructures &) = delete;
  ColonStructures &
  operator=(const ColonStructures &) = delete;

  /** Null if the valve is a bump. */
  const ColonIleum *
  GetIleum() const
  {
    return m_Ileum.get();
  }

  /** Null if absent. */
  const ColonCatheter *
  GetCatheter() const
  {
    return m_Catheter.get();
  }

  /** Null if absent. */
  const ColonContact *
  GetSigmoidContact() const
  {
    return m_SigmoidContact.get();
  }

  const std::vector<ColonResidue> &
  GetResidue() const
  {
    return m_Residue;
  }

  /** The diverticula of the anatomy, with their content. */
  const std::vector<ColonDiverticulum> &
  GetDiverticula() const
  {
    return m_Diverticula;
  }

  /** Axes of tubular structures, with the cell array structure (a ColonStructure). The ileum starts at the colon; the
   * catheter ends at its tip; the small bowel is the loop that touches the sigmoid. */
  CurveSet
  Axes() const;

  /** The ColonStructure at a point; where several overlap, the last in painting order. */
  ColonStructure
  At(const Eigen::Vector3d & point) const;

  /** Labels a region of an image with the ColonStructure of each voxel. */
  void
  Fill(LabelImageType * image, const itk::ImageRegion<3> & region) const;

  struct Part;
  /** In painting order. */
  const std::vector<Part> &
  GetParts() const
  {
    return m_Parts;
  }

private:
  void
  AddChest(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  AddColon(const ColonAnatomy & anatomy, const ColonFluid & fluid, const PhantomIleum & ileum);
  void
  AddBowel(const ColonAnatomy & anatomy, const ColonFluid & fluid, const SigmoidContactLoop & contact);
  void
  AddValve(const ColonAnatomy & anatomy);
  void
  AddIleum(const ColonAnatomy & anatomy, const PhantomIleum & ileum);
  void
  AddDiverticula(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  AddCatheter(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  FillBlock(LabelImageType * image, const itk::ImageRegion<3> & block, const std::vector<const Part *> & above) const;

  std::vector<Part>                         m_Parts;
  std::unique_ptr<ColonIleum>               m_Ileum;
  std::unique_ptr<ColonContact>             m_SigmoidContact;
  std::unique_ptr<ColonCatheter>            m_Catheter;
  std::vector<ColonResidue>                 m_Residue;
  std::vector<ColonDiverticulum>            m_Diverticula;
  std::vector<std::vector<Eigen::Vector3d>> m_Axes;
  std::vector<ColonStructure>               m_AxisOf;
};
} // namespace shapeton

#endif
