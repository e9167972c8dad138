#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/mechanics/soft/elements/isotropic_kernel.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// Must follow foreach_target.h, which includes these headers again.
#include <cmath>

#include "server/physics/mechanics/soft/elements/isotropic_kernel.h"
#include "server/physics/mechanics/soft/elements/lane_forces.h"
#include "server/physics/mechanics/soft/simd/lane_principal.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

using Single3 = VectorOf<Single>;

HWY_INLINE Matrix identity() {
  const V o = zero(), i = number(1);
  return {{i, o, o}, {o, i, o}, {o, o, i}};
}
HWY_INLINE Matrix operator*(V s, const Matrix& A) {
  return {s * A.a, s * A.b, s * A.c};
}
HWY_INLINE Matrix operator+(const Matrix& A, const Matrix& B) {
  return {A.a + B.a, A.b + B.b, A.c + B.c};
}
HWY_INLINE Matrix operator*(const Matrix& A, const Matrix& B) {
  return {A * B.a, A * B.b, A * B.c};
}
HWY_INLINE V trace(const Matrix& A) {
  return A.a.x + A.b.y + A.c.z;
}
/// Returns the energy density μ‖E‖² + λ/2 tr²E of a strain E.
HWY_INLINE V quadratic_energy(V lambda, V mu, const Matrix& E) {
  const V tr = trace(E);
  return mu * double_dot(E, E) + number(0.5) * lambda * tr * tr;
}
HWY_INLINE Matrix cofactor(const Matrix& F) {
  return {cross(F.b, F.c), cross(F.c, F.a), cross(F.a, F.b)};
}
/// Returns the natural logarithm of 1 + x in each lane, computed lane by lane by the C library.
HWY_INLINE V log1p(V x) {
  const D d;
  HWY_ALIGN double each[hn::MaxLanes(d)];
  hn::Store(x, d, each);
  for (std::size_t e = 0; e < hn::Lanes(d); ++e) each[e] = std::log1p(each[e]);
  return hn::Load(d, each);
}

/// A law's tangent relative to μ, in the frame of the principal directions, not projected. `twist` and `flip`
/// are its eigenvalues for the antisymmetric and symmetric change of two axes, by the third axis. `scaling`
/// is its symmetric matrix for changes of the principal stretches. `dilatation` is the derivative of the
/// law's volume change by the principal stretches.
struct PrincipalTangent {
  Single3 twist, flip;
  SymmetricOf<Single> scaling;
  Single3 dilatation;
};

// Formulas: fem_linear.cpp, fem_stvk.cpp and fem_neo_hookean.cpp.

struct LinearLanes {
  static constexpr bool objective = false;
  V lambda, mu;

  static Matrix strain(const Matrix& F) {
    const Matrix I = identity();
    return number(0.5) * (F + transposed(F)) + number(-1) * I;
  }
  V energy(const Matrix& F) const { return quadratic_energy(lambda, mu, strain(F)); }
  Matrix stress(const Matrix& F, V pressure) const {
    const Matrix E = strain(F);
    return number(2) * mu * E + (lambda * trace(E) + pressure) * identity();
  }
  static V dilatation(const Matrix& F) { return trace(F) - number(3); }
  static Matrix dilatation_gradient(const Matrix&) { return identity(); }
  PrincipalTangent principal(const Matrix&, V, const Single3&) const {
    const Single l = single(lambda / mu), d = l + number<Single>(2), two = number<Single>(2),
                 one = number<Single>(1), none = zero<Single>();
    return {{none, none, none}, {two, two, two}, {d, d, d, l, l, l}, {one, one, one}};
  }
};

struct StVKLanes {
  static constexpr bool objective = true;
  V lambda, mu;

