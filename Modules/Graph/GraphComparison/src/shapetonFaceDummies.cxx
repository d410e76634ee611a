#include "shapetonFaceDummies.h"

namespace shapeton
{
void
FaceDummies::DropNeighbors()
{
  const std::vector<char> before = m_IsGone;
  for (int h = 0; h < m_Packed.HalfEdges(); ++h)
  {
    if (before[m_Packed.Node(h)] && this->IsDummy(this->Head(h)))
    {
      this->Drop(this->Head(h));
    }
  }
}
} // namespace shapeton
