#include "shapetonParallelFor.h"

namespace shapeton
{
// Not in the header: all libraries must share it.
unsigned int &
DepthOfLoops()
{
  static thread_local unsigned int depth = 0;
  return depth;
}
} // namespace shapeton
