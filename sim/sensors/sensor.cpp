// SPDX-License-Identifier: MIT
#include "sim/sensors/sensor.h"

#include <map>

namespace bulletnav::sim {
namespace {

/// Filled before main by the registrations and only read after that.
std::map<std::string, internal::SensorConfigurer, std::less<>>& Registered() {
  static std::map<std::string, internal::SensorConfigurer, std::less<>> types;
  return types;
}

const internal::SensorConfigurer& FindType(std::string_view name) {
  const auto found = Registered().find(name);
  if (found != Registered().end()) return found->second;
  std::string known;
  for (const auto& [type, configure] : Registered()) known += (known.empty() ? "" : ", ") + type;
  throw Error("unknown type of sensor '" + std::string(name) + "'; known are: " + known);
}

const internal::SensorConfigurer& FindType(const YamlNode& name) {
  try {
    return FindType(name.ToString());
  } catch (const FileError&) {
    throw;
  } catch (const Error& e) {
    name.Fail(e.what());
  }
}

}  // namespace

std::vector<std::string> SensorTypes() {
  std::vector<std::string> types;
  for (const auto& [type, configure] : Registered()) types.push_back(type);
  return types;
}

ConfiguredSensor ConfigureSensor(const YamlNode& block) {
  if (block.yaml().IsScalar()) return FindType(block)(std::nullopt);
  block.ExpectMap();
  const YAML::Node type = block.yaml()["type"];
  if (!type.IsDefined()) block.Fail("a sensor needs a type, as in {type: pinhole}");
  return FindType(block.Child(type))(block);
}

ConfiguredSensor ConfigureSensor(std::string_view type) {
  return FindType(type)(std::nullopt);
}

void internal::RegisterSensor(std::string_view type, const SensorConfigurer& configure) {
  if (!Registered().try_emplace(std::string(type), configure).second) {
    throw Error("two types of sensor are called '" + std::string(type) + "'");
  }
}

}  // namespace bulletnav::sim
