// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "portolan/time.hpp"

namespace portolan {

/// Tells whether a message comes next by stamp, or whether another input may still bring one before
/// it: at equal stamps the input that was added first comes first.
class InputOrder {
 public:
  /// An input that brought nothing for so long is not waited for.
  static constexpr Duration kSilence = std::chrono::seconds(1);

  void add_input() { newest_.emplace_back(); }

  /// An input brought this stamp.
  void note(std::size_t input, Time stamp);

  /// Whether no other input may still bring a message that comes before this noted one, as long as
  /// each brings its own in order.
  bool is_in_turn(std::size_t input, Time stamp) const;

  /// Time begins anew.
  void clear();

 private:
  std::optional<Time> oldest_;
  std::vector<std::optional<Time>> newest_;  // by input
};

}  // namespace portolan
