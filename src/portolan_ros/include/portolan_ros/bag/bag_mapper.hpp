// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/message_instance.h>
#include <yaml-cpp/yaml.h>

#include <chrono>
#include <set>
#include <string>

#include "portolan/map_file.hpp"
#include "portolan_ros/bag/bag_topics.hpp"
#include "portolan_ros/bag/tally_summary.hpp"
#include "portolan_ros/bag/trajectory.hpp"
#include "portolan_ros/pipeline.hpp"

namespace portolan {

/// One kind of map over a bag: what its node would do, without a ROS graph.
template <class Kind>
class BagMapper {
 public:
  /// Throws OptionsError.
  explicit BagMapper(const MapperNodeOptions<Kind>& options);

  /// The topics that it wants, tf among them; then those of its inputs alone.
  std::set<std::string> topics() const { return topics_.names(); }
  const std::set<std::string>& input_topics() const { return input_topics_; }

  /// Takes one message of the bag; one that does not concern it is left out.
  void take(const rosbag::MessageInstance& message) { topics_.take(message); }

  /// No more messages come: what still waits for tf is used or dropped, and the map drawn.
  void finish();
  void correct(const Correction& correction) { pipeline_.remapper().correct(correction); }

  /// The map's files and pictures, and the trajectory; counts, wall time and options.
  FileSet files() const;
  YAML::Node summary() const;

  /// What became of the messages of each input.
  const std::vector<Tally>& tallies() const { return pipeline_.posed().tallies(); }

 private:
  template <class Message, class SensorReading>
  void add_input(const std::string& name, const std::string& noun,
                 std::optional<Sensed<SensorReading>> (*convert)(const Message&));

  MapperNodeOptions<Kind> options_;
  Pipeline<Kind> pipeline_{options_.pipeline, options_.mapper, options_.filter};
  Trajectory trajectory_{options_.pipeline.posing.odom_frame, options_.pipeline.base_frame};
  BagTopics topics_;
  std::set<std::string> input_topics_;
  std::chrono::duration<double> redrawing_{0.0};  // after the pose graph's correction [s]
};

template <class Kind>
BagMapper<Kind>::BagMapper(const MapperNodeOptions<Kind>& options) : options_(checked(options)) {
  topics_.add_poses(options_.node.odom_topic, trajectory_, pipeline_);
  Kind::inputs([this](const std::string& name, const std::string& noun, auto convert) {
    this->add_input(name, noun, convert);
  });
}

template <class Kind>
template <class Message, class SensorReading>
void BagMapper<Kind>::add_input(const std::string& name, const std::string& noun,
                                std::optional<Sensed<SensorReading>> (*convert)(const Message&)) {
  const std::size_t input = pipeline_.add_input(noun);
  for (const std::string& topic : options_.topics.by_input.at(name)) {
    input_topics_.insert(ros_convert::without_slash(topic));
    topics_.add<Message>(topic, [this, input, convert](const Message& message, Time now) {
      pipeline_.receive(input, convert(message), now);
    });
  }
}

template <class Kind>
void BagMapper<Kind>::finish() {
  pipeline_.poll(topics_.newest() + seconds(options_.pipeline.posing.tf_wait + 1.0));
  const auto start = std::chrono::steady_clock::now();
  pipeline_.remapper().finish();
  redrawing_ = std::chrono::steady_clock::now() - start;
}

template <class Kind>
FileSet BagMapper<Kind>::files() const {
  const auto& map = pipeline_.remapper().map();
  const Correction& correction = pipeline_.remapper().correction();
  FileSet files = Kind::save(map, Kind::kFileName, options_);
  if (files.empty()) return files;
  files.merge(Kind::pictures(map, Kind::kFileName, trajectory_.in_map(correction)));
  if (!trajectory_.empty()) files["trajectory.tum"] = trajectory_.tum(correction);
  return files;
}

template <class Kind>
YAML::Node BagMapper<Kind>::summary() const {
  YAML::Node node;
  node["inputs"] = counts_of(tallies());
  node["transforms_refused"] = pipeline_.posed().bad_transforms();
  node["counts"] = counts_of<Kind>(pipeline_.remapper().map());
  node["wall_time"] = topics_.wall_time();
  node["redrawing"]["observations"] = pipeline_.remapper().log_size();
  node["redrawing"]["log_megabytes"] = static_cast<double>(pipeline_.remapper().log_bytes()) * 1e-6;
  node["redrawing"]["wall_time"] = redrawing_.count();
  node["options"] = YAML::Load(to_yaml(option_rows(options_)));
  return node;
}

}  // namespace portolan
