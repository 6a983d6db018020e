// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace portolan {

/// Room for doubles that begins where a cache line does, as wide vectors like it. What is in it at
/// first is anything.
class AlignedRoom {
 public:
  AlignedRoom() = default;
  explicit AlignedRoom(std::size_t size)
      : begin_(static_cast<double*>(::operator new(size * sizeof(double), kLine))) {}

  double* get() const { return begin_.get(); }

 private:
  static constexpr std::align_val_t kLine{64};
  struct Free {
    void operator()(double* begin) const { ::operator delete(begin, kLine); }
  };

  std::unique_ptr<double, Free> begin_;
};

}  // namespace portolan
