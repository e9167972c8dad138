#include "drivers/fitting/guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {

ConfigValue written(const Vec3& place) {
  constexpr double steps = 1e6;
  std::vector<double> out;
  for (int i = 0; i < 3; ++i) out.push_back(std::round(steps * place[i]) / steps);
  return out;
}

ConfigValue written(const Quat& q) {
  constexpr double steps = 1e7;
  std::vector<double> out = {q.w(), q.x(), q.y(), q.z()};
  for (double& x : out) x = std::round(steps * x) / steps;
  return out;
}

const char* role_name(StationRole role) {
  constexpr std::array names = {"none", "head", "left", "right", "instrument", "tablet"};
  return names.at(static_cast<std::size_t>(role));
}

StationRole pointer_role(const ClientConfig& config) {
  const auto end = config.stations.end();
  return std::find(config.stations.begin(), end, StationRole::instrument) != end ? StationRole::instrument
                                                                                 : StationRole::right_hand;
}

std::size_t station_of_role(const ClientConfig& config, StationRole role) {
  const auto at = std::find(config.stations.begin(), config.stations.end(), role);
  if (at == config.stations.end())
    throw InputError(
        fmt::format("no receiver has the role '{}': set tracker.stations.{}.station in the configuration",
                    role_name(role), role_name(role)));
  return static_cast<std::size_t>(at - config.stations.begin());
}

}  // namespace prosector
