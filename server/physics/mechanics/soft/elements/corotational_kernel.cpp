#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/mechanics/soft/elements/corotational_kernel.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// Must follow foreach_target.h, which includes these headers again.
#include "server/physics/mechanics/soft/elements/corotational_kernel.h"
#include "server/physics/mechanics/soft/elements/lane_forces.h"
#include "server/physics/mechanics/soft/laws/fem_laws.h"
#include "server/physics/mechanics/soft/laws/polar.h"
#include "server/physics/mechanics/soft/simd/lane_math.h"
#include "server/physics/mechanics/soft/simd/lane_polar.h"
#include "server/physics/mechanics/soft/simd/lane_twists.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

using Blocks = Tet4Elements::Stiffness;
constexpr std::size_t stiffness_entries = sizeof(Blocks) / sizeof(double);

/// Rotated shape function gradients r_0 … r_3.
struct Corotated {
  Vector r[4];
};
HWY_INLINE Corotated corotated_gradients(const Matrix& R, const Matrix& B) {
  Corotated t;
  t.r[1] = R * B.a;
  t.r[2] = R * B.b;
  t.r[3] = R * B.c;
  t.r[0] = Vector{zero(), zero(), zero()} - (t.r[1] + t.r[2] + t.r[3]);
  return t;
}

/// Stiffness blocks of a few elements, stored entry by entry, then written element by element.
struct BlockBuffer {
  HWY_ALIGN double entry[stiffness_entries][hn::MaxLanes(D())];

  HWY_INLINE void set(int a, int b, const Matrix& block) {
    const D d;
    double(*to)[hn::MaxLanes(D())] = entry + 9 * Tet4Elements::pair_index(a, b);
    const auto column = [&](const Vector& v) HWY_ATTR {
      hn::Store(v.x, d, *to++);
      hn::Store(v.y, d, *to++);
      hn::Store(v.z, d, *to++);
    };
    column(block.a);
    column(block.b);
    column(block.c);
  }
  HWY_INLINE void write(std::size_t first, std::span<Blocks> K) const {
    const std::size_t last = std::min(first + hn::Lanes(D()), K.size());
    for (std::size_t e = first; e < last; ++e) {
      auto* to = reinterpret_cast<double*>(&K[e]);
      for (std::size_t k = 0; k < stiffness_entries; ++k) to[k] = entry[k][e - first];
    }
  }
};

void gradients(const LaneRest& rest, const LaneMatrix& edges, LaneMatrix& F) {
  for (std::size_t i = 0; i < elements_per_batch; i += hn::Lanes(D())) {
    const Matrix E = load(edges, i), Bt = transposed(load(rest.gradients, i));
    store({E * Bt.a, E * Bt.b, E * Bt.c}, F, i);
  }
}

void rotations(LaneStrain& strain) {
  const D d;
  for (std::size_t i = 0; i < elements_per_batch; i += hn::Lanes(d)) {
    M unique;
    store(polar_rotation(load(strain.F, i), unique), strain.R, i);
    if (hn::AllTrue(d, unique)) continue;
    HWY_ALIGN double is_unique[hn::MaxLanes(d)];
    hn::Store(hn::IfThenElseZero(unique, number(1)), d, is_unique);
    for (std::size_t e = 0; e < hn::Lanes(d); ++e) {
      if (is_unique[e] != 0) continue;
      Mat3 F;
      for (std::size_t k = 0; k < 9; ++k) F.data()[k] = strain.F.at[k][i + e];
      const Mat3 R = polar(F).R;
      for (std::size_t k = 0; k < 9; ++k) strain.R.at[k][i + e] = R.data()[k];
    }
  }
}

void energy(const LaneRest& rest, const LaneStrain& strain, double* out) {
  const D d;
  for (std::size_t i = 0; i < elements_per_batch; i += hn::Lanes(d)) {
    const Matrix F = load(strain.F, i), R = load(strain.R, i);
    const Matrix E = {F.a - R.a, F.b - R.b, F.c - R.c};
    const V volume = double_dot(R, F) - number(3);
    const V W = hn::Load(d, rest.mu + i) * double_dot(E, E) +
                number(0.5) * hn::Load(d, rest.lambda + i) * volume * volume;
    hn::StoreU(hn::Load(d, rest.volume + i) * W, d, out + i);
  }
}

