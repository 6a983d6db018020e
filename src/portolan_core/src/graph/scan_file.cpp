// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/graph/scan_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "graph/text_numbers.hpp"

namespace portolan {

namespace {

const std::string kTitle = "portolan scans 1 ";

static_assert(sizeof(float) == 4 && sizeof(double) == 8);

// Numbers as bytes, the least significant one first on every machine.
class Writer {
 public:
  explicit Writer(std::string& bytes) : bytes_(bytes) {}

  template <class Word>
  void word(Word value) {
    for (std::size_t i = 0; i < sizeof(Word); ++i) {
      bytes_ += static_cast<char>(static_cast<unsigned char>(value >> (8 * i) & 0xff));
    }
  }
  void number(double value) { word(bits<std::uint64_t>(value)); }
  void number(float value) { word(bits<std::uint32_t>(value)); }
  void pose(const Pose& T) {
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 4; ++column) number(T.matrix()(row, column));
    }
  }

 private:
  template <class Bits, class Number>
  static Bits bits(Number value) {
    Bits bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return bits;
  }

  std::string& bytes_;
};

// The same numbers again. What is beyond the end throws.
class Reader {
 public:
  Reader(const std::string& bytes, std::size_t begin) : bytes_(bytes), next_(begin) {}

  std::size_t left() const { return bytes_.size() - next_; }
  template <class Word>
  Word word() {
    if (left() < sizeof(Word)) throw std::runtime_error("is cut off");
    Word value = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i) {
      value |= static_cast<Word>(static_cast<unsigned char>(bytes_[next_ + i])) << (8 * i);
    }
    next_ += sizeof(Word);
    return value;
  }
  template <class Number, class Bits>
  Number number() {
    const Bits bits = word<Bits>();
    Number value;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }
  double real() { return number<double, std::uint64_t>(); }
  std::int64_t integer() { return number<std::int64_t, std::uint64_t>(); }
  Pose pose() {
    Pose T = Pose::Identity();
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 4; ++column) T.matrix()(row, column) = real();
    }
    if (!is_valid(T)) throw std::runtime_error("has a pose that is not rigid");
    return T;
  }

 private:
  const std::string& bytes_;
  std::size_t next_;
};

void write(std::size_t id, const Keyframe& keyframe, Writer& to) {
  const RangeScan& scan = keyframe.scan;
  to.word(static_cast<std::uint64_t>(id));
  to.word(static_cast<std::uint64_t>(keyframe.stamp.time_since_epoch().count()));
  to.pose(keyframe.T_base_sensor);
  to.pose(scan.T_first_last);
  to.number(scan.angle_min);
  to.number(scan.angle_increment);
  to.number(scan.range_min);
  to.number(scan.range_max);
  to.word(static_cast<std::uint32_t>(scan.ranges.size()));
  for (const float range : scan.ranges) to.number(range);
}

SavedScan read_scan(Reader& from) {
  SavedScan saved;
  saved.keyframe = from.integer();
  saved.stamp = Time(Duration(from.integer()));
  saved.T_base_sensor = from.pose();
  saved.scan.T_first_last = from.pose();
  saved.scan.angle_min = from.real();
  saved.scan.angle_increment = from.real();
  saved.scan.range_min = from.real();
  saved.scan.range_max = from.real();
  const auto count = from.word<std::uint32_t>();
  if (count > from.left() / sizeof(float)) throw std::runtime_error("is cut off");
  saved.scan.ranges.resize(count);
  for (float& range : saved.scan.ranges) range = from.number<float, std::uint32_t>();
  if (!is_usable(saved.scan)) throw std::runtime_error("is malformed");
  return saved;
}

// What the first line says of how many scans there are.
std::int64_t count_in(const std::string& line) {
  const bool is_titled = line.compare(0, kTitle.size(), kTitle) == 0;
  const auto count = is_titled ? integer_in(line.substr(kTitle.size())) : std::nullopt;
  if (!count || *count < 0) {
    throw std::runtime_error("does not begin with `" + kTitle + "COUNT`");
  }
  return *count;
}

}  // namespace

std::string to_scan_file(const std::vector<Keyframe>& keyframes) {
  const auto has_scan = [](const Keyframe& keyframe) { return !keyframe.scan.ranges.empty(); };
  const auto count = std::count_if(keyframes.begin(), keyframes.end(), has_scan);
  std::string bytes = kTitle + std::to_string(count) + "\n";
  Writer to(bytes);
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    if (has_scan(keyframes[i])) write(i, keyframes[i], to);
  }
  return bytes;
}

std::vector<SavedScan> scans_from_file(const std::string& bytes) {
  const std::size_t end = std::min(bytes.find('\n'), bytes.size());
  const std::int64_t count = count_in(bytes.substr(0, end));
  Reader from(bytes, std::min(end + 1, bytes.size()));
  std::vector<SavedScan> scans;
  for (std::int64_t i = 1; i <= count; ++i) {
    try {
      scans.push_back(read_scan(from));
      if (i > 1 && scans.back().keyframe <= scans[scans.size() - 2].keyframe) {
        throw std::runtime_error("comes after one of a later keyframe");
      }
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("scan " + std::to_string(i) + " of " + std::to_string(count) + " " +
                               error.what());
    }
  }
  if (from.left() > 0) throw std::runtime_error("goes on after its last scan");
  return scans;
}

}  // namespace portolan
