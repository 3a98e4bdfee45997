// Discrete Fourier transforms of real columns, by FFTW.
#pragma once

#include <Eigen/Core>

namespace slosh {

// The transform of each column x of n samples, padded with zeros to `length` >= n: row j holds the
// sum over i of x_i exp(-2 pi i j sqrt(-1) / length), for j = 0 ... length / 2.
Eigen::MatrixXcd fourier_transforms(const Eigen::MatrixXd& columns, Eigen::Index length);

// The real values x_0 ... x_{length - 1} that have this transform of length / 2 + 1 coefficients.
Eigen::VectorXd inverse_fourier_transform(Eigen::VectorXcd transform, Eigen::Index length);

// The smallest number >= `least` with no prime factor above 5, which FFTW transforms fast.
Eigen::Index fast_length(Eigen::Index least);

}  // namespace slosh
