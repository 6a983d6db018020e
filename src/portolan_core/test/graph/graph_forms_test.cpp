// SPDX-License-Identifier: BSD-3-Clause
// One graph written in several ways, as files of the literature are: all must lead to the same
// coordinates, to rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "graph/random_graph.hpp"
#include "portolan/graph/g2o_file.hpp"
#include "portolan/graph/graph_optimizer.hpp"

namespace portolan {
namespace {

using Words = std::vector<std::string>;
using Lines = std::vector<Words>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    Words split;
    for (std::string word; words >> word;) split.push_back(word);
    lines.push_back(split);
  }
  return lines;
}

std::string text_of(const Lines& lines) {
  std::string text;
  for (const Words& words : lines) {
    for (const std::string& word : words) text += word + " ";
    text += "\n";
  }
  return text;
}

bool is_edge(const Words& words) { return words[0].compare(0, 4, "EDGE") == 0; }

// The quaternion that ends at `end`, times a factor.
void scale_quaternion(Words& words, std::size_t end, double factor) {
  for (std::size_t i = end - 4; i < end; ++i) {
    std::ostringstream scaled;
    scaled.precision(17);
    scaled << factor * std::stod(words[i]);
    words[i] = scaled.str();
  }
}

class GraphForms : public ::testing::TestWithParam<GraphSpace> {
 protected:
  GraphForms() {
    std::mt19937_64 random(4);
    RandomGraph made;
    made.space = GetParam();
    made.noise = 0.5;
    graph = made.walk(random).graph;
    lines = lines_of(to_g2o(graph));
    lines.erase(std::remove_if(lines.begin(), lines.end(),
                               [](const Words& words) { return words[0] == "#"; }),
                lines.end());
  }

  // Optimised, it must fit and lie as the plain one does.
  static void expect_same(const Lines& a, const Lines& b) {
    Graph plain = graph_from_g2o(text_of(a));
    Graph other = graph_from_g2o(text_of(b));
    const OptimizerReport of_plain = GraphOptimizer().optimize(plain);
    const OptimizerReport of_other = GraphOptimizer().optimize(other);
    EXPECT_TRUE(of_plain.doubts.empty()) << to_string(of_plain.doubts);
    EXPECT_EQ(of_other.doubts, of_plain.doubts);
    EXPECT_NEAR(of_other.chi2, of_plain.chi2, 1e-6 * of_plain.chi2);
    ASSERT_EQ(other.poses().size(), plain.poses().size());
    for (std::size_t i = 0; i < plain.poses().size(); ++i) {
      const Pose difference = plain.poses()[i].T_map_pose.inverse() * other.poses()[i].T_map_pose;
      EXPECT_LT((difference.matrix() - Eigen::Matrix4d::Identity()).norm(), 1e-4) << i;
    }
  }

  bool planar() const { return GetParam() == GraphSpace::planar; }

  Graph graph;
  Lines lines;
};

TEST_P(GraphForms, may_come_in_any_order) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Lines shuffled = lines;
    std::mt19937_64 random(seed);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    expect_same(lines, shuffled);
  }
}

TEST_P(GraphForms, may_flip_and_stretch_quaternions) {
  if (planar()) return;
  Lines stretched = lines;
  for (std::size_t i = 0; i < stretched.size(); ++i) {
    const std::size_t end = is_edge(stretched[i]) ? 10 : 9;
    scale_quaternion(stretched[i], end, i % 2 == 0 ? -1.0 : 0.3);
  }
  expect_same(lines, stretched);
}

TEST_P(GraphForms, may_number_poses_with_gaps_and_below_zero) {
  Lines numbered = lines;
  for (Words& words : numbered) {
    for (std::size_t i = 1; i < (is_edge(words) ? 3U : 2U); ++i) {
      words[i] = std::to_string(1000003 * (std::stoll(words[i]) - 7));
    }
  }
  expect_same(lines, numbered);
}

TEST_P(GraphForms, may_leave_the_poses_out) {
  Lines edges = lines;
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [](const Words& words) { return !is_edge(words); }),
              edges.end());
  Lines from_origin = lines;  // where a graph without poses begins
  for (std::size_t i = 2; i < from_origin[0].size(); ++i) from_origin[0][i] = "0";
  if (!planar()) from_origin[0].back() = "1";
  expect_same(from_origin, edges);
}

TEST_P(GraphForms, may_fix_the_pose_that_stays_anyway) {
  Lines fixed = lines;
  fixed.push_back({"FIX", lines[0][1]});
  expect_same(lines, fixed);
}

// An arc that is said twice counts twice: as one with twice the information.
TEST_P(GraphForms, may_say_arcs_twice) {
  Lines twice = lines;
  Lines doubled = lines;
  for (Words& words : doubled) {
    if (!is_edge(words)) continue;
    twice.push_back(words);
    for (std::size_t i = planar() ? 6 : 10; i < words.size(); ++i) {
      std::ostringstream information;
      information.precision(17);
      information << 2.0 * std::stod(words[i]);
      words[i] = information.str();
    }
  }
  expect_same(doubled, twice);
}

// Two graphs in one file: each lies as it would alone, and that they hang apart is said.
TEST_P(GraphForms, may_hang_apart) {
  Lines both = lines;
  for (Words words : lines) {
    for (std::size_t i = 1; i < (is_edge(words) ? 3U : 2U); ++i) {
      words[i] = std::to_string(std::stoll(words[i]) + 100000);
    }
    both.push_back(words);
  }
  Graph alone = graph_from_g2o(text_of(lines));
  Graph apart = graph_from_g2o(text_of(both));
  const OptimizerReport of_alone = GraphOptimizer().optimize(alone);
  const OptimizerReport of_apart = GraphOptimizer().optimize(apart);
  EXPECT_EQ(of_apart.doubts, std::set<Doubt>{Doubt::disconnected});
  EXPECT_NEAR(of_apart.chi2, 2.0 * of_alone.chi2, 1e-6 * of_alone.chi2);
}

TEST_P(GraphForms, give_the_same_bits_each_time) {
  const std::string text = text_of(lines);
  Graph first = graph_from_g2o(text);
  GraphOptimizer().optimize(first);
  for (int i = 0; i < 3; ++i) {
    Graph again = graph_from_g2o(text);
    GraphOptimizer().optimize(again);
    EXPECT_TRUE(to_g2o(again) == to_g2o(first));
    for (std::size_t p = 0; p < first.poses().size(); ++p) {
      EXPECT_EQ(again.poses()[p].T_map_pose.matrix(), first.poses()[p].T_map_pose.matrix());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Spaces, GraphForms,
                         ::testing::Values(GraphSpace::planar, GraphSpace::spatial));

}  // namespace
}  // namespace portolan
