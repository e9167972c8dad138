#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "server/physics/mechanics/soft/matrices/corotated_stiffness.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep; compiles this file once per instruction set

// Must follow foreach_target.h, which includes these headers again.
#include <algorithm>

#include "server/physics/mechanics/soft/matrices/corotated_stiffness.h"
#include "server/physics/mechanics/soft/simd/four_lanes.h"

HWY_BEFORE_NAMESPACE();
namespace prosector::soft::HWY_NAMESPACE {

/// Floats of one block: its columns without the multiple of I, and the summands of this multiple.
constexpr std::size_t floats_per_sum = 16, slots_at_once = 96;  // on the stack

/// Adds r_b's part of (λ/μ) r_a r_bᵀ + [r_a]ₓT[r_b]ₓᵀ and of r_a·r_b to sums, for one a.
struct PointOfRow {
  V4 gradient, along, twisted[3];  // r_a, (λ/μ) r_a, [r_a]ₓT

  HWY_INLINE PointOfRow(const CorotatedVector& r, const Twist& T)
      : gradient(load4(r.at)),
        along(scaled(T.column[0].at[3], gradient)),
        twisted{cross4(gradient, load4(T.column[0].at)), cross4(gradient, load4(T.column[1].at)),
                cross4(gradient, load4(T.column[2].at))} {}

  HWY_INLINE void add(const float* r, V4* sum) const {
    sum[0] =
        multiply_add(r[1], twisted[2], multiply_add(-r[2], twisted[1], multiply_add(r[0], along, sum[0])));
    sum[1] =
        multiply_add(r[2], twisted[0], multiply_add(-r[0], twisted[2], multiply_add(r[1], along, sum[1])));
    sum[2] =
        multiply_add(r[0], twisted[1], multiply_add(-r[1], twisted[0], multiply_add(r[2], along, sum[2])));
    sum[3] = multiply_add(gradient, load4(r), sum[3]);
  }
};

HWY_INLINE void load_sum(const float* from, V4* sum) {
  for (std::size_t k = 0; k < 4; ++k) sum[k] = load4(from + 4 * k);
}
HWY_INLINE void store_sum(const V4* sum, float* to) {
  for (std::size_t k = 0; k < 4; ++k) store4(sum[k], to + 4 * k);
}

/// Sums the blocks of row i at the places `base` … base + count − 1 right of the diagonal.
template <std::size_t corners, std::size_t points>
HWY_INLINE void sum_row(const CorotatedRows& rows, std::size_t i, std::size_t base, std::size_t count,
                        float* sums) {
  std::fill_n(sums, floats_per_sum * count, 0.f);
  const CorotatedElements& elements = rows.elements;
  const std::uint32_t* slot = rows.blocks.places(i).data();
  for (const std::uint32_t corner : rows.blocks.incidence().corners(i)) {
    const std::size_t own = corner % corners, e = corner / corners;
    if (own + 1 == corners) continue;
    const CorotatedVector* r = elements.gradient.data() + points * corners * e;
    for (std::size_t p = 0; p < points; ++p, r += corners) {
      const PointOfRow point(r[own], elements.twist[points * e + p]);
      for (std::size_t b = own + 1; b < corners; ++b) {
        const std::size_t at = slot[b - own - 1] - base;
        if (at >= count) continue;
        V4 sum[4];
        load_sum(sums + floats_per_sum * at, sum);
        point.add(r[b].at, sum);
        store_sum(sum, sums + floats_per_sum * at);
      }
    }
    if (!elements.mean.empty()) {
      const CorotatedVector* m = elements.mean.data() + corners * e;
      const V4 mine = load4(m[own].at);
      for (std::size_t b = own + 1; b < corners; ++b) {
        const std::size_t at = slot[b - own - 1] - base;
        if (at >= count) continue;
        float* to = sums + floats_per_sum * at;
        for (std::size_t k = 0; k < 3; ++k)
          store4(multiply_add(m[b].at[k], mine, load4(to + 4 * k)), to + 4 * k);
      }
    }
    slot += corners - own - 1;
  }
}

template <std::size_t corners, std::size_t points>
HWY_INLINE void assemble_rows(const CorotatedRows& rows, std::size_t first, std::size_t last, float* K) {
  alignas(64) float sums[floats_per_sum * slots_at_once];
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t all = rows.pattern.right(i).size();
    float* to = K + 9 * rows.pattern.begin(i);
    for (std::size_t base = 0; base < all; base += slots_at_once) {
      const std::size_t count = std::min(slots_at_once, all - base);
      sum_row<corners, points>(rows, i, base, count, sums);
      for (std::size_t k = 0; k < count; ++k, to += 9) {
        const float* s = sums + floats_per_sum * k;
        const float multiple = 2 * (s[12] + s[13] + s[14]);
        for (std::size_t c = 0; c < 3; ++c)
          for (std::size_t entry = 0; entry < 3; ++entry)
            to[3 * c + entry] = s[4 * c + entry] + (c == entry ? multiple : 0);
      }
    }
  }
}