  /// Returns Green's strain E = (FᵀF − I)/2.
  static Matrix green(const Matrix& F) {
    const V half = number(0.5), xy = half * dot(F.a, F.b), xz = half * dot(F.a, F.c),
            yz = half * dot(F.b, F.c);
    return {{half * (dot(F.a, F.a) - number(1)), xy, xz},
            {xy, half * (dot(F.b, F.b) - number(1)), yz},
            {xz, yz, half * (dot(F.c, F.c) - number(1))}};
  }
  V energy(const Matrix& F) const { return quadratic_energy(lambda, mu, green(F)); }
  Matrix stress(const Matrix& F, V pressure) const {
    const Matrix E = green(F);
    return F * (number(2) * mu * E + (lambda * trace(E) + pressure) * identity());
  }
  static V dilatation(const Matrix& F) { return trace(green(F)); }
  static Matrix dilatation_gradient(const Matrix& F) { return F; }
  PrincipalTangent principal(const Matrix& F, V pressure, const Single3& s) const {
    const Single l = single(lambda / mu), k = single((lambda * trace(green(F)) + pressure) / mu),
                 one = number<Single>(1), three = number<Single>(3);
    const Single3 squares = {s.x * s.x, s.y * s.y, s.z * s.z};
    const Single yz = s.y * s.z, xz = s.x * s.z, xy = s.x * s.y;
    const Single3 sums = {k + squares.y + squares.z - one, k + squares.x + squares.z - one,
                          k + squares.x + squares.y - one};
    const auto diagonal = [&](Single square) HWY_ATTR { return l * square + k + three * square - one; };
    return {{sums.x - yz, sums.y - xz, sums.z - xy},
            {sums.x + yz, sums.y + xz, sums.z + xy},
            {diagonal(squares.x), diagonal(squares.y), diagonal(squares.z), l * xy, l * xz, l * yz},
            s};
  }
};

/// Both neo-Hookean laws. With W = m/2 (I_C − 3) + Λ/2 (J − α)² − b/2 ln((I_C + 1)/4): `m` = m, `volume` = Λ,
/// `alpha` = α, `barrier` = b.
template <bool logarithmic>
struct NeoHookeanLanes {
  static constexpr bool objective = true;
  V mu, m, volume, alpha;

  NeoHookeanLanes(V lambda, V mu_of_lame) : mu(mu_of_lame) {
    if constexpr (logarithmic) {
      m = number(4) * mu / number(3);
      volume = lambda + number(5) * mu / number(6);
      alpha = number(1) + number(3) * m / (number(4) * volume);
    } else {
      m = mu;
      volume = lambda + mu;
      alpha = number(1) + mu / volume;
    }
  }
  static V determinant(const Matrix& F) { return dot(F.a, cross(F.b, F.c)); }
  V shear(V I) const { return logarithmic ? m - m / (I + number(1)) : m; }

  V energy(const Matrix& F) const {
    const V I = double_dot(F, F) - number(3), dJ = determinant(F) - number(1);
    const V W = number(0.5) * (m * I + volume * dJ * (dJ + number(2) * (number(1) - alpha)));
    return logarithmic ? W - number(0.5) * m * log1p(I / number(4)) : W;
  }
  Matrix stress(const Matrix& F, V pressure) const {
    const V k = volume * (determinant(F) - alpha) + pressure;
    return shear(double_dot(F, F)) * F + k * cofactor(F);
  }
  static V dilatation(const Matrix& F) { return determinant(F) - number(1); }
  static Matrix dilatation_gradient(const Matrix& F) { return cofactor(F); }
  PrincipalTangent principal(const Matrix& F, V pressure, const Single3& s) const {
    const V I = double_dot(F, F), I1 = I + number(1);
    const Single a = single(shear(I) / mu), k = single((volume * (determinant(F) - alpha) + pressure) / mu),
                 slope = logarithmic ? single(number(2) * m / (I1 * I1 * mu)) : zero<Single>(),
                 bulk = single(volume / mu);
    const Single3 g = {s.y * s.z, s.x * s.z, s.x * s.y}, ks = k * s;
    const auto pair = [&](Single s_i, Single s_j, Single g_i, Single g_j)
                          HWY_ATTR { return slope * s_i * s_j + bulk * g_i * g_j; };
    return {
        {a + ks.x, a + ks.y, a + ks.z},
        {a - ks.x, a - ks.y, a - ks.z},
        {pair(s.x, s.x, g.x, g.x) + a, pair(s.y, s.y, g.y, g.y) + a, pair(s.z, s.z, g.z, g.z) + a,
         pair(s.x, s.y, g.x, g.y) + ks.z, pair(s.x, s.z, g.x, g.z) + ks.y, pair(s.y, s.z, g.y, g.z) + ks.x},
        g};
  }
};

/// Calls f(lanes of the law, F, first lane) for each register of elements below `count`.
template <class Law, class Call>
HWY_INLINE void for_lanes(const LaneRest& rest, const LaneMatrix& F, std::size_t count, const Call& f) {
  const D d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
    f(Law{hn::Load(d, rest.lambda + i), hn::Load(d, rest.mu + i)}, load(F, i), i);
}

