// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace portolan {

/// Why a message did not enter the map.
enum class Drop {
  malformed,       ///< its sizes, angles or limits make no sense
  no_stamp,        ///< stamp 0 would mean "wherever the robot is now"
  repeated_stamp,  ///< the same sensor has already sent this moment
  no_transform,    ///< tf did not say in time where the sensor was
  queue_full,      ///< too many waited for tf
  time_ran_back,   ///< it waited for tf when the clock ran back
  thinned,         ///< the sensor had not moved enough; by option, no fault
  rejected,        ///< the mapper: not from this pose
  unusable,        ///< the mapper: not from any pose
};

constexpr std::array<const char*, 9> enum_names(Drop) {
  return {"malformed",     "no_stamp", "repeated_stamp", "no_transform", "queue_full",
          "time_ran_back", "thinned",  "rejected",       "unusable"};
}

/// What became of the messages of one input: every one is used, waiting, or dropped for a reason.
class Tally {
 public:
  /// `noun` is what one calls the messages: "scans".
  explicit Tally(std::string noun) : noun_(std::move(noun)) {}

  void receive() { ++received_; }
  void use() { ++used_; }
  void drop(Drop reason, std::string detail = {});

  std::uint64_t received() const { return received_; }
  std::uint64_t used() const { return used_; }
  std::uint64_t dropped(Drop reason) const { return dropped_[static_cast<std::size_t>(reason)]; }
  /// All that is lost; what was thinned is not.
  std::uint64_t lost() const;
  std::uint64_t waiting() const;

  /// One sentence that a person understands: "0 of 312 scans used: no transform odom <- laser at
  /// their stamps; newest is 0.8 s older".
  std::string sentence() const;

  const std::string& noun() const { return noun_; }

 private:
  std::string noun_;
  std::uint64_t received_ = 0;
  std::uint64_t used_ = 0;
  std::array<std::uint64_t, enum_names(Drop{}).size()> dropped_{};
  std::array<std::string, enum_names(Drop{}).size()> details_;  // the last of each reason
};

}  // namespace portolan