/// Sums the elements' blocks of row i at the places `base` … base + count − 1 right of the diagonal.
template <std::size_t corners>
HWY_INLINE void sum_blocks(const CorotatedRows& rows, std::size_t i, std::size_t base, std::size_t count,
                           float* sums) {
  std::fill_n(sums, floats_per_sum * count, 0.f);
  constexpr std::size_t pairs = corners * (corners - 1) / 2;
  const std::uint32_t* slot = rows.blocks.places(i).data();
  for (const std::uint32_t corner : rows.blocks.incidence().corners(i)) {
    const std::size_t own = corner % corners, e = corner / corners;
    const float* block = rows.elements.blocks.data() + 9 * (pairs * e + own * (2 * corners - own - 1) / 2);
    for (std::size_t b = own + 1; b < corners; ++b, ++slot, block += 9) {
      const std::size_t at = *slot - base;
      if (at >= count) continue;
      float* to = sums + floats_per_sum * at;
      for (std::size_t k = 0; k < 3; ++k) store4(added(load4(block + 3 * k), load4(to + 4 * k)), to + 4 * k);
    }
  }
}

template <std::size_t corners>
HWY_INLINE void gather_rows(const CorotatedRows& rows, std::size_t first, std::size_t last, float* K) {
  alignas(64) float sums[floats_per_sum * slots_at_once];
  for (std::size_t i = first; i < last; ++i) {
    const std::size_t all = rows.pattern.right(i).size();
    float* to = K + 9 * rows.pattern.begin(i);
    for (std::size_t base = 0; base < all; base += slots_at_once) {
      const std::size_t count = std::min(slots_at_once, all - base);
      sum_blocks<corners>(rows, i, base, count, sums);
      for (std::size_t k = 0; k < count; ++k, to += 9)
        for (std::size_t c = 0; c < 3; ++c) std::copy_n(sums + floats_per_sum * k + 4 * c, 3, to + 3 * c);
    }
  }
}

void linear_blocks(const CorotatedRows& rows, std::size_t first, std::size_t last, float* K) {
  gather_rows<4>(rows, first, last, K);
}
void quadratic_blocks(const CorotatedRows& rows, std::size_t first, std::size_t last, float* K) {
  gather_rows<10>(rows, first, last, K);
}
void linear_rows(const CorotatedRows& rows, std::size_t first, std::size_t last, float* K) {
  assemble_rows<4, 1>(rows, first, last, K);
}
void quadratic_rows(const CorotatedRows& rows, std::size_t first, std::size_t last, float* K) {
  assemble_rows<10, 4>(rows, first, last, K);
}

/// Adds the stress of fibres f at a point, (fᵀDf) f fᵀ, to `stress`, which is D + Dᵀ. Returns their energy
/// ½(fᵀDf)².
HWY_INLINE double add_fiber_stress(const CorotatedVector& f, W4* stress) {
  const W4 fiber = wide(f.at);
  W4 Sf = wide_zero();
  for (std::size_t k = 0; k < 3; ++k) Sf = multiply_add(static_cast<double>(f.at[k]), stress[k], Sf);
  const double tension = 0.5 * sum_of_three(multiply_add(fiber, Sf, wide_zero()));
  for (std::size_t k = 0; k < 3; ++k)
    stress[k] = multiply_add(tension * static_cast<double>(f.at[k]), fiber, stress[k]);
  return 0.5 * tension * tension;
}

