// Discrete Fourier transforms of real columns, by FFTW.
#pragma once

#include <Eigen/Core>

namespace slosh {

// Per column x of n samples, zeros after them up to `length` >= n: the sums over i of
// x_i exp(-2 pi i j sqrt(-1) / length), a row for each j = 0 ... length / 2.
Eigen::MatrixXcd fourier_transforms(const Eigen::MatrixXd& columns, Eigen::Index length);

// The smallest number from `least` on with no prime factor above 5, which FFTW transforms fast.
Eigen::Index fast_length(Eigen::Index least);

}  // namespace slosh
