#include "server/physics/mechanics/collision/shapes/fidelity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "common/error.h"

namespace prosector {

Fidelity fidelity_of(std::string_view name) {
  const auto found = std::find(fidelity_names.begin(), fidelity_names.end(), name);
  if (found == fidelity_names.end())
    throw InputError(fmt::format("collision is \"{}\"; allowed: {}", name, fmt::join(fidelity_names, ", ")));
  return static_cast<Fidelity>(found - fidelity_names.begin());
}

}  // namespace prosector
