#include "tests/physics/following.h"

#include <algorithm>
#include <cmath>

#include "idl/message.h"
#include "server/physics/mechanics/organs/organ_geometry.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/integrators/substepper.h"
#include "tests/random.h"

namespace prosector {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

/// In which order vertices are looked at, and where they are.
std::vector<Vec3> vertices_in_order(contact::TissueSurface& surface, const VecX& x) {
  surface.place(x);
  const contact::SurfaceDetector& detector = surface.vertices();
  std::vector<Vec3> out;
  detector.in_box(detector.lo(), detector.hi(), [&](std::uint32_t vertex) {
    out.push_back(detector.positions()[vertex]);
    out.push_back(Vec3::Constant(vertex));
  });
  return out;
}

AssertionResult same(const Numbering& a, const Numbering& b) {
  if (a.nodes != b.nodes || a.vertices != b.vertices || a.triangles != b.triangles)
    return AssertionFailure() << "numbered otherwise";
  return AssertionSuccess();
}

AssertionResult same_vertices(contact::TissueSurface& a, contact::TissueSurface& b,
                              const soft::SoftBody& body) {
  const contact::SurfaceDetector &followed = a.vertices(), &rebuilt = b.vertices();
  if (!std::ranges::equal(followed.triangle_order(), rebuilt.triangle_order()))
    return AssertionFailure() << "another order of triangles";
  if (vertices_in_order(a, body.rest()) != vertices_in_order(b, body.rest()))
    return AssertionFailure() << "another order of vertices";
  const TriangleMesh& surface = body.anatomy().surface;
  for (std::uint32_t vertex = 0; vertex < surface.positions.size(); ++vertex)
    if (!std::ranges::equal(followed.around(vertex), rebuilt.around(vertex)))
      return AssertionFailure() << "other triangles around vertex " << vertex;
  for (std::uint32_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
    if (followed.neighbours(triangle) != rebuilt.neighbours(triangle))
      return AssertionFailure() << "other neighbours of triangle " << triangle;
  return AssertionSuccess();
}

AssertionResult same(const collision::TriangleSurface& followed, const collision::TriangleSurface& rebuilt) {
  const collision::SurfaceTopology &a = followed.topology(), &b = rebuilt.topology();
  if (!std::ranges::equal(a.triangles(), b.triangles()) || a.vertices() != b.vertices() ||
      a.closed() != b.closed() || !std::ranges::equal(a.pieces(), b.pieces()))
    return AssertionFailure() << "another topology";
  for (std::uint32_t vertex = 0; vertex < a.vertices(); ++vertex)
    if (!std::ranges::equal(a.around(vertex), b.around(vertex)))
      return AssertionFailure() << "other faces around vertex " << vertex;
  for (std::uint32_t triangle = 0; triangle < a.triangles().size(); ++triangle)
    for (std::size_t k = 0; k < 3; ++k)
      if (a.across(triangle, k) != b.across(triangle, k))
        return AssertionFailure() << "another face across an edge of " << triangle;
  const auto same_node = [](const collision::SurfaceTree::Node& p, const collision::SurfaceTree::Node& q) {
    return p.box.lo == q.box.lo && p.box.hi == q.box.hi && p.begin == q.begin && p.end == q.end &&
           p.right == q.right;
  };
  if (!std::ranges::equal(followed.tree().order(), rebuilt.tree().order()) ||
      !std::ranges::equal(followed.tree().nodes(), rebuilt.tree().nodes(), same_node))
    return AssertionFailure() << "another tree";
  return AssertionSuccess();
}

/// At places that only `seed` tells.
std::vector<VecX> answers(soft::SoftBody& body, unsigned seed) {
  Random random(seed);
  const Eigen::Index n = 3 * body.nodes();
  const auto near = [&](const VecX& x, double reach) {
    return VecX(x + VecX::NullaryExpr(n, [&] { return random.uniform(-reach, reach); }));
  };
  soft::SoftBodyState state = body.initial_state();
  state.motion.x = near(body.rest(), 1e-3);
  state.motion.v = near(VecX::Zero(n), 0.1);
  soft::IncrementalPotential& potential = body.potential();
  const soft::Weight weight = body.weight({0, -9.81, 0}, true);
  body.stepper().begin_stage(0, 0.01, weight, state);
  const VecX x = near(state.motion.x, 1e-3), p = near(VecX::Zero(n), 1);
  potential.linearise(x);
  VecX gradient = VecX::Zero(n), product(n), solution(n);
  potential.gradient(x, gradient);
  const double energy = potential.energy(x);
  potential.assemble(x);
  potential.multiply(p.data(), product.data());
  std::vector<Mat3> diagonal(static_cast<std::size_t>(body.nodes()));
  potential.diagonal(diagonal);
  std::vector<Mat3> inverse;
  for (const Mat3& block : diagonal) inverse.push_back(block.inverse());
  if (body.desc().configuration.solver == "direct")
    potential.factor_solve(p.data(), solution.data());
  else if (body.desc().configuration.solver == "multigrid")
    potential.multigrid_solve(diagonal, inverse, p.data(), solution.data());
  else
    solution.setZero();
  VecX blocks(9 * body.nodes());
  for (Eigen::Index i = 0; i < body.nodes(); ++i)
    blocks.segment<9>(9 * i) = diagonal[static_cast<std::size_t>(i)].reshaped();
  const VecX area = Eigen::Map<const VecX>(body.surface_area().data(),
                                           static_cast<Eigen::Index>(body.surface_area().size()));
  VecX numbers(5);
  numbers << energy, body.diagonal(), potential.elastic_energy(x), body.total_mass(),
      static_cast<double>(potential.tangent_is_cheap());
  if (soft::Substepper* steps = body.substepper()) {
    steps->begin(state);
    for (int i = 0; i < 3; ++i) steps->step(1e-4, weight, state);
    steps->finish(1e-4, state);
  }
  return {body.rest(),    body.node_mass(), body.attachment_stiffness(),
          area,           numbers,          gradient,
          product,        solution,         blocks,
          state.motion.x, state.mode,       VecX::Constant(1, state.omega)};
}

}  // namespace

AssertionResult same_answers(soft::SoftBody& followed, soft::SoftBody& rebuilt, unsigned seed) {
  const std::vector<VecX> x = answers(followed, seed), y = answers(rebuilt, seed);
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i].size() != y[i].size() || x[i] != y[i]) return AssertionFailure() << "answer " << i << " differs";
  return AssertionSuccess();
}

