// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/params.hpp"

#include <stdexcept>
#include <string>

#include "portolan/options/value.hpp"

namespace portolan {

namespace {

using XmlRpc::XmlRpcValue;

YAML::Node list(XmlRpcValue& value) {
  YAML::Node node(YAML::NodeType::Sequence);
  for (int i = 0; i < value.size(); ++i) node.push_back(to_yaml(value[i]));
  return node;
}

YAML::Node map(XmlRpcValue& value) {
  YAML::Node node(YAML::NodeType::Map);
  for (auto& entry : value) node[entry.first] = to_yaml(entry.second);
  return node;
}

}  // namespace

YAML::Node to_yaml(const XmlRpcValue& constant) {
  XmlRpcValue value = constant;  // XmlRpcValue can only be read through mutable access
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(value));
    case XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<int>(value));
    case XmlRpcValue::TypeDouble:
      return YAML::Node(options_detail::format_double(static_cast<double>(value)));
    case XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string>(value));
    case XmlRpcValue::TypeArray:
      return list(value);
    case XmlRpcValue::TypeStruct:
      return map(value);
    default:
      return YAML::Node();
  }
}

YAML::Node parameters(const ros::NodeHandle& handle) {
  XmlRpcValue value;
  const bool found = handle.getParam(handle.getNamespace(), value);
  return found && value.getType() == XmlRpcValue::TypeStruct ? map(value)
                                                             : YAML::Node(YAML::NodeType::Map);
}

std::string string_parameter(const ros::NodeHandle& handle, const std::string& name,
                             const std::string& otherwise) {
  std::string value = otherwise;
  if (handle.hasParam(name) && !handle.getParam(name, value)) {
    throw std::invalid_argument(name + " must be a string");
  }
  return value;
}

}  // namespace portolan
