#include "shapetonChecks.h"

#include <algorithm>

namespace shapeton
{
namespace
{
/** Role of each edge in the cut graph: 0 none, 1 tree, 2 generator. */
using CutEdges = std::vector<char>;

/** Edges of the tree; checks that it reaches each node from its parent. */
CutEdges
EdgesOfTree(const EmbeddingCertificate & certificate, const TracedMap & packed)
{
  CutEdges       cut(packed.HalfEdges() / 2, 0);
  UnitedElements sets(packed.nodes);
  int            roots = 0;
  for (int node = 0; node < packed.nodes; ++node)
  {
    const int halfEdge = certificate.tree[node];
    if (halfEdge < 0)
    {
      ++roots;
      continue;
    }
    if (packed.Node(halfEdge ^ 1) != node || !sets.Unite(node, packed.Node(halfEdge)))
    {
      throw Refusal("the tree does not reach node " + std::to_string(node) + " or has a cycle there");
    }
    cut[halfEdge / 2] = 1;
  }
  if (roots != 1)
  {
    throw Refusal("the tree has " + std::to_string(roots) + " roots instead of one");
  }
  return cut;
}

void
AddGenerators(const EmbeddingCertificate & certificate, CutEdges & cut)
{
  for (const DeckTransformation & generator : certificate.generators)
  {
    char & edge = cut[generator.halfEdge / 2];
    if (edge != 0)
    {
      throw Refusal("edge " + std::to_string(generator.halfEdge / 2) +
                    " is a generator but belongs to the tree or to another generator");
    }
    edge = 2;
  }
}

/** Checks that the surface remains connected after the cut. By Euler's formula it is then a disk. */
void
RequireDisk(const TracedMap & packed, const CutEdges & cut)
{
  const auto     faces = static_cast<int>(packed.firstOfFace.size());
  UnitedElements sets(faces);
  int            components = faces;
  for (int h = 0; h < packed.HalfEdges(); h += 2)
  {
    if (cut[h / 2] == 0 && sets.Unite(packed.face[h], packed.face[h + 1]))
    {
      --components;
    }
  }
  if (components != 1)
  {
    throw Refusal("tree and generators cut the surface into " + std::to_string(components) +
                  " pieces instead of one disk");
  }
}

/** Letters along the boundary of the disk, with the disk on the left. */
std::vector<int>
BoundaryWord(const EmbeddingCertificate & certificate, const TracedMap & packed, const CutEdges & cut)
{
  std::vector<int> letter(packed.HalfEdges(), 0);
  for (std::size_t k = 0; k < certificate.generators.size(); ++k)
  {
    const int halfEdge = certificate.generators[k].halfEdge;
    letter[halfEdge] = static_cast<int>(k) + 1;
    letter[halfEdge ^ 1] = -static_cast<int>(k) - 1;
  }
  std::vector<int> word;
  const int        first = certificate.generators.front().halfEdge;
  int              h = first;
  do
  {
    if (letter[h] != 0)
    {
      word.push_back(letter[h]);
    }
    do
    {
      h = cut[h / 2] != 0 ? packed.previous[h ^ 1] : packed.previous[h];
    } while (cut[h / 2] == 0);
  } while (h != first);
  return word;
}

bool
AreCyclicallyEqual(const std::vector<int> & first, const std::vector<int> & second)
{
  std::vector<int> twice = first;
  twice.insert(twice.end(), first.begin(), first.end());
  return first.size() == second.size() &&
         std::search(twice.begin(), twice.end(), second.begin(), second.end()) != twice.end();
}

/** Appends a letter; a letter and its inverse cancel. */
void
AppendReduced(std::vector<int> & word, int letter)
{
  if (!word.empty() && word.back() == -letter)
  {
    word.pop_back();
  }
  else
  {
    word.push_back(letter);
  }
}

void
AppendPower(std::vector<int> & word, const std::vector<int> & factor, bool isInverse)
{
  for (std::size_t i = 0; i < factor.size(); ++i)
  {
    AppendReduced(word, isInverse ? -factor[factor.size() - 1 - i] : factor[i]);
  }
}

/** Checks the words A1, B1, ...: the product of their commutators reduces to the word of the cut graph. */
void
CheckCanonicalWords(const EmbeddingCertificate & certificate)
{
  const auto & words = certificate.canonicalWords;
  if (words.empty())
  {
    return;
  }
  if (words.size() != certificate.generators.size())
  {
    throw Refusal("there are " + std::to_string(words.size()) + " canonical words for " +
                  std::to_string(certificate.generators.size()) + " generators");
  }
  std::vector<int> product;
  for (std::size_t k = 0; k + 1 < words.size(); k += 2)
  {
    AppendPower(product, words[k], false);
    AppendPower(product, words[k + 1], false);
    AppendPower(product, words[k], true);
    AppendPower(product, words[k + 1], true);
  }
  std::size_t ends = 0; // cyclic words may also cancel across their ends
  while (2 * ends + 1 < product.size() && product[ends] == -product[product.size() - 1 - ends])
  {
    ++ends;
  }
  const std::vector<int> reduced(product.begin() + ends, product.end() - ends);
  std::vector<int>       inverse;
  AppendPower(inverse, certificate.word, true);
  if (!AreCyclicallyEqual(certificate.word, reduced) && !AreCyclicallyEqual(inverse, reduced))
  {
    throw Refusal("the product of commutators of the canonical words is not the word of the fundamental polygon");
  }
}
} // namespace

void
CheckCutGraph(const EmbeddingCertificate & certificate, const TracedMap & packed)
{
  CutEdges cut = EdgesOfTree(certificate, packed);
  AddGenerators(certificate, cut);
  RequireDisk(packed, cut);
  const std::vector<int> word = BoundaryWord(certificate, packed, cut);
  if (!AreCyclicallyEqual(word, certificate.word))
  {
    throw Refusal("the word does not match the boundary of the fundamental polygon");
  }
  CheckCanonicalWords(certificate);
}
} // namespace shapeton