std::vector<Vec3> rest_of(const organs::Organ& organ) {
  std::vector<Vec3> out;
  for (cutting::NodeId node = 0; node < organ.complex().node_end(); ++node)
    out.push_back(organ.complex().rest(node));
  return out;
}

void Hung::make_surface() {
  surface.emplace(solver->anatomy());
  fit();
}

void Hung::remake_surface() {
  surface->remake();
  fit();
}

void Hung::follow(const SurfaceEdit& edit, Numbering now) {
  numbering = std::move(now);
  surface->follow(edit, !numbering.triangles.empty());
  fit();
}

void Hung::fit() {
  surface->fit({}, !numbering.triangles.empty());
  if (!surface->faces() || solver->anatomy().thickness > 0) return;
  EXPECT_TRUE(surface->fit_self_collision(2 * solver->desc().geometry.cell)) << "an open surface";
}

std::vector<contact::VertexMeeting> meetings_when_crumpled(Hung& body, unsigned seed) {
  std::vector<contact::VertexMeeting> out;
  contact::TissueSurface& surface = *body.surface;
  if (!surface.self_collision()) return out;
  const double cell = body.solver->desc().geometry.cell, little = 0.1 * std::sin(seed);  // cells
  const VecX rest = body.solver->rest();
  VecX x = rest;
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] += cell * (1 + little) * std::sin(2 * rest[3 * (i / 3) + (i + 1) % 3] / cell);
  surface.place(x);
  surface.begin_tick();
  surface.self_collision()->find({&surface.vertices(), surface.moved_faces(), 0, cell}, cell, out);
  return out;
}

