// A bar that hangs from its top and is stretched by its weight, cut half through and fully: how far it opens
// and where it comes to rest, against meshes that conform to the cut from the start.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>

#include "server/physics/mechanics/organs/organ_geometry.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

const Vec3 bar_size(0.04, 0.12, 0.04);  // m; around the origin, cut in its middle, where y = 0

TetMesh bar(int across, int along) {
  return make_block(bar_size, {across, along, across}).tets;
}

/// Cut along y = 0 from one side, at x = −2 cm, to where the blade's edge stops.
Anatomy cut_bar(const TetMesh& mesh, double to_x) {
  organs::Organ organ(0, with_boundary(mesh), 1000);
  const auto edge_at = [](double x) { return std::vector<Vec3>{{x, 0, -0.03}, {x, 0, 0}, {x, 0, 0.03}}; };
  constexpr double from_x = -0.03;
  constexpr int ticks = 8;
  cutting::BladeStroke stroke = cutting::begin_stroke(edge_at(from_x));
  for (int tick = 1; tick <= ticks; ++tick) {
    std::vector<Vec3> rest;
    for (cutting::NodeId node = 0; node < organ.complex().node_end(); ++node)
      rest.push_back(organ.complex().rest(node));
    organ.cut(rest, edge_at(from_x + tick * (to_x - from_x) / ticks), stroke, 1, 1);
  }
  organ.regroup(1);
  const auto height = [](const organs::OrganPiece& piece) {
    double sum = 0;
    for (const Vec3& x : piece.mesh.mesh.positions) sum += x.y();
    return sum / static_cast<double>(piece.mesh.mesh.positions.size());
  };
  const auto upper = [&](const organs::OrganPiece& a, const organs::OrganPiece& b) {
    return height(a) < height(b);
  };
  Numbering numbering;
  return organs::anatomy_of(organ, *std::max_element(organ.pieces().begin(), organ.pieces().end(), upper),
                            numbering);
}

/// What cutting does by hand: nodes on the plane up to x are one for each side.
Anatomy slit_bar(TetMesh mesh, double to_x) {
  std::map<std::uint32_t, std::uint32_t> below;
  const std::vector<Vec3> rest = mesh.positions;
  for (auto& tet : mesh.tets) {
    double height = 0;
    for (const std::uint32_t node : tet) height += rest[node].y();
    if (height > 0) continue;
    for (std::uint32_t& node : tet) {
      if (std::abs(rest[node].y()) > 1e-9 || rest[node].x() > to_x - 1e-9) continue;
      const auto [at, fresh] = below.emplace(node, static_cast<std::uint32_t>(mesh.positions.size()));
      if (fresh) mesh.positions.push_back(rest[node]);
      node = at->second;
    }
  }
  return with_boundary(std::move(mesh));
}

struct Rest {
  double opening = 0;       // m: of the slit, where it is widest
  Vec3 sag = Vec3::Zero();  // m: of the centre of mass
  std::size_t tets = 0;
};

Rest rest_of(const Anatomy& anatomy) {
  SceneDesc scene;
  scene.soft = {block("bar")};
  SoftDesc& soft = scene.soft[0];
  soft.pose = {};
  soft.material.density = 1000;
  soft.material.youngs_modulus = 20e3;
  soft.material.poisson_ratio = 0.3;
  soft.attach = {{{0, 0.26, 0}, 0.2021, 1e8}};  // the top's nodes alone
  CompileOptions with = options();
  with.anatomy = [&](const SoftDesc&) { return anatomy; };
  const Simulation simulation(scene, with);
  const soft::SoftBody& body = simulation.soft(0);
  const VecX& x = simulation.soft_state(0).motion.x;
  Rest out;
  out.tets = anatomy.tets.tets.size();
  std::map<std::array<double, 3>, Vec3> met;
  double mass = 0;
  for (std::size_t n = 0; n < anatomy.tets.positions.size(); ++n) {
    const Vec3& rest = anatomy.tets.positions[n];
    const Vec3 now = x.segment<3>(3 * static_cast<Eigen::Index>(n));
    const double m = body.node_mass()[static_cast<Eigen::Index>(n)];
    out.sag += m * (now - rest);
    mass += m;
    const auto [twin, first] = met.try_emplace({rest.x(), rest.y(), rest.z()}, now);
    if (!first) out.opening = std::max(out.opening, (now - twin->second).norm());
  }
  out.sag /= mass;
  return out;
}

/// Prints the two, and says how far off the cut one's rest is, relative.
double compare(const char* what, const Rest& cut, const Rest& conforming) {
  std::cout << what << ": opening " << 1e3 * cut.opening << " mm (" << 1e3 * conforming.opening << "), sag "
            << 1e3 * cut.sag.transpose() << " mm (" << 1e3 * conforming.sag.transpose() << "), " << cut.tets
            << " tetrahedra (" << conforming.tets << ")\n";
  return (cut.sag - conforming.sag).norm() / conforming.sag.norm();
}

TEST(CutBar, OpensAndComesToRestAsAMeshThatConformsToTheCut) {
  for (const int across : {4, 8}) {
    const int along = 3 * across;
    SCOPED_TRACE(across);
    // The blade goes along a mesh's own faces, and through the middle of its cells.
    const Rest slit = rest_of(slit_bar(bar(across, along), 0)),
               half = rest_of(cut_bar(bar(across, along - 1), 0));
    const double half_off = compare("half through", half, slit);
    EXPECT_GT(slit.opening, 1e-3);
    const Rest along_faces = rest_of(cut_bar(bar(across, along), 0));
    compare("half through, along faces", along_faces, slit);
    EXPECT_NEAR(along_faces.opening, slit.opening, 1e-6);
    EXPECT_LT((along_faces.sag - slit.sag).norm(), 1e-6);

    const auto upper_half = [&] {
      TetMesh mesh = make_block({0.04, 0.06, 0.04}, {across, along / 2, across}).tets;
      for (Vec3& x : mesh.positions) x.y() += 0.03;
      return with_boundary(std::move(mesh));
    };
    const double full_off =
        compare("fully", rest_of(cut_bar(bar(across, along - 1), 0.03)), rest_of(upper_half()));
    compare("not at all", rest_of(with_boundary(bar(across, along - 1))),
            rest_of(with_boundary(bar(across, along))));
    const double opening_off = half.opening / slit.opening - 1;
    std::cout << "off by " << 100 * half_off << " % and " << 100 * full_off << " % of the sag; opening by "
              << 100 * opening_off << " %\n";
    EXPECT_LT(half_off, across == 4 ? 0.045 : 0.03);
    EXPECT_LT(full_off, across == 4 ? 0.07 : 0.045);
    EXPECT_LT(std::abs(opening_off), 0.025);
  }
}

}  // namespace
}  // namespace prosector::test
