#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/mechanics/soft/elements/element_blocks.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// Must follow foreach_target.h, which includes these headers again.
#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/soft/elements/element_blocks.h"
#include "server/physics/mechanics/soft/elements/tet10_shares.h"
#include "server/physics/mechanics/soft/simd/lane_math.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

using Tag = hn::CappedTag<float, 16>;  // a quarter of a batch at most
using T = hn::Vec<Tag>;
using Vector3 = VectorOf<T>;
constexpr std::size_t quadratic_per_batch = elements_per_batch / 4;

/// Tangents at one point of several elements; `fiber` and `along_fiber` count with `has_fibers` only.
struct Tangent {
  T symmetric[21], rotational[6], fiber[3], along_fiber[6];
  bool has_fibers;

  /// Loads the tangent. row(r) returns the register of these elements in a row r of `points`.
  template <class Points, class Row>
  HWY_INLINE Tangent(const Points& points, const Row& row) : has_fibers(points.has_fibers) {
    for (std::size_t k = 0; k < 21; ++k) symmetric[k] = row(points.symmetric[k]);
    for (std::size_t k = 0; k < 6; ++k) rotational[k] = row(points.rotational[k]);
    for (std::size_t k = 0; k < 3; ++k) fiber[k] = has_fibers ? row(points.fiber[k]) : hn::Zero(Tag());
    for (std::size_t k = 0; k < 6; ++k)
      along_fiber[k] = has_fibers ? row(points.along_fiber[k]) : hn::Zero(Tag());
  }
};

/// The part of an element's stiffness that belongs to one node a: column j of the block of nodes a and b is
/// Σ_l y[j][l] r_b,l.
struct NodeRow {
  Vector3 y[3][3];

  HWY_INLINE NodeRow(const Tangent& t, const Vector3& r) {
    const auto D = [&](std::size_t v, std::size_t w)
                       HWY_ATTR { return t.symmetric[PointTangents::entry(std::min(v, w), std::max(v, w))]; };
    const auto column = [&](std::size_t v) HWY_ATTR {
      return Vector3{sum(D(0, v), r.x, D(3, v), r.y, D(4, v), r.z),
                     sum(D(3, v), r.x, D(1, v), r.y, D(5, v), r.z),
                     sum(D(4, v), r.x, D(5, v), r.y, D(2, v), r.z)};
    };
    const T* W = t.rotational;
    const Vector3 xy = column(3), xz = column(4), yz = column(5);
    const Vector3 X = cross(r, Vector3{W[0], W[3], W[4]}), Y = cross(r, Vector3{W[3], W[1], W[5]}),
                  Z = cross(r, Vector3{W[4], W[5], W[2]});  // [r]ₓW
    y[0][0] = column(0);
    y[1][1] = column(1);
    y[2][2] = column(2);
    y[0][1] = xy + Z;
    y[1][0] = xy - Z;
    y[0][2] = xz - Y;
    y[2][0] = xz + Y;
    y[1][2] = yz + X;
    y[2][1] = yz - X;
    if (t.has_fibers) add_fibers(t, r);
  }
  HWY_INLINE void add_fibers(const Tangent& t, const Vector3& r) {
    const T* Q = t.along_fiber;
    const T along = sum(t.fiber[0], r.x, t.fiber[1], r.y, t.fiber[2], r.z);
    const Vector3 columns[3] = {{Q[0], Q[3], Q[4]}, {Q[3], Q[1], Q[5]}, {Q[4], Q[5], Q[2]}};
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t l = 0; l < 3; ++l) y[j][l] = y[j][l] + (along * t.fiber[l]) * columns[j];
  }
  static HWY_INLINE T sum(T a, T x, T b, T y, T c, T z) { return hn::MulAdd(a, x, hn::MulAdd(b, y, c * z)); }
  HWY_INLINE Vector3 column(std::size_t j, const Vector3& r) const {
    const Vector3 *x = &y[j][0], *xx = &y[j][1], *xxx = &y[j][2];
    return {sum(x->x, r.x, xx->x, r.y, xxx->x, r.z), sum(x->y, r.x, xx->y, r.y, xxx->y, r.z),
            sum(x->z, r.x, xx->z, r.y, xxx->z, r.z)};
  }
};

/// Blocks of several elements, number by number.
template <std::size_t floats>
struct BlockLanes {
  HWY_ALIGN float at[floats][hn::MaxLanes(Tag())];

