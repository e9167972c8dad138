// What hangs on a piece's mesh follows cuts, and what takes them back: to the bits that it has made anew.

#include <gtest/gtest.h>

#include <algorithm>

#include "common/anatomy/embedding.h"
#include "common/anatomy/rest_stretch.h"
#include "common/byte_stream.h"
#include "server/physics/mechanics/organs/organ_geometry.h"
#include "server/physics/mechanics/organs/tet_lineage.h"
#include "server/physics/mechanics/soft/make_model.h"
#include "server/physics/mechanics/soft/mesh_follower.h"
#include "tests/cutting/meshes.h"
#include "tests/physics/following.h"
#include "tests/random.h"

namespace prosector {
namespace {

::testing::AssertionResult same(soft::SoftBody& followed, soft::SoftBody& rebuilt, unsigned seed) {
  const Anatomy &a = followed.anatomy(), &b = rebuilt.anatomy();
  if (followed.content_hash() != rebuilt.content_hash() || a.tets.tets != b.tets.tets ||
      followed.linear_tets().tets != rebuilt.linear_tets().tets ||
      followed.linear_tets().positions != rebuilt.linear_tets().positions)
    return ::testing::AssertionFailure() << "another mesh";
  if (a.surface.triangles != b.surface.triangles || a.surface.inner != b.surface.inner ||
      a.surface.positions != b.surface.positions ||
      !std::ranges::equal(a.embedding.rows, b.embedding.rows, [](const auto& p, const auto& q) {
        return p.node == q.node && p.weight == q.weight;
      }))
    return ::testing::AssertionFailure() << "another surface";
  return same_answers(followed, rebuilt, seed);
}

/// Whether an organ that goes through the log, looking at all of the skin after each entry, has the surfaces
/// that this one has, whose skin followed.
::testing::AssertionResult restores_alike(const organs::Organ& organ, std::size_t bodies, const Anatomy& mesh,
                                          double density) {
  organs::Organ restored(organ.pieces().front().body, mesh, density);
  restored.restore(organ.log(), organ.mark().pieces, bodies);
  for (const organs::OrganPiece& piece : organ.pieces()) {
    if (!piece.whole()) continue;
    const organs::PieceSurface a = organs::surface_of(organ, piece),
                               b = organs::surface_of(restored, restored.piece(piece.body));
    if (a.surface.triangles != b.surface.triangles || a.surface.inner != b.surface.inner ||
        a.surface.positions != b.surface.positions || a.numbering.nodes != b.numbering.nodes ||
        a.numbering.vertices != b.numbering.vertices || a.numbering.triangles != b.numbering.triangles)
      return ::testing::AssertionFailure() << "another surface of body " << piece.body;
  }
  return ::testing::AssertionSuccess();
}

struct Rung {
  const char *name, *model, *solver;
  const char* integrator = "implicit_euler";
  bool regions = false, damped = false, relaxes = false;
  double stiffness = 1;  // times as stiff as described, since it was made
  bool round = false;    // with a surface finer than its tetrahedra, rounded
  bool hold_volume = true;
  double spring_stiffness = 0;  // N/m; 0: from E
  const char* element = "tet4";
  double poisson_ratio = SoftDesc().material.poisson_ratio;
  std::uint32_t cells = 4;  // across
  bool tense = false;       // each tetrahedron stretched otherwise
};

class FollowingBlocks final : public FollowingBodies {
 public:
  FollowingBlocks(organs::Organ& cut, const SoftDesc& desc, const Anatomy& mesh, double stiffness)
      : FollowingBodies(cut, desc, stiffness), mesh_(mesh) {}
  std::size_t surfaces = 0;  // that followed: of what was cut before and is still

