#ifndef shapetonTerminalIleum_h
#define shapetonTerminalIleum_h

#include "shapetonIleocaecalValve.h"

namespace shapeton
{
/** \class TerminalIleum
 * \brief A part of the lumen that is no colon: gas or tagged fluid that went back through the valve.
 * \ingroup IleocaecalValve */
struct TerminalIleum
{
  /** On the grid of the labels, 1 where it is. */
  LumenMask::Pointer mask;
  /** The middle of where it leaves the colon, LPS, mm. */
  Eigen::Vector3d mouth{ Eigen::Vector3d::Zero() };
  /** mm, from the mouth to its farthest place, straight. */
  double length{ 0.0 };
  /** ml. */
  double volume{ 0.0 };
};

/** The terminal ileum in a lumen: what lies 4 mm and more beyond all balls of 8.5 mm radius, hangs together, leaves
 * the colon within 25 mm of the valve and nowhere else, goes on for at least 30 mm, and holds no point of the
 * centreline. Nothing else qualifies, so that no colon is cut: corners of haustra are not that deep, loops of colon are
 * wider, an appendix leaves elsewhere. Nothing where there is none.
 *
 * \param labels the lumen, not 0.
 * \param centreline as for FindIleocaecalValve(). The same bytes for any number of threads.
 * \ingroup IleocaecalValve */
IleocaecalValve_EXPORT std::optional<TerminalIleum>
FindTerminalIleum(const LumenMask * labels, const CurveSet & centreline, const IleocaecalValve & valve);

/** Sets voxels of an image to 0 where the ileum is; the grids may differ. \ingroup IleocaecalValve */
template <typename TImage>
void
TakeOut(const TerminalIleum & ileum, TImage * image);
extern template IleocaecalValve_EXPORT void
TakeOut(const TerminalIleum &, LumenMask *);
extern template IleocaecalValve_EXPORT void
TakeOut(const TerminalIleum &, itk::Image<float, 3> *);
} // namespace shapeton

#endif
