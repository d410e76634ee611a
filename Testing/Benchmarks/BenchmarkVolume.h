#ifndef BenchmarkVolume_h
#define BenchmarkVolume_h

#include <array>
#include <cstddef>
#include <vector>

/** Three balls with soft edges on a nonuniform, noisy background: 0 to 255 like the classic volumes, x fastest. */
std::vector<float>
MakeBenchmarkVolume(const std::array<std::size_t, 3> & size);

#endif