void forces(const LaneRest& rest, const LaneStrain& strain, std::span<Tet4Elements::Forces> out) {
  const D d;
  for (std::size_t i = 0; i < out.size(); i += hn::Lanes(d)) {
    const Matrix F = load(strain.F, i), R = load(strain.R, i), B = load(rest.gradients, i);
    const V V0 = hn::Load(d, rest.volume + i), stretch = number(2) * hn::Load(d, rest.mu + i) * V0;
    const V pressure =
        hn::Load(d, rest.lambda + i) * (double_dot(R, F) - number(3)) + hn::Load(d, strain.pressure + i);
    const V turn = pressure * V0 - stretch;
    const Matrix P = {stretch * F.a + turn * R.a, stretch * F.b + turn * R.b, stretch * F.c + turn * R.c};
    write_forces({P * B.a, P * B.b, P * B.c}, i, out);
  }
}

void dilatations(const LaneStrain& strain, std::span<double> theta) {
  const D d;
  for (std::size_t i = 0; i < theta.size(); i += hn::Lanes(d)) {
    HWY_ALIGN double each[hn::MaxLanes(d)];
    hn::Store(double_dot(load(strain.R, i), load(strain.F, i)) - number(3), d, each);
    for (std::size_t e = i; e < std::min(i + hn::Lanes(d), theta.size()); ++e) theta[e] = each[e - i];
  }
}

void turned(const LaneRest& rest, const LaneMatrix& R, std::span<Tet4Elements::Forces> G) {
  const D d;
  for (std::size_t i = 0; i < G.size(); i += hn::Lanes(d)) {
    const Corotated t = corotated_gradients(load(R, i), load(rest.gradients, i));
    const V V0 = hn::Load(d, rest.volume + i);
    write_forces({V0 * t.r[1], V0 * t.r[2], V0 * t.r[3]}, i, G);
  }
}

void stiffness(const LaneRest& rest, const LaneStrain& strain, std::span<Blocks> K) {
  const D d;
  BlockBuffer buffer;
  for (std::size_t i = 0; i < K.size(); i += hn::Lanes(d)) {
    const Matrix R = load(strain.R, i);
    const V V0 = hn::Load(d, rest.volume + i), l = hn::Load(d, rest.lambda + i),
            m = number(2) * hn::Load(d, rest.mu + i), lambda = l * V0, two_mu = m * V0;
    const Matrix C = half_twists(l, m, hn::Load(d, strain.pressure + i), least_corotational_pair, 1e-20,
                                 load(strain.F, i), R);
    const Corotated t = corotated_gradients(R, load(rest.gradients, i));
    for (int a = 0; a < 3; ++a) {
      // Rows of V [r_a]ₓ ½C.
      const Vector va = V0 * t.r[a];
      const Matrix X = transposed({cross(va, C.a), cross(va, C.b), cross(va, C.c)});
      const Vector la = lambda * t.r[a];
      for (int b = a + 1; b < 4; ++b) {
        const Vector& r = t.r[b];
        const V diagonal = two_mu * dot(t.r[a], r);
        Matrix rows = {la.x * r + cross(r, X.a), la.y * r + cross(r, X.b), la.z * r + cross(r, X.c)};
        rows.a.x = rows.a.x + diagonal;
        rows.b.y = rows.b.y + diagonal;
        rows.c.z = rows.c.z + diagonal;
        buffer.set(a, b, transposed(rows));
      }
    }
    buffer.write(i, K);
  }
}

void warped_stiffness(const LaneRest& rest, const LaneMatrix& R, std::span<Blocks> K) {
  const D d;
  BlockBuffer buffer;
  for (std::size_t i = 0; i < K.size(); i += hn::Lanes(d)) {
    const V V0 = hn::Load(d, rest.volume + i), lambda = hn::Load(d, rest.lambda + i) * V0,
            mu = hn::Load(d, rest.mu + i) * V0;
    const Corotated t = corotated_gradients(load(R, i), load(rest.gradients, i));
    for (int a = 0; a < 3; ++a) {
      const Vector la = lambda * t.r[a], ma = mu * t.r[a];
      for (int b = a + 1; b < 4; ++b) {
        const Vector& r = t.r[b];
        const V diagonal = dot(ma, r);
        Matrix block = {r.x * la + ma.x * r, r.y * la + ma.y * r, r.z * la + ma.z * r};
        block.a.x = block.a.x + diagonal;
        block.b.y = block.b.y + diagonal;
        block.c.z = block.c.z + diagonal;
        buffer.set(a, b, block);
      }
    }
    buffer.write(i, K);
  }
}

/// Writes vector registers of floats element by element, `stride` floats apart.
struct FloatBuffer {
  HWY_ALIGN float entry[hn::MaxLanes(D())];

