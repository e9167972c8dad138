// What hangs on a piece's mesh follows a cut that nothing comes off: to the bits that it has made anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "server/physics/byte_stream.h"
#include "server/physics/organs/organ.h"
#include "server/physics/organs/tet_lineage.h"
#include "server/physics/soft/soft_body.h"
#include "tests/cutting/meshes.h"
#include "tests/random.h"

namespace prosector {
namespace {

bool equal(const VecX& a, const VecX& b) {
  return a.size() == b.size() && (a.array() == b.array()).all();
}

/// All that a step would ask of a body, at places that only `seed` tells.
std::vector<VecX> answers(SoftBody& body, unsigned seed) {
  Random random(seed);
  const Eigen::Index n = 3 * body.nodes();
  const auto near = [&](const VecX& x, double reach) {
    return VecX(x + VecX::NullaryExpr(n, [&] { return random.uniform(-reach, reach); }));
  };
  SoftBodyState state = body.initial_state();
  state.motion.x = near(body.rest(), 1e-3);
  state.motion.v = near(VecX::Zero(n), 0.1);
  body.begin_stage(0, 0.01, {0, -9.81, 0}, state);
  const VecX x = near(state.motion.x, 1e-3), p = near(VecX::Zero(n), 1);
  body.linearise(x);
  VecX gradient = VecX::Zero(n), product(n), solution(n), warm(n);
  body.gradient(x, gradient);
  const double energy = body.energy(x);
  body.assemble(x);
  body.multiply(p.data(), product.data());
  std::vector<Mat3> diagonal(static_cast<std::size_t>(body.nodes()));
  body.diagonal(diagonal);
  std::vector<Mat3> inverse;
  for (const Mat3& block : diagonal) inverse.push_back(block.inverse());
  if (body.desc().solver == "direct")
    body.factor_solve(p.data(), solution.data());
  else if (body.desc().solver == "multigrid")
    body.multigrid_solve(diagonal, inverse, p.data(), solution.data());
  else
    solution.setZero();
  VecX blocks(9 * body.nodes());
  for (Eigen::Index i = 0; i < body.nodes(); ++i)
    blocks.segment<9>(9 * i) = diagonal[static_cast<std::size_t>(i)].reshaped();
  const VecX area = Eigen::Map<const VecX>(body.surface_area().data(),
                                           static_cast<Eigen::Index>(body.surface_area().size()));
  const VecX numbers = Eigen::Vector4d(energy, body.diagonal(), body.elastic_energy(x),
                                       static_cast<double>(body.tangent_is_cheap()));
  return {
      body.rest(), body.node_mass(), body.attachment_stiffness(), area, numbers, gradient, product, solution,
      blocks,      state.motion.x};
}

::testing::AssertionResult same(SoftBody& followed, SoftBody& anew, unsigned seed) {
  const Anatomy &a = followed.anatomy(), &b = anew.anatomy();
  if (followed.content_hash() != anew.content_hash() || a.tets.tets != b.tets.tets)
    return ::testing::AssertionFailure() << "another mesh";
  if (a.surface.triangles != b.surface.triangles || a.surface.inner != b.surface.inner ||
      a.surface.positions != b.surface.positions ||
      !std::ranges::equal(a.embedding.rows, b.embedding.rows, [](const auto& p, const auto& q) {
        return p.node == q.node && p.weight == q.weight;
      }))
    return ::testing::AssertionFailure() << "another surface";
  const std::vector<VecX> x = answers(followed, seed), y = answers(anew, seed);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!equal(x[i], y[i])) return ::testing::AssertionFailure() << "answer " << i << " differs";
  return ::testing::AssertionSuccess();
}

/// Whether an organ that goes through the log, looking at all of the skin after each entry, has the surfaces
/// that this one has, whose skin followed.
::testing::AssertionResult restores_alike(const Organ& organ, std::size_t bodies, const Anatomy& mesh,
                                          double density) {
  ByteWriter saved;
  organ.save(saved);
  Organ restored(organ.pieces().front().body, mesh, density);
  ByteReader in(saved.bytes(), "an organ's log");
  restored.load(in, bodies);
  for (const OrganPiece& piece : organ.pieces()) {
    if (!piece.whole()) continue;
    const PieceSurface a = organ.surface(piece), b = restored.surface(restored.piece(piece.body));
    if (a.surface.triangles != b.surface.triangles || a.surface.inner != b.surface.inner ||
        a.surface.positions != b.surface.positions || a.numbering.nodes != b.numbering.nodes ||
        a.numbering.vertices != b.numbering.vertices || a.numbering.triangles != b.numbering.triangles)
      return ::testing::AssertionFailure() << "another surface of body " << piece.body;
  }
  return ::testing::AssertionSuccess();
}

struct Rung {
  const char *name, *model, *solver;
  bool regions = false, damped = false, relaxes = false;
  double stiffness = 1;  // times as stiff as described, since it was made
};

class FollowingRungs : public ::testing::TestWithParam<Rung> {};

TEST_P(FollowingRungs, CutsAtRandomIsBeingMadeAnew) {
  const Rung rung = GetParam();
  SoftDesc desc;
  desc.name = "block";
  desc.model = rung.model;
  desc.solver = rung.solver;
  desc.damping_stiffness = rung.damped ? 0.01 : 0;
  desc.attach = {{{0.05, 0.1, 0.05}, 0.04, 1e8}};
  if (rung.regions) {
    RegionDesc& region = desc.regions.emplace_back();
    region.center = {0.07, 0.05, 0.05};
    region.radius = 0.04;
    region.youngs_modulus = 5 * desc.youngs_modulus;
  }
  if (rung.relaxes) desc.relaxation = {{0.3, 0.5}, {0.2, 5}};
  const Anatomy mesh = {shaken_box(4), {}, {}};
  Organ organ(0, mesh, desc.density);
  const auto made_anew = [&](std::size_t body) {
    Numbering numbering;
    auto out = std::make_unique<SoftBody>(desc, organ.anatomy(organ.piece(body), numbering));
    out->set_in_force(rung.stiffness, true);
    return out;
  };
  std::map<std::size_t, std::unique_ptr<SoftBody>> bodies;
  bodies[0] = made_anew(0);
  Random random(20261122);
  std::size_t followed = 0, pieces_followed = 0;
  for (unsigned stroke = 0; stroke < 10; ++stroke) {
    // Right through at times, else up to somewhere within.
    const Vec3 along = random.point(1).normalized(), ahead = along.cross(random.point(1)).normalized();
    const Vec3 begin = Vec3::Constant(mesh_size / 2) + random.point(0.02) - mesh_size * ahead;
    const int ticks = stroke % 3 == 0 ? 10 : 6;
    BladeStroke blade = begin_stroke(std::vector<Vec3>{begin - mesh_size * along, begin + mesh_size * along});
    if (stroke % 4 == 3) {
      EXPECT_EQ(organ.undo(1), "");
      for (const std::size_t body : organ.regroup(bodies.size()).bodies) bodies[body] = made_anew(body);
    }
    for (int tick = 1; tick <= ticks; ++tick) {
      std::vector<Vec3> x;
      for (NodeId node = 0; node < organ.complex().node_end(); ++node)
        x.push_back(organ.complex().rest(node));
      const Vec3 middle = begin + tick * 0.2 * mesh_size * ahead;
      const std::vector<Vec3> edge = {middle - mesh_size * along, middle + mesh_size * along};
      if (organ.cut(x, edge, blade, 1, stroke).ops.empty()) continue;
      std::vector<std::size_t> changed;
      const auto edit = organ.cut_in_one_piece();
      const bool follows = edit && bodies[edit->body]->can_follow(edit->mesh);
      if (follows) {
        organ.follow(*edit);
        PieceSurface skin = organ.surface(organ.piece(edit->body));
        bodies[edit->body]->follow(edit->mesh, std::move(skin.surface), std::move(skin.embedding));
        changed = {edit->body};
        ++(edit->body == 0 ? followed : pieces_followed);
      } else {
        changed = organ.regroup(bodies.size()).bodies;
      }
      for (const std::size_t body : changed) {
        auto anew = made_anew(body);
        if (follows) {
          ASSERT_TRUE(same(*bodies[body], *anew, stroke)) << "stroke " << stroke << ", tick " << tick;
        } else {
          bodies[body] = std::move(anew);
        }
      }
    }
    ASSERT_TRUE(restores_alike(organ, bodies.size(), mesh, desc.density)) << "stroke " << stroke;
  }
  EXPECT_GT(followed, 10U);
  EXPECT_GT(pieces_followed, 0U);  // what came off follows, too
}

// What relaxes remembers: each tetrahedron what the one that it is a part of did.
TEST(Following, HistoryIsThatOfWhatATetrahedronIsPartOf) {
  Organ organ(0, {shaken_box(4), {}, {}}, 1000);
  const PieceMesh before = organ.piece(0).mesh;
  const VecX history = VecX::LinSpaced(6 * static_cast<Eigen::Index>(before.tets.size()), 1, 2);
  std::vector<Vec3> x;
  for (NodeId node = 0; node < organ.complex().node_end(); ++node) x.push_back(organ.complex().rest(node));
  const auto edge = [](double at) { return std::vector<Vec3>{{at, 0.051, -0.1}, {at, 0.051, 0.2}}; };
  BladeStroke blade = begin_stroke(edge(-0.01));
  ASSERT_FALSE(organ.cut(x, edge(0.04), blade, 1, 1).ops.empty());
  organ.regroup(1);
  const PieceMesh& now = organ.piece(0).mesh;
  ASSERT_GT(now.tets.size(), before.tets.size());
  const PieceMesh* const meshes[] = {&before};
  const VecX* const histories[] = {&history};
  const VecX carried = carried_history(organ.complex(), meshes, histories, 6, now.tets);
  const auto of = [](const VecX& all, std::size_t tet) {
    return Eigen::Matrix<double, 6, 1>(all.segment<6>(6 * static_cast<Eigen::Index>(tet)));
  };
  for (std::size_t i = 0; i < now.tets.size(); ++i) {
    TetId whole = now.tets[i];
    while (organ.complex().parent(whole) != TetComplex::none) whole = organ.complex().parent(whole);
    EXPECT_EQ(of(carried, i), of(history, whole)) << "tetrahedron " << i;  // uncut, ids are indices
  }
}

INSTANTIATE_TEST_SUITE_P(Rungs, FollowingRungs,
                         ::testing::Values(Rung{"corotational", "fem_corotational", "cg", false, true},
                                           Rung{"regions", "fem_corotational", "cg", true, false, false, 3},
                                           Rung{"neo_hookean", "fem_neo_hookean", "cg", true, true},
                                           Rung{"relaxing", "fem_corotational", "cg", false, false, true},
                                           Rung{"direct", "fem_corotational", "direct"},
                                           Rung{"multigrid", "fem_corotational", "multigrid", false, true}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace prosector
