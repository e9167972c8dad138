// Statics with prescribed components of displacement and loads: torsion of a square bar, whose closed form
// both elements must approach at their theoretical rates, and Cook's membrane.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

#include "server/physics/soft/block_matrix.h"
#include "server/physics/soft/cholesky.h"
#include "server/physics/soft/elastic_model.h"
#include "server/physics/soft/soft_body.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

/// x_i of component c of the node at rest position p, if it is prescribed.
using Prescribed = std::function<std::optional<double>(const Vec3& p, int c)>;

struct Body {
  std::unique_ptr<ElasticModel> model;
  Anatomy anatomy;
};

Body make_body(const std::string& model, const std::string& element, double E, double nu, TetMesh mesh) {
  SoftDesc desc;
  desc.name = "specimen";
  desc.model = model;
  desc.element = element;
  desc.youngs_modulus = E;
  desc.poisson_ratio = nu;
  Anatomy anatomy = SoftBody(desc, {std::move(mesh), {}, {}}).anatomy();  // with its elements' nodes
  return {make_elastic_model(desc, anatomy), std::move(anatomy)};
}

/// Minimises W(x) − f·x by Newton from `x`.
VecX equilibrium(ElasticModel& model, const Prescribed& prescribed, const VecX& load) {
  const BlockPattern pattern(model.connectivity());
  Cholesky cholesky(pattern);
  const Eigen::Index n = model.rest().size();
  VecX x = model.rest(), g(n), step(n);
  std::vector<bool> fixed(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i)
    if (const auto value = prescribed(model.rest().segment<3>(i / 3 * 3), static_cast<int>(i % 3))) {
      x[i] = *value;
      fixed[static_cast<std::size_t>(i)] = true;
    }
  std::vector<Mat3> K(pattern.blocks());
  const auto potential = [&](const VecX& at) { return model.energy(at.data()) - load.dot(at); };
  double first = 0;
  for (int iteration = 0; iteration < 60; ++iteration) {
    g = -load;
    model.add_gradient(x.data(), g.data());
    pattern.gather(model.tangent(x.data()), 0, {}, K);
    double stiff = 0;
    for (std::size_t i = 0; i < pattern.rows(); ++i) stiff = std::max(stiff, K[pattern.diagonal(i)].trace());
    for (Eigen::Index i = 0; i < n; ++i) {
      if (!fixed[static_cast<std::size_t>(i)]) continue;
      g[i] = 0;
      K[pattern.diagonal(static_cast<std::size_t>(i / 3))](i % 3, i % 3) += 1e14 * stiff;
    }
    first = std::max(first, g.norm());
    if (g.norm() <= 1e-9 * first) break;
    EXPECT_TRUE(cholesky.factor(K));
    cholesky.solve(g.data(), step.data());
    const double now = potential(x);
    double length = 1;
    while (length > 1e-6 && potential(x - length * step) > now) length /= 2;
    x -= length * step;
  }
  return x;
}

/// Ends of a square prism turned against each other by θ, free to warp: Saint-Venant's W = ½·G·J·θ²/L with J
/// = 0.1405770 a⁴ is exact, and elements store more.
double torsion_excess(const std::string& element, std::uint32_t n, double nu) {
  const double a = 0.1, theta = 1e-3, E = 1e5;
  Body body = make_body("fem_linear", element, E, nu, kuhn_box({n, n, n}, Vec3(a, a, a)));
  const auto turned = [&](const Vec3& p, int c) -> std::optional<double> {
    const double angle = p.x() > a - 1e-9 ? theta / 2 : p.x() < 1e-9 ? -theta / 2 : NAN;
    if (!std::isfinite(angle)) return std::nullopt;
    const Vec3 arm = p - Vec3(0, a / 2, a / 2);
    if (c == 1) return p.y() - angle * arm.z();
    if (c == 2) return p.z() + angle * arm.y();
    const bool middle = arm.tail<2>().norm() < 1e-9 && p.x() < 1e-9;  // or it could slide along x
    return middle || n == 1 ? std::optional(p.x()) : std::nullopt;
  };
  const VecX x = equilibrium(*body.model, turned, VecX::Zero(body.model->rest().size()));
  const double G = E / (2 * (1 + nu)), exact = 0.5 * G * 0.1405770 * std::pow(a, 4) * theta * theta / a;
  return body.model->energy(x.data()) / exact - 1;
}

/// Energy converges at twice the order of the elements' polynomials; the corners, where the warping function
/// goes as r² log r, keep quadratic elements half an order below until meshes are fine.
TEST(Torsion, IsApproachedAtTheTheoreticalRate) {
  for (const double nu : {0.3, 0.49}) {
    const double coarse = torsion_excess("tet4", 4, nu), fine = torsion_excess("tet4", 8, nu);
    EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << nu << " " << coarse << " " << fine;
    EXPECT_LT(fine, 0.1);
  }
  const double two = torsion_excess("tet10", 2, 0.3), four = torsion_excess("tet10", 4, 0.3);
  const double three = torsion_excess("tet10", 3, 0.3), six = torsion_excess("tet10", 6, 0.3);
  EXPECT_GT(six, 0);
  EXPECT_LT(six, 1e-3);
  EXPECT_NEAR(std::log2(three / six), 4, 0.6);
  EXPECT_GT(std::log2(three / six), std::log2(two / four));
}

