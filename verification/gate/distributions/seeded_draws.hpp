// Random choices that are the same on every machine. The standard fixes the numbers of
// std::mt19937_64 to the bit (ISO C++, [rand.predef]) but not those of its distributions, so that
// the reduction to a range is written out here: of 2^64 equally likely numbers the last few, which
// would make the first remainders likelier, are drawn again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace slosh {

// So many random trials, begun by this seed. Results with one seed share the luck of its draws, so
// that what is counted over many results needs a seed for each.
struct SeededTrials {
  int count;
  std::uint64_t seed;
};

class SeededDraws {
 public:
  explicit SeededDraws(std::uint64_t seed) : generator_(seed) {}

  // Returns one of 0, 1, ..., count - 1, all equally likely. The count must be above 0.
  std::size_t below(std::size_t count) {
    constexpr std::uint64_t largest = std::mt19937_64::max();
    const std::uint64_t excess = (largest % count + 1) % count;  // 2^64 modulo count
    std::uint64_t drawn = generator_();
    while (drawn > largest - excess) drawn = generator_();
    return static_cast<std::size_t>(drawn % count);
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace slosh
