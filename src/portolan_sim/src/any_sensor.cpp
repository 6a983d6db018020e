// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/sim/any_sensor.hpp"

#include <set>
#include <type_traits>
#include <utility>

#include "portolan/sim/optical_frame.hpp"

namespace portolan::sim {

namespace {

template <class Sensor>
constexpr bool kIsOptical = std::is_same_v<Sensor, DepthCamera> || std::is_same_v<Sensor, Camera>;

template <class Sensor>
Pose frame_of(const Sensor& sensor) {
  const Pose T_base_body = mount(sensor.options());
  if constexpr (kIsOptical<Sensor>) return T_base_body * T_body_optical();
  return T_base_body;
}

template <class Sensor>
Event event_of(const Sensor& sensor, Time stamp, Event::Payload payload) {
  return {stamp, stamp, sensor.options().topic, sensor.options().frame, std::move(payload)};
}

/// Any sensor with one frame that measures in a moment.
template <class Sensor>
void measure_one(Sensor& sensor, const Moment& moment, std::vector<Event>& events) {
  const Pose T_map_sensor = moment.T_map_base.at(moment.stamp) * frame_of(sensor);
  events.push_back(event_of(sensor, moment.stamp, sensor.sense(moment.world, T_map_sensor)));
}

/// A laser, which takes its time. What it moved meanwhile is known by odometry.
void measure_one(Laser& laser, const Moment& moment, std::vector<Event>& events) {
  const Laser::Options& options = laser.options();
  const Time end = moment.stamp + seconds(options.sweep_time);
  const Pose T_base_laser = mount(options);
  RangeScan scan = laser.sense(moment.world, moment.T_map_base.at(moment.stamp) * T_base_laser,
                               moment.T_map_base.at(end) * T_base_laser);
  if (options.sweep_time > 0.0) {
    scan.T_first_last = (moment.T_odom_base.at(moment.stamp) * T_base_laser).inverse() *
                        moment.T_odom_base.at(end) * T_base_laser;
  }
  const double time_increment = options.sweep_time / (options.beams - 1);
  events.push_back(event_of(laser, moment.stamp, Event::Scan{std::move(scan), time_increment}));
  events.back().known = end;
}

void ping(SonarRing& ring, std::size_t sonar, const Moment& moment, std::vector<Event>& events) {
  const Pose T_map_base = moment.T_map_base.at(moment.stamp);
  events.push_back(event_of(ring, moment.stamp, ring.sense(sonar, moment.world, T_map_base)));
  events.back().frame = ring.frame(sonar);
}

void measure_one(SonarRing& ring, const Moment& moment, std::vector<Event>& events) {
  if (ring.options().in_turn) {
    ping(ring, static_cast<std::size_t>(moment.count) % ring.size(), moment, events);
    return;
  }
  for (std::size_t sonar = 0; sonar < ring.size(); ++sonar) ping(ring, sonar, moment, events);
}

template <class Sensor>
std::vector<Mount> mounts_of(const Sensor& sensor) {
  return {{sensor.options().frame, frame_of(sensor)}};
}

std::vector<Mount> mounts_of(const SonarRing& ring) {
  std::vector<Mount> all;
  for (std::size_t sonar = 0; sonar < ring.size(); ++sonar) {
    all.push_back({ring.frame(sonar), ring.mount(sonar)});
  }
  return all;
}

template <class Sensor>
double rate_of(const Sensor& sensor) {
  return sensor.options().rate;
}

double rate_of(const SonarRing& ring) {
  const double pings = ring.options().in_turn ? static_cast<double>(ring.size()) : 1.0;
  return ring.options().rate * pings;
}

template <class Sensor>
void add(const std::vector<typename Sensor::Options>& listed, std::int64_t seed,
         std::vector<AnySensor>& sensors) {
  for (const auto& options : listed) {
    sensors.emplace_back(Sensor(options, static_cast<std::uint64_t>(seed)));
  }
}

void check_frames(const std::vector<AnySensor>& sensors) {
  std::set<std::string> frames;
  std::vector<std::string> faults;
  for (const AnySensor& sensor : sensors) {
    for (const Mount& mount : mounts(sensor)) {
      if (!frames.insert(mount.frame).second) {
        faults.push_back("two sensors have the frame " + mount.frame);
      }
    }
  }
  if (!faults.empty()) throw OptionsError(std::move(faults));
}

}  // namespace

std::vector<AnySensor> sensors_of(const SimulationOptions& options) {
  std::vector<AnySensor> sensors;
  add<Laser>(options.lasers, options.seed, sensors);
  add<SonarRing>(options.sonar_rings, options.seed, sensors);
  add<Lidar>(options.lidars, options.seed, sensors);
  add<DepthCamera>(options.depth_cameras, options.seed, sensors);
  add<LandmarkSensor>(options.landmark_sensors, options.seed, sensors);
  add<Camera>(options.cameras, options.seed, sensors);
  add<BeaconReceiver>(options.beacon_receivers, options.seed, sensors);
  check_frames(sensors);
  return sensors;
}

std::vector<Mount> mounts(const AnySensor& sensor) {
  return std::visit([](const auto& one) { return mounts_of(one); }, sensor);
}

double rate(const AnySensor& sensor) {
  return std::visit([](const auto& one) { return rate_of(one); }, sensor);
}

Duration duration(const AnySensor& sensor) {
  const auto* laser = std::get_if<Laser>(&sensor);
  return laser != nullptr ? seconds(laser->options().sweep_time) : Duration::zero();
}

void measure(AnySensor& sensor, const Moment& moment, std::vector<Event>& events) {
  std::visit([&](auto& one) { measure_one(one, moment, events); }, sensor);
}

}  // namespace portolan::sim
