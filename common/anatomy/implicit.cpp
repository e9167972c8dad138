#include "common/anatomy/implicit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

double sphere(const Vec3& x, const Vec3& center, double radius) {
  return (x - center).norm() - radius;
}

// Approximate distance to an ellipsoid: exact on the surface, with a gradient of about 1 near it.
double ellipsoid(const Vec3& x, const Vec3& center, const Vec3& radii) {
  const Vec3 d = x - center;
  const double k = d.cwiseQuotient(radii).norm();
  const double g = d.cwiseQuotient(radii.cwiseProduct(radii)).norm();
  return g < 1e-12 ? -radii.minCoeff() : k * (k - 1) / g;
}

// Signed distance to a cone with rounded ends.
double round_cone(const Vec3& x, const Vec3& a, const Vec3& b, double ra, double rb) {
  const Vec3 axis = b - a;
  const double t = std::clamp((x - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return (x - a - t * axis).norm() - (ra + t * (rb - ra));
}

double box(const Vec3& x, const Vec3& half, double rounding) {
  const Vec3 q = x.cwiseAbs() - half + Vec3::Constant(rounding);
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0) - rounding;
}

// Smooth minimum (quadratic polynomial): blends within a distance k.
double join(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - 0.25 * h * h * k;
}
double smooth_subtract(double a, double b, double k) {
  return -join(-a, b, k);
}

// Seen from the front, x to the viewer's right: the large right lobe at −x, the left lobe tapering to +x.
double liver(const Vec3& x) {
  double d = ellipsoid(x, {-0.035, 0, 0}, {0.074, 0.072, 0.068});
  d = join(d, ellipsoid(x, {0.03, 0.018, 0.014}, {0.075, 0.042, 0.042}), 0.045);
  d = join(d, ellipsoid(x, {-0.055, -0.04, 0.006}, {0.042, 0.045, 0.045}), 0.04);
  d = smooth_subtract(d, ellipsoid(x, {0.04, -0.075, -0.045}, {0.085, 0.06, 0.08}), 0.025);  // visceral side
  return smooth_subtract(d, round_cone(x, {0.008, -0.06, 0.05}, {0.014, 0.02, 0.075}, 0.006, 0.005),
                         0.012);  // fissure
}

double kidney(const Vec3& x) {
  double d = ellipsoid(x, {0, 0, 0}, {0.03, 0.055, 0.022});
  d = join(d, sphere(x, {0.004, 0.03, 0}, 0.021), 0.02);
  d = join(d, sphere(x, {0.004, -0.03, 0}, 0.021), 0.02);
  return smooth_subtract(d, ellipsoid(x, {0.036, 0, 0}, {0.019, 0.02, 0.03}), 0.015);  // hilum
}

double gallbladder(const Vec3& x) {
  const double d = round_cone(x, {0, -0.021, 0}, {0, 0.012, 0}, 0.0135, 0.008);
  return join(d, round_cone(x, {0, 0.012, 0}, {0.006, 0.031, 0}, 0.006, 0.0035), 0.012);
}

double femur(const Vec3& x) {
  double d = round_cone(x, {0.006, -0.17, 0.004}, {-0.004, 0.15, 0}, 0.0145, 0.0145);
  d = join(d, round_cone(x, {-0.004, 0.165, 0}, {0.036, 0.197, 0}, 0.015, 0.0125), 0.02);  // neck
  d = join(d, sphere(x, {0.041, 0.2, 0}, 0.023), 0.008);                                   // head
  d = join(d, ellipsoid(x, {-0.019, 0.178, -0.004}, {0.016, 0.026, 0.02}), 0.02);          // trochanters
  d = join(d, sphere(x, {0.012, 0.135, -0.012}, 0.009), 0.015);
  d = join(d, ellipsoid(x, {-0.018, -0.2, -0.008}, {0.02, 0.024, 0.03}), 0.03);  // condyles
  d = join(d, ellipsoid(x, {0.026, -0.2, -0.008}, {0.02, 0.024, 0.03}), 0.025);
  return smooth_subtract(d, round_cone(x, {0.004, -0.23, -0.05}, {0.004, -0.195, -0.032}, 0.01, 0.01), 0.01);
}

// One solid: the bones of a standing foot with closed joints. z points to the toes.
double foot(const Vec3& x) {
  double d = join(round_cone(x, {0, -0.01, -0.1}, {0.002, 0, -0.06}, 0.021, 0.019),
                  ellipsoid(x, {0, 0.018, -0.05}, {0.019, 0.019, 0.028}), 0.015);
  d = join(d, ellipsoid(x, {0.006, 0.008, -0.015}, {0.025, 0.016, 0.024}), 0.015);
  for (int toe = 0; toe < 5; ++toe) {
    const double side = 0.5 - toe / 4.0;  // great toe at +x
    const double bulk = toe == 0 ? 1.5 : 1;
    const Vec3 base(0.006 + 0.042 * side, 0.008 - 0.006 * std::abs(side), 0.004);
    const Vec3 ball(0.004 + 0.068 * side, -0.022, 0.064 - 0.006 * toe);
    const Vec3 middle = ball + Vec3(0, -0.001, 0.026 - 0.003 * toe);
    const Vec3 tip = middle + Vec3(-0.004 * side, -0.003, 0.019 - 0.002 * toe);
    d = join(d, round_cone(x, base, ball, 0.0062 * bulk, 0.0056 * bulk), 0.006);
    d = join(d, sphere(x, ball, 0.0072 * bulk), 0.005);
    d = join(d, round_cone(x, ball, middle, 0.0055 * bulk, 0.005 * bulk), 0.005);
    d = join(d, round_cone(x, middle, tip, 0.0052 * bulk, 0.0048 * bulk), 0.005);
  }
  return d;
}

double block(const Vec3& x) {
  return box(x, Vec3::Constant(0.05), 0.004);
}
double ball(const Vec3& x) {
  return sphere(x, Vec3::Zero(), 0.05);
}
double beam(const Vec3& x) {
  return box(x, {0.2, 0.05, 0.05}, 0.004);
}
double cylinder(const Vec3& x) {
  const double radial = std::hypot(x[0], x[2]) - 0.046, axial = std::abs(x[1]) - 0.046;
  return std::hypot(std::max(radial, 0.0), std::max(axial, 0.0)) + std::min(std::max(radial, axial), 0.0) -
         0.004;
}
double capsule(const Vec3& x) {
  return round_cone(x, {0, -0.05, 0}, {0, 0.05, 0}, 0.025, 0.025);
}

// Two straight arms along x, joined by a half ring.
double horseshoe(const Vec3& x) {
  constexpr double bend = 0.03, arm = 0.09, radius = 0.015;
  const Vec3 q(x.x() + 0.03, x.y(), x.z());
  const double in_plane = q.x() < 0 ? std::hypot(q.x(), q.y()) - bend : std::abs(q.y()) - bend;
  return Vec3(std::max(q.x() - arm, 0.0), in_plane, q.z()).norm() - radius;
}

const ImplicitShape& find(std::string_view name) {
  std::vector<std::string_view> names;
  for (const ImplicitShape& s : implicit_shapes()) {
    if (s.name == name) return s;
    names.push_back(s.name);
  }
  throw InputError(
      fmt::format("implicit shape \"{}\" is unknown; allowed: {}", name, fmt::join(names, ", ")));
}

/// Finds the bounding box of the negative region by sampling, so that shapes needn't state their size.
Box measured_box(const ImplicitShape& shape) {
  constexpr int n = 64;
  const Vec3 span = 1.5 * shape.natural_size, step = span / n;
  Box out{span, -span};
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const Vec3 x = Vec3(i, j, k).cwiseProduct(step) - 0.5 * span;
        const double d = shape.value(x);
        if (d >= 0) continue;
        // Extends the box beyond the sample by the distance to the surface, at most one grid step.
        const Vec3 reach = step.cwiseMin(-d);
        out.min = out.min.cwiseMin(x - reach);
        out.max = out.max.cwiseMax(x + reach);
      }
  return out;
}

}  // namespace

