#include "shapetonEmbeddingVerification.h"
#include "shapetonChecks.h"

#include <cmath>
#include <cstdio>

namespace shapeton
{
std::string
Figure(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}

void
RequireRadii(const std::vector<double> & radii, double least, double most, const std::string & what)
{
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    if (!(radii[i] > least && radii[i] < most))
    {
      throw Refusal("the radius of " + what + ' ' + std::to_string(i) + " is " + Figure(radii[i]) + ", not between " +
                    Figure(least) + " and " + Figure(most) + ": the solution is degenerate");
    }
  }
}

double
RequireAngleSums(const std::vector<double> & angleSums, const std::vector<double> & tolerance, const std::string & what)
{
  const double full = 2.0 * std::acos(-1.0);
  double       largest = 0.0;
  for (std::size_t i = 0; i < angleSums.size(); ++i)
  {
    const double deviation = std::abs(angleSums[i] - full);
    if (!(deviation <= tolerance[i]))
    {
      throw Refusal("the angles at " + what + ' ' + std::to_string(i) + " sum to 2 pi + " +
                    Figure(angleSums[i] - full));
    }
    largest = std::max(largest, deviation);
  }
  return largest;
}

namespace
{
void
RequireGeometryOfGenus(const EmbeddingCertificate & certificate)
{
  const EmbeddingGeometry wanted = certificate.genus == 0   ? EmbeddingGeometry::Spherical
                                   : certificate.genus == 1 ? EmbeddingGeometry::Euclidean
                                                            : EmbeddingGeometry::Hyperbolic;
  if (certificate.geometry != wanted)
  {
    throw Refusal("a surface of genus " + std::to_string(certificate.genus) + " is " + NameOf(wanted) + ", not " +
                  NameOf(certificate.geometry));
  }
}

void
Check(const EmbeddingCertificate & certificate, Measures & measures)
{
  RequireGeometryOfGenus(certificate);
  const TracedMap packed(certificate.packed, certificate.packedRotation, "the rotation of the packed map");
  CheckMap(certificate, packed, measures);
  switch (certificate.geometry)
  {
    case EmbeddingGeometry::Spherical:
      CheckPackingExists(packed);
      CheckSphere(certificate, packed, measures);
      break;
    case EmbeddingGeometry::Euclidean:
      CheckCutGraph(certificate, packed);
      CheckPlane(certificate, packed, measures);
      break;
    default:
      CheckCutGraph(certificate, packed);
      CheckDisk(certificate, packed, measures);
  }
}
} // namespace

EmbeddingVerdict
VerifyEmbedding(const EmbeddingCertificate & certificate)
{
  EmbeddingVerdict verdict;
  try
  {
    Check(certificate, verdict.measures);
  }
  catch (const Refusal & refusal)
  {
    verdict.refusal = refusal.what();
  }
  return verdict;
}
} // namespace shapeton