AssertionResult same_contact(Hung& followed, Hung& rebuilt) {
  AssertionResult out = same(followed.numbering, rebuilt.numbering);
  if (out) out = same_vertices(*followed.surface, *rebuilt.surface, *rebuilt.solver);
  const collision::TriangleSurface *a = followed.surface->faces(), *b = rebuilt.surface->faces();
  if (out && (a == nullptr) != (b == nullptr))
    return AssertionFailure() << "faces where there are none, or none";
  if (out && b != nullptr) out = same(*a, *b);
  return out;
}

Hung FollowingBodies::rebuild(std::size_t body) const {
  Hung out;
  out.solver =
      std::make_unique<soft::SoftBody>(desc, organs::anatomy_of(organ, organ.piece(body), out.numbering));
  out.solver->set_in_force(stiffness_, true);
  out.make_surface();
  return out;
}

void FollowingBodies::make_strokes(unsigned count, const std::function<Stroke(unsigned)>& next) {
  bodies[0] = rebuild(0);
  for (unsigned stroke = 0; stroke < count; ++stroke) {
    SCOPED_TRACE(::testing::Message() << "stroke " << stroke);
    const Stroke way = next(stroke);
    cutting::BladeStroke blade = cutting::begin_stroke(way.edge(0));
    if (stroke % 4 == 3 && !organ.undo(1)) regroup(true);
    for (int tick = 1; tick <= way.ticks; ++tick) {
      if (::testing::Test::HasFatalFailure()) return;
      if (organ.cut(rest_of(organ), way.edge(1.0 * tick / way.ticks), blade, 1, stroke).ops.empty()) continue;
      const auto edit = organs::cut_in_one_piece(organ);
      if (!edit || !can_follow(*edit)) {
        regroup(false);
        continue;
      }
      follow_cut(*edit);
      compare(edit->body);
      ++(edit->body == 0 ? cuts : of_pieces);
    }
    end_stroke();
  }
  while (!::testing::Test::HasFatalFailure() && organs::last_stroke(organ.log(), 1)) {
    ASSERT_FALSE(organ.undo(1));
    regroup(true);
  }
}

void FollowingBodies::regroup(bool undone) {
  const organs::Regrouped changed = organ.regroup(bodies.size());
  const bool joins =
      std::any_of(changed.before.begin(), changed.before.end(),
                  [&](const organs::OrganPiece& old) { return !organ.piece(old.body).whole(); });
  for (const std::size_t body : changed.bodies) {
    const auto edit = organs::edit_since(organ, changed, organ.piece(body));
    if (!edit || !can_follow(*edit)) {
      bodies[body] = rebuild(body);
      not_followed += edit ? 1 : 0;
      continue;
    }
    follow_change(*edit, changed);
    compare(body);
    ++(!undone ? fell_apart : joins ? joined : taken_back);
  }
}

void FollowingBodies::compare(std::size_t body) {
  Hung rebuilt = rebuild(body);
  ASSERT_TRUE(same(body, rebuilt, compared_++)) << "body " << body;
  ASSERT_TRUE(same_contact(bodies[body], rebuilt)) << "body " << body;
  const auto found = meetings_when_crumpled(bodies[body], compared_);
  const auto same_meeting = [](const contact::VertexMeeting& a, const contact::VertexMeeting& b) {
    return a.vertex == b.vertex && a.at.triangle == b.at.triangle && a.at.weights == b.at.weights &&
           a.normal == b.normal && a.gap == b.gap;
  };
  ASSERT_TRUE(std::ranges::equal(found, meetings_when_crumpled(rebuilt, compared_), same_meeting))
      << "body " << body << " meets itself elsewhere";
  meetings += found.size();
}

}  // namespace prosector
