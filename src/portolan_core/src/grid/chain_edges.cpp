// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/grid/chain_edges.hpp"

#include <cstdlib>

#include "portolan/grid/row_vectors.hpp"

namespace portolan {

namespace {

using fine_walk::Walk;

FinePoint operator+(FinePoint a, FinePoint b) { return {a.x + b.x, a.y + b.y}; }

void find_rows(std::size_t n, const std::int32_t* __restrict y, std::int32_t shift,
               std::int32_t* __restrict row) {
  for (std::size_t i = 0; i < n; ++i) row[i] = fine_walk::first_centre(y[i] + shift);
}

// Which of the marked edges pass the centre of a row?
void find_passing(std::size_t n, const std::uint8_t* __restrict is_marked,
                  const std::int32_t* __restrict row, std::uint8_t* __restrict passes) {
  for (std::size_t i = 0; i < n; ++i) passes[i] = row[i] != row[i + 1] ? is_marked[i] : 0;
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
  toggle_long(points, shift, plane);
  start(points, shift);
  toggle_rows(plane);
}

void ChainEdges::choose(const FinePoints& points, const std::vector<std::uint8_t>& is_marked,
                        FinePoint shift) {
  const std::size_t n = is_marked.size();
  first_row_.resize(n + 1);
  passes_.resize(n);
  with_widest_rows([&](auto) {
    find_rows(n + 1, points.y.data(), shift.y, first_row_.data());
    find_passing(n, is_marked.data(), first_row_.data(), passes_.data());
  });
  edges_.resize(n);
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    edges_[count] = static_cast<std::uint32_t>(i);
    count += passes_[i];
  }
  edges_.resize(count);
}

// The few edges of many rows, which are better taken by a few rows at once.
void ChainEdges::toggle_long(const FinePoints& points, FinePoint shift, const EdgePlane& plane) {
  constexpr int kLong = 16;
  std::size_t left = 0;
  for (std::uint32_t i : edges_) {
    if (std::abs(first_row_[i + 1] - first_row_[i]) > kLong) {
      plane.toggle(points.at(i) + shift, points.at(i + 1) + shift);
    } else {
      edges_[left++] = i;
    }
  }
  edges_.resize(left);
}

void ChainEdges::start(const FinePoints& points, FinePoint shift) {
  const std::size_t n = edges_.size();
  row_.resize(n);
  end_.resize(n);
  position_.resize(n);
  step_.resize(n);
  with_widest_rows([&](auto) {
    start_walks(n, edges_.data(), points.x.data(), points.y.data(), shift, row_.data(), end_.data(),
                position_.data(), step_.data());
  });
}

void ChainEdges::toggle_rows(EdgePlane plane) {
  std::size_t count = edges_.size();
  for (std::size_t k = 0; k < count; ++k) edges_[k] = static_cast<std::uint32_t>(k);
  for (std::int32_t turn = 0; count > 0; ++turn) {
    std::size_t left = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t i = edges_[k];
      const std::int32_t row = row_[i] + turn;
      plane.toggle_from(static_cast<int>((position_[i] + turn * step_[i]) >> fine_walk::kPlaces),
                        row);
      edges_[left] = i;
      left += static_cast<std::size_t>(row + 1 < end_[i]);
    }
    count = left;
  }
}

}  // namespace portolan
