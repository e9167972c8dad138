#include "server/physics/stations/compile/compile.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <set>

#include "common/error.h"
#include "common/scene/primitives.h"
#include "server/physics/mechanics/contact/self_collision.h"
#include "server/physics/mechanics/rigid/collision_shape.h"
#include "server/physics/mechanics/soft/compression.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/stations/compile/scene_hash.h"
#include "server/physics/stations/compile/sources.h"
#include "server/physics/stations/compile/tension.h"
#include "server/physics/stations/parts/fracture.h"

namespace prosector {
namespace {

constexpr double reported_tension = 1e-3;  // m: smaller displacements by tension are not reported
// Ratio of surface edge to element edge beyond which refinement has little effect.
constexpr double coarse_surface = 1.5;
// Largest pressure of an unattached body's weight at its base, over Young's modulus, without a warning. A
// block of 10 cm by 6 cm that falls on a table rests up to 0.8, and sinks into the table from 1 on.
constexpr double most_weight = 1;
// Smallest fraction of its hull's volume that a plausible closed mesh fills.
constexpr double least_share_of_hull = 0.02;

collision::ShapePart to_shape(const PartDesc& part) {
  const double r = part.size.x() / 2, y = part.size.y() / 2;
  if (part.shape == "box") return {collision::ShapeKind::box, part.size / 2, part.pose, nullptr};
  if (part.shape == "sphere") return {collision::ShapeKind::sphere, {r, 0, 0}, part.pose, nullptr};
  if (part.shape == "capsule")
    return {collision::ShapeKind::capsule, {r, std::max(0.0, y - r), r}, part.pose, nullptr};
  if (part.shape == "cylinder") return {collision::ShapeKind::cylinder, {r, y, r}, part.pose, nullptr};
  return {collision::ShapeKind::ellipsoid, part.size / 2, part.pose, nullptr};
}

/// Returns the mass properties of a mesh, or of its hull if the mesh isn't closed: a thin or open surface has
/// no volume.
collision::MassProperties mesh_mass(const TriangleMesh& mesh, const collision::ShapePart& hull,
                                    double density) {
  const collision::MassProperties of_hull = collision::part_mass(hull, density);
  collision::ShapePart solid = hull;
  solid.mesh = std::make_shared<TriangleMesh>(mesh);
  const collision::MassProperties own = collision::part_mass(solid, density);
  const bool plausible = own.mass > least_share_of_hull * of_hull.mass && own.mass < 1.01 * of_hull.mass &&
                         Eigen::SelfAdjointEigenSolver<Mat3>(own.inertia).eigenvalues().minCoeff() > 0;
  return plausible ? own : of_hull;
}

struct Solid {
  std::vector<collision::ShapePart> parts;  // body frame
  collision::MassProperties mass;
};

Solid solid_of_parts(const RigidDesc& desc) {
  Solid out;
  std::vector<collision::MassProperties> masses;
  for (const PartDesc& part : desc.geometry.parts) {
    out.parts.push_back(to_shape(part));
    masses.push_back(collision::part_mass(out.parts.back(), desc.material.density));
  }
  out.mass = collision::combine(masses);
  return out;
}

Solid solid_of_mesh(const RigidDesc& desc, const TriangleMesh& surface) {
  collision::ShapePart hull{collision::ShapeKind::hull,
                            Vec3::Zero(),
                            {},
                            std::make_shared<TriangleMesh>(collision::convex_hull(surface.positions))};
  Solid out;
  out.mass = mesh_mass(surface, hull, desc.material.density);
  if (desc.contact.collision == Fidelity::mesh)
    out.parts = {
        {collision::ShapeKind::triangles, Vec3::Zero(), {}, std::make_shared<TriangleMesh>(surface)}};
  else
    out.parts = {hull};
  return out;
}

collision::CollisionGroups groups_of(const SceneDesc& scene) {
  collision::CollisionGroups out;
  std::set<std::string> known = {default_group, hand_group};
  out.add(hand_group);
  const auto add = [&](const auto& bodies) {
    for (const auto& body : bodies)
      if (known.insert(body.contact.group).second) out.add(body.contact.group);
  };
  add(scene.rigid);
  add(scene.soft);
  return out;
}

RigidModel compile_rigid(const RigidDesc& desc, TriangleMesh surface,
                         const collision::CollisionGroups& groups) {
  Solid solid = desc.geometry.parts.empty() ? solid_of_mesh(desc, surface) : solid_of_parts(desc);
  // The mass of a breakable body is that of its surface's volume, like that of its pieces, which conserves
  // momentum.
  if (desc.break_force > 0) solid.mass = solid_of_mesh(desc, surface).mass;
  if (!(solid.mass.mass > 0) && !desc.fixed)
    throw InputError(fmt::format(
        "rigid '{}': it encloses no volume, so it has no mass; give it parts or a closed mesh", desc.name));
  if (desc.material.mass > 0 && solid.mass.mass > 0) {
    solid.mass.inertia *= desc.material.mass / solid.mass.mass;
    solid.mass.mass = desc.material.mass;
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
  out.setup.friction = desc.contact.friction;
  out.setup.rolling_resistance = desc.contact.rolling_resistance;
  out.setup.restitution = desc.contact.restitution;
  out.setup.balanced = desc.balanced;
  out.setup.continuous = desc.contact.continuous;
  out.setup.mask = groups.mask(desc.contact.group, desc.contact.touches);
  for (collision::ShapePart part :
       rigid::at_fidelity(std::move(solid.parts), desc.contact.collision, desc.pose)) {
    part.pose = out.center.inverse() * part.pose;
    out.shape.distances.push_back(contact::make_signed_distance(part));
    out.shape.parts.push_back(std::move(part));
  }
  out.setup.parts = out.shape.parts;
  return out;
}

std::vector<RoomModel> compile_room(const std::optional<RoomDesc>& room) {
  std::vector<RoomModel> out;
  for (const rigid::RoomSide& side : rigid::room_sides(room)) {
    RoomModel& made = out.emplace_back();
    made.side = side;
    made.shape.parts.push_back(rigid::solid_of(side));
    made.shape.distances.push_back(contact::make_signed_distance(made.shape.parts.front()));
  }
  return out;
}

/// Returns the room sides behind which the body starts; the body passes through these.
template <class Say>
rigid::RoomSides passed_sides(const std::string& name, std::span<const Vec3> start, const Model& model,
                              const Say& say) {
  std::vector<rigid::RoomSide> room;
  for (const RoomModel& side : model.room) room.push_back(side.side);
  const rigid::RoomSides out = rigid::sides_before(start, room);
  if (out != 0)
    say(fmt::format(
        "{}: the body starts behind the room's {}, so it does not collide with that side of the room", name,
        rigid::has_side(out, 0) && model.scene.room->floor ? "floor" : "wall"));
  return out;
}

bool is_simple(const CompiledTissue& tissue) {
  return tissue.collision.fidelity != Fidelity::none && tissue.collision.fidelity != Fidelity::mesh;
}

collision::RigidOutline outline_of(const contact::RigidShape& shape) {
  const bool mesh = !shape.parts.empty() && shape.parts.front().kind == collision::ShapeKind::triangles;
  return collision::RigidOutline(shape.parts, mesh ? Fidelity::mesh : Fidelity::hull);
}

std::vector<std::optional<collision::RigidOutline>> compile_outlines(const Model& model) {
  std::vector<std::optional<collision::RigidOutline>> out;
  for (const RigidModel& r : model.rigid)
    out.push_back(r.shape.parts.empty() ? std::nullopt : std::optional(outline_of(r.shape)));
  for (const hands::HandModel& hand : model.hands) out.push_back(outline_of(hand.shape));
  for (const RoomModel& room : model.room) out.push_back(outline_of(room.shape));
  return out;
}

/// Returns whether rigid bodies press the body over areas. Throws InputError if the scene demands that for a
/// body without such areas, or with substeps.
bool presses_over_area(const soft::SoftBody& body) {
  const SoftDesc& desc = body.desc();
  const bool can = soft::mesh_kind(body.anatomy()) == soft::MeshKind::tets &&
                   desc.contact.collision == Fidelity::mesh && !body.substepper();
  if (!can && desc.contact.points == ContactPoints::surface)
    throw InputError(
        fmt::format("[[soft]] \"{}\": contact is \"surface\", which is allowed only for a solid with "
                    "collision = \"mesh\" and without substeps; set contact = \"vertices\"",
                    desc.name));
  return can && desc.contact.points != ContactPoints::vertices;
}

/// Warns if surface triangles are too large for refined elements to have an effect.
void warn_of_coarse_surface(const soft::SoftBody& body, const std::function<void(const std::string&)>& say) {
  const SoftDesc& desc = body.desc();
  if (desc.refinement.at == SoftDesc().refinement.at) return;
  const double cell = desc.refinement.cell > 0 ? desc.refinement.cell : desc.geometry.cell / 2;
  const double edge = contact::mean_edge(body.anatomy().surface);
  if (edge > coarse_surface * cell)
    say(
        fmt::format("{}: warning: refine creates elements of {:.1f} mm, but the surface triangles have edges "
                    "of {:.1f} mm; reduce surface_cell, or refinement has little effect",
                    desc.name, 1e3 * cell, 1e3 * edge));
}

/// Warns if an unattached body is so soft that its own weight flattens it. The pressure of its weight at its
/// base is ρgH, with density ρ, gravity g and height H.
void warn_of_weight(const soft::SoftBody& body, const Vec3& gravity,
                    const std::function<void(const std::string&)>& say) {
  const SoftDesc& desc = body.desc();
  if (!desc.gravity || gravity.isZero() || body.attached()) return;
  const Vec3 down = gravity.normalized();
  double lowest = -std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Vec3& x : body.anatomy().surface.positions) {
    lowest = std::max(lowest, x.dot(down));
    highest = std::min(highest, x.dot(down));
  }
  const double pressure = desc.material.density * gravity.norm() * (lowest - highest);
  const double least = pressure / most_weight;
  if (desc.material.youngs_modulus >= least) return;
  say(
      fmt::format("{}: warning: youngs_modulus is {:.3g} Pa, but the body's weight presses on its base with "
                  "{:.3g} Pa: it becomes flat, and may pass through what it lies on; set youngs_modulus to "
                  "{:.3g} Pa or more, make the body smaller, or attach it ([[soft.attach]])",
                  desc.name, desc.material.youngs_modulus, pressure, least));
}

CompiledTissue compile_soft(const SoftDesc& desc, Anatomy anatomy, const Model& model,
                            const collision::CollisionGroups& groups,
                            const std::function<void(const std::string&)>& say) {
  CompiledTissue out;
  if (const double moved = put_under_tension(desc, anatomy); moved > reported_tension)
    say(fmt::format("{}: the body's tension moves its nodes by up to {:.1f} mm from its imaged shape",
                    desc.name, 1e3 * moved));
  out.solver = std::make_unique<soft::SoftBody>(desc, std::move(anatomy));
  const TriangleMesh& surface = out.solver->anatomy().surface;
  const double cell = desc.contact.self_contact ? contact::mean_edge(surface) : 0;
  const rigid::RoomSides passes = passed_sides(desc.name, surface.positions, model, say);
  out.collision = {desc.contact.collision,
                   groups.mask(desc.contact.group, desc.contact.touches),
                   passes,
                   desc.contact.continuous,
                   desc.contact.self_contact,
                   cell,
                   model.scene.contact_stiffness,
                   presses_over_area(*out.solver)};
  warn_of_coarse_surface(*out.solver, say);
  warn_of_weight(*out.solver, model.scene.gravity, say);
  say(fmt::format("{}: {} elements, {} nodes, {} surface vertices", desc.name, out.solver->elements(),
                  out.solver->nodes(), surface.positions.size()));
  const bool solid = soft::mesh_kind(out.solver->anatomy()) == soft::MeshKind::tets;
  if (const std::string limit = soft::limit_under_compression(desc, solid); !limit.empty())
    say(fmt::format("{}: warning: model {} {}", desc.name, desc.configuration.model, limit));
  return out;
}

}  // namespace

CompiledScene compile(const SceneDesc& written, const CompileOptions& options) {
  const SceneDesc scene = whole_scene(written, options);
  const auto say = [&](const std::string& line) {
    if (options.progress) options.progress(line);
  };
  if (!(scene.tick_rate > 0) || !std::isfinite(scene.tick_rate))
    throw InputError(fmt::format("tick_rate is {} Hz; allowed: a positive rate", scene.tick_rate));
  CompiledScene out;
  Model& model = out.model;
  model.scene = scene;
  model.h = 1 / scene.tick_rate;
  model.room = compile_room(scene.room);
  const collision::CollisionGroups groups = groups_of(scene);
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
    model.hands[hand] = hands::make_hand_model(hand, scene.hand);
    model.hands[hand].setup.mask = groups.mask(hand_group, {});
    model.hands[hand].setup.passes = rigid::all_room_sides;
  }
  for (const RigidDesc& desc : model.scene.rigid) model.blades.push_back(organs::blade_shape(desc.edges));
  if (std::any_of(out.soft.begin(), out.soft.end(), is_simple)) model.outlines = compile_outlines(model);
  model.hash = hash_of(model, out.soft);
  return out;
}

}  // namespace prosector
