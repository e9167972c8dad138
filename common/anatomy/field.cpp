#include "common/anatomy/field.h"

#include <algorithm>

namespace prosector {

double sampled_volume(const SolidField& field, int samples) {
  const Vec3 step = field.box.size() / samples;
  int inside = 0;
  for (int k = 0; k < samples; ++k)
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i)
        if (field.value(field.box.min + step.cwiseProduct(Vec3(i + 0.5, j + 0.5, k + 0.5))) < 0) ++inside;
  return field.box.size().prod() * inside / (samples * samples * samples);
}

Vec3 gradient(const SolidField& field, const Vec3& x, double step) {
  Vec3 g;
  for (int k = 0; k < 3; ++k) {
    const Vec3 d = step * Vec3::Unit(k);
    g[k] = (field.value(x + d) - field.value(x - d)) / (2 * step);
  }
  return g;
}

double crossing(const SolidField& field, const Vec3& inside, double f_inside, const Vec3& outside,
                double f_outside) {
  double a = 0, b = 1;
  constexpr int steps = 10;
  for (int k = 0; k < steps; ++k) {
    // Alternates bounded secant steps with bisection: fast on smooth fields, robust on steep ones.
    const double secant = a + (b - a) * f_inside / (f_inside - f_outside);
    const double margin = 0.05 * (b - a);
    const double t = k % 2 == 0 ? std::clamp(secant, a + margin, b - margin) : 0.5 * (a + b);
    const double f = field.value(inside + t * (outside - inside));
    if (f < 0) {
      a = t;
      f_inside = f;
    } else {
      b = t;
      f_outside = f;
    }
  }
  return 0.5 * (a + b);
}

}  // namespace prosector
