// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/match/correlative.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace portolan {

namespace {

using Cell = ScorePyramid::Cell;

constexpr int kMaxLevels = 7;
constexpr double kRivalry = 0.9;  // of the best score: less is no rival

// Moves of the source by 2^level cells a side from `corner` on, at one of the turns.
struct Block {
  int turn = 0;
  int level = 0;
  Cell corner = Cell::Zero();  // [cells]
  int score = 0;               // no move in it has more
};

struct Turned {
  double angle = 0.0;        // [rad]
  std::vector<Cell> points;  // where the source's points lie without a move
};

int levels_for(double reach, double resolution) {
  const double cells = std::max(1.0, 2.0 * reach / resolution);
  return std::min(kMaxLevels, 1 + static_cast<int>(std::ceil(std::log2(cells))));
}

std::vector<Eigen::Vector3d> some_of(const std::vector<Eigen::Vector3d>& points, int most) {
  const std::size_t stride = 1 + (points.size() - 1) / static_cast<std::size_t>(most);
  std::vector<Eigen::Vector3d> some;
  for (std::size_t i = 0; i < points.size(); i += stride) some.push_back(points[i]);
  return some;
}

// One search: the blocks, what they score, and the best move so far.
class Search {
 public:
  Search(const ScorePyramid& pyramid, const std::vector<Eigen::Vector3d>& points,
         const Pose& T_target_source, const SearchWindow& window)
      : pyramid_(pyramid), T_(T_target_source) {
    turn_all(points, window.turn);
    reach_ = static_cast<int>(std::ceil(window.reach / pyramid.resolution()));
  }

  // The best block of one move that scores more than `floor` and pleases.
  template <class Predicate>
  std::optional<Block> best(int floor, const Predicate& pleases) const {
    std::optional<Block> found;
    for (const Block& root : roots(floor)) descend(root, pleases, floor, found);
    return found;
  }

  Pose pose_of(const Block& block) const {
    Pose T = T_;
    T.linear() = turn_by(turned(block).angle) * T_.linear();
    T.translation().head<2>() += pyramid_.resolution() * block.corner.cast<double>();
    return T;
  }
  bool differ(const Block& a, const Block& b, double distance, double turn) const {
    const double moved = pyramid_.resolution() * (a.corner - b.corner).cast<double>().norm();
    return moved > distance || std::abs(turned(a).angle - turned(b).angle) > turn;
  }

 private:
  static Eigen::Matrix3d turn_by(double angle) {
    return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  const Turned& turned(const Block& block) const {
    return turned_[static_cast<std::size_t>(block.turn)];
  }

  // So finely that the outer points move by a cell.
  void turn_all(const std::vector<Eigen::Vector3d>& points, double most) {
    double squared = 1e-6;
    for (const Eigen::Vector3d& p : points) squared = std::max(squared, p.head<2>().squaredNorm());
    const double step = pyramid_.resolution() / std::sqrt(squared);
    const int turns = static_cast<int>(std::ceil(most / step));
    for (int k = -turns; k <= turns; ++k) {
      Turned turned;
      turned.angle = k * (turns > 0 ? most / turns : 0.0);
      const Eigen::Matrix3d R = turn_by(turned.angle) * T_.linear();
      for (const Eigen::Vector3d& p : points) {
        turned.points.push_back(pyramid_.cell_of((R * p + T_.translation()).head<2>()));
      }
      turned_.push_back(std::move(turned));
    }
  }

  int score(const Block& block) const {
    int sum = 0;
    for (const Cell& cell : turned(block).points) {
      sum += pyramid_.score(block.level, cell + block.corner);
    }
    return sum;
  }

  std::vector<Block> roots(int floor) const {
    const int level = pyramid_.levels() - 1;
    const int side = 1 << level;
    std::vector<Block> all;
    for (int turn = 0; turn < static_cast<int>(turned_.size()); ++turn) {
      for (int y = -reach_; y <= reach_; y += side) {
        for (int x = -reach_; x <= reach_; x += side) keep({turn, level, {x, y}, 0}, floor, all);
      }
    }
    sort(all);
    return all;
  }

  // Ties in the order of turns and rows, so that the answer is always the same one.
  static void sort(std::vector<Block>& blocks) {
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const Block& a, const Block& b) { return a.score > b.score; });
  }

  void keep(Block block, int floor, std::vector<Block>& blocks) const {
    if (block.corner.x() > reach_ || block.corner.y() > reach_) return;
    block.score = score(block);
    if (block.score > floor) blocks.push_back(block);
  }

  template <class Predicate>
  void descend(const Block& block, const Predicate& pleases, int& floor,
               std::optional<Block>& found) const {
    if (block.score <= floor) return;
    if (block.level == 0) {
      if (!pleases(block)) return;
      found = block;
      floor = block.score;
      return;
    }
    const int half = 1 << (block.level - 1);
    std::vector<Block> parts;
    for (const Cell& part : {Cell(0, 0), Cell(half, 0), Cell(0, half), Cell(half, half)}) {
      keep({block.turn, block.level - 1, block.corner + part, 0}, floor, parts);
    }
    sort(parts);
    for (const Block& part : parts) descend(part, pleases, floor, found);
  }

  const ScorePyramid& pyramid_;
  Pose T_;
  int reach_ = 0;  // [cells]
  std::vector<Turned> turned_;
};

}  // namespace

CorrelativeMatcher::CorrelativeMatcher(const Surface& target, double reach,
                                       const CorrelativeOptions& options)
    : options_(checked(options)),
      pyramid_(target.points, options.resolution, options.blur,
               levels_for(reach, options.resolution)) {}

std::optional<Correlation> CorrelativeMatcher::search(const Surface& source,
                                                      const Pose& T_target_source,
                                                      const SearchWindow& window) const {
  if (source.empty()) return std::nullopt;
  const std::vector<Eigen::Vector3d> points = some_of(source.points, options_.max_points);
  const double full = 255.0 * static_cast<double>(points.size());
  const Search search(pyramid_, points, T_target_source, window);
  const auto best = search.best(static_cast<int>(options_.min_score * full),
                                [](const Block& /*any*/) { return true; });
  if (!best) return std::nullopt;
  const auto rival = search.best(static_cast<int>(kRivalry * best->score), [&](const Block& other) {
    return search.differ(*best, other, options_.rival_distance, options_.rival_turn);
  });
  Correlation found{search.pose_of(*best), best->score / full};
  if (rival) {
    found.rival = rival->score / full;
    found.T_rival = search.pose_of(*rival);
  }
  return found;
}

std::optional<Correlation> CorrelativeMatcher::best(const Surface& source,
                                                    const Pose& T_target_source,
                                                    const SearchWindow& window,
                                                    double floor) const {
  if (source.empty()) return std::nullopt;
  const std::vector<Eigen::Vector3d> points = some_of(source.points, options_.max_points);
  const double full = 255.0 * static_cast<double>(points.size());
  const Search search(pyramid_, points, T_target_source, window);
  const auto found = search.best(static_cast<int>(std::max(floor, options_.min_score) * full),
                                 [](const Block& /*any*/) { return true; });
  if (!found) return std::nullopt;
  return Correlation{search.pose_of(*found), found->score / full};
}

}  // namespace portolan
