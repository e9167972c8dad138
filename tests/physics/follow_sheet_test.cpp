// What hangs on a sheet's piece follows cuts, and what takes them back: to the bits that it has made anew.
// And what cuts do to its momentum.

#include <gtest/gtest.h>

#include <algorithm>

#include "common/anatomy/sheets_and_ropes.h"
#include "server/physics/mechanics/organs/momentum.h"
#include "server/physics/mechanics/organs/organ_geometry.h"
#include "server/physics/mechanics/organs/sheet_parts.h"
#include "server/physics/mechanics/organs/surface_follow.h"
#include "server/physics/mechanics/soft/mesh_follower.h"
#include "server/physics/mechanics/soft/springs/sheet_springs.h"
#include "tests/physics/following.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr double side = 0.1, cell = 0.0125, thickness = 0.002;  // m

Anatomy square() {
  return make_sheet({side, thickness, side}, cell);
}

/// An edge that stands upright in the sheet, leaning a little.
std::vector<Vec3> edge_at(const Vec3& at) {
  return {at + Vec3(0, 0.03, 0.002), at - Vec3(0, 0.03, 0.002)};
}

/// From somewhere around or in the sheet to somewhere else.
struct Way {
  Vec3 from, to;
  Vec3 at(double share) const { return from + share * (to - from); }
};

Way random_way(Random& random) {
  const auto place = [&] { return Vec3(random.point(1).cwiseProduct(Vec3(0.06, 0.005, 0.06))); };
  return {place(), place()};
}

::testing::AssertionResult same(const soft::SpringNetwork& a, const soft::SpringNetwork& b) {
  const auto same_spring = [](const soft::Spring& p, const soft::Spring& q) {
    return p.node == q.node && p.rest == q.rest && p.stiffness == q.stiffness;
  };
  const auto same_bend = [](const soft::Bend& p, const soft::Bend& q) {
    return p.node == q.node && p.count == q.count && p.stiffness == q.stiffness && p.weight == q.weight;
  };
  if (!std::ranges::equal(a.springs, b.springs, same_spring))
    return ::testing::AssertionFailure()
           << "other springs: " << a.springs.size() << " and " << b.springs.size();
  if (!std::ranges::equal(a.bends, b.bends, same_bend))
    return ::testing::AssertionFailure() << "other bends: " << a.bends.size() << " and " << b.bends.size();
  if (a.rest != b.rest || a.volume != b.volume || a.dropped != b.dropped)
    return ::testing::AssertionFailure() << "other nodes";
  return ::testing::AssertionSuccess();
}

::testing::AssertionResult same(soft::SoftBody& followed, soft::SoftBody& rebuilt, unsigned seed) {
  const Anatomy &a = followed.anatomy(), &b = rebuilt.anatomy();
  if (followed.content_hash() != rebuilt.content_hash() || a.quads != b.quads || a.triangles != b.triangles ||
      followed.elements() != rebuilt.elements())
    return ::testing::AssertionFailure() << "another mesh";
  if (a.surface.triangles != b.surface.triangles || a.surface.positions != b.surface.positions)
    return ::testing::AssertionFailure() << "another surface";
  return same_answers(followed, rebuilt, seed);
}

struct Rung {
  const char *name, *model, *solver;
  const char* integrator = "implicit_euler";
  bool damped = false;
  double stiffness = 1;  // times as stiff as described, since it was made
};

class FollowingCloths final : public FollowingBodies {
 public:
  FollowingCloths(organs::Organ& cut, const SoftDesc& desc, double stiffness)
      : FollowingBodies(cut, desc, stiffness) {}