template <class Law>
void energy_of(const LaneRest& rest, const LaneStrain& strain, double* out) {
  const D d;
  for_lanes<Law>(rest, strain.F, elements_per_batch,
                 [&](const Law& law, const Matrix& F, std::size_t i)
                     HWY_ATTR { hn::StoreU(hn::Load(d, rest.volume + i) * law.energy(F), d, out + i); });
}

template <class Law>
void forces_of(const LaneRest& rest, const LaneStrain& strain, std::span<Tet4Elements::Forces> out) {
  const D d;
  for_lanes<Law>(rest, strain.F, out.size(), [&](const Law& law, const Matrix& F, std::size_t i) HWY_ATTR {
    const Matrix P = hn::Load(d, rest.volume + i) * law.stress(F, hn::Load(d, strain.pressure + i));
    write_forces(P * load(rest.gradients, i), i, out);
  });
}

template <class Law>
void dilatations_of(const LaneStrain& strain, std::span<double> theta) {
  const D d;
  for (std::size_t i = 0; i < theta.size(); i += hn::Lanes(d)) {
    HWY_ALIGN double each[hn::MaxLanes(d)];
    hn::Store(Law::dilatation(load(strain.F, i)), d, each);
    for (std::size_t e = i; e < std::min(i + hn::Lanes(d), theta.size()); ++e) theta[e] = each[e - i];
  }
}

template <class Law>
void dilatation_forces_of(const LaneRest& rest, const LaneStrain& strain, std::span<Tet4Elements::Forces> G) {
  const D d;
  for (std::size_t i = 0; i < G.size(); i += hn::Lanes(d)) {
    const Matrix T = hn::Load(d, rest.volume + i) * Law::dilatation_gradient(load(strain.F, i));
    write_forces(T * load(rest.gradients, i), i, G);
  }
}

/// Raises the negative eigenvalues of a symmetric 3×3 matrix to 0 in each lane; others keep their bits.
HWY_INLINE void raise_negative(SymmetricOf<Single>& A) {
  using Tag = hn::DFromV<Single>;
  const Single none = zero<Single>(), one = number<Single>(1);
  // Scaled, so that products do not overflow.
  const Single size = hn::Max(hn::Max(hn::Abs(A.xx), hn::Abs(A.yy)), hn::Max(hn::Abs(A.zz), one));
  const Single part = one / size;
  SymmetricOf<Single> B = {part * A.xx, part * A.yy, part * A.zz, part * A.xy, part * A.xz, part * A.yz};
  const Single minor = B.xx * B.yy - B.xy * B.xy;
  const Single determinant = B.xx * (B.yy * B.zz - B.yz * B.yz) - B.xy * (B.xy * B.zz - B.yz * B.xz) +
                             B.xz * (B.xy * B.yz - B.yy * B.xz);
  const auto positive = hn::And(hn::And(B.xx > none, minor > none), determinant > none);
  if (hn::AllTrue(Tag(), positive)) return;
  MatrixOf<Single> u = {{one, none, none}, {none, one, none}, {none, none, one}};
  diagonalise(B, u, 1e-12);
  const auto raised = [&](Single value) HWY_ATTR { return size * hn::Max(value, none); };
  const Single3 a = raised(B.xx) * u.a, b = raised(B.yy) * u.b, c = raised(B.zz) * u.c;
  const auto choose = [&](Single& old, Single other) HWY_ATTR { old = hn::IfThenElse(positive, old, other); };
  choose(A.xx, a.x * u.a.x + b.x * u.b.x + c.x * u.c.x);
  choose(A.yy, a.y * u.a.y + b.y * u.b.y + c.y * u.c.y);
  choose(A.zz, a.z * u.a.z + b.z * u.b.z + c.z * u.c.z);
  choose(A.xy, a.x * u.a.y + b.x * u.b.y + c.x * u.c.y);
  choose(A.xz, a.x * u.a.z + b.x * u.b.z + c.x * u.c.z);
  choose(A.yz, a.y * u.a.z + b.y * u.b.z + c.y * u.c.z);
}