 private:
  bool can_follow(const organs::PieceEdit& edit) const override {
    return bodies.at(edit.body).solver->follower().can_follow(edit.mesh);
  }
  void follow_cut(const organs::PieceEdit& edit) override {
    const Hung& body = bodies[edit.body];
    std::optional<SurfaceEdit> surface;
    if (!body.numbering.triangles.empty())
      surface = organs::surface_edit(organ, edit, body.solver->anatomy().surface, body.numbering);
    organ.follow(edit);
    follow(edit, surface);
  }
  void follow_change(const organs::PieceEdit& edit, const organs::Regrouped& changed) override {
    const Hung& body = bodies[edit.body];
    follow(edit, organs::surface_edit_since(organ, changed, organ.piece(edit.body),
                                            body.solver->anatomy().surface, body.numbering));
  }
  void follow(const organs::PieceEdit& edit, const std::optional<SurfaceEdit>& surface) {
    Hung& body = bodies[edit.body];
    const organs::OrganPiece& piece = organ.piece(edit.body);
    if (!surface) {
      organs::PieceSurface skin = organs::surface_of(organ, piece);
      body.numbering = std::move(skin.numbering);
      body.solver->follower().follow(edit.mesh, std::move(skin.surface), std::move(skin.embedding));
      body.remake_surface();
      return;
    }
    Numbering numbering = body.numbering;
    apply(*surface, numbering);
    numbering.nodes = piece.mesh.nodes;
    body.solver->follower().follow(edit.mesh, *surface);
    body.follow(*surface, std::move(numbering));
    ++surfaces;
  }
  ::testing::AssertionResult same(std::size_t body, Hung& rebuilt, unsigned seed) override {
    return prosector::same(*bodies[body].solver, *rebuilt.solver, seed);
  }
  void end_stroke() override {
    ASSERT_TRUE(restores_alike(organ, bodies.size(), mesh_, desc.material.density));
  }

