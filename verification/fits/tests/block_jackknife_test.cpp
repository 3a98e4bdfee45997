#include "verification/fits/block_jackknife.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace slosh::block_jackknife_test {
namespace {

double rms_ratio(const BlockIntegrals& of) { return std::sqrt(of.residual / of.variation); }

BlockIntegrals block(double residual, double variation = 1) {
  return {.residual = residual, .variation = variation};
}

TEST(BlockJackknife, AnAlikeWindowHasNoSpread) {
  const Estimate rms = block_jackknife(std::vector<BlockIntegrals>(6, block(0.04)), rms_ratio);
  EXPECT_NEAR(rms.value, 0.2, 1e-15);
  EXPECT_NEAR(rms.half_width, 0, 1e-14);
}

TEST(BlockJackknife, OfAMeanItIsStudentsInterval) {
  // Blocks of the same length: the mean of 1, 2, 3, 6 is 3, its standard error sqrt(14/3)/2, and
  // Student's t of three degrees of freedom at 97.5 % is 3.18245 (tables).
  const Estimate mean =
      block_jackknife({block(1), block(2), block(3), block(6)},
                      [](const BlockIntegrals& of) { return of.residual / of.variation; });
  EXPECT_NEAR(mean.value, 3, 1e-14);
  EXPECT_NEAR(mean.half_width, 3.18245 * std::sqrt(14.0 / 3) / 2, 1e-4);
}

TEST(BlockJackknife, HoldsTheTruthAsOftenAsItSays) {
  std::mt19937 random(7);
  std::exponential_distribution<double> square(1 / 0.01);
  int held = 0;
  constexpr int trials = 2000;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<BlockIntegrals> blocks;
    for (int j = 0; j < most_blocks; ++j) {
      double sum = 0;
      for (int k = 0; k < 8; ++k) sum += square(random) / 8;
      blocks.push_back(block(sum));
    }
    const Estimate rms = block_jackknife(blocks, rms_ratio);
    held += std::abs(rms.value - 0.1) <= rms.half_width;
  }
  EXPECT_GT(held, 0.93 * trials);
  EXPECT_LT(held, 0.97 * trials);
}

TEST(BlockJackknife, TakesBlocksOfAPeriodOrLongerAndNoFewerThanThree) {
  EXPECT_EQ(block_count(20, 4.2), 4);
  EXPECT_EQ(block_count(20, 1), most_blocks);
  EXPECT_EQ(block_count(12, 4), 3);
  EXPECT_EQ(block_count(20, 8), 1);
}

TEST(BlockJackknife, OfASingleBlockSaysNothing) {
  EXPECT_EQ(block_jackknife({block(0.04)}, rms_ratio).half_width, 0);
}

}  // namespace
}  // namespace slosh::block_jackknife_test
