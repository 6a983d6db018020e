// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <Eigen/Core>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "portolan/options/value.hpp"

// What files of maps in YAML have in common: numbers, vectors and covariances, written so that they
// are read again to the last bit, and refused with std::runtime_error where they are none.

namespace portolan::yaml_values {

/// A vector or matrix by rows: `[1, 2, 3]`.
template <class Matrix>
std::string listed(const Matrix& matrix) {
  std::string text = "[";
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      text += (text.size() == 1 ? "" : ", ") + options_detail::format_double(matrix(row, column));
    }
  }
  return text + "]";
}

/// Throws where `holds` is false.
inline void require(bool holds, const std::string& fault) {
  if (!holds) throw std::runtime_error(fault);
}

/// Throws where what stands before a list, or a whole file, does not say that it is a map of
/// `things` of this version.
void check_version(const YAML::Node& head, int version, const std::string& things);

double finite_number(const YAML::Node& node, const std::string& name);

template <int rows, int columns>
Eigen::Matrix<double, rows, columns> matrix(const YAML::Node& node, const std::string& name) {
  const std::size_t size = static_cast<std::size_t>(rows) * columns;
  require(node.IsDefined() && node.IsSequence() && node.size() == size,
          name + " must have " + std::to_string(size) + " numbers");
  Eigen::Matrix<double, rows, columns> values;
  for (std::size_t i = 0; i < size; ++i) {
    values(static_cast<int>(i) / columns, static_cast<int>(i) % columns) =
        finite_number(node[i], name);
  }
  return values;
}

/// Symmetric and without negative eigenvalues, but for rounding.
Eigen::Matrix3d covariance(const YAML::Node& node, const std::string& name);

}  // namespace portolan::yaml_values
