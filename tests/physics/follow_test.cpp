// What hangs on a piece's mesh follows cuts, and what takes them back: to the bits that it has made anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "common/anatomy/embedding.h"
#include "server/physics/byte_stream.h"
#include "server/physics/collision/triangle_surface.h"
#include "server/physics/contact/surface_detector.h"
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

/// A body with what the simulation hangs on its surface.
struct Hung {
  std::unique_ptr<SoftBody> solver;
  Numbering numbering;
  std::optional<SurfaceDetector> detector;
  std::optional<TriangleSurface> faces;

  void find_contact() {
    detector.emplace(solver->anatomy().embedding, solver->anatomy().surface);
    if (!numbering.triangles.empty())  // else nobody has cut it
      faces.emplace(solver->anatomy().surface, detector->triangle_order());
  }
};

/// In which order vertices are looked at, and where they are.
std::vector<Vec3> vertices_in_order(SurfaceDetector& detector, const VecX& x) {
  detector.update(x.data());
  std::vector<Vec3> out;
  detector.in_box(detector.lo(), detector.hi(), [&](std::uint32_t vertex) {
    out.push_back(detector.positions()[vertex]);
    out.push_back(Vec3::Constant(vertex));
  });
  return out;
}

::testing::AssertionResult same(const Numbering& a, const Numbering& b) {
  if (a.nodes != b.nodes || a.vertices != b.vertices || a.triangles != b.triangles)
    return ::testing::AssertionFailure() << "numbered otherwise";
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult same(SurfaceDetector& followed, SurfaceDetector& anew, const SoftBody& body) {
  if (!std::ranges::equal(followed.triangle_order(), anew.triangle_order()))
    return ::testing::AssertionFailure() << "another order of triangles";
  if (vertices_in_order(followed, body.rest()) != vertices_in_order(anew, body.rest()))
    return ::testing::AssertionFailure() << "another order of vertices";
  const TriangleMesh& surface = body.anatomy().surface;
  for (std::uint32_t vertex = 0; vertex < surface.positions.size(); ++vertex)
    if (!std::ranges::equal(followed.around(vertex), anew.around(vertex)))
      return ::testing::AssertionFailure() << "other triangles around vertex " << vertex;
  for (std::uint32_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
    if (followed.neighbours(triangle) != anew.neighbours(triangle))
      return ::testing::AssertionFailure() << "other neighbours of triangle " << triangle;
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult same(const TriangleSurface& followed, const TriangleSurface& anew) {
  const SurfaceTopology &a = followed.topology(), &b = anew.topology();
  if (!std::ranges::equal(a.triangles(), b.triangles()) || a.vertices() != b.vertices() ||
      a.closed() != b.closed() || !std::ranges::equal(a.pieces(), b.pieces()))
    return ::testing::AssertionFailure() << "another topology";
  for (std::uint32_t vertex = 0; vertex < a.vertices(); ++vertex)
    if (!std::ranges::equal(a.around(vertex), b.around(vertex)))
      return ::testing::AssertionFailure() << "other faces around vertex " << vertex;
  for (std::uint32_t triangle = 0; triangle < a.triangles().size(); ++triangle)
    for (std::size_t k = 0; k < 3; ++k)
      if (a.across(triangle, k) != b.across(triangle, k))
        return ::testing::AssertionFailure() << "another face across an edge of " << triangle;
  const auto same_node = [](const SurfaceTree::Node& p, const SurfaceTree::Node& q) {
    return p.box.lo == q.box.lo && p.box.hi == q.box.hi && p.begin == q.begin && p.end == q.end &&
           p.right == q.right;
  };
  if (!std::ranges::equal(followed.tree().order(), anew.tree().order()) ||
      !std::ranges::equal(followed.tree().nodes(), anew.tree().nodes(), same_node))
    return ::testing::AssertionFailure() << "another tree";
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
  bool round = false;    // with a surface finer than its tetrahedra, rounded
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
  const Anatomy mesh =
      rung.round ? embed(shaken_box(4), surface_of("block", 0.01)).anatomy : Anatomy{shaken_box(4), {}, {}};
  Organ organ(0, mesh, desc.density);
  const auto made_anew = [&](std::size_t body) {
    Hung out;
    out.solver = std::make_unique<SoftBody>(desc, organ.anatomy(organ.piece(body), out.numbering));
    out.solver->set_in_force(rung.stiffness, true);
    out.find_contact();
    return out;
  };
  std::map<std::size_t, Hung> bodies;
  bodies[0] = made_anew(0);
  Random random(20261122);
  std::size_t followed = 0, pieces_followed = 0, surfaces_followed = 0, fell_apart = 0, taken_back = 0,
              joined = 0;
  // As the simulation does; whether each is what it is made anew.
  const auto regroup = [&](bool undone) {
    const Organ::Regrouped changed = organ.regroup(bodies.size());
    const bool joins = std::any_of(changed.before.begin(), changed.before.end(),
                                   [&](const OrganPiece& old) { return !organ.piece(old.body).whole(); });
    for (const std::size_t body : changed.bodies) {
      const OrganPiece& piece = organ.piece(body);
      Hung anew = made_anew(body);
      const auto edit = organ.edit_since(changed, piece);
      if (!edit) {
        bodies[body] = std::move(anew);
        continue;
      }
      Hung& hung = bodies[body];
      ASSERT_TRUE(hung.solver->can_follow(*edit));
      PieceSurface skin = organ.surface(piece);
      hung.numbering = std::move(skin.numbering);
      hung.solver->follow(*edit, std::move(skin.surface), std::move(skin.embedding));
      hung.find_contact();
      ASSERT_TRUE(same(*hung.solver, *anew.solver, 7)) << "body " << body;
      ASSERT_TRUE(same(hung.numbering, anew.numbering));
      ++(!undone ? fell_apart : joins ? joined : taken_back);
    }
  };
  for (unsigned stroke = 0; stroke < 10; ++stroke) {
    // Right through at times, else up to somewhere within.
    const Vec3 along = random.point(1).normalized(), ahead = along.cross(random.point(1)).normalized();
    const Vec3 begin = Vec3::Constant(mesh_size / 2) + random.point(0.02) - mesh_size * ahead;
    const int ticks = stroke % 3 == 0 ? 10 : 6;
    BladeStroke blade = begin_stroke(std::vector<Vec3>{begin - mesh_size * along, begin + mesh_size * along});
    if (stroke % 4 == 3) {
      EXPECT_EQ(organ.undo(1), "");
      ASSERT_NO_FATAL_FAILURE(regroup(true)) << "stroke " << stroke << " undone";
    }
    for (int tick = 1; tick <= ticks; ++tick) {
      std::vector<Vec3> x;
      for (NodeId node = 0; node < organ.complex().node_end(); ++node)
        x.push_back(organ.complex().rest(node));
      const Vec3 middle = begin + tick * 0.2 * mesh_size * ahead;
      const std::vector<Vec3> edge = {middle - mesh_size * along, middle + mesh_size * along};
      if (organ.cut(x, edge, blade, 1, stroke).ops.empty()) continue;
      const auto edit = organ.cut_in_one_piece();
      if (edit && bodies[edit->body].solver->can_follow(edit->mesh)) {
        Hung& body = bodies[edit->body];
        if (body.numbering.triangles.empty()) {
          organ.follow(*edit);
          PieceSurface skin = organ.surface(organ.piece(edit->body));
          body.numbering = std::move(skin.numbering);
          body.solver->follow(edit->mesh, std::move(skin.surface), std::move(skin.embedding));
          body.find_contact();
        } else {
          const SurfaceEdit surface =
              organ.surface_edit(*edit, body.solver->anatomy().surface, body.numbering);
          organ.follow(*edit);
          apply(surface, body.numbering);
          body.numbering.nodes = organ.piece(edit->body).mesh.nodes;
          body.solver->follow(edit->mesh, surface);
          body.detector->follow(surface);
          body.faces->follow(surface, body.solver->anatomy().surface, body.detector->triangle_order());
          ++surfaces_followed;
        }
        ++(edit->body == 0 ? followed : pieces_followed);
        Hung anew = made_anew(edit->body);
        SCOPED_TRACE(::testing::Message() << "stroke " << stroke << ", tick " << tick);
        ASSERT_TRUE(same(*body.solver, *anew.solver, stroke));
        ASSERT_TRUE(same(body.numbering, anew.numbering));
        ASSERT_TRUE(same(*body.detector, *anew.detector, *anew.solver));
        ASSERT_TRUE(same(*body.faces, *anew.faces));
      } else {
        ASSERT_NO_FATAL_FAILURE(regroup(false)) << "stroke " << stroke << ", tick " << tick;
      }
    }
    ASSERT_TRUE(restores_alike(organ, bodies.size(), mesh, desc.density)) << "stroke " << stroke;
  }
  EXPECT_GT(followed, 10U);
  EXPECT_GT(pieces_followed, 0U);  // what came off follows, too
  EXPECT_GT(surfaces_followed, 10U);
  EXPECT_GT(fell_apart, 0U);
  // The rest, to the uncut mesh.
  while (organ.last_stroke(1)) {
    ASSERT_EQ(organ.undo(1), "");
    ASSERT_NO_FATAL_FAILURE(regroup(true));
  }
  EXPECT_GT(taken_back, 0U);
  EXPECT_GT(joined, 0U);
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
                                           Rung{"round", "fem_corotational", "cg", false, false, false, 1,
                                                true},
                                           Rung{"direct", "fem_corotational", "direct"},
                                           Rung{"multigrid", "fem_corotational", "multigrid", false, true}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace prosector