 private:
  bool can_follow(const organs::PieceEdit& edit) const override {
    return bodies.at(edit.body).solver->follower().can_follow_sheet(edit.mesh.kept_nodes);
  }
  void follow_cut(const organs::PieceEdit& edit) override {
    organ.follow(edit);
    follow(edit);
  }
  void follow_change(const organs::PieceEdit& edit, const organs::Regrouped&) override { follow(edit); }
  void follow(const organs::PieceEdit& edit) {
    Hung& body = bodies[edit.body];
    Numbering numbering;
    Anatomy sheet = organs::anatomy_of(organ, organ.piece(edit.body), numbering);
    const SurfaceEdit surface = organs::edit_between(body.solver->anatomy().surface, body.numbering,
                                                     sheet.surface, sheet.embedding, numbering);
    soft::SpringNetwork springs = soft::make_sheet_springs(desc.material, body.solver->anatomy());
    soft::follow_sheet(desc.material, sheet, edit.mesh.kept_nodes, edit.touched, springs);
    springs_ = std::move(springs);
    body.solver->follower().follow_sheet(std::move(sheet), edit.mesh.kept_nodes, edit.touched);
    body.follow(surface, std::move(numbering));
  }
  ::testing::AssertionResult same(std::size_t body, Hung& rebuilt, unsigned seed) override {
    if (const auto springs =
            prosector::same(springs_, soft::make_sheet_springs(desc.material, rebuilt.solver->anatomy()));
        !springs)
      return springs;
    return prosector::same(*bodies[body].solver, *rebuilt.solver, seed);
  }

  soft::SpringNetwork springs_;  // of what followed last
};

class FollowingSheets : public ::testing::TestWithParam<Rung> {};

TEST_P(FollowingSheets, CutsAtRandomIsBeingMadeAnew) {
  const Rung rung = GetParam();
  SoftDesc desc;
  desc.name = "sheet";
  desc.configuration.model = rung.model;
  desc.configuration.solver = rung.solver;
  desc.configuration.integrator = rung.integrator;
  desc.material.damping_stiffness = rung.damped ? 0.01 : 0;
  desc.attach = {{{0.05, 0, 0.05}, 0.03, 1e8}};
  const Anatomy sheet = square();
  organs::Organ organ(0, sheet, desc.material.density, organs::held_nodes(desc.attach, sheet));
  FollowingCloths bodies(organ, desc, rung.stiffness);
  Random random(20261122);
  bodies.make_strokes(24, [&](unsigned) -> FollowingBodies::Stroke {
    const Way way = random_way(random);
    return {[=](double share) { return edge_at(way.at(share)); }, 8};
  });
  EXPECT_GT(bodies.cuts, 20U);
  EXPECT_GT(bodies.of_pieces, 0U);
  EXPECT_GT(bodies.fell_apart, 0U);
  EXPECT_GT(bodies.taken_back, 0U);
  EXPECT_GT(bodies.joined, 0U);
  EXPECT_EQ(bodies.not_followed, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Rungs, FollowingSheets,
    ::testing::Values(
        Rung{.name = "mass_spring", .model = "mass_spring", .solver = "cg", .damped = true},
        Rung{.name = "direct", .model = "mass_spring", .solver = "direct", .stiffness = 3},
        Rung{.name = "symplectic_euler",
             .model = "mass_spring",
             .solver = "cg",
             .integrator = "symplectic_euler"},
        Rung{.name = "rk4", .model = "mass_spring", .solver = "cg", .integrator = "rk4", .damped = true},
        Rung{.name = "xpbd", .model = "xpbd", .solver = "cg"}),
    [](const auto& info) { return std::string(info.param.name); });

struct Total {
  double mass = 0;                                    // kg
  Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();  // about the centre of mass
};

Total total(const VecX& mass, const VecX& x, const VecX& v) {
  Total out;
  Vec3 centre = Vec3::Zero();
  const auto at = [](const VecX& of, Eigen::Index i) { return Vec3(of.segment<3>(3 * i)); };
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    out.mass += mass[i];
    out.momentum += mass[i] * at(v, i);
    centre += mass[i] * at(x, i);
  }
  centre /= out.mass;
  for (Eigen::Index i = 0; i < mass.size(); ++i)
    out.spin += mass[i] * (at(x, i) - centre).cross(at(v, i) - out.momentum / out.mass);
  return out;
}

