#ifndef shapetonColonStructurePart_h
#define shapetonColonStructurePart_h

#include "shapetonColonStructures.h"
#include "shapetonPhantomSolid.h"

#include <memory>

namespace shapeton
{
/** A piece of a structure: where it is by the truth, and what a scanner sees of it. */
struct ColonStructures::Part
{
  ColonStructure                     label; ///< None: no label
  PhantomSolid                       solid;
  std::shared_ptr<const PhantomBody> body;                   ///< null: nothing to see
  bool                               isBehindColon{ false }; ///< painted before the colon
  bool                               isInChest{ false };     ///< painted before the organs of the abdomen
};
} // namespace shapeton

#endif
