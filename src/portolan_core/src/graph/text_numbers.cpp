// SPDX-License-Identifier: BSD-3-Clause
#include "graph/text_numbers.hpp"

#include <locale.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace portolan {

namespace {

constexpr std::int64_t kNanoseconds = 1000000000;
constexpr double kGrid = 1e14;                     // steps of turns [1/rad]
constexpr double kNearlyEqual = M_SQRT1_2 * 1e-9;  // which texts of decimals do not differ by

double c_number(const char* text, char** end) {
  static const locale_t kClassic = newlocale(LC_ALL_MASK, "C", nullptr);
  return strtod_l(text, end, kClassic);
}

std::string with_digits(double value, int digits) {
  thread_local std::ostringstream out = [] {
    std::ostringstream made;
    made.imbue(std::locale::classic());
    return made;
  }();
  out.str({});
  out << std::setprecision(digits) << value;
  return out.str();
}

double rounded(double value, double grid) { return std::round(value * grid) / grid; }

}  // namespace

std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = c_number(text.c_str(), &end);
  const bool whole = end == text.c_str() + text.size() && !text.empty();
  return whole && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

std::optional<std::int64_t> integer_in(const std::string& text) {
  std::int64_t value = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc{} && end == last ? std::optional<std::int64_t>(value) : std::nullopt;
}

std::optional<Time> stamp_in(const std::string& text) {
  const std::size_t point = text.find('.');
  std::string decimals = point == std::string::npos ? "" : text.substr(point + 1);
  if (decimals.size() > 9 || decimals.find_first_not_of("0123456789") != std::string::npos) {
    return std::nullopt;
  }
  decimals.resize(9, '0');
  const std::optional<std::int64_t> whole = integer_in(text.substr(0, point));
  const std::optional<std::int64_t> part = integer_in(decimals);
  if (!whole || !part || std::abs(*whole) > 9000000000) return std::nullopt;
  const std::int64_t sign = text.front() == '-' ? -1 : 1;
  return Time(Duration(*whole * kNanoseconds + sign * *part));
}

std::string to_text(double value) {
  if (std::abs(value) < 1e15 && value == std::floor(value) &&
      !(value == 0.0 && std::signbit(value))) {
    return std::to_string(static_cast<std::int64_t>(value));
  }
  std::string text = with_digits(value, 15);
  return c_number(text.c_str(), nullptr) == value ? text : with_digits(value, 17);
}

std::string to_text(Time stamp) {
  const std::int64_t count = stamp.time_since_epoch().count();
  const std::int64_t size = std::abs(count);
  const std::string decimals = std::to_string(kNanoseconds + size % kNanoseconds).substr(1);
  return (count < 0 ? "-" : "") + std::to_string(size / kNanoseconds) + "." + decimals;
}

double rounded_heading(const Pose& pose) { return rounded(yaw(pose), kGrid); }

// The largest component makes the norm 1, so that normalising it again moves nothing.
Eigen::Quaterniond rounded_quaternion(const Pose& pose) {
  Eigen::Quaterniond q(pose.linear());
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  Eigen::Index largest = 0;
  for (Eigen::Index i = 1; i < 4; ++i) {
    const double more = std::abs(q.coeffs()[i]) - std::abs(q.coeffs()[largest]);
    if (more > kNearlyEqual) largest = i;
  }
  double rest = 1.0;
  for (Eigen::Index i = 0; i < 4; ++i) {
    double& component = q.coeffs()[i];
    if (i == largest) continue;
    component = rounded(component, kGrid);
    rest -= component * component;
  }
  q.coeffs()[largest] = std::copysign(std::sqrt(rest), q.coeffs()[largest]);
  return q;
}

Pose spatial_pose(const Eigen::Vector3d& t, const Eigen::Quaterniond& q) {
  Pose pose = Pose::Identity();
  pose.linear() = q.normalized().toRotationMatrix();
  pose.translation() = t;
  return pose;
}

}  // namespace portolan
