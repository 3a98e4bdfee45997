#include "verification/series/fourier_transform.hpp"

#include <fftw3.h>

#include <memory>
#include <mutex>

namespace slosh {

using Eigen::Index, Eigen::MatrixXcd, Eigen::MatrixXd;

MatrixXcd fourier_transforms(const MatrixXd& columns, Index length) {
  MatrixXd padded = MatrixXd::Zero(length, columns.cols());
  MatrixXcd transforms(length / 2 + 1, columns.cols());
  // FFTW's planner is not thread-safe; the execution of plans is.
  static std::mutex planning;
  const int size = static_cast<int>(length), outputs = size / 2 + 1;
  const auto destroy = [](fftw_plan plan) {
    const std::lock_guard lock(planning);
    fftw_destroy_plan(plan);
  };
  std::unique_ptr<fftw_plan_s, decltype(destroy)> plan(nullptr, destroy);
  {
    const std::lock_guard lock(planning);
    plan.reset(fftw_plan_many_dft_r2c(
        1, &size, static_cast<int>(columns.cols()), padded.data(), nullptr, 1, size,
        reinterpret_cast<fftw_complex*>(transforms.data()), nullptr, 1, outputs, FFTW_ESTIMATE));
  }
  padded.topRows(columns.rows()) = columns;
  fftw_execute(plan.get());
  return transforms;
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
