// SPDX-License-Identifier: BSD-3-Clause
#include "graph/block_pattern.hpp"

#include <algorithm>
#include <numeric>

#include "graph/elimination_order.hpp"

namespace portolan {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// By column: its first row below the diagonal of the factor, -1 for none. Liu's algorithm, with
// shortcuts to the roots found so far.
std::vector<int> elimination_tree(const Neighbours& graph) {
  std::vector<int> parent(at(graph.size()), -1);
  std::vector<int> root(at(graph.size()), -1);
  for (int row = 0; row < graph.size(); ++row) {
    for (int column : graph.of(row)) {
      while (column < row && column >= 0) {
        const int above = root[at(column)];
        root[at(column)] = row;
        if (above < 0) parent[at(column)] = row;
        column = above;
      }
    }
  }
  return parent;
}

// By node of a forest: its number when children come before parents and subtrees stay together.
std::vector<int> postorder(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  std::vector<int> size(parent.size(), 1);
  for (int i = 0; i < n; ++i) {
    if (parent[at(i)] >= 0) size[at(parent[at(i)])] += size[at(i)];
  }
  // A subtree's numbers end at its root's; younger children come first.
  std::vector<int> number(parent.size());
  std::vector<int> next(parent.size());  // the first number free in the subtree
  int free = 0;
  for (int i = n - 1; i >= 0; --i) {
    int& begin = parent[at(i)] < 0 ? free : next[at(parent[at(i)])];
    next[at(i)] = begin;
    begin += size[at(i)];
    number[at(i)] = begin - 1;
  }
  return number;
}

std::vector<int> renumbered(const std::vector<int>& parent, const std::vector<int>& number) {
  std::vector<int> renamed(parent.size());
  for (std::size_t i = 0; i < parent.size(); ++i) {
    renamed[at(number[i])] = parent[i] < 0 ? -1 : number[at(parent[i])];
  }
  return renamed;
}

// By column of the factor: how many entries, with the diagonal. Each row is a subtree of the
// elimination tree, spanned by the entries of the matrix.
std::vector<int> column_heights(const Neighbours& graph, const std::vector<int>& parent) {
  std::vector<int> height(parent.size(), 1);
  std::vector<int> seen(parent.size(), -1);
  for (int row = 0; row < graph.size(); ++row) {
    seen[at(row)] = row;
    for (int column : graph.of(row)) {
      for (; column < row && seen[at(column)] != row; column = parent[at(column)]) {
        seen[at(column)] = row;
        ++height[at(column)];
      }
    }
  }
  return height;
}

double trapezoid(int height, int columns) { return columns * (height - 0.5 * (columns - 1)); }

// Supernodes are worth joining as long as not too many zeros are then worked on.
bool worth_joining(int columns, double zeros, double entries) {
  if (columns <= 4) return zeros < 0.6 * entries;
  if (columns <= 12) return zeros < 0.3 * entries;
  return zeros < 0.08 * entries;
}

// Joins each column to those before it where their rows are nearly the same.
class Amalgamation {
 public:
  Amalgamation(const std::vector<int>& parent, const std::vector<int>& height) : parent_(parent) {
    for (int column = 0; column < static_cast<int>(parent.size()); ++column) {
      Candidate candidate;
      candidate.supernode.first = column;
      candidate.supernode.last = column + 1;
      candidate.supernode.height = height[at(column)];
      while (joins(candidate)) {
      }
      candidates_.push_back(candidate);
    }
  }

  std::vector<BlockPattern::Supernode> supernodes() const {
    std::vector<BlockPattern::Supernode> all;
    all.reserve(candidates_.size());
    for (const Candidate& candidate : candidates_) all.push_back(candidate.supernode);
    return all;
  }

 private:
  struct Candidate {
    BlockPattern::Supernode supernode;
    double zeros = 0.0;
    double entries() const { return trapezoid(supernode.height, supernode.columns()); }
  };

  // Takes the last candidate in, if it is a child and that is worth it.
  bool joins(Candidate& upper) {
    if (candidates_.empty()) return false;
    const Candidate& lower = candidates_.back();
    const int parent = parent_[at(lower.supernode.last - 1)];
    if (parent < upper.supernode.first || parent >= upper.supernode.last) return false;
    Candidate joint = upper;
    joint.supernode.first = lower.supernode.first;
    joint.supernode.height += lower.supernode.columns();
    joint.zeros =
        joint.entries() - (upper.entries() - upper.zeros) - (lower.entries() - lower.zeros);
    if (!worth_joining(joint.supernode.columns(), joint.zeros, joint.entries())) return false;
    upper = joint;
    candidates_.pop_back();
    return true;
  }

