#include "server/physics/mechanics/soft/laws/constitutive_law.h"

#include <algorithm>

#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/laws/fem_laws.h"

namespace prosector::soft {

const std::vector<LawRow>& laws() {
  static const std::vector<LawRow> rows = {
      {"fem_linear", "linear elasticity for small strain and small rotations; constant stiffness matrix",
       make_fem_linear},
      {"fem_corotational",
       "linear elasticity in a frame that rotates with each element; moderate strain, any rotation",
       make_fem_corotational},
      {"fem_stvk", "St. Venant-Kirchhoff; moderate strain, any rotation, but inverted elements stay inverted",
       make_fem_stvk},
      {"fem_neo_hookean", "stable neo-Hookean law for large strain; recovers from collapse",
       make_fem_neo_hookean},
      {"fem_neo_hookean_polynomial",
       "stable neo-Hookean law without the logarithmic term, for large strain; stays collapsed when "
       "compressed to a point",
       make_fem_neo_hookean_polynomial},
      {"fem_fibers", "fem_neo_hookean with fibres along one direction; for muscle and tendon",
       make_fem_fibers},
  };
  return rows;
}

bool is_law(const std::string& name) {
  return std::any_of(laws().begin(), laws().end(), [&](const LawRow& row) { return name == row.name; });
}

std::unique_ptr<ConstitutiveLaw> make_law(const std::string& name, const Material& constants) {
  return find_row(laws(), "model", name).make(constants);
}

}  // namespace prosector::soft
