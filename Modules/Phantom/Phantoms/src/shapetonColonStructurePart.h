#ifndef shapetonColonStructurePart_h
#define shapetonColonStructurePart_h

#include "shapetonColonStructures.h"
#include "shapetonPhantomSolid.h"

#include <memory>

namespace shapeton
{
/** A part of a structure: region in the ground truth, and appearance in the image. */
struct ColonStructures::Part
{
  ColonStructure                     label; ///< None: no label
  PhantomSolid                       solid;
  std::shared_ptr<const PhantomBody> body;                   ///< null: invisible
  bool                               isBehindColon{ false }; ///< painted before the colon
  bool                               isInChest{ false };     ///< painted before the organs of the abdomen
};
} // namespace shapeton

#endif