  const std::vector<int>& parent_;
  std::vector<Candidate> candidates_;
};

}  // namespace

BlockPattern::BlockPattern(const Neighbours& graph) : place_(elimination_order(graph)) {
  const std::vector<int> tree = elimination_tree(graph.renamed(place_));
  const std::vector<int> number = postorder(tree);
  for (int& place : place_) place = number[at(place)];
  const std::vector<int> parent = renumbered(tree, number);
  const Neighbours ordered = graph.renamed(place_);
  supernodes_ = Amalgamation(parent, column_heights(ordered, parent)).supernodes();
  find_rows(ordered);
  find_shares();
  count_work();
}

// The rows below a supernode are those of its children and of the matrix.
void BlockPattern::find_rows(const Neighbours& graph) {
  supernode_of_.resize(at(size()));
  std::vector<int> seen(at(size()), -1);
  std::vector<std::vector<int>> children(supernodes_.size());
  for (int s = 0; s < static_cast<int>(supernodes_.size()); ++s) {
    Supernode& supernode = supernodes_[at(s)];
    supernode.below = rows_.size();
    const auto take = [&](int row) {
      if (row < supernode.last || seen[at(row)] == s) return;
      seen[at(row)] = s;
      rows_.push_back(row);
    };
    for (int column = supernode.first; column < supernode.last; ++column) {
      supernode_of_[at(column)] = s;
      for (const int row : graph.of(column)) take(row);
    }
    for (const int child : children[at(s)]) {
      const Supernode& lower = supernodes_[at(child)];
      const std::size_t end = lower.below + at(lower.rows_below());
      for (std::size_t i = lower.below; i < end; ++i) take(rows_[i]);
    }
    std::sort(rows_.begin() + static_cast<std::ptrdiff_t>(supernode.below), rows_.end());
    supernode.height = supernode.columns() + static_cast<int>(rows_.size() - supernode.below);
    if (supernode.rows_below() == 0) continue;
    // Supernodes above are not numbered by column yet: look for the one that holds the row.
    const auto parent =
        std::upper_bound(supernodes_.begin() + s, supernodes_.end(), rows_[supernode.below],
                         [](int row, const Supernode& candidate) { return row < candidate.last; });
    supernode.parent = static_cast<int>(parent - supernodes_.begin());
    children[at(supernode.parent)].push_back(s);
  }
}

void BlockPattern::find_shares() {
  shares_begin_.push_back(0);
  for (const Supernode& supernode : supernodes_) {
    const int* below = rows_.data() + supernode.below;
    for (int begin = 0, end = 0; begin < supernode.rows_below(); begin = end) {
      const int s = supernode_of_[at(below[begin])];
      const Supernode& upper = supernodes_[at(s)];
      shares_.push_back({s, begin, 0, rows_above_.size()});
      for (; end < supernode.rows_below() && below[end] < upper.last; ++end) {
        rows_above_.push_back(below[end] - upper.first);
      }
      shares_.back().end = end;
      const int* first = rows_.data() + upper.below;
      const int* row = first;
      for (int i = end; i < supernode.rows_below(); ++i) {
        while (*row != below[i]) ++row;
        rows_above_.push_back(upper.columns() + static_cast<int>(row - first));
      }
    }
    shares_begin_.push_back(shares_.size());
  }
}

int BlockPattern::row_in(const Supernode& supernode, int place) const {
  if (place < supernode.last) return place - supernode.first;
  const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(supernode.below);
  const auto end = begin + supernode.rows_below();
  return supernode.columns() + static_cast<int>(std::lower_bound(begin, end, place) - begin);
}

void BlockPattern::count_work() {
  for (const Supernode& supernode : supernodes_) {
    entries_ += trapezoid(supernode.height, supernode.columns());
    for (int column = 0; column < supernode.columns(); ++column) {
      const double height = supernode.height - column;
      work_ += 0.5 * height * height;
    }
  }
}

}  // namespace portolan