  HWY_INLINE void add(std::size_t place, const Vector3& v) {
    const Tag d;
    const auto one = [&](float* to, T x) HWY_ATTR { hn::Store(hn::Load(d, to) + x, d, to); };
    one(at[place], v.x);
    one(at[place + 1], v.y);
    one(at[place + 2], v.z);
  }
  HWY_INLINE void set(std::size_t place, const Vector3& v) {
    const Tag d;
    hn::Store(v.x, d, at[place]);
    hn::Store(v.y, d, at[place + 1]);
    hn::Store(v.z, d, at[place + 2]);
  }
  HWY_INLINE void clear() {
    for (auto& row : at) hn::Store(hn::Zero(Tag()), Tag(), row);
  }
  /// Writes the elements from `first` on, element by element.
  HWY_INLINE void write(std::size_t first, std::span<float> blocks) const {
    const Tag d;
    const std::size_t count = std::min(hn::Lanes(d), blocks.size() / floats - first);
    float* const to = blocks.data() + floats * first;
    HWY_ALIGN float four[4 * hn::MaxLanes(d)];
    std::size_t k = 0;
    for (; k + 4 <= floats; k += 4) {
      hn::StoreInterleaved4(hn::Load(d, at[k]), hn::Load(d, at[k + 1]), hn::Load(d, at[k + 2]),
                            hn::Load(d, at[k + 3]), d, four);
      for (std::size_t e = 0; e < count; ++e) std::copy_n(four + 4 * e, 4, to + floats * e + k);
    }
    for (; k < floats; ++k)
      for (std::size_t e = 0; e < count; ++e) to[floats * e + k] = at[k][e];
  }
};

void tet4_blocks(const PointTangents& points, std::span<float> blocks) {
  const Tag d;
  BlockLanes<floats_per_tet4> out;
  for (std::size_t i = 0; floats_per_tet4 * i < blocks.size(); i += hn::Lanes(d)) {
    const Tangent t(points, [&](const float* row) HWY_ATTR { return hn::Load(d, row + i); });
    const auto gradient = [&](std::size_t a) HWY_ATTR {
      return Vector3{hn::Load(d, points.gradient[3 * a] + i), hn::Load(d, points.gradient[3 * a + 1] + i),
                     hn::Load(d, points.gradient[3 * a + 2] + i)};
    };
    std::size_t place = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const NodeRow row(t, gradient(a));
      for (std::size_t b = a + 1; b < 4; ++b) {
        const Vector3 r = gradient(b);
        for (std::size_t j = 0; j < 3; ++j, place += 3) out.set(place, row.column(j, r));
      }
    }
    out.write(i, blocks);
  }
}

/// Separates the four points of each element: to[q][e] = from[4e + q].
HWY_INLINE void separate(const float* from, float (*to)[quadratic_per_batch]) {
  const Tag d;
  for (std::size_t e = 0; e < quadratic_per_batch; e += hn::Lanes(d)) {
    T q0, q1, q2, q3;
    hn::LoadInterleaved4(d, from + 4 * e, q0, q1, q2, q3);
    hn::Store(q0, d, to[0] + e);
    hn::Store(q1, d, to[1] + e);
    hn::Store(q2, d, to[2] + e);
    hn::Store(q3, d, to[3] + e);
  }
}

/// The rows of PointTangents, by point of an element.
struct SeparatedPoints {
  HWY_ALIGN float gradient[12][4][quadratic_per_batch], symmetric[21][4][quadratic_per_batch],
      rotational[6][4][quadratic_per_batch], dilatation[6][4][quadratic_per_batch],
      fiber[3][4][quadratic_per_batch], along_fiber[6][4][quadratic_per_batch];
  bool has_fibers;

  explicit SeparatedPoints(const PointTangents& points) : has_fibers(points.has_fibers) {
    for (std::size_t k = 0; k < 12; ++k) separate(points.gradient[k], gradient[k]);
    for (std::size_t k = 0; k < 21; ++k) separate(points.symmetric[k], symmetric[k]);
    for (std::size_t k = 0; k < 6; ++k) separate(points.rotational[k], rotational[k]);
    for (std::size_t k = 0; k < 6; ++k) separate(points.dilatation[k], dilatation[k]);
    if (!has_fibers) return;
    for (std::size_t k = 0; k < 3; ++k) separate(points.fiber[k], fiber[k]);
    for (std::size_t k = 0; k < 6; ++k) separate(points.along_fiber[k], along_fiber[k]);
  }
};

/// Returns the gradients of the ten shape functions at point q, in the order of the element's nodes.
HWY_INLINE void node_gradients(const SeparatedPoints& points, std::size_t q, std::size_t e, Vector3* r) {
  const Tag d;
  for (std::size_t n = 0; n < 10; ++n) {
    const Tet10Share& s = tet10_shares[q][n];
    const auto entry = [&](std::size_t k) HWY_ATTR {
      const T first = hn::Set(d, static_cast<float>(s.weight[0])) *
                      hn::Load(d, points.gradient[3 * s.corner[0] + k][q] + e);
      return hn::MulAdd(hn::Set(d, static_cast<float>(s.weight[1])),
                        hn::Load(d, points.gradient[3 * s.corner[1] + k][q] + e), first);
    };
    r[n] = {entry(0), entry(1), entry(2)};
  }
}

