// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/graph/graph_services.hpp"

#include <exception>
#include <stdexcept>
#include <string>

#include "portolan_ros/convert/basics.hpp"
#include "portolan_ros/convert/pose_graph.hpp"

namespace portolan {

namespace {

// Does it to each arc; says what came of it.
template <class Deed>
bool for_each_arc(const portolan_msgs::SetArcs::Request& request, const char* what, Deed deed,
                  portolan_msgs::SetArcs::Response& response) {
  try {
    for (const std::uint32_t arc : request.arcs) deed(arc);
    response.success = true;
    response.message = std::to_string(request.arcs.size()) + " arcs " + what;
  } catch (const std::out_of_range&) {
    response.message = "there is no such arc";
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return true;
}

}  // namespace

GraphServices::GraphServices(ros::NodeHandle& private_handle, GraphPipeline& pipeline)
    : pipeline_(pipeline) {
  servers_.push_back(private_handle.advertiseService("list_arcs", &GraphServices::list, this));
  servers_.push_back(private_handle.advertiseService("enable_arcs", &GraphServices::enable, this));
  servers_.push_back(
      private_handle.advertiseService("disable_arcs", &GraphServices::disable, this));
  servers_.push_back(private_handle.advertiseService("add_arc", &GraphServices::add, this));
}

bool GraphServices::list(portolan_msgs::ListArcs::Request& request,
                         portolan_msgs::ListArcs::Response& response) {
  const Graph& graph = pipeline_.graph().graph();
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    const ArcKind kind = graph.arcs()[i].kind;
    const bool between_neighbours = kind == ArcKind::odometry || kind == ArcKind::scan;
    if (!request.all && between_neighbours) continue;
    response.arcs.push_back(ros_convert::graph_arc(graph, i));
  }
  return true;
}

bool GraphServices::enable(portolan_msgs::SetArcs::Request& request,
                           portolan_msgs::SetArcs::Response& response) {
  const auto deed = [this](std::size_t arc) { pipeline_.graph().enable(arc); };
  return for_each_arc(request, "enabled", deed, response);
}

bool GraphServices::disable(portolan_msgs::SetArcs::Request& request,
                            portolan_msgs::SetArcs::Response& response) {
  const auto deed = [this](std::size_t arc) { pipeline_.graph().disable(arc); };
  return for_each_arc(request, "disabled", deed, response);
}

bool GraphServices::add(portolan_msgs::AddArc::Request& request,
                        portolan_msgs::AddArc::Response& response) {
  TangentMatrix information;
  for (Eigen::Index i = 0; i < 36; ++i) {
    information(i / 6, i % 6) = request.information[static_cast<std::size_t>(i)];
  }
  try {
    PoseGraph& graph = pipeline_.graph();
    const std::size_t arc = graph.add(request.from, request.to, ros_convert::pose(request.pose),
                                      information, request.force != 0);
    const Arc& added = graph.graph().arcs()[arc];
    response.arc = static_cast<std::uint32_t>(arc);
    response.success = added.state == ArcState::accepted;
    response.message = enum_names(ArcReason{}).at(static_cast<std::size_t>(added.reason));
  } catch (const std::exception& error) {
    response.message = error.what();
  }
  return true;
}

}  // namespace portolan
