#include "verification/series/fourier_transform.hpp"

#include <fftw3.h>

#include <memory>
#include <mutex>

namespace slosh {

using Eigen::Index, Eigen::MatrixXcd, Eigen::MatrixXd, Eigen::VectorXcd, Eigen::VectorXd;

namespace {

using Plan = std::unique_ptr<fftw_plan_s, void (*)(fftw_plan)>;

// FFTW's planner is not thread-safe; the execution of plans is.
std::mutex& planning() {
  static std::mutex mutex;
  return mutex;
}

template <class Make>
Plan planned(const Make& make) {
  const std::lock_guard lock(planning());
  return {make(), [](fftw_plan plan) {
            const std::lock_guard destroying(planning());
            fftw_destroy_plan(plan);
          }};
}

}  // namespace

MatrixXcd fourier_transforms(const MatrixXd& columns, Index length) {
  MatrixXd padded = MatrixXd::Zero(length, columns.cols());
  MatrixXcd transforms(length / 2 + 1, columns.cols());
  const int size = static_cast<int>(length), outputs = size / 2 + 1;
  const Plan plan = planned([&] {
    return fftw_plan_many_dft_r2c(
        1, &size, static_cast<int>(columns.cols()), padded.data(), nullptr, 1, size,
        reinterpret_cast<fftw_complex*>(transforms.data()), nullptr, 1, outputs, FFTW_ESTIMATE);
  });
  padded.topRows(columns.rows()) = columns;
  fftw_execute(plan.get());
  return transforms;
}

VectorXd inverse_fourier_transform(VectorXcd transform, Index length) {
  VectorXd values(length);
  const Plan plan = planned([&] {
    return fftw_plan_dft_c2r_1d(static_cast<int>(length),
                                reinterpret_cast<fftw_complex*>(transform.data()), values.data(),
                                FFTW_ESTIMATE);
  });
  fftw_execute(plan.get());
  return values / static_cast<double>(length);
}

Index fast_length(Index least) {
  for (Index length = least;; ++length) {
    Index rest = length;
    for (const Index factor : {2, 3, 5})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return length;
  }
}

}  // namespace slosh
