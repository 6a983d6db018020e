// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "portolan/landmark/landmark_estimate.hpp"
#include "portolan/landmark/landmark_options.hpp"
#include "portolan/landmark/landmark_store.hpp"
#include "portolan/landmark/matching.hpp"
#include "portolan/landmark/sensor_view.hpp"
#include "portolan/outcome.hpp"

namespace portolan {

/// Where landmarks are, from ranges and bearings or from bearings alone.
///
/// Sections 4-6. Given the poses landmarks are independent (Eq. 12): each is a filter of its own,
/// and a message costs in proportion to what was seen, whatever the size of the map.
class LandmarkMapper {
 public:
  using Options = LandmarkOptions;
  using Observation = std::variant<LandmarkSightings, ImageFeatures>;

  /// Throws OptionsError.
  explicit LandmarkMapper(const Options& options);

  /// Takes what the sensor at `T_map_sensor` saw; for images that is the optical frame. What is
  /// malformed is left out and counted: unusable where nothing was well-formed, rejected where
  /// nothing of it could be used.
  Outcome insert(const Observation& z, const Pose& T_map_sensor);

  /// The landmarks that were seen often enough, by identity.
  std::vector<LandmarkEstimate> estimates() const;

  /// All of them, and what may become one.
  const LandmarkStore& store() const { return store_; }

  const LandmarkCounts& counts() const { return counts_; }
  const Options& options() const { return options_; }

  /// Grows whenever the map changes.
  std::uint64_t revision() const { return revision_; }

  /// A mapper that goes on from saved landmarks; identities must differ.
  static LandmarkMapper restored(const Options& options,
                                 const std::vector<std::pair<LandmarkId, LandmarkTrack>>& tracks);

 private:
  static constexpr LandmarkId kFirstOwnId = -2;  // -1 says unknown

  struct Sighted {
    LandmarkId id;
    Measurement z;
  };
  /// The sightings of one message and what they may show.
  struct Message {
    SensorKind kind;
    UncertainSensorPose sensor;
    std::vector<Sighted> sighted;
    std::vector<Candidate> identified;  // the landmark of that identity, whether it fits or not
    std::vector<Candidate> similar;     // of sightings without identity: what fits
    std::vector<bool> doubtful;         // by sighting: near a landmark, though it does not fit
    Matches matches;                    // by sighting
  };

  LandmarkId identity(LandmarkId stated) const;
  std::vector<Sighted> well_formed(const LandmarkSightings& z);
  std::vector<Sighted> well_formed(const ImageFeatures& z);
  void identify(Message& message) const;
  void add_identified(std::size_t i, Message& message) const;
  void add_similar(std::size_t i, Message& message) const;
  void choose(Message& message) const;
  bool use(std::size_t i, const Message& message, std::vector<LandmarkId>& seen);
  bool take(const Sighted& sighted, const Candidate& candidate, const UncertainSensorPose& sensor);
  bool start(const Sighted& sighted, const UncertainSensorPose& sensor,
             std::vector<LandmarkId>& seen);
  void note_seen(const std::vector<LandmarkId>& seen, const Message& message);
  void note_beside(const std::vector<LandmarkId>& seen);
  void note_missed(const Message& message);
  void merge_double(LandmarkId id);
  bool are_one(LandmarkId a, LandmarkId b) const;
  bool is_fixed(const LandmarkStore::Entry& entry) const;
  bool is_believed(LandmarkId id, const LandmarkStore::Entry& entry) const;
  LandmarkEstimate estimate(LandmarkId id, const LandmarkTrack& track) const;

  Options options_;
  std::array<double, 4> gates_;        // squared distances, by how many numbers were measured
  std::array<double, 4> merge_gates_;  // likewise
  LandmarkStore store_;
  std::array<SensorView, 2> views_;           // by SensorKind
  std::array<std::uint64_t, 2> last_news_{};  // in which message the view was news, likewise
  LandmarkId next_id_ = kFirstOwnId;
  std::uint64_t messages_ = 0;
  std::uint64_t revision_ = 0;
  LandmarkCounts counts_;
};

/// What the observation occupies in memory [byte].
inline std::size_t byte_size(const LandmarkMapper::Observation& z) {
  return std::visit([](const auto& observation) { return byte_size(observation); }, z);
}

}  // namespace portolan
