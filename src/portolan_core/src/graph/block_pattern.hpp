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

  /// What of a supernode's rows below are columns of one above it: from row `begin` to before
  /// `end`, counted from the first one below.
  struct Share {
    int supernode;
    int begin;
    int end;
    std::size_t rows;  ///< where in `rows_above()` those from `begin` to the last one are
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
  /// By supernode, and one more, where in `shares()` its own begin.
  const std::vector<std::size_t>& shares_begin() const { return shares_begin_; }
  const std::vector<Share>& shares() const { return shares_; }
  /// The rows below of shares, as rows of the supernodes that they go to.
  const std::vector<int>& rows_above() const { return rows_above_; }
  /// Which row of its supernode a place is. It must be one.
  int row_in(const Supernode& supernode, int place) const;
  /// How many products of blocks it takes to factor.
  double work() const { return work_; }
  /// How many blocks the factor has.
  double entries() const { return entries_; }

 private:
  void find_rows(const Neighbours& graph);
  void find_shares();
  void count_work();

  std::vector<int> place_;
  std::vector<Supernode> supernodes_;
  std::vector<int> supernode_of_;
  std::vector<int> rows_;
  std::vector<std::size_t> shares_begin_;
  std::vector<Share> shares_;
  std::vector<int> rows_above_;
  double work_ = 0.0;
  double entries_ = 0.0;
};

}  // namespace portolan