/// Computes the warped stress at a point, with D = Σ (u_b − u_0) r_bᵀ: D + Dᵀ + (λ/μ) tr(D) I. Returns the
/// energy ½(½‖D + Dᵀ‖² + (λ/μ) tr(D)²).
template <std::size_t corners>
HWY_INLINE double warped_stress(const W4* u, const CorotatedVector* r, float lame_ratio, W4* stress,
                                double& pressure) {
  for (std::size_t k = 0; k < 3; ++k) stress[k] = wide_zero();
  W4 diagonal = wide_zero();
  for (std::size_t b = 1; b < corners; ++b) {
    for (std::size_t k = 0; k < 3; ++k)
      stress[k] = multiply_add(static_cast<double>(r[b].at[k]), u[b], stress[k]);
    diagonal = multiply_add(wide(r[b].at), u[b], diagonal);
  }
  add_transposed(stress);
  const double trace = sum_of_three(diagonal);
  pressure = static_cast<double>(lame_ratio) * trace;
  W4 squares = wide_zero();
  for (std::size_t k = 0; k < 3; ++k) squares = multiply_add(stress[k], stress[k], squares);
  return 0.5 * (0.5 * sum_of_three(squares) + pressure * trace);
}

/// Returns ½uᵀKu of an element; with `f`, computes the forces K·u on its corners, three numbers each.
template <std::size_t corners, std::size_t points>
HWY_INLINE double element_product(const CorotatedElements& elements, std::size_t e, const std::uint32_t* node,
                                  const double* x, double (*f)[4]) {
  W4 u[corners], sum[corners];
  const W4 first = wide(x + 4 * std::size_t{node[0]});
  for (std::size_t b = 1; b < corners; ++b) {
    u[b] = multiply_add(-1, first, wide(x + 4 * std::size_t{node[b]}));
    sum[b] = wide_zero();
  }
  double energy = 0;
  const CorotatedVector* r = elements.gradient.data() + points * corners * e;
  for (std::size_t p = 0; p < points; ++p, r += corners) {
    W4 stress[3];
    double pressure;
    energy += warped_stress<corners>(u, r, elements.twist[points * e + p].column[0].at[3], stress, pressure);
    if (!elements.fiber.empty()) energy += add_fiber_stress(elements.fiber[points * e + p], stress);
    if (!f) continue;
    for (std::size_t b = 1; b < corners; ++b) {
      sum[b] = multiply_add(pressure, wide(r[b].at), sum[b]);
      for (std::size_t k = 0; k < 3; ++k)
        sum[b] = multiply_add(static_cast<double>(r[b].at[k]), stress[k], sum[b]);
    }
  }
  if (!elements.mean.empty()) {
    const CorotatedVector* m = elements.mean.data() + corners * e;
    W4 products = wide_zero();
    for (std::size_t b = 1; b < corners; ++b) products = multiply_add(wide(m[b].at), u[b], products);
    const double dilatation = sum_of_three(products);
    energy += 0.5 * dilatation * dilatation;
    for (std::size_t b = 1; b < corners; ++b) sum[b] = multiply_add(dilatation, wide(m[b].at), sum[b]);
  }
  if (!f) return energy;
  W4 total = wide_zero();
  for (std::size_t b = 1; b < corners; ++b) {
    total = multiply_add(-1, sum[b], total);
    store(sum[b], f[b]);
  }
  store(total, f[0]);
  return energy;
}

template <std::size_t corners, std::size_t points>
HWY_INLINE double element_products(const CorotatedElements& elements, const Connectivity& all,
                                   std::size_t first, std::size_t last, const double* x, Vec3* out) {
  double energy = 0, f[corners][4];
  for (std::size_t e = first; e < last; ++e) {
    energy += element_product<corners, points>(elements, e, all.element(e).data(), x, out ? f : nullptr);
    if (!out) continue;
    for (std::size_t b = 0; b < corners; ++b) out[corners * e + b] = Vec3(f[b][0], f[b][1], f[b][2]);
  }
  return energy;
}

