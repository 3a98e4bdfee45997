#include "sph/start/linear_solver.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <unsupported/Eigen/IterativeSolvers>

namespace slosh::sph {
class AppliedOperator;
}

// Eigen requires these traits of a matrix-free operator (Eigen's documentation, "Matrix-free
// solvers").
namespace Eigen::internal {
template <>
struct traits<slosh::sph::AppliedOperator> : traits<SparseMatrix<double>> {};
}  // namespace Eigen::internal

namespace slosh::sph {

class AppliedOperator : public Eigen::EigenBase<AppliedOperator> {
 public:
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = int;
  enum {
    ColsAtCompileTime = Eigen::Dynamic,
    MaxColsAtCompileTime = Eigen::Dynamic,
    IsRowMajor = false
  };
  using Apply = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

  AppliedOperator(const Apply& apply, Eigen::Index size) : apply_(apply), size_(size) {}
  Eigen::Index rows() const { return size_; }
  Eigen::Index cols() const { return size_; }
  const Apply& apply() const { return apply_; }

  template <class Vector>
  Eigen::Product<AppliedOperator, Vector, Eigen::AliasFreeProduct> operator*(
      const Eigen::MatrixBase<Vector>& x) const {
    return {*this, x.derived()};
  }

 private:
  const Apply& apply_;
  Eigen::Index size_;
};

}  // namespace slosh::sph

namespace Eigen::internal {
template <class Vector>
struct generic_product_impl<slosh::sph::AppliedOperator, Vector, SparseShape, DenseShape,
                            GemvProduct>
    : generic_product_impl_base<slosh::sph::AppliedOperator, Vector,
                                generic_product_impl<slosh::sph::AppliedOperator, Vector,
                                                     SparseShape, DenseShape, GemvProduct>> {
  template <class Target>
  static void scaleAndAddTo(Target& target, const slosh::sph::AppliedOperator& matrix,
                            const Vector& x, double factor) {
    target += factor * matrix.apply()(x);
  }
};
}  // namespace Eigen::internal

namespace slosh::sph {

LinearSolution solve(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& apply,
                     const Eigen::VectorXd& right_side, double tolerance, int most) {
  const AppliedOperator matrix(apply, right_side.size());
  Eigen::GMRES<AppliedOperator, Eigen::IdentityPreconditioner> solver;
  solver.set_restart(50);
  solver.compute(matrix);
  solver.setTolerance(tolerance);
  solver.setMaxIterations(most);
  Eigen::VectorXd x = solver.solve(right_side);
  return {std::move(x), static_cast<int>(solver.iterations()), solver.error()};
}

}  // namespace slosh::sph