/// Cook's membrane in plane strain, one layer of n × n cells: u_y at the middle of its loaded edge.
double cook(const std::string& model, const std::string& element, double E, double nu, double force,
            std::uint32_t n) {
  const double thickness = 48. / n;
  TetMesh mesh = kuhn_box({n, n, 1}, Vec3(1, 1, thickness));
  for (Vec3& p : mesh.positions) {
    const double x = p.x(), y = p.y();
    p.x() = 48 * x;
    p.y() = 44 * x + (44 * (1 - x) + 16 * x) * y;
  }
  Body body = make_body(model, element, E, nu, mesh);
  const VecX& rest = body.model->rest();
  // A uniform shear traction: on quadratic triangles a third of the area at the middle of each edge.
  VecX load = VecX::Zero(rest.size());
  const auto& all = body.anatomy.tets.positions;
  const auto loaded = [](const Vec3& p) { return p.x() > 48 - 1e-6; };
  const auto node_at = [&](const Vec3& p) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if ((all[i] - p).norm() < 1e-6) return static_cast<Eigen::Index>(i);
    ADD_FAILURE();
    return Eigen::Index{0};
  };
  for (const auto& tet : mesh.tets) {
    std::vector<Vec3> face;
    for (const std::uint32_t node : tet)
      if (loaded(mesh.positions[node])) face.push_back(mesh.positions[node]);
    if (face.size() != 3) continue;
    const double area = (face[1] - face[0]).cross(face[2] - face[0]).norm() / 2;
    const double third = force * thickness / (16 * thickness) * area / 3;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 at = element == "tet10" ? Vec3((face[k] + face[(k + 1) % 3]) / 2) : face[k];
      load[3 * node_at(at) + 1] += third;
    }
  }
  const auto held = [](const Vec3& p, int c) -> std::optional<double> {
    if (p.x() < 1e-9 || c == 2) return p[c];
    return std::nullopt;
  };
  const VecX x = equilibrium(*body.model, held, load);
  double sum = 0;
  for (const double z : {0., thickness}) {
    const Eigen::Index i = node_at({48, 52, z});
    sum += x[3 * i + 1] - rest[3 * i + 1];
  }
  return sum / 2;
}

TEST(CooksMembrane, LargeStrainInPlaneStrain) {
  const double E = 240.565, force = 100;
  struct Case {
    const char* model;
    double deflection;
  };
  for (const Case& c : {Case{"fem_neo_hookean_polynomial", 7.263}, Case{"fem_corotational", 7.12}}) {
    const double coarse = cook(c.model, "tet10", E, .45, force, 4),
                 fine = cook(c.model, "tet10", E, .45, force, 8);
    EXPECT_NEAR(fine / c.deflection, 1, 0.01) << c.model;
    EXPECT_LT(std::abs(fine - c.deflection), std::abs(coarse - c.deflection)) << c.model << " " << coarse;
  }
  // Nearly incompressible; the reference's volumetric law differs in what no longer matters there.
  EXPECT_NEAR(cook("fem_neo_hookean_polynomial", "tet10", E, .4999, force, 8) / 6.958, 1, 0.015);
}

/// Hz: the lowest of the reference beam, clamped at x = 0, with lumped mass, by inverse iteration.
double first_frequency(const std::string& element, std::uint32_t n) {
  Body body = make_body("fem_linear", element, 3e5, 0.3, kuhn_box({4 * n, n, n}, Vec3(0.4, 0.1, 0.1)));
  const BlockPattern pattern(body.model->connectivity());
  Cholesky cholesky(pattern);
  const VecX& rest = body.model->rest();
  std::vector<Mat3> K(pattern.blocks());
  pattern.gather(body.model->tangent(rest.data()), 0, {}, K);
  for (std::size_t i = 0; i < pattern.rows(); ++i)
    if (rest[3 * static_cast<Eigen::Index>(i)] < 1e-9) K[pattern.diagonal(i)].diagonal().array() += 1e14;
  EXPECT_TRUE(cholesky.factor(K));
  VecX mode = VecX::Zero(rest.size()), next = mode;
  for (Eigen::Index i = 0; i < rest.size(); i += 3) mode[i + 1] = rest[i] * rest[i];  // in one of two planes
  double omega2 = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    VecX inertia(rest.size());
    for (Eigen::Index i = 0; i < rest.size(); ++i) inertia[i] = 1000 * body.model->volume()[i / 3] * mode[i];
    cholesky.solve(inertia.data(), next.data());
    omega2 = mode.dot(inertia) / next.dot(inertia);
    mode = next.normalized();
  }
  return std::sqrt(omega2) / (2 * M_PI);
}

TEST(Frequency, OfTheBeamOnThisMeshAndOfTheContinuum) {
  // Other codes' values for linear tetrahedra on these meshes. A beam of square section has two modes of one
  // frequency; the mesh's diagonals part them by little.
  const double coarse = first_frequency("tet4", 2), fine = first_frequency("tet4", 4);
  EXPECT_NEAR(coarse, 2.14970, 2e-4);
  EXPECT_NEAR(fine, 1.83024, 2e-4);
  const double continuum = 1.6864;
  EXPECT_NEAR(first_frequency("tet10", 2) / continuum, 1, 0.01);
}

}  // namespace
}  // namespace prosector
