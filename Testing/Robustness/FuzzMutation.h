#ifndef FuzzMutation_h
#define FuzzMutation_h

#include <cstdint>
#include <string>

/** SplitMix64 (Steele, Lea, Flood 2014): reproducible on every machine. */
class FuzzRandom
{
public:
  FuzzRandom(std::uint64_t seed, std::uint64_t stream)
    : m_State(seed * 0x9E3779B97F4A7C15u + stream * 0xD1B54A32D192ED03u)
  {}

  std::uint64_t
  Next()
  {
    m_State += 0x9E3779B97F4A7C15u;
    std::uint64_t z = m_State;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /** Returns a number in [0, limit); 0 for limit 0. */
  std::size_t
  Below(std::size_t limit)
  {
    return limit > 0 ? static_cast<std::size_t>(this->Next() % limit) : 0;
  }

private:
  std::uint64_t m_State;
};

/** Mutates a file by one to four changes: bits, bytes, lengths, numbers in text; pieces removed, duplicated, or
 * inserted from another file. */
std::string
Mutate(std::string bytes, const std::string & other, FuzzRandom & random);
#endif