const std::vector<ImplicitShape>& implicit_shapes() {
  static const std::vector<ImplicitShape> table = {
      {"liver", "a liver of two lobes, the right one larger, hollow below", {0.21, 0.16, 0.14}, liver},
      {"kidney", "a bean-shaped kidney with its hilum at +x", {0.06, 0.11, 0.045}, kidney},
      {"gallbladder", "a pear, neck up", {0.027, 0.07, 0.027}, gallbladder},
      {"femur", "a thigh bone, head at +x", {0.11, 0.45, 0.07}, femur},
      {"foot", "the bones of a right foot as one solid, toes at +z", {0.09, 0.075, 0.24}, foot},
      {"block", "a cube with rounded edges", {0.1, 0.1, 0.1}, block},
      {"ball", "a sphere", {0.1, 0.1, 0.1}, ball},
      {"beam", "a bar along x with rounded edges", {0.4, 0.1, 0.1}, beam},
      {"cylinder", "a cylinder along y with rounded edges", {0.1, 0.1, 0.1}, cylinder},
      {"capsule", "a capsule along y", {0.05, 0.15, 0.05}, capsule},
      {"horseshoe", "a bent bar, open towards +x", {0.15, 0.09, 0.03}, horseshoe},
  };
  return table;
}

SolidField implicit_shape(std::string_view name, const Vec3& size) {
  const ImplicitShape& shape = find(name);
  if (!size.allFinite() || !(size.minCoeff() > 0) || size.maxCoeff() > 100)
    throw InputError(
        fmt::format("implicit shape \"{}\": size {} x {} x {} m; allowed: above 0, at most 100 m", name,
                    size[0], size[1], size[2]));
  const Box own = measured_box(shape);
  const Vec3 scale = size.cwiseQuotient(own.size()), center = own.center();
  const double least = scale.minCoeff();
  return {[value = shape.value, scale, center, least](const Vec3& x) {
            return least * value(x.cwiseQuotient(scale) + center);
          },
          {-0.5 * size, 0.5 * size}};
}

Vec3 natural_size(std::string_view name) {
  return find(name).natural_size;
}

}  // namespace prosector