/// Projects the tangent, and mixes it with the linear elastic stiffness as lane_point_tangents() says.
HWY_INLINE void project_and_mix(PrincipalTangent& t, double share, Single lame_ratio) {
  raise_negative(t.scaling);
  const Single part = number<Single>(share), rest = number<Single>(1 - share), none = zero<Single>();
  const Single all = rest * lame_ratio, twice = number<Single>(2) * rest;
  const auto mix = [&](Single& value, Single other) HWY_ATTR { value = part * value + other; };
  for (Single* value : {&t.scaling.xx, &t.scaling.yy, &t.scaling.zz}) mix(*value, all + twice);
  for (Single* value : {&t.scaling.xy, &t.scaling.xz, &t.scaling.yz}) mix(*value, all);
  for (Single* value : {&t.flip.x, &t.flip.y, &t.flip.z}) mix(*value = hn::Max(*value, none), twice);
  for (Single* value : {&t.twist.x, &t.twist.y, &t.twist.z}) mix(*value = hn::Max(*value, none), none);
}

/// Six entries of a symmetric matrix, in the order xx, yy, zz, xy, xz, yz.
struct Six {
  Single at[6];
};
HWY_INLINE Six square(const Single3& u) {
  return {{u.x * u.x, u.y * u.y, u.z * u.z, u.x * u.y, u.x * u.z, u.y * u.z}};
}
/// Returns u vᵀ + v uᵀ.
HWY_INLINE Six twice_product(const Single3& u, const Single3& v) {
  const Single xx = u.x * v.x, yy = u.y * v.y, zz = u.z * v.z;
  return {{xx + xx, yy + yy, zz + zz, u.x * v.y + u.y * v.x, u.x * v.z + u.z * v.x, u.y * v.z + u.z * v.y}};
}
HWY_INLINE Six sum(Single a, const Six& A, Single b, const Six& B, Single c, const Six& C) {
  Six out;
  for (int k = 0; k < 6; ++k) out.at[k] = a * A.at[k] + b * B.at[k] + c * C.at[k];
  return out;
}
HWY_INLINE Six scaled(Single a, const Six& A) {
  Six out;
  for (int k = 0; k < 6; ++k) out.at[k] = a * A.at[k];
  return out;
}

/// Writes a tangent, rotated from the frame of the principal directions u to the world's.
HWY_INLINE void write_tangent(const PrincipalTangent& t, const MatrixOf<Single>& u, std::size_t i,
                              PointTangents& out) {
  const hn::DFromV<Single> d;
  const Single half = number<Single>(0.5);
  const Six P[3] = {square(u.a), square(u.b), square(u.c)};
  const SymmetricOf<Single>& A = t.scaling;
  const Six G[3] = {sum(A.xx, P[0], A.xy, P[1], A.xz, P[2]), sum(A.xy, P[0], A.yy, P[1], A.yz, P[2]),
                    sum(A.xz, P[0], A.yz, P[1], A.zz, P[2])};
  const Six Q[3] = {twice_product(u.b, u.c), twice_product(u.a, u.c), twice_product(u.a, u.b)};
  const Six H[3] = {scaled(half * t.flip.x, Q[0]), scaled(half * t.flip.y, Q[1]),
                    scaled(half * t.flip.z, Q[2])};
  for (std::size_t v = 0; v < 6; ++v)
    for (std::size_t w = v; w < 6; ++w) {
      Single total = P[0].at[v] * G[0].at[w];
      for (int k = 1; k < 3; ++k) total = hn::MulAdd(P[k].at[v], G[k].at[w], total);
      for (int k = 0; k < 3; ++k) total = hn::MulAdd(Q[k].at[v], H[k].at[w], total);
      hn::Store(total, d, out.symmetric[PointTangents::entry(v, w)] + i);
    }
  const Six W = sum(half * t.twist.x, P[0], half * t.twist.y, P[1], half * t.twist.z, P[2]);
  const Six theta = sum(t.dilatation.x, P[0], t.dilatation.y, P[1], t.dilatation.z, P[2]);
  for (int k = 0; k < 6; ++k) {
    hn::Store(W.at[k], d, out.rotational[k] + i);
    hn::Store(theta.at[k], d, out.dilatation[k] + i);
  }
}

/// Writes r_a = √(Vμ)·R·b_a of all four nodes.
HWY_INLINE void write_gradients(const Matrix& R, const Matrix& B, V size, std::size_t i, PointTangents& out) {
  const hn::DFromV<Single> d;
  const Matrix RB = size * (R * B);
  const Vector r[4] = {Vector{zero(), zero(), zero()} - (RB.a + RB.b + RB.c), RB.a, RB.b, RB.c};
  for (std::size_t a = 0; a < 4; ++a) {
    hn::Store(single(r[a].x), d, out.gradient[3 * a] + i);
    hn::Store(single(r[a].y), d, out.gradient[3 * a + 1] + i);
    hn::Store(single(r[a].z), d, out.gradient[3 * a + 2] + i);
  }
}

