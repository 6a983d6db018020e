// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

#include <string>

#include "portolan/options.hpp"

namespace portolan {

/// The same tree as YAML, so that one reader serves files and the parameter server.
YAML::Node to_yaml(const XmlRpc::XmlRpcValue& constant);

/// All parameters below this handle's namespace, as YAML; empty where there are none.
YAML::Node parameters(const ros::NodeHandle& handle);

/// The parameter as it is now, or `otherwise` where it is not set. Throws std::invalid_argument
/// where it is no string.
std::string string_parameter(const ros::NodeHandle& handle, const std::string& name,
                             const std::string& otherwise);

/// Fills the options from a node's private parameters. Throws OptionsError with every fault at
/// once; a parameter that none of the options knows is a fault.
template <class... Options>
void read_parameters(const ros::NodeHandle& handle, Options&... options) {
  read_options(parameters(handle), options...);
}

}  // namespace portolan
