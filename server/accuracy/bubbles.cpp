#include "server/accuracy/bubbles.h"

namespace prosector {
namespace {

using Powers = std::array<int, 4>;

struct Term {
  double factor;
  Powers powers;
};
using Polynomial = std::vector<Term>;

double factorial(int n) {
  double product = 1;
  for (int k = 2; k <= n; ++k) product *= k;
  return product;
}

/// Returns the mean of ΠL^power over a simplex of that many dimensions: d!·Πpower! / (Σpower + d)!.
double mean(const Powers& powers, int dimensions) {
  double product = factorial(dimensions);
  int sum = dimensions;
  for (const int power : powers) {
    product *= factorial(power);
    sum += power;
  }
  return product / factorial(sum);
}

double mean_of_product(const Polynomial& p, const Polynomial& q, int dimensions) {
  double sum = 0;
  for (const Term& s : p)
    for (const Term& t : q) {
      Powers powers;
      for (std::size_t k = 0; k < powers.size(); ++k) powers[k] = s.powers[k] + t.powers[k];
      sum += s.factor * t.factor * mean(powers, dimensions);
    }
  return sum;
}

Polynomial coordinate(std::size_t corner) {
  Powers powers{};
  powers[corner] = 1;
  return {{1, powers}};
}

Polynomial derivative(const Polynomial& p, std::size_t corner) {
  Polynomial out;
  for (Term term : p) {
    if (term.powers[corner] == 0) continue;
    term.factor *= term.powers[corner]--;
    out.push_back(term);
  }
  return out;
}

/// A function and the corners of its edge or face.
struct Shape {
  std::vector<std::size_t> corners;
  Polynomial polynomial;
};

/// Returns the functions on a simplex with that many corners: a tetrahedron, or a triangle.
std::vector<Shape> shapes(bool quadratic, std::size_t corners) {
  std::vector<Shape> out;
  for (std::size_t a = 0; a < corners; ++a)
    for (std::size_t b = a + 1; b < corners; ++b) {
      Powers once{}, first{}, second{};
      once[a] = once[b] = first[b] = second[a] = 1;
      first[a] = second[b] = 2;
      out.push_back(quadratic ? Shape{{a, b}, {{1, first}, {-1, second}}} : Shape{{a, b}, {{4, once}}});
    }
  if (!quadratic) return out;
  for (std::size_t a = 0; a < corners; ++a)
    for (std::size_t b = a + 1; b < corners; ++b)
      for (std::size_t c = b + 1; c < corners; ++c) {
        Powers once{};
        once[a] = once[b] = once[c] = 1;
        out.push_back({{a, b, c}, {{1, once}}});
      }
  return out;
}

Bubble integrated(const Shape& shape) {
  Bubble out;
  out.corners = shape.corners;
  const Polynomial one = {{1, {}}};
  out.square = mean_of_product(shape.polynomial, shape.polynomial, 3);
  for (int c = 0; c < 4; ++c) {
    const Polynomial L = coordinate(static_cast<std::size_t>(c));
    const Polynomial slope = derivative(shape.polynomial, static_cast<std::size_t>(c));
    out.slope[c] = mean_of_product(one, slope, 3);
    out.load[c] = mean_of_product(shape.polynomial, L, 3);
    for (int d = 0; d < 4; ++d) {
      const Polynomial other = derivative(shape.polynomial, static_cast<std::size_t>(d));
      out.stress(c, d) = mean_of_product(L, other, 3);
      out.stiffness(c, d) = mean_of_product(slope, other, 3);
    }
  }
  return out;
}

}  // namespace

BubbleTable bubbles(bool quadratic) {
  BubbleTable out;
  for (const Shape& shape : shapes(quadratic, 4)) out.of_tet.push_back(integrated(shape));
  for (const Shape& shape : shapes(quadratic, 3)) {
    FaceBubble& face = out.of_face.emplace_back();
    face.corners = shape.corners;
    for (int c = 0; c < 3; ++c)
      face.load[c] = mean_of_product(shape.polynomial, coordinate(static_cast<std::size_t>(c)), 2);
  }
  return out;
}

}  // namespace prosector
