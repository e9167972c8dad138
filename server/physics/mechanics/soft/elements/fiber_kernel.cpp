#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/mechanics/soft/elements/fiber_kernel.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// Must follow foreach_target.h, which includes these headers again.
#include "server/physics/mechanics/soft/elements/fiber_kernel.h"
#include "server/physics/mechanics/soft/elements/lane_forces.h"
#include "server/physics/mechanics/soft/simd/lane_math.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

/// Fibres of a few elements: a, F·a, k and the stretch excess ⟨|F·a|² − 1⟩.
struct Fibers {
  Vector a, f;
  V k, excess;

  HWY_INLINE Fibers(const LaneFibers& fibers, const LaneStrain& strain, std::size_t i) {
    const D d;
    a = {hn::Load(d, fibers.direction[0] + i), hn::Load(d, fibers.direction[1] + i),
         hn::Load(d, fibers.direction[2] + i)};
    f = load(strain.F, i) * a;
    k = hn::Load(d, fibers.stiffness + i);
    excess = hn::Max(dot(f, f) - number(1), zero());
  }
  /// Returns k, or 0 for slack fibres, which do not resist changes of length.
  HWY_INLINE V taut_stiffness() const { return hn::IfThenElseZero(dot(f, f) >= number(1 - 1e-9), k); }
};

void add_energy(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain, double* energy) {
  const D d;
  for (std::size_t i = 0; i < elements_per_batch; i += hn::Lanes(d)) {
    const Fibers own(fibers, strain, i);
    const V W = own.k / number(8) * own.excess * own.excess;
    hn::StoreU(hn::LoadU(d, energy + i) + hn::Load(d, rest.volume + i) * W, d, energy + i);
  }
}

void add_forces(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain,
                std::span<Tet4Elements::Forces> forces) {
  const D d;
  Tet4Elements::Forces added[elements_per_batch];
  const std::span<Tet4Elements::Forces> out(added, forces.size());
  for (std::size_t i = 0; i < forces.size(); i += hn::Lanes(d)) {
    const Fibers own(fibers, strain, i);
    const Matrix B = load(rest.gradients, i);
    const Vector pull = hn::Load(d, rest.volume + i) * own.k * number(0.5) * own.excess * own.f;
    write_forces({dot(own.a, B.a) * pull, dot(own.a, B.b) * pull, dot(own.a, B.c) * pull}, i, out);
  }
  for (std::size_t e = 0; e < forces.size(); ++e)
    for (std::size_t a = 0; a < 4; ++a) forces[e][a] += added[e][a];
}

void tangents(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain, double share,
              PointTangents& out) {
  const D d;
  const hn::DFromV<Single> to;
  out.has_fibers = true;
  for (std::size_t i = 0; i < elements_per_batch; i += hn::Lanes(d)) {
    const Fibers own(fibers, strain, i);
    const Vector turned = load(strain.R, i) * own.a;
    const V mu = hn::Load(d, rest.mu + i), taut = number(share) * own.k / mu,
            warped = number(1 - share) * own.taut_stiffness() / mu;
    const V along = hn::IfThenElseZero(own.excess > zero(), taut), across = number(0.5) * taut * own.excess;
    const auto entry = [&](std::size_t row, V f_i, V f_j, V r_i, V r_j, V more) HWY_ATTR {
      hn::Store(single(along * f_i * f_j + warped * r_i * r_j + more), to, out.along_fiber[row] + i);
    };
    const Vector &f = own.f, &r = turned;
    entry(0, f.x, f.x, r.x, r.x, across);
    entry(1, f.y, f.y, r.y, r.y, across);
    entry(2, f.z, f.z, r.z, r.z, across);
    entry(3, f.x, f.y, r.x, r.y, zero());
    entry(4, f.x, f.z, r.x, r.z, zero());
    entry(5, f.y, f.z, r.y, r.z, zero());
    hn::Store(single(r.x), to, out.fiber[0] + i);
    hn::Store(single(r.y), to, out.fiber[1] + i);
    hn::Store(single(r.z), to, out.fiber[2] + i);
    hn::Store(single(hn::Sqrt(hn::Sqrt(own.taut_stiffness() / mu))), to, out.fiber_root + i);
  }
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace prosector::soft {

HWY_EXPORT(add_energy);
HWY_EXPORT(add_forces);
HWY_EXPORT(tangents);

void lane_add_fiber_energy(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain,
                           double* energy) {
  HWY_DYNAMIC_DISPATCH(add_energy)(fibers, rest, strain, energy);
}
void lane_add_fiber_forces(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain,
                           std::span<Tet4Elements::Forces> forces) {
  HWY_DYNAMIC_DISPATCH(add_forces)(fibers, rest, strain, forces);
}
void lane_fiber_tangents(const LaneFibers& fibers, const LaneRest& rest, const LaneStrain& strain,
                         double share, PointTangents& out) {
  HWY_DYNAMIC_DISPATCH(tangents)(fibers, rest, strain, share, out);
}

}  // namespace prosector::soft
#endif
