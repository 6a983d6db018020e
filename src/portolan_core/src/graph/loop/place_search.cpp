// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/loop/place_search.hpp"

#include <algorithm>
#include <cmath>

#include "portolan/graph/loop/loop_search.hpp"

namespace portolan {

namespace {

constexpr std::size_t kBest = 6;  // places that are looked at closely at the end of a round
constexpr double kShare = 0.8;    // of the best place's score: with less none is looked at closely

CorrelativeOptions coarse(const PoseGraphOptions& options) {
  CorrelativeOptions search = options.loops.search;
  search.resolution = search.blur = options.loops.places.resolution;
  search.max_points = options.loops.places.max_points;
  return search;
}

SurfaceOptions coarse_surfaces(const PoseGraphOptions& options) {
  SurfaceOptions surfaces = options.surfaces;
  surfaces.spacing = std::max(surfaces.spacing, 0.5 * options.loops.places.resolution);
  return surfaces;
}

// The turn that moves what is seen so far on average [rad].
double turn_of(double shift, const LocalMap& map) {
  double ranges = 0.0;
  for (const Eigen::Vector3d& p : map.surface.points) ranges += p.norm();
  return shift * static_cast<double>(map.surface.size()) / std::max(1.0, ranges);
}

bool contradicts(const LoopFinding& finding, const LoopOptions& options) {
  return !finding.match.converged || finding.agreement.agreed < options.places.min_agreed;
}

}  // namespace

void PlaceSearch::restart(std::size_t begin) {
  begin_ = begin;
  places_.clear();
  hits_.clear();
}

std::optional<Arc> PlaceSearch::go_on(const PlacedKeyframes& placed,
                                      const PoseGraphOptions& options) {
  if (places_.empty() && hits_.empty()) {
    here_ = placed.keyframes.size() - 1;
    places_ = placed.places(begin_, options.loops.places.spacing);
  }
  const LocalMap here =
      placed.map_around(here_, 2.0 * options.loops.map_way, 0.0, options.surfaces);
  if (places_.empty()) {
    add_rivals(placed, here, options);
    refine(placed, here, options);
    const auto loop = verdict(placed, here, options);
    hits_.clear();
    ++rounds_;
    return loop;
  }
  for (int k = 0; k < options.loops.places.places && !places_.empty(); ++k) {
    compare(placed, here, options);
    places_.pop_back();
  }
  return std::nullopt;
}

void PlaceSearch::compare(const PlacedKeyframes& placed, const LocalMap& here,
                          const PoseGraphOptions& options) {
  const std::size_t place = places_.back();
  const LocalMap target =
      placed.map_near(place, begin_, options.loops.map_way, coarse_surfaces(options));
  const double reach = options.loops.places.reach;
  const CorrelativeMatcher matcher(target.surface, reach, coarse(options));
  const auto found =
      matcher.best(here.surface, Pose::Identity(), {reach, M_PI}, kShare * best_score());
  if (found) hits_.push_back({place, found->T_target_source, found->score});
}

double PlaceSearch::best_score() const {
  double best = 0.0;
  for (const Hit& hit : hits_) best = std::max(best, hit.score);
  return best;
}

// The best of the hits that put the robot in different places.
std::vector<PlaceSearch::Hit> PlaceSearch::distinct(const PlacedKeyframes& placed,
                                                    std::size_t count,
                                                    const CorrelativeOptions& options) const {
  const auto is_same = [&](const Hit& a, const Hit& b) {
    const Pose apart = (placed.T_map_base(a.place) * a.T_place_here).inverse() *
                       placed.T_map_base(b.place) * b.T_place_here;
    return apart.translation().norm() <= options.rival_distance &&
           rotation_angle(apart) <= options.rival_turn;
  };
  std::vector<Hit> sorted = hits_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Hit& a, const Hit& b) { return a.score > b.score; });
  std::vector<Hit> best;
  for (const Hit& hit : sorted) {
    const bool is_new = std::none_of(best.begin(), best.end(),
                                     [&](const Hit& other) { return is_same(hit, other); });
    if (is_new && best.size() < count && hit.score >= kShare * sorted.front().score) {
      best.push_back(hit);
    }
  }
  return best;
}

// The same surfaces may fit in several ways, as in a square room.
void PlaceSearch::add_rivals(const PlacedKeyframes& placed, const LocalMap& here,
                             const PoseGraphOptions& options) {
  const double reach = options.loops.places.reach;
  hits_ = distinct(placed, kBest, options.loops.search);
  for (std::size_t i = 0; i < std::min(hits_.size(), kBest); ++i) {
    const LocalMap target =
        placed.map_near(hits_[i].place, begin_, options.loops.map_way, options.surfaces);
    const CorrelativeMatcher matcher(target.surface, reach, coarse(options));
    const auto found = matcher.search(here.surface, hits_[i].T_place_here, {reach, M_PI});
    if (found && found->rival > 0.0)
      hits_.push_back({hits_[i].place, found->T_rival, found->rival});
  }
}

// Seen from the keyframe that is nearest to where the robot may be.
void PlaceSearch::refine(const PlacedKeyframes& placed, const LocalMap& here,
                         const PoseGraphOptions& options) {
  hits_ = distinct(placed, 2 * kBest, options.loops.search);
  const double shift = 2.0 * options.loops.places.resolution;
  for (Hit& hit : hits_) {
    const Pose T_map_here = placed.T_map_base(hit.place) * hit.T_place_here;
    hit.place = placed.nearest(T_map_here, begin_);
    hit.T_place_here = placed.T_map_base(hit.place).inverse() * T_map_here;
    const LocalMap target =
        placed.map_near(hit.place, begin_, options.loops.map_way, options.surfaces);
    const CorrelativeMatcher matcher(target.surface, shift, options.loops.search);
    const auto found =
        matcher.best(here.surface, hit.T_place_here, {shift, turn_of(shift, here)}, 0.0);
    hit.score = found ? found->score : 0.0;
    if (found) hit.T_place_here = found->T_target_source;
  }
  hits_ = distinct(placed, 2 * kBest, options.loops.search);
}

std::optional<Arc> PlaceSearch::verdict(const PlacedKeyframes& placed, const LocalMap& here,
                                        const PoseGraphOptions& options) const {
  const TangentMatrix anywhere = 1e6 * TangentMatrix::Identity();
  std::optional<Arc> best;
  double score = 0.0;
  for (const Hit& hit : hits_) {
    if (hit.score < options.loops.max_rivalry * score) break;
    const LocalMap target =
        placed.map_near(hit.place, begin_, options.loops.map_way, options.surfaces);
    const LoopFinding finding = examine(target, here, hit.T_place_here,
                                        {hit.T_place_here, anywhere}, options.loops, options.icp);
    if (contradicts(finding, options.loops)) continue;
    if (best || finding.reason != ArcReason::none) return std::nullopt;
    best = Arc{};
    best->from = static_cast<PoseId>(hit.place);
    best->to = static_cast<PoseId>(here_);
    best->T_from_to = finding.match.T_target_source;
    best->information = finding.match.information;
    best->kind = ArcKind::loop;
    best->state = ArcState::rejected;
    best->reason = ArcReason::unconfirmed;
    score = hit.score;
  }
  return best;
}

}  // namespace portolan
