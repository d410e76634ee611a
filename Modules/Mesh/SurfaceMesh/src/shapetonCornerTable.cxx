#include "shapetonCornerTable.h"

namespace shapeton
{
CornerTable::CornerTable(const FaceMatrix & F, const SurfaceConnectivity & connectivity)
  : m_Corner(F.data(), F.data() + F.size())
  , m_Twin(F.size(), -1)
  , m_Outgoing(connectivity.NumberOfVertices(), -1)
  , m_LiveFaces(static_cast<int>(F.rows()))
  , m_Mark(connectivity.NumberOfVertices(), 0)
{
  std::vector<int> first(connectivity.NumberOfEdges(), -1);
  for (int h = 0; h < this->NumberOfHalfEdges(); ++h)
  {
    int & other = first[connectivity.EdgeOfFace(h / 3, h % 3)];
    if (other < 0)
    {
      other = h;
    }
    else
    {
      this->Link(h, other);
    }
  }
  for (int h = 0; h < this->NumberOfHalfEdges(); ++h)
  {
    if (m_Outgoing[m_Corner[h]] < 0 || m_Twin[h] < 0)
    {
      m_Outgoing[m_Corner[h]] = h;
    }
  }
}

CornerTable::~CornerTable() = default;

void
CornerTable::Link(int a, int b)
{
  if (a >= 0)
  {
    m_Twin[a] = b;
  }
  if (b >= 0)
  {
    m_Twin[b] = a;
  }
}

// Sets the outgoing half-edge of the start vertex of h to h or, on a boundary, to the half-edge without a twin.
void
CornerTable::KeepOutgoing(int h)
{
  const int start = h;
  while (m_Twin[h] >= 0)
  {
    const int back = Next(m_Twin[h]);
    if (back == start)
    {
      break;
    }
    h = back;
  }
  m_Outgoing[m_Corner[start]] = h;
}

void
CornerTable::RemoveFace(int f)
{
  for (int h = 3 * f; h < 3 * f + 3; ++h)
  {
    m_Corner[h] = -1;
    m_Twin[h] = -1;
  }
  --m_LiveFaces;
}

int
CornerTable::AddFace(int a, int b, int c)
{
  m_Corner.insert(m_Corner.end(), { a, b, c });
  m_Twin.insert(m_Twin.end(), 3, -1);
  ++m_LiveFaces;
  return this->NumberOfHalfEdges() - 3;
}

int
CornerTable::Valence(int v) const
{
  int valence = 0;
  this->ForEachNeighbor(v, [&](int) { ++valence; });
  return valence;
}

int
CornerTable::FindHalfEdge(int v, int w) const
{
  int found = -1;
  this->ForEachOutgoing(v, [&](int h) {
    if (this->To(h) == w)
    {
      found = h;
    }
    else if (found < 0 && this->Apex(h) == w)
    {
      found = m_Twin[Previous(h)] >= 0 ? m_Twin[Previous(h)] : Previous(h);
    }
  });
  return found;
}

bool
CornerTable::CanCollapse(int h) const
{
  const int  u = this->From(h);
  const int  v = this->To(h);
  const int  t = m_Twin[h];
  const bool isOnBoundary = t < 0;
  if (isOnBoundary ? m_Twin[Next(h)] < 0 && m_Twin[Previous(h)] < 0 : this->IsBoundary(u) && this->IsBoundary(v))
  {
    return false; // an isolated triangle, or a bridge between boundaries
  }
  ++m_Stamp;
  this->ForEachNeighbor(u, [&](int w) { m_Mark[w] = m_Stamp; });
  int common = 0;
  this->ForEachNeighbor(v, [&](int w) { common += m_Mark[w] == m_Stamp; });
  if (common != (isOnBoundary ? 1 : 2))
  {
    return false;
  }
  // Inside the surface a vertex opposite to the edge must keep three neighbors; fails only for a tetrahedron.
  const auto staysSound = [&](int w) { return this->IsBoundary(w) || this->Valence(w) > 3; };
  return isOnBoundary || (staysSound(this->Apex(h)) && staysSound(this->Apex(t)));
}

void
CornerTable::Collapse(int h)
{
  const int u = this->From(h);
  const int v = this->To(h);
  const int sides[] = { h, m_Twin[h] };
  this->ForEachOutgoing(u, [&](int outgoing) { m_Corner[outgoing] = v; });
  m_Outgoing[u] = -1;
  for (const int side : sides)
  {
    if (side < 0)
    {
      continue;
    }
    const int a = m_Twin[Next(side)];
    const int b = m_Twin[Previous(side)];
    this->RemoveFace(side / 3);
    this->Link(a, b);
    const int ofOne = a >= 0 ? a : b; // the merged edge: v and the apex
    this->KeepOutgoing(ofOne);
    this->KeepOutgoing(Next(ofOne)); // starts at its other end
  }
}

bool
CornerTable::CanFlip(int h) const
{
  return m_Twin[h] >= 0 && this->FindHalfEdge(this->Apex(h), this->Apex(m_Twin[h])) < 0;
}

void
CornerTable::Flip(int h)
{
  const int t = m_Twin[h];
  const int n = Next(h);
  const int n2 = Next(t);
  const int w = this->Apex(h);
  const int x = this->Apex(t);
  const int outerN = m_Twin[n];
  const int outerN2 = m_Twin[n2];
  // The faces (u, v, w) and (v, u, x) become (u, x, w) and (v, w, x).
  m_Corner[n] = x;
  m_Corner[n2] = w;
  m_Twin[h] = m_Twin[t] = -1;
  this->Link(h, outerN2);
  this->Link(t, outerN);
  this->Link(n, n2);
  for (const int outgoing : { h, t, n, n2 })
  {
    this->KeepOutgoing(outgoing);
  }
}

int
CornerTable::Split(int h)
{
  const int t = m_Twin[h];
  const int u = this->From(h);
  const int v = this->To(h);
  const int m = this->NumberOfVertices();
  m_Outgoing.push_back(-1);
  m_Mark.push_back(0);
  // (u, v, w) becomes (u, m, w) and (m, v, w).
  const int outer = m_Twin[Next(h)];
  const int a = this->AddFace(m, v, this->Apex(h));
  m_Corner[Next(h)] = m;
  m_Twin[Next(h)] = -1;
  this->Link(Next(a), outer);
  this->Link(Previous(a), Next(h));
  m_Twin[h] = -1;
  if (t >= 0)
  {
    // (v, u, x) becomes (v, m, x) and (m, u, x).
    const int outerT = m_Twin[Next(t)];
    const int b = this->AddFace(m, u, this->Apex(t));
    m_Corner[Next(t)] = m;
    m_Twin[Next(t)] = -1;
    this->Link(Next(b), outerT);
    this->Link(Previous(b), Next(t));
    this->Link(h, b);
    this->Link(t, a);
    this->KeepOutgoing(Previous(b));
  }
  for (const int outgoing : { h, a, Next(a), Previous(a) })
  {
    this->KeepOutgoing(outgoing);
  }
  return m;
}

SurfaceMesh
CornerTable::ToSurface(const std::vector<Eigen::Vector3d> & positions) const
{
  SurfaceMesh      surface;
  std::vector<int> newIndex(m_Outgoing.size(), -1);
  int              vertices = 0;
  for (std::size_t v = 0; v < m_Outgoing.size(); ++v)
  {
    newIndex[v] = m_Outgoing[v] >= 0 ? vertices++ : -1;
  }
  surface.V.resize(vertices, 3);
  for (std::size_t v = 0; v < m_Outgoing.size(); ++v)
  {
    if (newIndex[v] >= 0)
    {
      surface.V.row(newIndex[v]) = positions[v];
    }
  }
  surface.F.resize(m_LiveFaces, 3);
  int face = 0;
  for (int h = 0; h < this->NumberOfHalfEdges(); h += 3)
  {
    if (this->IsLive(h))
    {
      surface.F.row(face++) << newIndex[m_Corner[h]], newIndex[m_Corner[h + 1]], newIndex[m_Corner[h + 2]];
    }
  }
  return surface;
}
} // namespace shapeton