  HWY_INLINE void scatter(Single value, float* to, std::size_t stride, std::size_t count) {
    hn::Store(value, hn::Rebind<float, D>(), entry);
    for (std::size_t e = 0; e < count; ++e) to[stride * e] = entry[e];
  }
  HWY_INLINE void scatter(const VectorOf<Single>& value, float* to, std::size_t stride, std::size_t count) {
    scatter(value.x, to, stride, count);
    scatter(value.y, to + 1, stride, count);
    scatter(value.z, to + 2, stride, count);
  }
};

void corotated_elements(const LaneRest& rest, const LaneStrain& strain, double share,
                        std::span<CorotatedVector> gradients, std::span<Twist> twists) {
  const D d;
  FloatBuffer buffer;
  for (std::size_t i = 0; i < twists.size(); i += hn::Lanes(d)) {
    const std::size_t count = std::min(hn::Lanes(d), twists.size() - i);
    const Matrix R = load(strain.R, i);
    const V mu = hn::Load(d, rest.mu + i), lambda = hn::Load(d, rest.lambda + i);
    const Corotated t = corotated_gradients(R, load(rest.gradients, i));
    const V size = hn::Sqrt(hn::Load(d, rest.volume + i) * mu);
    for (std::size_t a = 0; a < 4; ++a)
      buffer.scatter(single(size * t.r[a]), gradients[4 * i + a].at, 16, count);
    float* to = twists[i].column[0].at;
    buffer.scatter(single(lambda / mu), to + 3, 12, count);
    const V pressure = hn::Load(d, strain.pressure + i) / mu;
    MatrixOf<Single> T = half_twists(single(lambda / mu), number<Single>(2), single(pressure),
                                     least_corotational_pair, 1e-12, single(load(strain.F, i)), single(R));
    const Single part = number<Single>(share), rest_of_it = number<Single>(share - 1);
    T = {part * T.a, part * T.b, part * T.c};
    T.a.x = T.a.x + rest_of_it;
    T.b.y = T.b.y + rest_of_it;
    T.c.z = T.c.z + rest_of_it;
    buffer.scatter(T.a, to, 12, count);
    buffer.scatter(T.b, to + 4, 12, count);
    buffer.scatter(T.c, to + 8, 12, count);
  }
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace prosector::soft {

HWY_EXPORT(gradients);
HWY_EXPORT(rotations);
HWY_EXPORT(energy);
HWY_EXPORT(forces);
HWY_EXPORT(dilatations);
HWY_EXPORT(turned);
HWY_EXPORT(stiffness);
HWY_EXPORT(warped_stiffness);
HWY_EXPORT(corotated_elements);

void lane_gradients(const LaneRest& rest, const LaneMatrix& edges, LaneMatrix& F) {
  HWY_DYNAMIC_DISPATCH(gradients)(rest, edges, F);
}
void lane_rotations(LaneStrain& strain) {
  HWY_DYNAMIC_DISPATCH(rotations)(strain);
}
void lane_corotational_energy(const LaneRest& rest, const LaneStrain& strain, double* out) {
  HWY_DYNAMIC_DISPATCH(energy)(rest, strain, out);
}
void lane_corotational_forces(const LaneRest& rest, const LaneStrain& strain,
                              std::span<Tet4Elements::Forces> out) {
  HWY_DYNAMIC_DISPATCH(forces)(rest, strain, out);
}
void lane_corotational_dilatations(const LaneStrain& strain, std::span<double> theta) {
  HWY_DYNAMIC_DISPATCH(dilatations)(strain, theta);
}
void lane_turned_gradients(const LaneRest& rest, const LaneMatrix& R, std::span<Tet4Elements::Forces> G) {
  HWY_DYNAMIC_DISPATCH(turned)(rest, R, G);
}
void lane_corotational_stiffness(const LaneRest& rest, const LaneStrain& strain,
                                 std::span<Tet4Elements::Stiffness> K) {
  HWY_DYNAMIC_DISPATCH(stiffness)(rest, strain, K);
}
void lane_warped_stiffness(const LaneRest& rest, const LaneMatrix& R, std::span<Tet4Elements::Stiffness> K) {
  HWY_DYNAMIC_DISPATCH(warped_stiffness)(rest, R, K);
}
void lane_turned_elements(const LaneRest& rest, const LaneStrain& strain, double share,
                          std::span<CorotatedVector> gradients, std::span<Twist> twists) {
  HWY_DYNAMIC_DISPATCH(corotated_elements)(rest, strain, share, gradients, twists);
}

}  // namespace prosector::soft
#endif
