// SPDX-License-Identifier: BSD-3-Clause
#include "graph/elimination_order.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <utility>

namespace portolan {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// By node: when an approximate minimum degree ordering eliminates it.
std::vector<int> minimum_degree(const Neighbours& graph) {
  Eigen::SparseMatrix<float> matrix(graph.size(), graph.size());
  for (int node = 0; node < graph.size(); ++node) {
    matrix.startVec(node);
    matrix.insertBackByOuterInner(node, node) = 1.0F;
    for (const int row : graph.of(node)) {
      if (row > node) matrix.insertBackByOuterInner(node, row) = 1.0F;
    }
  }
  matrix.finalize();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(matrix.selfadjointView<Eigen::Lower>(), order);
  std::vector<int> place(at(graph.size()));
  for (int i = 0; i < graph.size(); ++i) place[at(order.indices()[i])] = i;
  return place;
}

// Takes out nodes with two neighbours or fewer, whose elimination leaves no more than an edge
// between these. What the robot drove once are chains of them.
class Chains {
 public:
  explicit Chains(const Neighbours& graph) : place_(at(graph.size()), -1) {
    begin_.reserve(at(graph.size()));
    end_.reserve(at(graph.size()));
    for (int node = 0; node < graph.size(); ++node) {
      begin_.push_back(neighbours_.size());
      for (const int next : graph.of(node)) neighbours_.push_back(next);
      end_.push_back(neighbours_.size());
    }
    for (int node = 0; node < graph.size(); ++node) take_out_from(node);
  }

  // By node: when it was taken out; -1: it is left.
  std::vector<int> take_places() { return std::move(place_); }
  int taken() const { return taken_; }

  // The graph of those that are left, where they are called `name[node]`.
  Neighbours rest(int size, const std::vector<int>& name) const {
    std::vector<std::pair<int, int>> edges;
    for (int node = 0; node < static_cast<int>(name.size()); ++node) {
      if (name[at(node)] < 0) continue;
      for (std::size_t i = begin_[at(node)]; i < end_[at(node)]; ++i) {
        if (node < neighbours_[i]) edges.emplace_back(name[at(node)], name[at(neighbours_[i])]);
      }
    }
    return Neighbours(size, edges);
  }

 private:
  std::size_t degree(int node) const { return end_[at(node)] - begin_[at(node)]; }

  // And on, to where that leaves others with few neighbours.
  void take_out_from(int first) {
    waiting_.push_back(first);
    while (!waiting_.empty()) {
      const int node = waiting_.back();
      waiting_.pop_back();
      if (place_[at(node)] >= 0 || degree(node) > 2) continue;
      place_[at(node)] = taken_++;
      const std::size_t begin = begin_[at(node)];
      const int a = degree(node) > 0 ? neighbours_[begin] : -1;
      const int b = degree(node) > 1 ? neighbours_[begin + 1] : -1;
      for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        if (one < 0) continue;
        connect(one, node, other);
        if (degree(one) <= 2) waiting_.push_back(one);
      }
    }
  }

  // Puts another neighbour in the place of one, or none if that is there already.
  void connect(int node, int gone, int other) {
    int* begin = neighbours_.data() + begin_[at(node)];
    int* end = neighbours_.data() + end_[at(node)];
    int* place = std::find(begin, end, gone);
    if (other >= 0 && std::find(begin, end, other) == end) {
      *place = other;
    } else {
      *place = *(end - 1);
      --end_[at(node)];
    }
  }

  std::vector<int> neighbours_;
  std::vector<std::size_t> begin_;  // by node, into neighbours_
  std::vector<std::size_t> end_;
  std::vector<int> place_;
  std::vector<int> waiting_;
  int taken_ = 0;
};

}  // namespace

std::vector<int> elimination_order(const Neighbours& graph) {
  Chains chains(graph);
  std::vector<int> place = chains.take_places();
  std::vector<int> name(place.size(), -1);
  int left = 0;
  for (std::size_t node = 0; node < place.size(); ++node) {
    if (place[node] < 0) name[node] = left++;
  }
  const std::vector<int> order = minimum_degree(chains.rest(left, name));
  for (std::size_t node = 0; node < place.size(); ++node) {
    if (place[node] < 0) place[node] = chains.taken() + order[at(name[node])];
  }
  return place;
}

}  // namespace portolan
