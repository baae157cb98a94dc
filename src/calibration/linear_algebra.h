#pragma once

#include <Eigen/Dense>

namespace repose {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Index = Eigen::Index;

}  // namespace repose
