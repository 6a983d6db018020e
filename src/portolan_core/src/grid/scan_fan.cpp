// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/scan_fan.hpp"

#include <array>
#include <cstring>

#include "portolan/grid/row_vectors.hpp"

namespace portolan {

namespace {

/// Calls visit(i) for each i below `count`. Neighbours mostly change the same word of a plane, and
/// one change has to wait for the other; so beams that lie far apart take turns.
template <class Visit>
void for_each_apart(std::size_t count, Visit visit) {
  const std::size_t quarter = count / 4;
  for (std::size_t i = 0; i < quarter; ++i) {
    visit(i);
    visit(i + quarter);
    visit(i + 2 * quarter);
    visit(i + 3 * quarter);
  }
  for (std::size_t i = 4 * quarter; i < count; ++i) visit(i);
}

// Neighbours are joined where both free something.
void join(std::size_t n, const std::uint8_t* __restrict frees, std::uint8_t is_round,
          std::uint8_t* __restrict is_joined) {
  for (std::size_t i = 0; i < n; ++i) is_joined[i] = frees[i] & frees[i + 1];
  is_joined[n - 1] &= is_round;
}

// Which free something, but are not joined on both sides?
void find_ends(std::size_t n, const std::uint8_t* __restrict frees,
               const std::uint8_t* __restrict is_joined, std::uint8_t* __restrict is_end) {
  is_end[0] = frees[0] & static_cast<std::uint8_t>(~(is_joined[n - 1] & is_joined[0]));
  for (std::size_t i = 1; i < n; ++i) {
    is_end[i] = frees[i] & static_cast<std::uint8_t>(~(is_joined[i - 1] & is_joined[i]));
  }
}

// The first index from there on that is marked, or one beyond all.
std::size_t next_marked(const std::vector<std::uint8_t>& marks, std::size_t from) {
  const void* found = std::memchr(marks.data() + from, 1, marks.size() - from);
  if (found == nullptr) return marks.size();
  return static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - marks.data());
}

}  // namespace

bool ScanFan::draw(const RangeScan& scan, const Pose& T_map_sensor, const GridOptions& options,
                   Footprint& footprint) {
  beams_.place(scan, T_map_sensor, options);
  bounds_ = beams_.bounds();
  const bool has_sectors = options.laser.beam_model == BeamModel::sector;
  is_rim_.assign(beams_.size(), 0);
  is_strip_.assign(beams_.size(), 0);
  more_strips_.clear();
  overlapping_.clear();
  if (has_sectors) make_sectors();
  if (has_sectors && beams_.has_margin()) join_echoes();
  const Footprint::Anchor anchor = beams_.grid().anchor(T_map_sensor.translation());
  if (!footprint.open(anchor, bounds_.min, bounds_.max)) return false;
  draw_overlapping(footprint);
  if (has_sectors) {
    for (const Edge& edge : outline_) footprint.outline(edge.a, edge.b);
  } else {
    draw_rays(footprint);
  }
  draw_echoes(footprint);
  return true;
}

// Inside the outline sectors share their sides, so only rims and the ends of chains remain of them.
void ScanFan::make_sectors() {
  outline_.clear();
  const std::size_t n = beams_.size();
  const bool joins = beams_.may_join();
  const bool wraps = joins && beams_.is_round();
  if (joins && beams_.first_turn() >= n && !(wraps && beams_.is_swept())) return join_all();
  bool joined = wraps && beams_.frees(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    if (!beams_.frees(i)) {
      joined = false;
      continue;
    }
    if (!joined) add_half(i, -1.0);
    joined = i + 1 < n ? joins && beams_.frees(i + 1) : wraps && beams_.frees(0);
    if (joined && is_in_first_turn(i, next(i))) {
      is_rim_[i] = 1;
    } else if (joined) {
      add_overlapping(i, next(i));
    } else {
      add_half(i, 1.0);
    }
  }
}

