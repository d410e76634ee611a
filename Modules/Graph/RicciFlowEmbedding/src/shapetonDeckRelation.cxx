#include "shapetonSurfaceLayout.h"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <stdexcept>

namespace shapeton
{
namespace
{
/** Many digits are needed because canonical words move the origin far out and back. */
constexpr unsigned int digits = 320;
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>, boost::multiprecision::et_off>;
/** A relation with a larger residual is meaningless and is not refined. */
constexpr double worstRelation = 0.1;
constexpr int    mostNewtonSteps = 12;
/** Longer words are not multiplied, because the time is cubic in their length. */
constexpr std::size_t longestWord = 160;

struct ExactComplex
{
  Real re{ 0 };
  Real im{ 0 };
};

ExactComplex
operator*(const ExactComplex & x, const ExactComplex & y)
{
  return { x.re * y.re - x.im * y.im, x.re * y.im + x.im * y.re };
}

ExactComplex
operator+(const ExactComplex & x, const ExactComplex & y)
{
  return { x.re + y.re, x.im + y.im };
}

ExactComplex
Conj(const ExactComplex & x)
{
  return { x.re, -x.im };
}

/** An element of SU(1,1). */
struct ExactMotion
{
  ExactComplex a{ 1, 0 };
  ExactComplex b;
};

ExactMotion
operator*(const ExactMotion & x, const ExactMotion & y)
{
  return { x.a * y.a + x.b * Conj(y.b), x.a * y.b + x.b * Conj(y.a) };
}

ExactMotion
Inverse(const ExactMotion & x)
{
  return { Conj(x.a), { -x.b.re, -x.b.im } };
}

/** |a| from |b|. Their squares differ by 1, which is lost to rounding in double precision for long translations. */
ExactMotion
Normalized(const ExactMotion & x)
{
  const Real squaredOfA = x.a.re * x.a.re + x.a.im * x.a.im;
  const Real squaredOfB = x.b.re * x.b.re + x.b.im * x.b.im;
  const Real scale = sqrt((1 + squaredOfB) / squaredOfA);
  return { { x.a.re * scale, x.a.im * scale }, x.b };
}

ExactMotion
FromMotion(const PlaneMotion & motion)
{
  return Normalized({ { motion.a.real(), motion.a.imag() }, { motion.b.real(), motion.b.imag() } });
}

PlaneMotion
ToMotion(const ExactMotion & motion)
{
  return { FlowGeometry::Hyperbolic,
           { static_cast<double>(motion.a.re), static_cast<double>(motion.a.im) },
           { static_cast<double>(motion.b.re), static_cast<double>(motion.b.im) } };
}

using ExactMotions = std::vector<ExactMotion>;

ExactMotion
Letter(const ExactMotions & generators, int letter)
{
  return letter > 0 ? generators[letter - 1] : Inverse(generators[-letter - 1]);
}

ExactMotion
Product(const ExactMotions & generators, const std::vector<int> & word)
{
  ExactMotion product;
  for (const int letter : word)
  {
    product = product * Letter(generators, letter);
  }
  return product;
}

/** Largest difference from plus or minus the identity. */
double
Deviation(const ExactMotion & motion)
{
  using boost::multiprecision::abs;
  const auto largest = [&](const Real & one) {
    return static_cast<double>(std::max(
      { Real(abs(motion.a.re - one)), Real(abs(motion.a.im)), Real(abs(motion.b.re)), Real(abs(motion.b.im)) }));
  };
  return std::min(largest(1), largest(-1));
}

/** An element (i t, x + i y) of the Lie algebra. */
using Algebra = std::array<Real, 3>;

/** S^-1 X S. */
Algebra
Conjugated(const ExactMotion & s, const Algebra & x)
{
  const ExactMotion product = Inverse(s) * ExactMotion{ { 0, x[0] }, { x[1], x[2] } } * s;
  return { product.a.im, product.b.re, product.b.im };
}

/** The x of a group element 1 + x near the identity, up to second order; a factor -1 is removed. */
Algebra
Logarithm(const ExactMotion & motion)
{
  const Real sign = motion.a.re < 0 ? -1 : 1;
  return { sign * motion.a.im, sign * motion.b.re, sign * motion.b.im };
}

ExactMotion
Exponential(const Algebra & x)
{
  // Cayley map: exactly in the group, agrees with the exponential to second order.
  const Algebra     half{ x[0] / 2, x[1] / 2, x[2] / 2 };
  const ExactMotion plus{ { 1, half[0] }, { half[1], half[2] } };
  return Normalized(plus * plus);
}

/** Solves a symmetric 3 x 3 system by Cramer's rule. */
Algebra
Solve(const std::array<Algebra, 3> & matrix, const Algebra & right)
{
  const auto determinant = [](const Algebra & p, const Algebra & q, const Algebra & r) {
    return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
  };
  const Real whole = determinant(matrix[0], matrix[1], matrix[2]);
  return { determinant(right, matrix[1], matrix[2]) / whole,
           determinant(matrix[0], right, matrix[2]) / whole,
           determinant(matrix[0], matrix[1], right) / whole };
}

/** Derivative of the word product, as product (1 + sum), when generator k becomes G exp(x_k): three columns for each
 * generator. */
std::vector<std::array<Algebra, 3>>
Derivative(const ExactMotions & generators, const std::vector<int> & word)
{
  std::vector<std::array<Algebra, 3>> columns(generators.size());
  ExactMotion                         after;
  for (auto letter = word.rbegin(); letter != word.rend(); ++letter)
  {
    const ExactMotion before = Letter(generators, *letter) * after;
    for (int i = 0; i < 3; ++i)
    {
      Algebra unit{ 0, 0, 0 };
      unit[i] = *letter > 0 ? 1 : -1;
      const Algebra change = Conjugated(*letter > 0 ? after : before, unit);
      for (int j = 0; j < 3; ++j)
      {
        columns[std::abs(*letter) - 1][i][j] += change[j];
      }
    }
    after = before;
  }
  return columns;
}

/** Performs the Newton step with the smallest change. */
void
Refine(ExactMotions & generators, const std::vector<int> & word)
{
  const auto             columns = Derivative(generators, word);
  std::array<Algebra, 3> square{};
  for (const auto & column : columns)
  {
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        for (int k = 0; k < 3; ++k)
        {
          square[j][k] += column[i][j] * column[i][k];
        }
      }
    }
  }
  const Algebra multiplier = Solve(square, Logarithm(Product(generators, word)));
  for (std::size_t g = 0; g < generators.size(); ++g)
  {
    Algebra change{ 0, 0, 0 };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        change[i] -= columns[g][i][j] * multiplier[j];
      }
    }
    generators[g] = Normalized(generators[g] * Exponential(change));
  }
}

