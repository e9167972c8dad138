#include "common/anatomy/volume_check.h"

#include <fmt/format.h>

#include <cmath>

#include "common/error.h"

namespace prosector {

std::string check_volume(double made, double expected, double accepted, const std::string& of,
                         const std::string& remedy) {
  if (!(expected > 0)) return "";
  const double error = 100 * std::abs(made / expected - 1);
  if (error <= reported_volume_error) return "";
  const std::string said =
      fmt::format("its volume is {:.4g} ml, {:.3g} % {} than the {:.4g} ml {}", 1e6 * made, error,
                  made < expected ? "less" : "more", 1e6 * expected, of);
  if (error > (accepted > 0 ? accepted : accepted_volume_error))
    throw InputError(
        said + ". " + remedy +
        (error <= max_accepted_volume_error
             ? fmt::format(" To accept it nevertheless: max_volume_error = \"{:.0f} %\"", std::ceil(error))
             : std::string()));
  return "warning: " + said;
}

}  // namespace prosector
