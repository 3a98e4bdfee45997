#include "sph/benchmarks/machine_ceilings.hpp"

#include <algorithm>
#include <chrono>

#include "sph/neighbours/lanes.hpp"
#include "sph/neighbours/particles.hpp"

namespace slosh::sph {
namespace {

constexpr int chains =
    12;  // more than latency times throughput, with registers left for the factors

void multiply_and_add(long rounds, const Lanes* factor, Lanes* result) {
  Lanes sums[chains];  // all different, so that the compiler cannot merge the chains
  for (int chain = 0; chain < chains; ++chain) sums[chain] = factor[chain];
  const Lanes a = factor[0], b = factor[1];
  for (long i = 0; i < rounds; ++i)
    for (Lanes& sum : sums) sum = sum * a + b;
  for (const Lanes& sum : sums) *result += sum;
}

void sum_array(const double* values, std::size_t count, Lanes* result) {
  constexpr std::size_t streams = 8;
  Lanes sums[streams] = {};
  for (std::size_t i = 0; i + streams * lane_count <= count; i += streams * lane_count)
    for (std::size_t s = 0; s < streams; ++s) sums[s] += load(values + i + s * lane_count);
  for (const Lanes& sum : sums) *result += sum;
}

// Returns the shortest time of some repetitions [s].
template <class Work>
double fastest(const Work& work) {
  double seconds = 1e300;
  for (int repetition = 0; repetition < 7; ++repetition) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const auto end = std::chrono::steady_clock::now();
    seconds = std::min(seconds, std::chrono::duration<double>(end - start).count());
  }
  return seconds;
}

volatile double kept;  // keeps the compiler from removing the computation

}  // namespace

double peak_flops(InstructionSet set) {
  const long rounds = 1000000;
  Lanes factors[chains];
  for (int i = 0; i < chains; ++i) factors[i] = 0.5 + 0.01 * i - Lanes{};
  Lanes result{};
  const double seconds =
      fastest([&] { call<&multiply_and_add>(set, rounds, &factors[0], &result); });
  kept = result[0];
  return 2.0 * lane_count * chains * rounds / seconds;
}

double read_bandwidth(std::size_t bytes, InstructionSet set) {
  const Array<double> values(bytes / sizeof(double), 1.0);
  const std::size_t least_bytes = std::size_t{1} << 27;
  const std::size_t rounds = std::max<std::size_t>(1, least_bytes / bytes);
  Lanes result{};
  const double seconds = fastest([&] {
    for (std::size_t i = 0; i < rounds; ++i)
      call<&sum_array>(set, values.data(), values.size(), &result);
  });
  kept = result[0];
  return static_cast<double>(rounds * bytes) / seconds;
}

}  // namespace slosh::sph
