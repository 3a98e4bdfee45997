// Columns brought to unit length, and orthonormal ones that span them.
#pragma once

#include <Eigen/Core>

namespace slosh {

// One over each column's length.
Eigen::VectorXd inverse_lengths(const Eigen::MatrixXd& columns);

// The columns at unit length: those of a weak tone would vanish beside those that carry seconds.
Eigen::MatrixXd unit_columns(const Eigen::MatrixXd& columns);

// Orthonormal columns that span these, without the directions in which their squares sum to no
// more than `least`.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns, double least);

// What is orthogonal to an orthonormal basis.
Eigen::VectorXd orthogonal_part(Eigen::VectorXd value, const Eigen::MatrixXd& basis);

}  // namespace slosh
