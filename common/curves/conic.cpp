#include "common/curves/conic.h"

#include <fmt/format.h>

#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

void check_arc(double a, double b, double from, double to) {
  if (!(a > 0) || !(b > 0) || !std::isfinite(a) || !std::isfinite(b))
    throw InputError(fmt::format("a conic with a = {} and b = {}: both must be above 0", a, b));
  if (!std::isfinite(from) || !std::isfinite(to) || !(to > from))
    throw InputError(fmt::format("a conic's arc from t = {} to t = {} must end after it begins", from, to));
}

}  // namespace

NurbsCurve ellipse_arc(double a, double b, double from, double to) {
  constexpr double turn = 2 * M_PI;
  check_arc(a, b, from, to);
  if (to - from > turn * (1 + 1e-12))
    throw InputError(
        fmt::format("an ellipse's arc from t = {} to t = {} must be at most one full turn (2π)", from, to));
  const int arcs = std::max(1, static_cast<int>(std::ceil((to - from) / (turn / 4) - 1e-9)));
  const double half = (to - from) / arcs / 2;
  std::vector<Vec3> points;
  std::vector<double> weights, knots = {0};
  for (int k = 0; k <= 2 * arcs; ++k) {
    const double t = from + k * half;
    const bool joint = k % 2 == 0;
    // An inner control point is where the tangents at two joints intersect.
    const double out = joint ? 1 : 1 / std::cos(half);
    points.emplace_back(out * a * std::cos(t), out * b * std::sin(t), 0);
    weights.push_back(joint ? 1 : std::cos(half));
    if (joint) knots.insert(knots.end(), 2, static_cast<double>(k) / (2 * arcs));
  }
  // A full turn closes exactly, bit by bit.
  if (to - from >= turn * (1 - 1e-12)) points.back() = points.front();
  knots.push_back(1);
  return {2, std::move(knots), std::move(points), std::move(weights)};
}

NurbsCurve parabola_arc(double a, double from, double to) {
  check_arc(a, a, from, to);
  return NurbsCurve::bezier({{a * from * from, 2 * a * from, 0},
                             {a * from * to, a * (from + to), 0},
                             {a * to * to, 2 * a * to, 0}});
}

NurbsCurve hyperbola_arc(double a, double b, double from, double to) {
  check_arc(a, b, from, to);
  const double half = (to - from) / 2, middle = (from + to) / 2, weight = std::cosh(half);
  return NurbsCurve::bezier({{a * std::cosh(from), b * std::sinh(from), 0},
                             {a * std::cosh(middle) / weight, b * std::sinh(middle) / weight, 0},
                             {a * std::cosh(to), b * std::sinh(to), 0}},
                            {1, weight, 1});
}

}  // namespace prosector
