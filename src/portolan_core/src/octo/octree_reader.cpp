// SPDX-License-Identifier: BSD-3-Clause
#include "portolan/octo/octree_reader.hpp"

#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace portolan {

namespace {

constexpr int kLevels = 16;
constexpr const char* kFullFile = "# Octomap OcTree file";
constexpr const char* kBinaryFile = "# Octomap OcTree binary file";

[[noreturn]] void fail(const std::string& fault) { throw std::runtime_error(fault); }

/// The next line from `at` on, which moves behind it.
std::string next_line(const std::string& file, std::size_t& at) {
  const std::size_t end = file.find('\n', at);
  if (end == std::string::npos) fail("its header is cut off");
  const std::string line = file.substr(at, end - at);
  at = end + 1;
  return line;
}

template <class T>
T number(const std::string& word, const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  T value{};
  if (!(in >> value)) fail("its header says " + word + " " + text);
  return value;
}

void read_word(const std::string& line, OctreeHeader& header) {
  const std::size_t space = line.find(' ');
  const std::string word = line.substr(0, space);
  const std::string value = space == std::string::npos ? "" : line.substr(space + 1);
  if (word == "id" && value != "OcTree") fail("it holds a tree of type " + value.substr(0, 40));
  if (word == "size") header.nodes = number<std::size_t>(word, value.substr(0, 40));
  if (word == "res") header.resolution = number<double>(word, value.substr(0, 40));
}

/// Walks through the nodes of a file in the order in which they stand there.
class NodeReader {
 public:
  NodeReader(const std::string& file, const OctreeHeader& header, float free, float occupied,
             const std::function<void(const OctreeLeaf&)>& visit)
      : file_(file), at_(header.data), free_(free), occupied_(occupied), visit_(visit) {}

  std::size_t nodes() const { return nodes_; }
  bool is_at_end() const { return at_ == file_.size(); }

  /// A node of a `.ot` file: its log-odds, and a bit for each child.
  void read_full(const octomap::OcTreeKey& corner, int level) {
    ++nodes_;
    float log_odds = 0.0F;
    std::memcpy(&log_odds, take(sizeof(log_odds)), sizeof(log_odds));
    const auto children = static_cast<unsigned char>(*take(1));
    if (!std::isfinite(log_odds)) fail("a node's log-odds are not finite");
    if (children == 0) return visit_({corner, level, log_odds});
    for (unsigned i = 0; i < 8; ++i) {
      if ((children >> i & 1) != 0) read_full(child(corner, level, i), level - 1);
    }
  }

  /// An inner node of a `.bt` file: two bits for each child, those of the first child lowest.
  void read_binary(const octomap::OcTreeKey& corner, int level) {
    ++nodes_;
    const auto* bytes = reinterpret_cast<const unsigned char*>(take(2));
    const unsigned kinds = bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
    for (unsigned i = 0; i < 8; ++i) {
      const unsigned kind = kinds >> (2 * i) & 3;
      if (kind == 1 || kind == 2) {
        ++nodes_;
        visit_({child(corner, level, i), level - 1, kind == 1 ? free_ : occupied_});
      }
    }
    for (unsigned i = 0; i < 8; ++i) {
      if ((kinds >> (2 * i) & 3) == 3) read_binary(child(corner, level, i), level - 1);
    }
  }

 private:
  const char* take(std::size_t bytes) {
    if (file_.size() - at_ < bytes) fail("it is cut off");
    at_ += bytes;
    return file_.data() + at_ - bytes;
  }

  static octomap::OcTreeKey child(octomap::OcTreeKey corner, int level, unsigned i) {
    if (level == 0) fail("it is deeper than 16 levels");
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned far = i >> axis & 1;
      corner[axis] = static_cast<octomap::key_type>(corner[axis] + (far << (level - 1)));
    }
    return corner;
  }

  const std::string& file_;
  std::size_t at_;
  float free_;
  float occupied_;
  const std::function<void(const OctreeLeaf&)>& visit_;
  std::size_t nodes_ = 0;
};

}  // namespace

OctreeHeader read_octree_header(const std::string& file) {
  OctreeHeader header;
  const std::string first = next_line(file, header.data);
  header.is_binary = first.rfind(kBinaryFile, 0) == 0;
  if (!header.is_binary && first.rfind(kFullFile, 0) != 0) fail("it is no octree file");
  for (std::string line = next_line(file, header.data); line != "data";) {
    if (line.rfind('#', 0) != 0) read_word(line, header);
    line = next_line(file, header.data);
  }
  if (!(header.resolution > 0.0 && std::isfinite(header.resolution))) {
    fail("its header has no resolution above 0");
  }
  return header;
}

void read_octree(const std::string& file, const OctreeHeader& header, float free_log_odds,
                 float occupied_log_odds, const std::function<void(const OctreeLeaf&)>& visit) {
  NodeReader reader(file, header, free_log_odds, occupied_log_odds, visit);
  const octomap::OcTreeKey corner(0, 0, 0);
  if (header.nodes > 0 && header.is_binary) reader.read_binary(corner, kLevels);
  if (header.nodes > 0 && !header.is_binary) reader.read_full(corner, kLevels);
  if (!reader.is_at_end()) fail("it goes on after its last node");
  if (reader.nodes() != header.nodes) {
    fail("it says " + std::to_string(header.nodes) + " nodes and holds " +
         std::to_string(reader.nodes()));
  }
}

}  // namespace portolan