template <class Law>
void point_tangents_of(const LaneRest& rest, const LaneStrain& strain, double share, PointTangents& out) {
  const D d;
  for_lanes<Law>(
      rest, strain.F, elements_per_batch, [&](const Law& law, const Matrix& F, std::size_t i) HWY_ATTR {
        const V mu = hn::Load(d, rest.mu + i);
        const Matrix R = Law::objective ? load(strain.R, i) : identity();
        MatrixOf<Single> u = single(R);
        Single3 s = {number<Single>(1), number<Single>(1), number<Single>(1)};
        if constexpr (Law::objective) {
          SymmetricOf<Single> S = stretch(single(F), u);
          diagonalise(S, u, 1e-12);
          s = {S.xx, S.yy, S.zz};
        }
        PrincipalTangent t = law.principal(F, hn::Load(d, strain.pressure + i), s);
        const Single lame_ratio = single(hn::Load(d, rest.lambda + i) / mu);
        project_and_mix(t, share, lame_ratio);
        hn::Store(lame_ratio, hn::DFromV<Single>(), out.lame_ratio + i);
        write_tangent(t, u, i, out);
        write_gradients(R, load(rest.gradients, i), hn::Sqrt(hn::Load(d, rest.volume + i) * mu), i, out);
      });
}

/// Calls f.template operator()<Lanes>() with the lanes of a law.
template <class Call>
HWY_INLINE void with_law(IsotropicLaw law, const Call& f) {
  switch (law) {
    case IsotropicLaw::fem_linear:
      return f.template operator()<LinearLanes>();
    case IsotropicLaw::fem_stvk:
      return f.template operator()<StVKLanes>();
    case IsotropicLaw::fem_neo_hookean:
      return f.template operator()<NeoHookeanLanes<true>>();
    case IsotropicLaw::fem_neo_hookean_polynomial:
      return f.template operator()<NeoHookeanLanes<false>>();
  }
}

void energy(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain, double* out) {
  with_law(law, [&]<class Law>() { energy_of<Law>(rest, strain, out); });
}
void forces(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain,
            std::span<Tet4Elements::Forces> out) {
  with_law(law, [&]<class Law>() { forces_of<Law>(rest, strain, out); });
}
void dilatations(IsotropicLaw law, const LaneStrain& strain, std::span<double> theta) {
  with_law(law, [&]<class Law>() { dilatations_of<Law>(strain, theta); });
}
void dilatation_forces(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain,
                       std::span<Tet4Elements::Forces> G) {
  with_law(law, [&]<class Law>() { dilatation_forces_of<Law>(rest, strain, G); });
}
void point_tangents(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain, double share,
                    PointTangents& out) {
  with_law(law, [&]<class Law>() { point_tangents_of<Law>(rest, strain, share, out); });
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace prosector::soft {

HWY_EXPORT(energy);
HWY_EXPORT(forces);
HWY_EXPORT(dilatations);
HWY_EXPORT(dilatation_forces);
HWY_EXPORT(point_tangents);

void lane_energy(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain, double* out) {
  HWY_DYNAMIC_DISPATCH(energy)(law, rest, strain, out);
}
void lane_forces(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain,
                 std::span<Tet4Elements::Forces> out) {
  HWY_DYNAMIC_DISPATCH(forces)(law, rest, strain, out);
}
void lane_dilatations(IsotropicLaw law, const LaneStrain& strain, std::span<double> theta) {
  HWY_DYNAMIC_DISPATCH(dilatations)(law, strain, theta);
}
void lane_dilatation_forces(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain,
                            std::span<Tet4Elements::Forces> G) {
  HWY_DYNAMIC_DISPATCH(dilatation_forces)(law, rest, strain, G);
}
void lane_point_tangents(IsotropicLaw law, const LaneRest& rest, const LaneStrain& strain, double share,
                         PointTangents& out) {
  HWY_DYNAMIC_DISPATCH(point_tangents)(law, rest, strain, share, out);
}

}  // namespace prosector::soft
#endif