double linear_products(const CorotatedElements& elements, const Connectivity& all, std::size_t first,
                       std::size_t last, const double* x, Vec3* out) {
  return element_products<4, 1>(elements, all, first, last, x, out);
}
double quadratic_products(const CorotatedElements& elements, const Connectivity& all, std::size_t first,
                          std::size_t last, const double* x, Vec3* out) {
  return element_products<10, 4>(elements, all, first, last, x, out);
}

}  // namespace prosector::soft::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/node_vectors.h"
#include "server/physics/mechanics/soft/base/scratch.h"

namespace prosector::soft {
namespace {

constexpr std::size_t corotated_rows_per_chunk = 64, elements_per_chunk = 256, nodes_per_chunk = 1024;

}  // namespace

HWY_EXPORT(linear_blocks);
HWY_EXPORT(quadratic_blocks);
HWY_EXPORT(linear_rows);
HWY_EXPORT(quadratic_rows);
HWY_EXPORT(linear_products);
HWY_EXPORT(quadratic_products);

CorotatedStiffness::CorotatedStiffness(const Connectivity& elements, const BlockPattern& blocks,
                                       const SymmetricPattern& pattern)
    : connectivity_(elements), blocks_(blocks), pattern_(pattern) {
  fit();
}

void CorotatedStiffness::fit() {
  fit_scratch(forces_, connectivity_.corners());
  fit_scratch(moved_, 4 * connectivity_.nodes());
  sums_.resize(chunk_count(connectivity_.size(), elements_per_chunk));
}

void CorotatedStiffness::assemble(const CorotatedElements& elements, SymmetricRows& K) const {
  const CorotatedRows rows = {blocks_, pattern_, elements};
  parallel_chunks(pattern_.rows(), corotated_rows_per_chunk,
                  [&](std::size_t first, std::size_t last, std::size_t) {
                    if (!elements.blocks.empty() && corners() == 4) {
                      HWY_DYNAMIC_DISPATCH(linear_blocks)(rows, first, last, K.right.data());
                    } else if (!elements.blocks.empty()) {
                      HWY_DYNAMIC_DISPATCH(quadratic_blocks)(rows, first, last, K.right.data());
                    } else if (corners() == 4) {
                      HWY_DYNAMIC_DISPATCH(linear_rows)(rows, first, last, K.right.data());
                    } else {
                      HWY_DYNAMIC_DISPATCH(quadratic_rows)(rows, first, last, K.right.data());
                    }
                  });
  K.close(pattern_);
}

double CorotatedStiffness::energy(const CorotatedElements& elements, const double* u) {
  return visit(elements, u, nullptr);
}

double CorotatedStiffness::multiply(const CorotatedElements& elements, const double* u, double* f) {
  const double energy = visit(elements, u, forces_.data());
  std::fill_n(f, 3 * connectivity_.nodes(), 0.0);
  blocks_.incidence().add(forces_, f);
  return energy;
}

/// Returns ½uᵀKu and, unless `forces` is null, computes the corners' forces.
double CorotatedStiffness::visit(const CorotatedElements& elements, const double* u, Vec3* forces) {
  parallel_short_chunks(connectivity_.nodes(), nodes_per_chunk,
                        [&](std::size_t first, std::size_t last, std::size_t) {
                          for (std::size_t i = first; i < last; ++i)
                            for (std::size_t k = 0; k < 3; ++k) moved_[4 * i + k] = u[3 * i + k];
                        });
  parallel_chunks(
      connectivity_.size(), elements_per_chunk, [&](std::size_t first, std::size_t last, std::size_t chunk) {
        const double* x = moved_.data();
        sums_[chunk] =
            corners() == 4
                ? HWY_DYNAMIC_DISPATCH(linear_products)(elements, connectivity_, first, last, x, forces)
                : HWY_DYNAMIC_DISPATCH(quadratic_products)(elements, connectivity_, first, last, x, forces);
      });
  return ordered_sum(sums_);
}

}  // namespace prosector::soft
#endif
