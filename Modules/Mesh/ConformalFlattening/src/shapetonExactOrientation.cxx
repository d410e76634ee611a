#include "shapetonExactOrientation.h"

#include <array>
#include <cmath>
#include <limits>

namespace shapeton
{
namespace
{
/** An exact sum of doubles: nonoverlapping terms, smallest first. */
class Expansion
{
public:
  void
  Add(double value)
  {
    for (int i = 0; i < m_Number; ++i)
    {
      // Knuth's two-sum: `value` becomes the rounded sum, the term its rounding error.
      const double sum = value + m_Terms[i];
      const double part = sum - value;
      m_Terms[i] = (value - (sum - part)) + (m_Terms[i] - part);
      value = sum;
    }
    m_Terms[m_Number++] = value;
  }

  void
  AddProduct(double x, double y)
  {
    const double product = x * y;
    this->Add(std::fma(x, y, -product));
    this->Add(product);
  }

  /** Sign of the largest nonzero term. */
  int
  Sign() const
  {
    for (int i = m_Number - 1; i >= 0; --i)
    {
      if (m_Terms[i] != 0.0)
      {
        return m_Terms[i] > 0.0 ? 1 : -1;
      }
    }
    return 0;
  }

private:
  /** Six products of two terms each. */
  static constexpr int          MostTerms = 12;
  std::array<double, MostTerms> m_Terms{};
  int                           m_Number{ 0 };
};
} // namespace

int
ExactOrientation(const Eigen::RowVector2d & a, const Eigen::RowVector2d & b, const Eigen::RowVector2d & c)
{
  // Shewchuk's bound for the determinant of rounded differences.
  constexpr double half = 0.5 * std::numeric_limits<double>::epsilon();
  constexpr double bound = (3.0 + 16.0 * half) * half;
  const double     left = (a[0] - c[0]) * (b[1] - c[1]);
  const double     right = (a[1] - c[1]) * (b[0] - c[0]);
  const double     determinant = left - right;
  if (std::abs(determinant) > bound * (std::abs(left) + std::abs(right)))
  {
    return determinant > 0.0 ? 1 : -1;
  }
  Expansion sum;
  sum.AddProduct(a[0], b[1]);
  sum.AddProduct(-a[1], b[0]);
  sum.AddProduct(b[0], c[1]);
  sum.AddProduct(-b[1], c[0]);
  sum.AddProduct(c[0], a[1]);
  sum.AddProduct(-c[1], a[0]);
  return sum.Sign();
}
} // namespace shapeton
