#include "tests/soft/statics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "server/physics/mechanics/soft/make_model.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/solvers/cholesky.h"

namespace prosector {
namespace {

/// Six points that integrate polynomials of degree four over a triangle (Dunavant 1985).
struct TrianglePoint {
  std::array<double, 3> at;
  double weight;
};
std::array<TrianglePoint, 6> triangle_rule() {
  std::array<TrianglePoint, 6> rule{};
  std::size_t i = 0;
  constexpr double near[] = {0.445948490915965, 0.091576213509771},
                   weight[] = {0.223381589678011, 0.109951743655322};
  for (int orbit = 0; orbit < 2; ++orbit)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      rule[i].at.fill(near[orbit]);
      rule[i].at[corner] = 1 - 2 * near[orbit];
      rule[i++].weight = weight[orbit];
    }
  return rule;
}

struct Face {
  std::array<std::uint32_t, 3> vertex;
  std::uint32_t opposite;  // the tetrahedron's other vertex: inside
};

std::vector<Face> surface_of(const TetMesh& mesh) {
  std::map<std::array<std::uint32_t, 3>, std::vector<Face>> faces;
  for (const auto& tet : mesh.tets)
    for (std::size_t k = 0; k < 4; ++k) {
      Face face{{tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]}, tet[k]};
      auto key = face.vertex;
      std::sort(key.begin(), key.end());
      faces[key].push_back(face);
    }
  std::vector<Face> surface;
  for (const auto& [key, sharing] : faces)
    if (sharing.size() == 1) surface.push_back(sharing[0]);
  return surface;
}

using Place = std::array<long, 3>;
Place place(const Vec3& p, double hair) {
  return {std::lround(p.x() / hair), std::lround(p.y() / hair), std::lround(p.z() / hair)};
}

double hair_of(const TetMesh& mesh) {
  double size = 0;
  for (const Vec3& p : mesh.positions) size = std::max(size, p.cwiseAbs().maxCoeff());
  return 1e-6 * size;
}

}  // namespace

Specimen make_specimen(const std::string& model, const std::string& element, double E, double nu,
                       TetMesh mesh) {
  SoftDesc desc;
  desc.name = "specimen";
  desc.configuration.model = model;
  desc.configuration.element = element;
  desc.material.youngs_modulus = E;
  desc.material.poisson_ratio = nu;
  Anatomy anatomy = soft::SoftBody(desc, {std::move(mesh), {}, {}}).anatomy();  // with its elements' nodes
  return {element, soft::make_elastic_model(desc, anatomy), std::move(anatomy.tets)};
}

Eigen::Index node_at(const TetMesh& mesh, const Vec3& p) {
  const double hair = hair_of(mesh);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if ((mesh.positions[i] - p).norm() < hair) return static_cast<Eigen::Index>(i);
  ADD_FAILURE() << "no node at " << p.transpose();
  return 0;
}

VecX forces_of(const Specimen& specimen, const Traction& traction) {
  const TetMesh& mesh = specimen.mesh;
  const double hair = hair_of(mesh);
  std::map<Place, Eigen::Index> node;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    node[place(mesh.positions[i], hair)] = static_cast<Eigen::Index>(i);
  VecX load = VecX::Zero(specimen.model->rest().size());
  for (const Face& face : surface_of(mesh)) {
    std::array<Vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k) corner[k] = mesh.positions[face.vertex[k]];
    Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const double area = normal.norm() / 2;
    normal.normalize();
    if (normal.dot(mesh.positions[face.opposite] - corner[0]) > 0) normal = -normal;
    for (const TrianglePoint& point : triangle_rule()) {
      const auto& L = point.at;
      const Vec3 at = L[0] * corner[0] + L[1] * corner[1] + L[2] * corner[2];
      const Vec3 force = point.weight * area * traction(at, normal);
      if (force.isZero(0)) continue;
      const auto add = [&](Eigen::Index i, double share) { load.segment<3>(3 * i) += share * force; };
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const bool quadratic = specimen.element == "tet10";
        add(face.vertex[k], quadratic ? L[k] * (2 * L[k] - 1) : L[k]);
        if (quadratic) add(node.at(place((corner[k] + corner[next]) / 2, hair)), 4 * L[k] * L[next]);
      }
    }
  }
  return load;
}

VecX equilibrium(soft::ElasticModel& model, const Prescribed& prescribed, const VecX& load) {
  const soft::BlockPattern pattern(model.connectivity());
  soft::Cholesky cholesky(pattern);
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

VecX free_equilibrium(const Specimen& specimen, const VecX& load) {
  const auto& nodes = specimen.mesh.positions;
  const Vec3 origin = nodes[0];
  // Far along x from the first node, then far along y: the triple holds all six rigid motions.
  const auto farthest = [&](int axis) {
    return *std::max_element(nodes.begin(), nodes.end(), [&](const Vec3& a, const Vec3& b) {
      const auto reach = [&](const Vec3& p) {
        const Vec3 arm = p - origin;
        return 2 * arm[axis] - arm.norm();
      };
      return reach(a) < reach(b);
    });
  };
  const Vec3 along = farthest(0), aside = farthest(1);
  const auto held = [&](const Vec3& p, int c) -> std::optional<double> {
    const bool holds = p == origin || (p == along && c != 0) || (p == aside && c == 2);
    return holds ? std::optional(p[c]) : std::nullopt;
  };
  return equilibrium(*specimen.model, held, load);
}

double lowest_frequency(soft::ElasticModel& model, double density,
                        const std::function<bool(const Vec3& p, int c)>& held, VecX mode) {
  const VecX& rest = model.rest();
  const soft::BlockPattern pattern(model.connectivity());
  soft::Cholesky cholesky(pattern);
  std::vector<Mat3> K(pattern.blocks());
  pattern.gather(model.tangent(rest.data()), 0, {}, K);
  for (std::size_t i = 0; i < pattern.rows(); ++i)
    for (int c = 0; c < 3; ++c)
      if (held(rest.segment<3>(3 * static_cast<Eigen::Index>(i)), c)) K[pattern.diagonal(i)](c, c) += 1e14;
  EXPECT_TRUE(cholesky.factor(K));
  VecX inertia(rest.size()), next(rest.size());
  double omega2 = 0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    for (Eigen::Index i = 0; i < rest.size(); ++i) inertia[i] = density * model.volume()[i / 3] * mode[i];
    cholesky.solve(inertia.data(), next.data());
    omega2 = mode.dot(inertia) / next.dot(inertia);
    mode = next.normalized();
  }
  return std::sqrt(omega2) / (2 * M_PI);
}

}  // namespace prosector
