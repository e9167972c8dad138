#include "server/physics/mechanics/soft/compression.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace prosector {
namespace {

struct Limit {
  std::string_view model;
  std::string_view sentence;
};

constexpr std::array limits = {
    Limit{"fem_stvk",
          "yields when squeezed below 58 % of its length, and is content inside out: not for what is pressed "
          "hard; fem_corotational and fem_neo_hookean come back"},
    Limit{"fem_linear",
          "is for small strains and turns, and does not resist being turned inside out: not for what is "
          "pressed hard; fem_corotational and fem_neo_hookean come back"},
    Limit{"fem_neo_hookean_polynomial",
          "stays collapsed when squeezed to a point: fem_neo_hookean and fem_corotational come back"},
    Limit{"xpbd", "stays collapsed when squeezed to a point: fem_neo_hookean and fem_corotational come back"},
};

}  // namespace

std::string limit_under_compression(const SoftDesc& desc, bool solid) {
  if (!solid) return {};
  if (desc.model == "mass_spring" && !desc.hold_volume)
    return "has springs that do not know inside from outside: with hold_volume they do";
  const auto row = std::find_if(limits.begin(), limits.end(),
                                [&](const Limit& limit) { return limit.model == desc.model; });
  return row == limits.end() ? std::string() : std::string(row->sentence);
}

}  // namespace prosector
