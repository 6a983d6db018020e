// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/chain_edges.hpp"

#include <cstdlib>

#include "portolan/grid/row_vectors.hpp"

namespace portolan {

namespace {

using fine_walk::Walk;

constexpr int kLong = 16;  // rows that are better taken by a few at once

FinePoint operator+(FinePoint a, FinePoint b) { return {a.x + b.x, a.y + b.y}; }

void find_rows(std::size_t n, const std::int32_t* __restrict y, std::int32_t shift,
               std::int32_t* __restrict row) {
  for (std::size_t i = 0; i < n; ++i) row[i] = fine_walk::first_centre(y[i] + shift);
}

void start_walks(std::size_t n, const std::uint32_t* __restrict edge,
                 const std::int32_t* __restrict x, const std::int32_t* __restrict y,
                 FinePoint shift, std::int32_t* __restrict row, std::int32_t* __restrict end,
                 std::int64_t* __restrict position, std::int64_t* __restrict step) {
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = edge[k];
    const Walk walk(FinePoint{x[i], y[i]} + shift, FinePoint{x[i + 1], y[i + 1]} + shift,
                    EdgePlane::kOffset);
    row[k] = walk.row;
    end[k] = walk.end;
    position[k] = walk.position;
    step[k] = walk.step;
  }
}

}  // namespace

void ChainEdges::toggle(const FinePoints& points, const std::vector<std::uint8_t>& is_marked,
                        FinePoint shift, const EdgePlane& plane) {
  choose(points, is_marked, shift);
  for (std::uint32_t i : long_) plane.toggle(points.at(i) + shift, points.at(i + 1) + shift);
  start(points, shift);
  toggle_rows(plane);
}

void ChainEdges::choose(const FinePoints& points, const std::vector<std::uint8_t>& is_marked,
                        FinePoint shift) {
  first_row_.resize(points.y.size());
  with_widest_rows(
      [&](auto) { find_rows(points.y.size(), points.y.data(), shift.y, first_row_.data()); });
  const std::size_t n = is_marked.size();
  short_.resize(n);
  long_.resize(n);
  std::size_t short_count = 0;
  std::size_t long_count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int rows = std::abs(first_row_[i + 1] - first_row_[i]);
    short_[short_count] = static_cast<std::uint32_t>(i);
    long_[long_count] = static_cast<std::uint32_t>(i);
    const bool passes = (is_marked[i] != 0) & (rows > 0);
    short_count += static_cast<std::size_t>(passes & (rows <= kLong));
    long_count += static_cast<std::size_t>(passes & (rows > kLong));
  }
  short_.resize(short_count);
  long_.resize(long_count);
}

void ChainEdges::start(const FinePoints& points, FinePoint shift) {
  const std::size_t n = short_.size();
  row_.resize(n);
  end_.resize(n);
  position_.resize(n);
  step_.resize(n);
  with_widest_rows([&](auto) {
    start_walks(n, short_.data(), points.x.data(), points.y.data(), shift, row_.data(), end_.data(),
                position_.data(), step_.data());
  });
}

void ChainEdges::toggle_rows(EdgePlane plane) {
  std::size_t count = short_.size();
  for (std::size_t k = 0; k < count; ++k) short_[k] = static_cast<std::uint32_t>(k);
  for (std::int32_t turn = 0; count > 0; ++turn) {
    std::size_t left = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t i = short_[k];
      const std::int32_t row = row_[i] + turn;
      plane.toggle_from(static_cast<int>((position_[i] + turn * step_[i]) >> fine_walk::kPlaces),
                        row);
      short_[left] = i;
      left += static_cast<std::size_t>(row + 1 < end_[i]);
    }
    count = left;
  }
}

}  // namespace portolan
