// How far two samples are from samples of one distribution. With n_i the sizes of the samples,
// N = n_1 + n_2, z_1 < ... < z_L the distinct values of both together, l_j how often z_j occurs,
// B_j the number of all values below z_j plus l_j / 2, and M_ij the same of sample i alone:
//   Kolmogorov-Smirnov  D = max over x of |F_1(x) - F_2(x)|   (Smirnov 1939)
//   Anderson-Darling    A^2 = (N - 1)/N sum_i 1/n_i sum_j l_j/N (N M_ij - n_i B_j)^2
//                             / (B_j (N - B_j) - N l_j / 4)
//     (Scholz & Stephens 1987, J. Am. Stat. Assoc. 82:918-924, equation 7: the version of midranks,
//     which handles ties; it holds for any number of samples)
//   Welch               t = (m_1 - m_2) / sqrt(s_1^2/n_1 + s_2^2/n_2), of
//                       (s_1^2/n_1 + s_2^2/n_2)^2 / sum_i (s_i^2/n_i)^2 / (n_i - 1) degrees of
//                       freedom (Welch 1947, Biometrika 34:28-35)
// D sees a shift best; A^2 weighs the tails, where the largest peaks are.
#pragma once

#include <cstddef>
#include <vector>

#include "verification/series/distribution.hpp"

namespace slosh {

// The distinct values of several samples together, and how each sample is spread over them.
class PooledSamples {
 public:
  explicit PooledSamples(const std::vector<Distribution>& samples);

  std::size_t size() const { return size_; }  // N
  const std::vector<double>& values() const { return values_; }
  // The index of the distinct value that each of the N values has, in increasing order.
  const std::vector<std::size_t>& places() const { return places_; }
  // How often each distinct value occurs in a sample.
  std::vector<int> counts_of(const Distribution& sample) const;

  // For a sample of the pooled values, given by its counts, and the sample of all the others.
  double kolmogorov_smirnov(const std::vector<int>& counts) const;
  double anderson_darling(const std::vector<int>& counts) const;

  // A^2 of all the samples.
  double anderson_darling(const std::vector<Distribution>& samples) const;

 private:
  // The sum over j of the sample in A^2.
  double anderson_darling_sum(const std::vector<int>& counts) const;

  std::size_t size_ = 0;
  std::vector<double> values_, below_, weight_;  // by distinct value: z_j, B_j, l_j/N / (...)
  std::vector<int> counts_;                      // l_j
  std::vector<std::size_t> places_;
};

// The two-sided p-value of Welch's test of equal means. It is 1 for two samples that do not scatter
// and have one mean, and 0 where they have different ones. Throws ComparisonError for a sample of a
// single value.
double welch_p_value(const Distribution& one, const Distribution& other);

}  // namespace slosh
