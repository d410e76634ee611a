#ifndef shapetonTerminalIleum_h
#define shapetonTerminalIleum_h

#include "shapetonIleocecalValve.h"

namespace shapeton
{
/** \class TerminalIleum
 * \brief A part of the lumen outside the colon: gas or tagged fluid that passed back through the valve.
 * \ingroup ShapetonColonModel */
struct TerminalIleum
{
  /** On the grid of the labels, 1 inside. */
  LumenMask::Pointer mask;
  /** Center of its opening into the colon, LPS, mm. */
  Eigen::Vector3d mouth{ Eigen::Vector3d::Zero() };
  /** Straight distance from the mouth to its farthest point, mm. */
  double length{ 0.0 };
  /** Volume, ml. */
  double volume{ 0.0 };
};

/** Finds the terminal ileum in a lumen: a connected region 4 mm or more beyond all balls of 8.5 mm radius that leaves
 * the colon within 25 mm of the valve and only there, extends at least 30 mm, and contains no point of the centerline.
 * These rules prevent cutting the colon: corners of haustra are shallower, loops of colon are wider, and an appendix
 * leaves elsewhere. Empty if none is found.
 *
 * \param labels nonzero voxels are lumen.
 * \param centerline as for FindIleocecalValve(). The result is identical for any number of threads.
 * \ingroup ShapetonColonModel */
ShapetonColonModel_EXPORT std::optional<TerminalIleum>
FindTerminalIleum(const LumenMask * labels, const CurveSet & centerline, const IleocecalValve & valve);

/** Sets the voxels of an image inside the ileum to 0; the grids may differ. \ingroup ShapetonColonModel */
template <typename TImage>
void
TakeOut(const TerminalIleum & ileum, TImage * image);
extern template ShapetonColonModel_EXPORT void
TakeOut(const TerminalIleum &, LumenMask *);
extern template ShapetonColonModel_EXPORT void
TakeOut(const TerminalIleum &, itk::Image<float, 3> *);
} // namespace shapeton

#endif
