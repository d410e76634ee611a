#ifndef shapetonForEachCell_h
#define shapetonForEachCell_h

namespace shapeton
{
/** Calls `visit` for the cells, or the points of a lattice, in a box [first, end), at intervals of `step` along each
 * axis, first axis fastest. TCell has three coordinates. */
template <typename TCell, typename TStep, typename TVisit>
void
ForEachCell(const TCell & first, const TCell & end, TStep step, const TVisit & visit)
{
  TCell cell = first;
  for (cell[2] = first[2]; cell[2] < end[2]; cell[2] += step)
  {
    for (cell[1] = first[1]; cell[1] < end[1]; cell[1] += step)
    {
      for (cell[0] = first[0]; cell[0] < end[0]; cell[0] += step)
      {
        visit(cell);
      }
    }
  }
}
} // namespace shapeton

#endif
