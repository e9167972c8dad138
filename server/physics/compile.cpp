#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <set>

#include "common/byte_stream.h"
#include "common/error.h"
#include "common/primitives.h"
#include "server/physics/contact/self_surface.h"
#include "server/physics/fracture.h"
#include "server/physics/model.h"
#include "server/physics/rigid/collision_shape.h"
#include "server/physics/soft/compression.h"
#include "server/physics/soft/rungs.h"
#include "server/physics/sources.h"
#include "server/physics/tension.h"

namespace prosector {
namespace {

constexpr double told_of_tension = 1e-3;  // m: of less than this the author is not told
constexpr double coarse_surface = 1.5;    // a surface's edge over an element's: what is too coarse to feel it
constexpr double near_the_room = 0.02;    // m: soft bodies as near may rest on it
constexpr double least_share_of_hull = 0.02;  // of its hull's volume that a closed mesh fills, at least

ShapePart to_shape(const PartDesc& part) {
  const double r = part.size.x() / 2, y = part.size.y() / 2;
  if (part.shape == "box") return {ShapeKind::box, part.size / 2, part.pose, nullptr};
  if (part.shape == "sphere") return {ShapeKind::sphere, {r, 0, 0}, part.pose, nullptr};
  if (part.shape == "capsule") return {ShapeKind::capsule, {r, std::max(0.0, y - r), r}, part.pose, nullptr};
  if (part.shape == "cylinder") return {ShapeKind::cylinder, {r, y, r}, part.pose, nullptr};
  return {ShapeKind::ellipsoid, part.size / 2, part.pose, nullptr};
}

/// Returns the mass properties of a mesh as given, or of its hull when it isn't closed: a thin or open
/// surface has no volume of its own.
MassProperties mesh_mass(const TriangleMesh& mesh, const ShapePart& hull, double density) {
  const MassProperties of_hull = part_mass(hull, density);
  ShapePart solid = hull;
  solid.mesh = std::make_shared<TriangleMesh>(mesh);
  const MassProperties own = part_mass(solid, density);
  const bool plausible = own.mass > least_share_of_hull * of_hull.mass && own.mass < 1.01 * of_hull.mass &&
                         Eigen::SelfAdjointEigenSolver<Mat3>(own.inertia).eigenvalues().minCoeff() > 0;
  return plausible ? own : of_hull;
}

struct Solid {
  std::vector<ShapePart> parts;  // body frame
  MassProperties mass;
};

Solid solid_of_parts(const RigidDesc& desc) {
  Solid out;
  std::vector<MassProperties> masses;
  for (const PartDesc& part : desc.parts) {
    out.parts.push_back(to_shape(part));
    masses.push_back(part_mass(out.parts.back(), desc.density));
  }
  out.mass = combine(masses);
  return out;
}

Solid solid_of_mesh(const RigidDesc& desc, const TriangleMesh& surface) {
  ShapePart hull{
      ShapeKind::hull, Vec3::Zero(), {}, std::make_shared<TriangleMesh>(convex_hull(surface.positions))};
  Solid out;
  out.mass = mesh_mass(surface, hull, desc.density);
  if (fidelity_of(desc.collision) == Fidelity::mesh)
    out.parts = {{ShapeKind::triangles, Vec3::Zero(), {}, std::make_shared<TriangleMesh>(surface)}};
  else
    out.parts = {hull};
  return out;
}

CollisionGroups groups_of(const SceneDesc& scene) {
  CollisionGroups out;
  std::set<std::string> known = {default_group, hand_group};
  out.add(hand_group);
  const auto add = [&](const auto& bodies) {
    for (const auto& body : bodies)
      if (known.insert(body.group).second) out.add(body.group);
  };
  add(scene.rigid);
  add(scene.soft);
  return out;
}

RigidModel compile_rigid(const RigidDesc& desc, TriangleMesh surface, const CollisionGroups& groups) {
  Solid solid = desc.parts.empty() ? solid_of_mesh(desc, surface) : solid_of_parts(desc);
  // What breaks weighs what its surface encloses, as its pieces do: so they keep its momentum.
  if (desc.break_force > 0) solid.mass = solid_of_mesh(desc, surface).mass;
  if (!(solid.mass.mass > 0) && !desc.fixed)
    throw InputError(
        fmt::format("rigid '{}': has no volume, so no mass; give it parts or a closed mesh", desc.name));
  if (desc.mass > 0 && solid.mass.mass > 0) {
    solid.mass.inertia *= desc.mass / solid.mass.mass;
    solid.mass.mass = desc.mass;
  }
  RigidModel out;
  out.name = desc.name;
  out.surface = std::move(surface);
  out.start = desc.pose;
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(solid.mass.inertia);
  Mat3 axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  out.center = {solid.mass.center, Quat(axes).normalized()};
  if (desc.fixed) out.center = {};
  out.setup.mass = desc.fixed ? 0 : solid.mass.mass;
  if (!desc.fixed) out.setup.inertia = principal.eigenvalues();
  out.setup.friction = desc.friction;
  out.setup.rolling_resistance = desc.rolling_resistance;
  out.setup.restitution = desc.restitution;
  out.setup.balanced = desc.balanced;
  out.setup.continuous = desc.continuous;
  out.setup.mask = groups.mask(desc.group, desc.touches);
  for (ShapePart part : at_fidelity(std::move(solid.parts), fidelity_of(desc.collision), desc.pose)) {
    part.pose = out.center.inverse() * part.pose;
    out.shape.distances.push_back(make_signed_distance(part));
    out.shape.parts.push_back(std::move(part));
  }
  out.setup.parts = out.shape.parts;
  return out;
}

void add_mesh(const TriangleMesh& mesh, ByteWriter& out) {
  for (const Vec3& x : mesh.positions) out.add(x);
  for (const auto& t : mesh.triangles) out.raw(t.data(), sizeof t);
}

std::vector<RoomModel> compile_room(const std::optional<RoomDesc>& room) {
  std::vector<RoomModel> out;
  for (const RoomSide& side : room_sides(room)) {
    RoomModel& made = out.emplace_back();
    made.side = side;
    made.shape.parts.push_back(solid_of(side));
    made.shape.distances.push_back(make_signed_distance(made.shape.parts.front()));
  }
  return out;
}

/// Returns the sides that the body's start is behind: the scene puts it there, so it goes through them.
template <class Say>
RoomSides passed_sides(const std::string& name, std::span<const Vec3> start, const Model& model,
                       const Say& say) {
  std::vector<RoomSide> room;
  for (const RoomModel& side : model.room) room.push_back(side.side);
  const RoomSides out = sides_before(start, room);
  if (out != 0)
    say(fmt::format("{}: begins behind the room's {}, so it passes through that side", name,
                    has_side(out, 0) && model.scene.room->floor ? "floor" : "wall"));
  return out;
}

bool begins_on(const SoftBody& body, const RoomSide& side) {
  const auto& points = body.anatomy().surface.positions;
  const double reach = near_the_room + body.anatomy().thickness / 2;
  return std::any_of(points.begin(), points.end(),
                     [&](const Vec3& x) { return side.normal.dot(x - side.point) <= reach; });
}

void add_rigid(const RigidModel& r, double break_force, ByteWriter& out) {
  out.add(r.name);
  add_mesh(r.surface, out);
  out.add(r.center);
  out.add(r.start);
  for (const double v : {r.setup.mass, r.setup.friction, r.setup.restitution}) out.add(v);
  if (r.setup.balanced) out.add(r.setup.balanced);
  if (r.setup.rolling_resistance > 0) out.add(r.setup.rolling_resistance);
  out.add(r.setup.inertia);
  for (const RigidModel::Fracture& plane : r.fractures) {
    out.add(plane.point);
    out.add(plane.normal);
    out.add(break_force);
  }
  for (const ShapePart& part : r.shape.parts) {
    out.add(part.kind);
    out.add(part.half);
    out.add(part.pose);
    if (part.mesh) add_mesh(*part.mesh, out);
  }
}

void add_soft(const SoftBody& s, ByteWriter& out) {
  const SoftDesc& d = s.desc();
  out.add(d.name);
  out.add(s.content_hash());
  add_mesh(s.anatomy().surface, out);
  for (const std::string& text : {d.model, d.integrator, d.solver}) out.add(text);
  for (const double v : {d.youngs_modulus, d.poisson_ratio, d.density, d.damping_mass, d.damping_stiffness,
                         d.friction, d.solver_tolerance, d.surface_cell, d.spring_stiffness,
                         d.shear_stiffness, d.bending_stiffness, s.anatomy().thickness})
    out.add(v);
  for (const int v : {d.newton_iterations, d.solver_iterations, static_cast<int>(d.gravity), d.substeps,
                      d.max_substeps, static_cast<int>(d.hold_volume)})
    out.add(v);
  // Bodies without these keep the hash that sessions recorded before them have.
  if (d.fiber_stiffness > 0 || !d.regions.empty()) {
    out.add(d.fiber_stiffness);
    out.add(d.fiber_direction);
  }
  if (rolls(fidelity_of(d.collision))) out.add(d.rolling_resistance);
  for (const RegionDesc& r : d.regions) {
    for (const Vec3& v : {r.center, r.size, r.fiber_direction}) out.add(v);
    for (const double v : {r.radius, r.youngs_modulus, r.poisson_ratio, r.fiber_stiffness}) out.add(v);
  }
  for (const RelaxationDesc& r : d.relaxation)
    for (const double v : {r.share, r.time}) out.add(v);
  if (d.tension) {
    out.add(d.tension.value);
    out.add(d.tension_depth);
  }
  out.add(s.attachment_stiffness());
}

/// Hashes everything that changes what a tick computes or what is drawn.
ContentHash hash_of(const Model& model, std::span<const CompiledTissue> soft) {
  ByteWriter out;
  const SceneDesc& scene = model.scene;
  out.add(scene.gravity);
  out.add(scene.tick_rate);
  out.add(scene.contact_stiffness);
  for (const double v : {scene.hand.mass, scene.hand.stiffness, scene.hand.max_force, scene.hand.tear_force,
                         scene.hand.friction})
    out.add(v);
  for (std::size_t i = 0; i < model.rigid.size(); ++i)
    add_rigid(model.rigid[i], scene.rigid[i].break_force, out);
  // Scenes without these keep the hash that sessions recorded before them have.
  const auto add_collision = [&](const auto& desc) {
    using Desc = std::decay_t<decltype(desc)>;
    if (desc.group != default_group || !desc.touches.empty()) {
      out.add(desc.group);
      for (const std::string& group : desc.touches) out.add(group);
    }
    if (desc.continuous) out.add(std::string("continuous"));
    if (desc.collision != Desc().collision) out.add(desc.collision);
  };
  for (const RigidDesc& desc : scene.rigid) add_collision(desc);
  for (const SoftDesc& desc : scene.soft) {
    add_collision(desc);
    if (desc.self_contact) out.add(std::string("self_contact"));
    if (desc.contact != SoftDesc().contact) out.add(desc.contact);
    if (desc.refine != SoftDesc().refine) {
      out.add(desc.refine);
      for (const double v : {desc.cell, desc.refine_cell, desc.refine_reach}) out.add(v);
      out.add(desc.refine_most);
    }
  }
  if (scene.room && !scene.room->floor) out.add(std::string("no floor"));
  if (scene.room && !scene.room->walls) out.add(std::string("no walls"));
  for (std::size_t i = 0; i < model.room.size(); ++i)  // their equilibrium is another than it was
    for (const CompiledTissue& tissue : soft)
      if (!has_side(tissue.collision.passes, i) && begins_on(*tissue.solver, model.room[i].side))
        out.add(static_cast<std::uint64_t>(i));
  for (const RigidDesc& desc : scene.rigid)
    for (const EdgeDesc& edge : desc.edges) {
      out.add(edge.from);
      out.add(edge.to);
      if (edge.ray) out.add(std::string("ray"));
      for (const SoftDesc& tissue : scene.soft) out.add(tissue.toughness);
    }
  for (const CompiledTissue& tissue : soft) add_soft(*tissue.solver, out);
  return content_hash(std::as_bytes(std::span(out.bytes())));
}

bool is_simple(const CompiledTissue& tissue) {
  return tissue.collision.fidelity != Fidelity::none && tissue.collision.fidelity != Fidelity::mesh;
}

RigidOutline outline_of(const RigidShape& shape) {
  const bool mesh = !shape.parts.empty() && shape.parts.front().kind == ShapeKind::triangles;
  return RigidOutline(shape.parts, mesh ? Fidelity::mesh : Fidelity::hull);
}

std::vector<std::optional<RigidOutline>> compile_outlines(const Model& model) {
  std::vector<std::optional<RigidOutline>> out;
  for (const RigidModel& r : model.rigid)
    out.push_back(r.shape.parts.empty() ? std::nullopt : std::optional(outline_of(r.shape)));
  for (const HandModel& hand : model.hands) out.push_back(outline_of(hand.shape));
  for (const RoomModel& room : model.room) out.push_back(outline_of(room.shape));
  return out;
}

/// Makes rigid things press the body over the area that touches. Throws InputError for what has no such area,
/// or is not minimised.
void press_over_area(const SoftBody& body, SoftCollision& collision) {
  const SoftDesc& desc = body.desc();
  if (mesh_kind(body.anatomy()) != MeshKind::tets || collision.fidelity != Fidelity::mesh ||
      body.substepper())
    throw InputError(
        fmt::format("[[soft]] \"{}\": contact is \"surface\"; allowed for a solid that collides as mesh and "
                    "has no substeps, else: vertices",
                    desc.name));
  collision.over_area = true;
}

/// Warns where smaller elements would be met at the corners of larger triangles.
void warn_of_coarse_surface(const SoftBody& body, const std::function<void(const std::string&)>& say) {
  const SoftDesc& desc = body.desc();
  if (desc.refine == SoftDesc().refine) return;
  const double cell = desc.refine_cell > 0 ? desc.refine_cell : desc.cell / 2;
  const double edge = mean_edge(body.anatomy().surface);
  if (edge > coarse_surface * cell)
    say(fmt::format(
        "{}: warning: refine makes elements of {:.1f} mm, but the triangles that are touched have "
        "edges of {:.1f} mm; a smaller surface_cell lets them be felt",
        desc.name, 1e3 * cell, 1e3 * edge));
}

CompiledTissue compile_soft(const SoftDesc& desc, Anatomy anatomy, const Model& model,
                            const CollisionGroups& groups,
                            const std::function<void(const std::string&)>& say) {
  CompiledTissue out;
  if (const double moved = put_under_tension(desc, anatomy); moved > told_of_tension)
    say(fmt::format("{}: its tension moves it by {:.1f} mm from its imaged shape", desc.name, 1e3 * moved));
  out.solver = std::make_unique<SoftBody>(desc, std::move(anatomy));
  const TriangleMesh& surface = out.solver->anatomy().surface;
  const double cell = desc.self_contact ? mean_edge(surface) : 0;
  const RoomSides passes = passed_sides(desc.name, surface.positions, model, say);
  out.collision = {fidelity_of(desc.collision),
                   groups.mask(desc.group, desc.touches),
                   passes,
                   desc.continuous,
                   desc.self_contact,
                   cell,
                   model.scene.contact_stiffness};
  if (desc.contact == "surface") press_over_area(*out.solver, out.collision);
  warn_of_coarse_surface(*out.solver, say);
  say(fmt::format("{}: {} elements, {} nodes, {} surface vertices", desc.name, out.solver->elements(),
                  out.solver->nodes(), surface.positions.size()));
  const bool solid = mesh_kind(out.solver->anatomy()) == MeshKind::tets;
  if (const std::string limit = limit_under_compression(desc, solid); !limit.empty())
    say(fmt::format("{}: warning: model {} {}", desc.name, desc.model, limit));
  return out;
}

}  // namespace

CompiledScene compile(const SceneDesc& written, const CompileOptions& options) {
  const SceneDesc scene = whole_scene(written, options);
  const auto say = [&](const std::string& line) {
    if (options.progress) options.progress(line);
  };
  if (!(scene.tick_rate > 0) || !std::isfinite(scene.tick_rate))
    throw InputError(fmt::format("tick_rate: {} Hz must be positive", scene.tick_rate));
  CompiledScene out;
  Model& model = out.model;
  model.scene = scene;
  model.h = 1 / scene.tick_rate;
  model.room = compile_room(scene.room);
  const CollisionGroups groups = groups_of(scene);
  for (const RigidDesc& desc : scene.rigid)
    model.rigid.push_back(compile_rigid(desc, rigid_surface(desc, scene, options), groups));
  const auto compile_piece = [&](const RigidDesc& desc, TriangleMesh surface) {
    return compile_rigid(desc, std::move(surface), groups);
  };
  for (std::size_t i = 0; i < model.rigid.size(); ++i) add_pieces(model, i, compile_piece);
  for (RigidModel& body : model.rigid) {
    std::vector<Vec3> start;
    for (const Vec3& x : body.surface.positions) start.push_back(body.start * x);
    if (body.setup.mass > 0) body.setup.passes = passed_sides(body.name, start, model, say);
  }
  for (const SoftDesc& desc : scene.soft)
    out.soft.push_back(compile_soft(desc, soft_anatomy(desc, scene, options), model, groups, say));
  for (std::size_t hand = 0; hand < 2; ++hand) {
    model.hands[hand] = make_hand_model(hand, scene.hand);
    model.hands[hand].setup.mask = groups.mask(hand_group, {});
    model.hands[hand].setup.passes = all_room_sides;
  }
  for (const RigidDesc& desc : model.scene.rigid) model.blades.push_back(blade_shape(desc.edges));
  if (std::any_of(out.soft.begin(), out.soft.end(), is_simple)) model.outlines = compile_outlines(model);
  model.hash = hash_of(model, out.soft);
  return out;
}

}  // namespace prosector
