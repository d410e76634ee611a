#include "itkFaceDummies.h"

namespace itk
{
/** The dummies of one face hang together, those of two faces do not. */
FaceDummies::FaceDummies(const CombinatorialMap & packed, int first)
  : m_Packed(packed)
  , m_First(first)
  , m_Face(packed.Nodes(), -1)
  , m_IsGone(packed.Nodes(), 0)
  , m_IsFaceGone(packed.Nodes(), 0)
{
  for (int start = first; start < packed.Nodes(); ++start)
  {
    std::vector<int> found;
    if (m_Face[start] < 0)
    {
      m_Face[start] = start;
      found.push_back(start);
    }
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      for (const int h : packed.Around(found[i]))
      {
        const int head = this->Head(h);
        if (this->IsDummy(head) && m_Face[head] < 0)
        {
          m_Face[head] = start;
          found.push_back(head);
        }
      }
    }
  }
}
} // namespace itk
