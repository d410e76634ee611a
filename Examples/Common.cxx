// Estimates pi on all threads with counter-based random numbers; the result is the same for any number of
// threads. Prints the SHA-256 of the result.
// Usage: ExampleCommon POINTS
#include "shapetonExceptions.h"
#include "shapetonNumberText.h"
#include "shapetonParallelFor.h"
#include "shapetonPhiloxStream.h"
#include "shapetonSha256.h"

#include <cstdlib>
#include <iostream>
#include <numeric>
#include <vector>

int
main(int argc, char * argv[])
try
{
  const int points = argc == 2 ? std::atoi(argv[1]) : 0;
  shapeton::RequireParameter(points > 0, "the number of points must be greater than 0"); // throws ParameterError

  std::vector<int> inside(100, 0);
  shapeton::ParallelFor(inside.size(), [&](std::size_t i) {
    shapeton::PhiloxStream random(1, static_cast<std::uint32_t>(i), 0); // seed, stream, purpose
    for (int k = 0; k < points; ++k)
    {
      const double x = random.Unit();
      const double y = random.Unit();
      inside[i] += x * x + y * y < 1.0;
    }
  });
  const double      sum = std::accumulate(inside.begin(), inside.end(), 0.0);
  const std::string pi = shapeton::NumberText(4.0 * sum / (100.0 * points), 5);
  std::cout << "pi is about " << pi << ", SHA-256 " << shapeton::Sha256OfBytes(pi) << '\n';
}
catch (const shapeton::Exception & error) // derived from itk::ExceptionObject
{
  std::cerr << error.GetDescription() << '\n';
  return 2;
}