// The same where all neighbours lie in the first turn.
void ScanFan::join_all() {
  const std::size_t n = beams_.size();
  const std::vector<std::uint8_t>& frees = beams_.frees();
  is_end_.resize(n);
  with_widest_rows([&](auto) {
    join(n, frees.data(), beams_.is_round() ? 1 : 0, is_rim_.data());
    find_ends(n, frees.data(), is_rim_.data(), is_end_.data());
  });
  for (std::size_t i = 0; (i = next_marked(is_end_, i)) < n; ++i) {
    if (is_rim_[i > 0 ? i - 1 : n - 1] == 0) add_half(i, -1.0);
    if (is_rim_[i] == 0) add_half(i, 1.0);
  }
}

void ScanFan::add_overlapping(std::size_t i, std::size_t next) {
  overlapping_.push_back({beams_.end(i), beams_.end(next)});
  if (i < beams_.first_turn()) outline_.push_back({beams_.end(i), beams_.centre()});
  if (next < beams_.first_turn()) outline_.push_back({beams_.centre(), beams_.end(next)});
}

void ScanFan::add_half(std::size_t i, double side) {
  const FinePoint end = beams_.end(i);
  const FinePoint corner = beams_.beside(i, side);
  bounds_.add(corner);
  if (i >= beams_.first_turn()) return overlapping_.push_back({end, corner});
  outline_.push_back({end, corner});
  outline_.push_back({corner, beams_.centre()});
}

void ScanFan::join_echoes() {
  const std::size_t pairs = beams_.is_round() ? beams_.size() : beams_.size() - 1;
  if (!beams_.may_join()) return;
  for (std::size_t i = 0; i < pairs; ++i) {
    if (!beams_.is_one_surface(i, next(i))) continue;
    if (is_in_first_turn(i, next(i))) {
      is_strip_[i] = 1;
    } else {
      more_strips_.push_back(i);
    }
  }
}

void ScanFan::draw_rays(Footprint& footprint) const {
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    if (beams_.frees(i)) footprint.ray(beams_.origin(i), beams_.end(i));
  }
}

void ScanFan::draw_overlapping(Footprint& footprint) const {
  for (const Edge& sector : overlapping_) {
    const std::array<FinePoint, 3> corners = {beams_.centre(), sector.a, sector.b};
    footprint.fill(corners.data(), 3);
  }
  for (std::size_t i : more_strips_) {
    const std::array<FinePoint, 4> corners = {beams_.end(i), beams_.far(i), beams_.far(next(i)),
                                              beams_.end(next(i))};
    footprint.fill_occupied(corners.data(), 4);
  }
}

void ScanFan::draw_echoes(Footprint& footprint) {
  draw_rims(footprint);
  if (beams_.has_margin()) draw_strips(footprint);
  const ScanBeams& beams = beams_;
  for_each_apart(beams.size(), [&beams, pen = footprint.cell_pen()](std::size_t i) {
    if (beams.hits(i)) pen.set(beams.echo(i));
  });
}

// The rims of the sectors, which are those of the strips between echoes, too.
void ScanFan::draw_rims(Footprint& footprint) {
  const Footprint::Pen free = footprint.outline_pen();
  rims_.toggle(beams_.ends(), is_rim_, free.shift, free.plane);
  if (!beams_.has_margin()) return;
  const Footprint::Pen occupied = footprint.occupied_outline_pen();
  rims_.toggle(beams_.ends(), is_strip_, occupied.shift, occupied.plane);
}

void ScanFan::draw_strips(Footprint& footprint) const {
  bool joined = is_strip_.back() != 0;
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const bool joins = is_strip_[i] != 0;
    if (joins != joined) footprint.outline_occupied(beams_.end(i), beams_.far(i));
    if (joins) footprint.outline_occupied(beams_.far(i), beams_.far(next(i)));
    joined = joins;
  }
}

}  // namespace portolan
