#include "server/physics/mechanics/soft/compression.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace prosector::soft {
namespace {

struct Limit {
  std::string_view model;
  std::string_view sentence;
};

constexpr std::array limits = {
    Limit{"fem_stvk",
          "softens when compressed below 58 % of its length, and its inverted elements stay inverted; for "
          "strong "
          "compression, use fem_corotational or fem_neo_hookean, which recover"},
    Limit{"fem_linear",
          "is for small strains and rotations, and does not resist inversion; for strong compression, use "
          "fem_corotational or fem_neo_hookean, which recover"},
    Limit{"fem_neo_hookean_polynomial",
          "stays collapsed when compressed to a point; fem_neo_hookean and fem_corotational recover their "
          "shape"},
    Limit{"xpbd",
          "stays collapsed when compressed to a point; fem_neo_hookean and fem_corotational recover their "
          "shape"},
};

}  // namespace

std::string limit_under_compression(const SoftDesc& desc, bool solid) {
  if (!solid) return {};
  if (desc.configuration.model == "mass_spring" && !desc.material.hold_volume)
    return "has springs that do not resist inversion; hold_volume = true adds volume springs that do";
  const auto row = std::find_if(limits.begin(), limits.end(),
                                [&](const Limit& limit) { return limit.model == desc.configuration.model; });
  return row == limits.end() ? std::string() : std::string(row->sentence);
}

}  // namespace prosector::soft
