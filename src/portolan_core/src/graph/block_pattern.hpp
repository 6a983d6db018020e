// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "graph/neighbours.hpp"

namespace portolan {

/// Where the Cholesky factor of a symmetric matrix of blocks has entries, and in which order its
/// rows are best eliminated; the size of the blocks does not matter. Analysed once for a graph.
class BlockPattern {
 public:
  /// Neighbouring columns of the factor with (nearly) the same rows, worked on as a dense matrix.
  /// Its rows are its own columns, then those below, all as places in the order of elimination.
  struct Supernode {
    int first = 0;          ///< column
    int last = 0;           ///< behind the last column
    int parent = -1;        ///< the supernode that its first row below is a column of; -1: none
    std::size_t below = 0;  ///< where in `rows()` the rows below begin
    int height = 0;         ///< of all its rows
    int columns() const { return last - first; }
    int rows_below() const { return height - columns(); }
  };

  /// Of a matrix with entries on its diagonal and where nodes are neighbours.
  explicit BlockPattern(const Neighbours& graph);

  int size() const { return static_cast<int>(place_.size()); }
  /// By node: its place in the order of elimination.
  const std::vector<int>& place() const { return place_; }
  /// Children before parents.
  const std::vector<Supernode>& supernodes() const { return supernodes_; }
  /// By place: the supernode whose column it is.
  const std::vector<int>& supernode_of() const { return supernode_of_; }
  /// Rows below the supernodes' own columns.
  const std::vector<int>& rows() const { return rows_; }
  /// For each of `rows()`, which row of the parent it is.
  const std::vector<int>& rows_in_parent() const { return rows_in_parent_; }
  /// Which row of its supernode a place is. It must be one.
  int row_in(const Supernode& supernode, int place) const;
  /// How many products of blocks it takes to factor.
  double work() const { return work_; }
  /// How many blocks the factor has.
  double entries() const { return entries_; }

 private:
  void find_rows(const Neighbours& graph);
  void find_rows_in_parents();
  void count_work();

  std::vector<int> place_;
  std::vector<Supernode> supernodes_;
  std::vector<int> supernode_of_;
  std::vector<int> rows_;
  std::vector<int> rows_in_parent_;
  double work_ = 0.0;
  double entries_ = 0.0;
};

}  // namespace portolan