  const Anatomy& mesh_;
};

void stretch_at_random(TetMesh& mesh) {
  Random random(8);
  std::vector<Mat3> stretch;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    stretch.emplace_back((Vec3::Ones() + random.point(0.1)).asDiagonal());
  mesh.stretch = std::make_shared<RestStretch>(mesh, stretch);
}

class FollowingRungs : public ::testing::TestWithParam<Rung> {};

TEST_P(FollowingRungs, CutsAtRandomIsBeingMadeAnew) {
  const Rung rung = GetParam();
  SoftDesc desc;
  desc.name = "block";
  desc.configuration.model = rung.model;
  desc.configuration.element = rung.element;
  desc.material.poisson_ratio = rung.poisson_ratio;
  desc.configuration.solver = rung.solver;
  desc.configuration.integrator = rung.integrator;
  desc.material.damping_stiffness = rung.damped ? 0.01 : 0;
  desc.material.hold_volume = rung.hold_volume;
  desc.material.spring_stiffness = rung.spring_stiffness;
  desc.attach = {{{0.05, 0.1, 0.05}, 0.04, 1e8}};
  if (rung.regions) {
    RegionDesc& region = desc.material.regions.emplace_back();
    region.center = {0.07, 0.05, 0.05};
    region.radius = 0.04;
    region.youngs_modulus = 5 * desc.material.youngs_modulus;
  }
  if (desc.configuration.model == "fem_fibers") desc.material.fiber_stiffness = 1e4;
  if (rung.relaxes) desc.material.relaxation = {{0.3, 0.5}, {0.2, 5}};
  Anatomy mesh = rung.round ? embed(shaken_box(rung.cells), surface_of("block", 0.01)).anatomy
                            : Anatomy{shaken_box(rung.cells), {}, {}};
  if (rung.tense) stretch_at_random(mesh.tets);
  organs::Organ organ(0, mesh, desc.material.density);
  FollowingBlocks bodies(organ, desc, mesh, rung.stiffness);
  Random random(20261122);
  bodies.make_strokes(10, [&](unsigned stroke) -> FollowingBodies::Stroke {
    // Right through at times, else up to somewhere within.
    const Vec3 along = random.point(1).normalized(), ahead = along.cross(random.point(1)).normalized();
    const Vec3 begin = Vec3::Constant(mesh_size / 2) + random.point(0.02) - mesh_size * ahead;
    const int ticks = stroke % 3 == 0 ? 10 : 6;
    return {[=](double share) -> std::vector<Vec3> {
              const Vec3 middle = begin + share * ticks * 0.2 * mesh_size * ahead;
              return {middle - mesh_size * along, middle + mesh_size * along};
            },
            ticks};
  });
  EXPECT_GT(bodies.cuts, 10U);
  EXPECT_GT(bodies.of_pieces, 0U);
  EXPECT_GT(bodies.surfaces, 20U);
  EXPECT_GT(bodies.meetings, 100U);
  EXPECT_GT(bodies.fell_apart, 0U);
  EXPECT_GT(bodies.taken_back, 0U);
  EXPECT_GT(bodies.joined, 0U);
  EXPECT_EQ(bodies.not_followed, 0U);
}

// Which no other answer tells of: it only says from where on single precision will do.
TEST(Following, StiffnessAtRestIsThatOfAModelMadeAnew) {
  SoftDesc desc;
  desc.configuration.model = "fem_fibers";
  desc.material.fiber_stiffness = 1e4;
  RegionDesc& region = desc.material.regions.emplace_back();
  region.center = {0.07, 0.05, 0.05};
  region.radius = 0.04;
  region.fiber_stiffness = 3e4;
  organs::Organ organ(0, {shaken_box(4), {}, {}}, 1000);
  Numbering numbering;
  const auto model = soft::make_elastic_model(desc, organs::anatomy_of(organ, organ.piece(0), numbering));
  TetMesh mesh = organ.whole().tets;
  const auto edge = [](double at) { return std::vector<Vec3>{{at, 0.051, -0.1}, {at, 0.051, 0.2}}; };
  cutting::BladeStroke blade = cutting::begin_stroke(edge(-0.01));
  for (int tick = 1; tick <= 3; ++tick) {
    ASSERT_FALSE(organ.cut(rest_of(organ), edge(0.03 * tick), blade, 1, 1).ops.empty());
    const auto edit = organs::cut_in_one_piece(organ);
    ASSERT_TRUE(edit && model->can_follow(edit->mesh));
    organ.follow(*edit);
    soft::apply(edit->mesh, mesh);
    model->follow(desc.material, mesh, edit->mesh);
    const auto rebuilt = soft::make_elastic_model(desc, organs::anatomy_of(organ, organ.piece(0), numbering));
    EXPECT_EQ(model->rest_trace(), rebuilt->rest_trace());
  }
}

// What relaxes remembers: each tetrahedron what the one that it is a part of did.
TEST(Following, HistoryIsThatOfWhatATetrahedronIsPartOf) {
  organs::Organ organ(0, {shaken_box(4), {}, {}}, 1000);
  const organs::PieceMesh before = organ.piece(0).mesh;
  const VecX history = VecX::LinSpaced(6 * static_cast<Eigen::Index>(before.tets.size()), 1, 2);
  const std::vector<Vec3> x = rest_of(organ);
  const auto edge = [](double at) { return std::vector<Vec3>{{at, 0.051, -0.1}, {at, 0.051, 0.2}}; };
  cutting::BladeStroke blade = cutting::begin_stroke(edge(-0.01));
  ASSERT_FALSE(organ.cut(x, edge(0.04), blade, 1, 1).ops.empty());
  organ.regroup(1);
  const organs::PieceMesh& now = organ.piece(0).mesh;
  ASSERT_GT(now.tets.size(), before.tets.size());
  const organs::PieceMesh* const meshes[] = {&before};
  const VecX* const histories[] = {&history};
  const VecX carried = organs::carried_history(organ.complex(), meshes, histories, 6, now.tets);
  const auto of = [](const VecX& all, std::size_t tet) {
    return Eigen::Matrix<double, 6, 1>(all.segment<6>(6 * static_cast<Eigen::Index>(tet)));
  };
  for (std::size_t i = 0; i < now.tets.size(); ++i) {
    cutting::TetId whole = now.tets[i];
    while (organ.complex().lineage(whole).parent != cutting::TetComplex::none)
      whole = organ.complex().lineage(whole).parent;
    EXPECT_EQ(of(carried, i), of(history, whole)) << "tetrahedron " << i;  // uncut, ids are indices
  }
}

// What a cut leaves of motion, and what it makes, is what a mesh made anew would be given.
TEST(Following, NodesOnEdgesMoveAsThoseOfAMeshMadeAnew) {
  SoftDesc desc;
  desc.configuration.element = "tet10";
  organs::Organ organ(0, {shaken_box(3), {}, {}}, 1000);
  Numbering numbering;
  soft::SoftBody body(desc, organs::anatomy_of(organ, organ.piece(0), numbering));
  const auto edge = [](double at) { return std::vector<Vec3>{{at, 0.051, -0.1}, {at, 0.051, 0.2}}; };
  cutting::BladeStroke blade = cutting::begin_stroke(edge(-0.01));
  Random random(5);
  for (int tick = 1; tick <= 3; ++tick) {
    ASSERT_FALSE(organ.cut(rest_of(organ), edge(0.03 * tick), blade, 1, 1).ops.empty());
    const auto edit = organs::cut_in_one_piece(organ);
    ASSERT_TRUE(edit && body.follower().can_follow(edit->mesh));
    const VecX field = VecX::NullaryExpr(3 * body.nodes(), [&] { return random.uniform(-1, 1); });
    const organs::PieceMesh before = organ.piece(0).mesh;
    const soft::MeshEdit nodes = body.follower().edit_of_nodes(edit->mesh);
    const organs::NodeTransfer made(organ.complex(), before, edit->nodes, edit->tets, nodes,
                                    body.follower().edge_nodes());
    const VecX followed = made.carried(field, nodes);
    organ.follow(*edit);
    const organs::PieceMesh* const pieces[] = {&before};
    const VecX* const fields[] = {&field};
    const organs::NodeTransfer all(organ.complex(), pieces, organ.piece(0).mesh, true);
    EXPECT_EQ(followed, all(fields));
    organs::PieceSurface skin = organs::surface_of(organ, organ.piece(0));
    body.follower().follow(edit->mesh, std::move(skin.surface), std::move(skin.embedding));
    EXPECT_EQ(followed.size(), 3 * body.nodes());
    // Nodes that stay keep what they had.
    for (const soft::Kept::Run& run : nodes.kept_nodes.runs)
      EXPECT_EQ(followed.segment(3 * run.to, 3 * run.count), field.segment(3 * run.from, 3 * run.count));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rungs, FollowingRungs,
    ::testing::Values(
        Rung{.name = "corotational", .model = "fem_corotational", .solver = "cg", .damped = true},
        Rung{.name = "regions", .model = "fem_corotational", .solver = "cg", .regions = true, .stiffness = 3},
        Rung{.name = "neo_hookean",
             .model = "fem_neo_hookean",
             .solver = "cg",
             .regions = true,
             .damped = true},
        Rung{
            .name = "fibers", .model = "fem_fibers", .solver = "multigrid", .regions = true, .relaxes = true},
        Rung{.name = "relaxing", .model = "fem_corotational", .solver = "cg", .relaxes = true},
        Rung{.name = "round", .model = "fem_corotational", .solver = "cg", .round = true},
        Rung{.name = "direct", .model = "fem_corotational", .solver = "direct"},
        Rung{.name = "multigrid", .model = "fem_corotational", .solver = "multigrid", .damped = true},
        Rung{.name = "tense", .model = "fem_corotational", .solver = "cg", .round = true, .tense = true},
        Rung{.name = "tense_springs", .model = "mass_spring", .solver = "cg", .regions = true, .tense = true},
        Rung{.name = "tense_xpbd", .model = "xpbd", .solver = "cg", .damped = true, .tense = true},
        Rung{.name = "tense_quadratic",
             .model = "fem_neo_hookean",
             .solver = "cg",
             .element = "tet10",
             .cells = 3,
             .tense = true},
        Rung{.name = "explicit",
             .model = "fem_corotational",
             .solver = "cg",
             .integrator = "verlet",
             .damped = true},
        Rung{.name = "springs",
             .model = "mass_spring",
             .solver = "direct",
             .damped = true,
             .hold_volume = false},
        Rung{.name = "springs_with_volume",
             .model = "mass_spring",
             .solver = "multigrid",
             .regions = true,
             .damped = true,
             .stiffness = 3},
        Rung{.name = "given_springs", .model = "mass_spring", .solver = "cg", .spring_stiffness = 100},
        Rung{.name = "explicit_springs",
             .model = "mass_spring",
             .solver = "cg",
             .integrator = "symplectic_euler",
             .regions = true},
        Rung{.name = "xpbd", .model = "xpbd", .solver = "cg", .damped = true},
        Rung{.name = "xpbd_regions", .model = "xpbd", .solver = "direct", .regions = true, .stiffness = 3},
        Rung{.name = "quadratic",
             .model = "fem_corotational",
             .solver = "cg",
             .regions = true,
             .damped = true,
             .element = "tet10",
             .poisson_ratio = 0.49,
             .cells = 3},
        Rung{.name = "quadratic_round",
             .model = "fem_corotational",
             .solver = "cg",
             .round = true,
             .element = "tet10",
             .cells = 3},
        Rung{.name = "quadratic_relaxing",
             .model = "fem_neo_hookean",
             .solver = "cg",
             .regions = true,
             .relaxes = true,
             .element = "tet10",
             .poisson_ratio = 0.45,
             .cells = 3}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace prosector
