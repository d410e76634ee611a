#ifndef shapetonColonStructures_h
#define shapetonColonStructures_h

#include "ShapetonPhantomsExport.h"
#include "shapetonColonAnatomy.h"
#include "shapetonColonFluid.h"

#include "itkImage.h"

#include <memory>
#include <string>
#include <vector>

namespace shapeton
{
/** Structure of a voxel of the ground truth besides the lumen of the colon. \ingroup ShapetonPhantoms */
enum class ColonStructure : unsigned char
{
  None,
  Valve,          ///< the tissue of its lips, or the bump
  Ileum,          ///< the lumen of the terminal ileum, up to the mouth of the valve
  IleumWall,      ///< also the whole of a collapsed ileum
  Catheter,       ///< its wall and bore
  Balloon,        ///< its wall and content
  Stool,          ///< including the gas in it
  Bubble,         ///< of gas, in fluid
  Foam,           ///< bubbles and films between them
  SmallBowel,     ///< the lumen of its other loops
  Stomach,        ///< its lumen
  Diverticulum,   ///< its neck and sac, including their content
  RightUpperLobe, ///< parenchyma of the lobe; this and the following only in a whole chest
  RightMiddleLobe,
  RightLowerLobe,
  LeftUpperLobe,
  LeftLowerLobe,
  Airway,     ///< the lumen of trachea and bronchi
  AirwayWall, ///< also the whole of a bronchus thinner than its wall
  LungVessel, ///< pulmonary arteries and veins, from the heart on
  Heart       ///< excluding its fat
};

/** Stool, a bubble or a patch of foam in the lumen. LPS, mm. \ingroup ShapetonPhantoms */
struct ColonResidue
{
  ColonStructure  structure;
  Eigen::Vector3d position;  ///< its center
  double          diameter;  ///< nominal diameter
  double          intensity; ///< HU; for foam that of the films
  std::string     kind;      ///< plain or mottled (containing gas) stool, bubble, foam
};

/** The terminal ileum of a valve with lips. LPS, mm. \ingroup ShapetonPhantoms */
struct ColonIleum
{
  std::string content; ///< collapsed, gas or fluid
  bool        isOpen;  ///< whether its lumen is connected to that of the colon
  double      slitWidth;
  double      bore;
  double      length;
  double      intensity; ///< HU of the content; 0 if collapsed
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
  double          balloonDiameter{ 0.0 }; ///< including its wall
};

/** \class ColonStructures
 * \brief Structures of an examination besides the colon, with their ground truth: lungs, heart, small bowel, stomach,
 * valve, terminal ileum, residue in the lumen, rectal catheter.
 *
 * A voxel's label depends only on its position.
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
  GetIleum() const;

  /** Null if there is none. */
  const ColonCatheter *
  GetCatheter() const;

  const std::vector<ColonResidue> &
  GetResidue() const;

  /** The diverticula of the anatomy, with their content. */
  const std::vector<ColonDiverticulum> &
  GetDiverticula() const;

  /** The axis of each tubular structure, with the cell array structure (a ColonStructure); that of the ileum starts
   * at the colon, that of the catheter ends at its tip. */
  CurveSet
  Axes() const;

  /** The ColonStructure at a point; if several overlap, the one painted last. */
  ColonStructure
  At(const Eigen::Vector3d & point) const;

  /** Labels a region of an image with the ColonStructure of each voxel. */
  void
  Fill(LabelImageType * image, const itk::ImageRegion<3> & region) const;

  struct Part;
  /** In painting order. */
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