VecX masses(const organs::Organ& organ) {
  const std::vector<cutting::NodeId>& nodes = organ.piece(0).mesh.nodes;
  return VecX::NullaryExpr(static_cast<Eigen::Index>(nodes.size()), [&](Eigen::Index i) {
    return organ.complex().mass(nodes[static_cast<std::size_t>(i)]);
  });
}

// It flies, turns, bends and ripples while it is cut.
TEST(SheetMomentum, AndSpinAreKeptByEachCut) {
  organs::Organ organ(0, square(), 1000);
  const Vec3 flies(0.5, -1, 2), turns(3, 5, -2);
  const auto bent = [](const Vec3& x) { return Vec3(x.x(), 5 * x.x() * x.x() - 3 * x.x() * x.z(), x.z()); };
  const auto velocity = [&](const Vec3& x) {
    return Vec3(flies + turns.cross(x) + 0.3 * Vec3(std::sin(90 * x.z()), std::cos(70 * x.x()), 0));
  };
  VecX x(3 * static_cast<Eigen::Index>(organ.piece(0).mesh.nodes.size())), v = x;
  for (Eigen::Index i = 0; i < x.size() / 3; ++i) {
    x.segment<3>(3 * i) = bent(organ.complex().rest(static_cast<cutting::NodeId>(i)));
    v.segment<3>(3 * i) = velocity(x.segment<3>(3 * i));
  }
  Random random(5);
  int cuts = 0;
  double without = 0, most = 0;  // kg m²/s lost where spin isn't asked for; m/s, most that it takes
  for (unsigned stroke = 0; stroke < 12; ++stroke) {
    const Way way = random_way(random);
    cutting::BladeStroke blade = cutting::begin_stroke(edge_at(way.from));
    for (int tick = 1; tick <= 8; ++tick) {
      const organs::PieceMesh mesh = organ.piece(0).mesh;
      const VecX mass = masses(organ), x_before = x;
      VecX v_before = v;
      if (organ.cut(rest_of(organ), edge_at(way.at(tick / 8.0)), blade, 1, stroke).ops.empty()) continue;
      const auto edit = organs::cut_in_one_piece(organ);
      if (!edit) return;  // it fell apart
      const organs::NodeTransfer transfer(organ.complex(), mesh, edit->nodes, edit->tets, edit->mesh,
                                          nullptr);
      organ.follow(*edit);
      x = transfer.carried(x, edit->mesh);
      v = transfer.carried(v, edit->mesh);
      const VecX carried = v, mass_now = masses(organ);
      const organs::PieceMotion before[] = {{mesh.nodes, &mass, &x_before, &v_before}};
      const organs::PieceMotion now[] = {{organ.piece(0).mesh.nodes, &mass_now, &x, &v}};
      organs::keep_momentum(before, now, false);
      const Total was = total(mass, x_before, v_before);
      without = std::max(without, (total(mass_now, x, v).spin - was.spin).norm());
      v = carried;
      organs::keep_momentum(before, now, true);
      const Total is = total(mass_now, x, v);
      ASSERT_NEAR(is.mass, was.mass, 1e-12 * was.mass);
      ASSERT_LT((is.momentum - was.momentum).norm(), 1e-12 * was.momentum.norm()) << "stroke " << stroke;
      ASSERT_LT((is.spin - was.spin).norm(), 1e-12 * was.spin.norm()) << "stroke " << stroke;
      most = std::max(most, (v - carried).lpNorm<Eigen::Infinity>());
      ++cuts;
    }
  }
  EXPECT_GT(cuts, 10);
  EXPECT_GT(without, 1e-7);
  EXPECT_LT(most, 0.3);  // what nodes of a cell differ by
}

}  // namespace
}  // namespace prosector
