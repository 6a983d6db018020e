// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/loop/reckoning.hpp"

#include <queue>
#include <utility>

namespace portolan {

namespace {

// How much uncertainty a way adds; a turn counts by what it moves at ten metres.
double length_of(const Link& link) {
  constexpr double kLever = 10.0;
  const TangentMatrix& covariance = link.T_from_to.covariance;
  return covariance.diagonal().head<3>().sum() +
         kLever * kLever * covariance.diagonal().tail<3>().sum();
}

struct Step {
  double length = 0.0;  // from the root
  std::size_t to = 0;
  std::size_t from = 0;
  std::size_t link = 0;

  // The shortest first; of equal ones the lowest number, so that the tree is always the same.
  bool operator<(const Step& other) const {
    return std::make_pair(length, to) > std::make_pair(other.length, other.to);
  }
};

std::vector<std::vector<std::size_t>> links_at(const std::vector<Link>& links, std::size_t count) {
  std::vector<std::vector<std::size_t>> at(count);
  for (std::size_t i = 0; i < links.size(); ++i) {
    at[links[i].from].push_back(i);
    at[links[i].to].push_back(i);
  }
  return at;
}

}  // namespace

std::vector<std::optional<UncertainPose>> reckon(const std::vector<Link>& links, std::size_t count,
                                                 std::size_t root) {
  const auto at = links_at(links, count);
  std::vector<std::optional<UncertainPose>> T_root(count);
  std::priority_queue<Step> open;
  const auto reach = [&](std::size_t node, double length) {
    for (const std::size_t i : at[node]) {
      const std::size_t next = links[i].from == node ? links[i].to : links[i].from;
      if (!T_root[next]) open.push({length + length_of(links[i]), next, node, i});
    }
  };
  T_root[root] = UncertainPose{};
  reach(root, 0.0);
  while (!open.empty()) {
    const Step step = open.top();
    open.pop();
    if (T_root[step.to]) continue;
    const Link& link = links[step.link];
    T_root[step.to] =
        *T_root[step.from] * (link.from == step.from ? link.T_from_to : inverse(link.T_from_to));
    reach(step.to, step.length);
  }
  return T_root;
}

}  // namespace portolan
