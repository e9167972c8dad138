#include "tests/physics/following.h"

#include <algorithm>

namespace prosector {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

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

AssertionResult same(const Numbering& a, const Numbering& b) {
  if (a.nodes != b.nodes || a.vertices != b.vertices || a.triangles != b.triangles)
    return AssertionFailure() << "numbered otherwise";
  return AssertionSuccess();
}

AssertionResult same(SurfaceDetector& followed, SurfaceDetector& anew, const SoftBody& body) {
  if (!std::ranges::equal(followed.triangle_order(), anew.triangle_order()))
    return AssertionFailure() << "another order of triangles";
  if (vertices_in_order(followed, body.rest()) != vertices_in_order(anew, body.rest()))
    return AssertionFailure() << "another order of vertices";
  const TriangleMesh& surface = body.anatomy().surface;
  for (std::uint32_t vertex = 0; vertex < surface.positions.size(); ++vertex)
    if (!std::ranges::equal(followed.around(vertex), anew.around(vertex)))
      return AssertionFailure() << "other triangles around vertex " << vertex;
  for (std::uint32_t triangle = 0; triangle < surface.triangles.size(); ++triangle)
    if (followed.neighbours(triangle) != anew.neighbours(triangle))
      return AssertionFailure() << "other neighbours of triangle " << triangle;
  return AssertionSuccess();
}

AssertionResult same(const TriangleSurface& followed, const TriangleSurface& anew) {
  const SurfaceTopology &a = followed.topology(), &b = anew.topology();
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
  const auto same_node = [](const SurfaceTree::Node& p, const SurfaceTree::Node& q) {
    return p.box.lo == q.box.lo && p.box.hi == q.box.hi && p.begin == q.begin && p.end == q.end &&
           p.right == q.right;
  };
  if (!std::ranges::equal(followed.tree().order(), anew.tree().order()) ||
      !std::ranges::equal(followed.tree().nodes(), anew.tree().nodes(), same_node))
    return AssertionFailure() << "another tree";
  return AssertionSuccess();
}

}  // namespace

std::vector<Vec3> rest_of(const Organ& organ) {
  std::vector<Vec3> out;
  for (NodeId node = 0; node < organ.complex().node_end(); ++node) out.push_back(organ.complex().rest(node));
  return out;
}

void Hung::find_contact() {
  const Anatomy& anatomy = solver->anatomy();
  detector.emplace(anatomy.embedding, anatomy.surface, anatomy.thickness > 0);
  faces.reset();
  if (!numbering.triangles.empty())  // else nobody has cut it
    faces.emplace(anatomy.surface, detector->triangle_order());
}

void Hung::follow(const SurfaceEdit& edit, Numbering now) {
  detector->follow(edit);
  const bool was_cut = !numbering.triangles.empty();
  numbering = std::move(now);
  const TriangleMesh& surface = solver->anatomy().surface;
  if (numbering.triangles.empty())
    faces.reset();
  else if (was_cut)
    faces->follow(edit, surface, detector->triangle_order());
  else
    faces.emplace(surface, detector->triangle_order());
}

AssertionResult same_contact(Hung& followed, Hung& anew) {
  AssertionResult out = same(followed.numbering, anew.numbering);
  if (out) out = same(*followed.detector, *anew.detector, *anew.solver);
  if (out && followed.faces.has_value() != anew.faces.has_value())
    return AssertionFailure() << "faces where there are none, or none";
  if (out && anew.faces) out = same(*followed.faces, *anew.faces);
  return out;
}

void FollowingBodies::make_strokes(unsigned count, const std::function<Stroke(unsigned)>& next) {
  bodies[0] = made_anew(0);
  for (unsigned stroke = 0; stroke < count; ++stroke) {
    SCOPED_TRACE(::testing::Message() << "stroke " << stroke);
    const Stroke way = next(stroke);
    BladeStroke blade = begin_stroke(way.edge(0));
    if (stroke % 4 == 3 && organ.undo(1).empty()) regroup(true);
    for (int tick = 1; tick <= way.ticks; ++tick) {
      if (::testing::Test::HasFatalFailure()) return;
      if (organ.cut(rest_of(organ), way.edge(1.0 * tick / way.ticks), blade, 1, stroke).ops.empty()) continue;
      const auto edit = organ.cut_in_one_piece();
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
  while (!::testing::Test::HasFatalFailure() && organ.last_stroke(1)) {
    ASSERT_EQ(organ.undo(1), "");
    regroup(true);
  }
}

void FollowingBodies::regroup(bool undone) {
  const Organ::Regrouped changed = organ.regroup(bodies.size());
  const bool joins = std::any_of(changed.before.begin(), changed.before.end(),
                                 [&](const OrganPiece& old) { return !organ.piece(old.body).whole(); });
  for (const std::size_t body : changed.bodies) {
    const auto edit = organ.edit_since(changed, organ.piece(body));
    if (!edit || !can_follow(*edit)) {
      bodies[body] = made_anew(body);
      not_followed += edit ? 1 : 0;
      continue;
    }
    follow_change(*edit, changed);
    compare(body);
    ++(!undone ? fell_apart : joins ? joined : taken_back);
  }
}

void FollowingBodies::compare(std::size_t body) {
  Hung anew = made_anew(body);
  ASSERT_TRUE(same(body, anew, compared_++)) << "body " << body;
  ASSERT_TRUE(same_contact(bodies[body], anew)) << "body " << body;
}

}  // namespace prosector
