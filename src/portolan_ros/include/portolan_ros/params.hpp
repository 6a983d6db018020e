// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <XmlRpcValue.h>
#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

#include "portolan/options.hpp"

namespace portolan {

/// The same tree as YAML, so that one reader serves files and the parameter server.
YAML::Node to_yaml(const XmlRpc::XmlRpcValue& value);

/// All parameters below this handle's namespace, as YAML; empty where there are none.
YAML::Node parameters(const ros::NodeHandle& handle);

/// Fills the options from a node's private parameters. Throws OptionsError with every fault at
/// once; a parameter that none of the options knows is a fault.
template <class... Options>
void read_parameters(const ros::NodeHandle& handle, Options&... options) {
  read_options(parameters(handle), options...);
}

}  // namespace portolan
