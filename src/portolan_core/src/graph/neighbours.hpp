// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace portolan {

/// The neighbours of each node of an undirected graph, each once and always in the same order.
class Neighbours {
 public:
  struct Range {
    const int* first;
    const int* last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };

  /// Edges may be there several times and either way, but from no node to itself.
  Neighbours(int size, const std::vector<std::pair<int, int>>& edges);

  int size() const { return static_cast<int>(begin_.size()) - 1; }
  Range of(int node) const {
    const std::size_t i = static_cast<std::size_t>(node);
    return {all_.data() + begin_[i], all_.data() + begin_[i + 1]};
  }
  /// The same graph where node i is called `name[i]`, a permutation.
  Neighbours renamed(const std::vector<int>& name) const;

 private:
  Neighbours() = default;

  std::vector<int> begin_;  // by node, into all_; one more at the end
  std::vector<int> all_;
};

}  // namespace portolan