/// Adds sum_a sum_bᵀ of all pairs of nodes a < b, times `factor`.
HWY_INLINE void add_products(T factor, const Vector3* sum, BlockLanes<floats_per_tet10>& out) {
  std::size_t place = 0;
  for (std::size_t a = 0; a < 9; ++a) {
    const Vector3 own = factor * sum[a];
    for (std::size_t b = a + 1; b < 10; ++b) {
      out.add(place, sum[b].x * own);
      out.add(place + 3, sum[b].y * own);
      out.add(place + 6, sum[b].z * own);
      place += 9;
    }
  }
}

void tet10_blocks(const PointTangents& points, std::span<const double> mean_share, double share,
                  std::span<float> blocks) {
  const Tag d;
  const SeparatedPoints separated(points);
  BlockLanes<floats_per_tet10> out;
  for (std::size_t e = 0; floats_per_tet10 * e < blocks.size(); e += hn::Lanes(d)) {
    out.clear();
    Vector3 dilating[10], turned[10];
    for (std::size_t n = 0; n < 10; ++n) {
      const T none = hn::Zero(d);
      dilating[n] = turned[n] = {none, none, none};
    }
    for (std::size_t q = 0; q < 4; ++q) {
      const Tangent t(separated, [&](const float(*row)[quadratic_per_batch])
                                     HWY_ATTR { return hn::Load(d, row[q] + e); });
      Vector3 r[10];
      node_gradients(separated, q, e, r);
      std::size_t place = 0;
      for (std::size_t a = 0; a < 9; ++a) {
        const NodeRow row(t, r[a]);
        for (std::size_t b = a + 1; b < 10; ++b)
          for (std::size_t j = 0; j < 3; ++j, place += 3) out.add(place, row.column(j, r[b]));
      }
      if (mean_share.empty()) continue;
      T theta[6];
      for (std::size_t k = 0; k < 6; ++k) theta[k] = hn::Load(d, separated.dilatation[k][q] + e);
      const MatrixOf<T> Theta = {
          {theta[0], theta[3], theta[4]}, {theta[3], theta[1], theta[5]}, {theta[4], theta[5], theta[2]}};
      for (std::size_t n = 0; n < 10; ++n) {
        dilating[n] = dilating[n] + Theta * r[n];
        turned[n] = turned[n] + r[n];
      }
    }
    if (!mean_share.empty()) {
      HWY_ALIGN float squares[hn::MaxLanes(d)] = {};
      for (std::size_t k = e; k < std::min(e + hn::Lanes(d), mean_share.size()); ++k)
        squares[k - e] = static_cast<float>(mean_share[k] * mean_share[k]);
      const T factor = hn::Load(d, squares);
      add_products(hn::Set(d, static_cast<float>(share)) * factor, dilating, out);
      if (share < 1) add_products(hn::Set(d, static_cast<float>(1 - share)) * factor, turned, out);
    }
    out.write(e, blocks);
  }
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace prosector::soft {

HWY_EXPORT(tet4_blocks);
HWY_EXPORT(tet10_blocks);

void lane_tet4_blocks(const PointTangents& points, std::span<float> blocks) {
  HWY_DYNAMIC_DISPATCH(tet4_blocks)(points, blocks);
}
void lane_tet10_blocks(const PointTangents& points, std::span<const double> mean_share, double share,
                       std::span<float> blocks) {
  HWY_DYNAMIC_DISPATCH(tet10_blocks)(points, mean_share, share, blocks);
}

void turned_points(const PointTangents& points, std::span<CorotatedVector> gradients,
                   std::span<Twist> twists) {
  for (std::size_t e = 0; e < twists.size(); ++e) {
    for (std::size_t a = 0; a < 4; ++a)
      gradients[4 * e + a] = {
          {points.gradient[3 * a][e], points.gradient[3 * a + 1][e], points.gradient[3 * a + 2][e], 0}};
    twists[e].column[0].at[3] = points.lame_ratio[e];
  }
}

void turned_fibers(const PointTangents& points, std::span<CorotatedVector> fibers) {
  for (std::size_t e = 0; e < fibers.size(); ++e) {
    const float root = points.fiber_root[e];
    fibers[e] = {{root * points.fiber[0][e], root * points.fiber[1][e], root * points.fiber[2][e], 0}};
  }
}

}  // namespace prosector::soft
#endif
