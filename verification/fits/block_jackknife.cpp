#include "verification/fits/block_jackknife.hpp"

#include <algorithm>
#include <cmath>

#include "verification/series/sample_moments.hpp"

namespace slosh {
namespace {

BlockIntegrals sum_without(const std::vector<BlockIntegrals>& blocks, std::size_t left_out) {
  BlockIntegrals sum;
  for (std::size_t j = 0; j < blocks.size(); ++j)
    if (j != left_out) sum += blocks[j];
  return sum;
}

}  // namespace

BlockIntegrals& BlockIntegrals::operator+=(const BlockIntegrals& other) {
  residual += other.residual;
  variation += other.variation;
  candidate += other.candidate;
  reference += other.reference;
  product += other.product;
  return *this;
}

int block_count(double duration, double longest_period) {
  const double periods = std::floor(duration / longest_period * (1 + 1e-9));
  return periods >= fewest_blocks ? static_cast<int>(std::min<double>(periods, most_blocks)) : 1;
}

double jackknife_half_width(const std::vector<double>& without) {
  const double freedom = static_cast<double>(without.size()) - 1;
  return t95(freedom) * std::sqrt(freedom) * rms(without_mean(without));
}

Estimate block_jackknife(const std::vector<BlockIntegrals>& blocks,
                         const std::function<double(const BlockIntegrals&)>& of) {
  const double value = of(sum_without(blocks, blocks.size()));
  if (blocks.size() < 2) return {value, 0};
  std::vector<double> without;
  for (std::size_t j = 0; j < blocks.size(); ++j) without.push_back(of(sum_without(blocks, j)));
  return {value, jackknife_half_width(without)};
}

}  // namespace slosh
