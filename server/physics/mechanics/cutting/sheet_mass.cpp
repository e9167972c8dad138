#include "server/physics/mechanics/cutting/sheet_mass.h"

#include "common/assert.h"

namespace prosector::cutting {

EdgeMasses share_mass(const EdgeEnd& a, const EdgeEnd& b, double t) {
  PROSECTOR_ASSERT(t > 0 && t < 1);
  if (a.held != b.held)
    return a.held ? EdgeMasses{a.mass, b.mass / 2, b.mass / 2} : EdgeMasses{a.mass / 2, b.mass, a.mass / 2};
  const double sum = a.mass + b.mass, m = a.mass + t * (b.mass - a.mass), f = sum / (sum + m);
  return {f * a.mass, f * b.mass, f * m};
}

}  // namespace prosector::cutting
