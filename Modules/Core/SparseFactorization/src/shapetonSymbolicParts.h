#ifndef shapetonSymbolicParts_h
#define shapetonSymbolicParts_h

#include "shapetonSubtreeTasks.h"
#include "shapetonSymbolicFactorization.h"

namespace shapeton
{
struct SymbolicFactorization::Parts
{
  Parts(std::vector<int> order, const std::vector<std::array<int, 2>> & edges)
    : numberOfEdges(static_cast<int>(edges.size())), supernodes(std::move(order), edges), tasks(supernodes)
  {}
  int          numberOfEdges;
  Supernodes   supernodes;
  SubtreeTasks tasks;
};
} // namespace shapeton

#endif
