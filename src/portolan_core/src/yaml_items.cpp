// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/yaml_items.hpp"

#include <yaml-cpp/eventhandler.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "portolan/yaml_values.hpp"

namespace portolan::yaml_values {

namespace {

/// Puts together what the parser finds, and hands items on as soon as they are whole.
class Collector : public YAML::EventHandler {
 public:
  Collector(const std::string& list, const TakeItem& take) : list_(list), take_(take) {}

  const YAML::Node& head() const { return head_; }

  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t anchor) override {
    count(anchor);
    put(YAML::Node(YAML::NodeType::Null));
  }
  void OnAlias(const YAML::Mark& /*mark*/, YAML::anchor_t anchor) override { count(anchor); }
  void OnScalar(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t anchor,
                const std::string& value) override {
    count(anchor);
    put(YAML::Node(value));
  }
  void OnSequenceStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/,
                       YAML::anchor_t anchor, YAML::EmitterStyle::value /*style*/) override {
    open(YAML::NodeType::Sequence, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& /*mark*/, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(YAML::NodeType::Map, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  /// A list or a map that is not yet whole.
  struct Level {
    YAML::Node node;
    bool has_key = false;
    std::string key = {};  // of the value to come, in a map
  };

  void count(YAML::anchor_t anchor) {
    constexpr std::size_t kMost = 1000000;
    require(anchor == 0, "anchors have no place in a map's file");
    require(++values_ <= kMost, "it is too large");
  }

  void open(YAML::NodeType::value type, YAML::anchor_t anchor) {
    constexpr std::size_t kDeepest = 32;
    count(anchor);
    require(levels_.size() < kDeepest, "it is too deep");
    if (levels_.size() == 1) head_ = levels_.front().node;
    levels_.push_back({YAML::Node(type)});
  }

  void close() {
    const YAML::Node whole = levels_.back().node;
    levels_.pop_back();
    put(whole);
  }

  void put(const YAML::Node& value) {
    if (levels_.empty()) {
      head_ = value;
    } else if (levels_.size() == 2 && levels_.front().key == list_ &&
               levels_.back().node.IsSequence()) {
      take_(head_, value);
      values_ = 0;
    } else {
      put_into(levels_.back(), value);
    }
  }

  static void put_into(Level& level, const YAML::Node& value) {
    if (level.node.IsSequence()) return level.node.push_back(value);
    if (level.has_key) {
      level.node[level.key] = value;
    } else {
      require(value.IsScalar(), "a key is no word");
      level.key = value.Scalar();
    }
    level.has_key = !level.has_key;
  }

  const std::string& list_;
  const TakeItem& take_;
  YAML::Node head_;
  std::vector<Level> levels_;
  std::size_t values_ = 0;  // in this item, or in the head
};

}  // namespace

YAML::Node read_items(const std::string& text, const std::string& list, const TakeItem& take) try {
  std::istringstream in(text);
  YAML::Parser parser(in);
  Collector collector(list, take);
  parser.HandleNextDocument(collector);
  return collector.head();
} catch (const YAML::Exception& error) {
  throw std::runtime_error(error.what());
}

}  // namespace portolan::yaml_values
