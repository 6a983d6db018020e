// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace portolan::bench {

/// Compares two ways on a machine that others use too: they alternate, each pair gives one ratio,
/// and the median of the pairs counts.
class Pairs {
 public:
  /// Runs both once; the time of ours [s].
  template <class Peer, class Ours>
  double run(Peer peer, Ours ours) {
    const double peer_time = time(peer);
    const double our_time = time(ours);
    peer_.push_back(peer_time);
    ours_.push_back(our_time);
    ratios_.push_back(peer_time / our_time);
    return our_time;
  }

  double peer() const { return median(peer_); }     ///< [s]
  double ours() const { return median(ours_); }     ///< [s]
  double ratio() const { return median(ratios_); }  ///< times that ours is faster

 private:
  template <class Work>
  static double time(Work work) {
    const double start = thread_seconds();
    work();
    return thread_seconds() - start;
  }

  // The processor's time for this thread: what others run meanwhile does not count.
  static double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  static double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  std::vector<double> peer_;
  std::vector<double> ours_;
  std::vector<double> ratios_;
};

}  // namespace portolan::bench
