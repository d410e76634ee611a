#ifndef shapetonColonStructures_h
#define shapetonColonStructures_h

#include "ColonPhantomExport.h"
#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"

#include "itkImage.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** What a voxel of the truth may belong to besides the lumen of the colon. \ingroup ColonPhantom */
enum class ColonStructure : unsigned char
{
  None,
  Valve,          ///< the tissue of its lips, or the bump
  Ileum,          ///< the lumen of the terminal ileum, up to the mouth of the valve
  IleumWall,      ///< and all of an ileum that is collapsed
  Catheter,       ///< its wall and its bore
  Balloon,        ///< its wall and what it holds
  Stool,          ///< with the gas in it
  Bubble,         ///< of gas, in fluid
  Foam,           ///< bubbles and the films between them
  SmallBowel,     ///< the lumen of its other loops
  Stomach,        ///< its lumen
  Diverticulum,   ///< its neck and sac, with what they hold
  RightUpperLobe, ///< of the lung: its parenchyma; this and what follows in a whole chest alone
  RightMiddleLobe,
  RightLowerLobe,
  LeftUpperLobe,
  LeftLowerLobe,
  Airway,     ///< the lumen of trachea and bronchi
  AirwayWall, ///< and all of a bronchus that is thinner than its wall
  LungVessel, ///< pulmonary arteries and veins from the heart on
  Heart       ///< without its fat
};

/** Stool, a bubble or a patch of foam in the lumen. LPS, mm. \ingroup ColonPhantom */
struct ColonResidue
{
  ColonStructure  structure;
  Eigen::Vector3d position;  ///< its middle
  double          diameter;  ///< nominal
  double          intensity; ///< HU; of foam that of the films
  std::string     kind;      ///< plain or mottled (with gas in it) stool, bubble, foam
};

/** The terminal ileum of a valve with lips. LPS, mm. \ingroup ColonPhantom */
struct ColonIleum
{
  std::string content; ///< collapsed, gas or fluid
  bool        isOpen;  ///< its lumen and that of the colon are one
  double      slitWidth;
  double      bore;
  double      length;
  double      intensity; ///< of the content, HU; 0 where collapsed
};

/** The rectal catheter. LPS, mm. \ingroup ColonPhantom */
struct ColonCatheter
{
  std::string     kind;      ///< central, rigid or soft
  double          bore;      ///< inner diameter
  double          wall;      ///< thickness
  double          intensity; ///< of the wall, HU
  int             sideHoles;
  Eigen::Vector3d tip;     ///< the last point of the axis
  std::string     balloon; ///< none, gas, fluid or deflated
  Eigen::Vector3d balloonCenter{ 0.0, 0.0, 0.0 };
  double          balloonDiameter{ 0.0 }; ///< with its wall
};

/** \class ColonStructures
 * \brief What else belongs to the examination of a colon, with its truth: lungs, heart, small bowel, stomach, valve,
 * terminal ileum, residue in the lumen, rectal catheter.
 *
 * A voxel's label depends on its position alone.
 *
 * \ingroup ColonPhantom
 */
class ColonPhantom_EXPORT ColonStructures
{
public:
  using LabelImageType = itk::Image<unsigned char, 3>;

  /** Anatomy and fluid have to outlive this object. */
  ColonStructures(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  ~ColonStructures();
  ColonStructures(const ColonStructures &) = delete;
  ColonStructures &
  operator=(const ColonStructures &) = delete;

  /** Null where the valve is a bump. */
  const ColonIleum *
  GetIleum() const;

  /** Null where there is none. */
  const ColonCatheter *
  GetCatheter() const;

  const std::vector<ColonResidue> &
  GetResidue() const;

  /** Those of the anatomy, with what they hold. */
  const std::vector<ColonDiverticulum> &
  GetDiverticula() const;

  /** The axis of each long structure, that of the ileum from the colon on, that of the catheter to its tip, with the
   * cell array structure (a ColonStructure). */
  CurveSet
  Axes() const;

  /** The ColonStructure at a point; where several claim it, the one that is painted last. */
  ColonStructure
  At(const Eigen::Vector3d & point) const;

  /** Labels a region of an image with the ColonStructure of each voxel. */
  void
  Fill(LabelImageType * image, const itk::ImageRegion<3> & region) const;

  struct Part;
  /** In the order of painting. */
  const std::vector<Part> &
  GetParts() const;

private:
  void
  AddChest(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  AddColon(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  AddBowel(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  AddValve(const ColonAnatomy & anatomy);
  void
  AddIleum(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  AddDiverticula(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  AddCatheter(const ColonAnatomy & anatomy, const ColonFluid & fluid);
  void
  FillBlock(LabelImageType * image, const itk::ImageRegion<3> & block, const std::vector<const Part *> & above) const;

  std::vector<Part>                         m_Parts;
  std::unique_ptr<ColonIleum>               m_Ileum;
  std::unique_ptr<ColonCatheter>            m_Catheter;
  std::vector<ColonResidue>                 m_Residue;
  std::vector<ColonDiverticulum>            m_Diverticula;
  std::vector<std::vector<Eigen::Vector3d>> m_Axes;
  std::vector<ColonStructure>               m_AxisOf;
};
} // namespace shapeton

#endif