ExactMotions
ToExact(const std::vector<PlaneMotion> & motions)
{
  ExactMotions exact;
  for (const PlaneMotion & motion : motions)
  {
    exact.push_back(FromMotion(motion));
  }
  return exact;
}

std::vector<int>
Reversed(std::vector<int> word)
{
  std::reverse(word.begin(), word.end());
  for (int & letter : word)
  {
    letter = -letter;
  }
  return word;
}
} // namespace

std::vector<std::vector<int>>
CanonicalWords(const std::vector<int> & word)
{
  using Word = std::vector<int>;
  const auto join = [](std::initializer_list<Word> parts) {
    Word whole;
    for (const Word & part : parts)
    {
      whole.insert(whole.end(), part.begin(), part.end());
    }
    return whole;
  };
  std::vector<Word> canonical;
  Word              rest = word;
  while (!rest.empty())
  {
    const auto find = [&rest](int letter) { return std::find(rest.begin(), rest.end(), letter); };
    // The first letter a, and the first b after it whose inverse follows the inverse of a.
    const auto a = rest.begin();
    const auto aInverse = find(-*a);
    auto       b = a + 1;
    while (b < aInverse && find(-*b) < aInverse)
    {
      ++b;
    }
    const auto bInverse = b < aInverse ? find(-*b) : rest.end();
    if (aInverse == rest.end() || bInverse == rest.end())
    {
      throw std::invalid_argument("the word is not that of a closed orientable surface cut into one disk");
    }
    const Word P(a + 1, b);
    const Word Q(b + 1, aInverse);
    const Word R(aInverse + 1, bInverse);
    const Word S(bInverse + 1, rest.end());
    canonical.push_back(join({ { *a }, Reversed(Q), Reversed(R) }));
    canonical.push_back(join({ R, Q, P, { *b }, Reversed(R) }));
    rest = join({ R, Q, P, S });
  }
  return canonical;
}

double
WordResidual(const std::vector<PlaneMotion> & generators, const std::vector<int> & word)
{
  PlaneMotion product = PlaneMotion::Rotation(generators.front().geometry, 0.0);
  for (const int letter : word)
  {
    product = product * (letter > 0 ? generators[letter - 1] : generators[-letter - 1].Inverse());
  }
  return std::min(std::max(std::abs(product.a - 1.0), std::abs(product.b)),
                  std::max(std::abs(product.a + 1.0), std::abs(product.b)));
}

std::vector<int>
CenteredWord(const std::vector<PlaneMotion> & generators, const std::vector<int> & word)
{
  std::size_t best = 0;
  double      least = 1e300;
  for (std::size_t start = 0; start < word.size(); ++start)
  {
    PlaneMotion product = PlaneMotion::Rotation(FlowGeometry::Hyperbolic, 0.0);
    double      largest = 0.0;
    for (std::size_t i = 0; i < word.size() && largest < least; ++i)
    {
      const int letter = word[(start + i) % word.size()];
      product = product * (letter > 0 ? generators[letter - 1] : generators[-letter - 1].Inverse());
      largest = std::max(largest, std::abs(product.a));
    }
    if (largest < least)
    {
      least = largest;
      best = start;
    }
  }
  std::vector<int> rotated = word;
  std::rotate(rotated.begin(), rotated.begin() + best, rotated.end());
  return rotated;
}

DeckRelation
RefineDeckRelation(const std::vector<PlaneMotion> &      generators,
                   const std::vector<int> &              word,
                   const std::vector<std::vector<int>> & canonicalWords)
{
  DeckRelation relation;
  ExactMotions exact = ToExact(generators);
  relation.givenResidual = Deviation(Product(exact, word));
  relation.isRefined = relation.givenResidual < worstRelation;
  for (int step = 0; relation.isRefined && step < mostNewtonSteps && Deviation(Product(exact, word)) > 1e-300; ++step)
  {
    Refine(exact, word);
  }
  for (const ExactMotion & motion : exact)
  {
    relation.generators.push_back(ToMotion(motion));
  }
  relation.residual = WordResidual(relation.generators, word);
  if (!relation.isRefined || word.size() > longestWord)
  {
    return relation;
  }
  ExactMotion whole;
  for (std::size_t i = 0; i + 1 < canonicalWords.size(); i += 2)
  {
    const ExactMotion A = Product(exact, canonicalWords[i]);
    const ExactMotion B = Product(exact, canonicalWords[i + 1]);
    whole = whole * A * B * Inverse(A) * Inverse(B);
    relation.canonical.push_back(ToMotion(A));
    relation.canonical.push_back(ToMotion(B));
  }
  relation.canonicalResidual = Deviation(whole);
  return relation;
}
} // namespace shapeton
