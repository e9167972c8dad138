#include "server/physics/stations/parts/fracture.h"

#include <fmt/format.h>

#include "common/error.h"
#include "server/physics/mechanics/rigid/cut_surface.h"

namespace prosector {
namespace {

constexpr std::size_t most_pieces = 64;  // of one body: each additional plane may double the number

RigidDesc piece_of(const RigidDesc& whole, std::size_t plane, const char* side) {
  RigidDesc out = whole;
  out.name = fmt::format("{}, piece {}{}", whole.name, plane + 1, side);
  out.description = "piece of " + (whole.description.empty() ? whole.name : whole.description);
  out.geometry.parts.clear();
  out.part = false;
  out.material.mass = 0;
  if (out.contact.collision == Fidelity::none) out.contact.collision = Fidelity::hull;
  out.fractures.erase(out.fractures.begin() + static_cast<std::ptrdiff_t>(plane));
  return out;
}

std::size_t pieces_of(const Model& model, std::size_t body) {
  std::size_t count = 0;
  for (std::size_t i = body + 1; i < model.rigid.size(); ++i) {
    std::size_t root = i;
    while (model.rigid[root].whole) root = *model.rigid[root].whole;
    count += root == body;
  }
  return count;
}

}  // namespace

void add_pieces(Model& model, std::size_t body,
                const std::function<RigidModel(const RigidDesc&, TriangleMesh)>& make) {
  const RigidDesc desc = model.scene.rigid[body];
  if (!(desc.break_force > 0)) return;
  const TriangleMesh surface = model.rigid[body].surface;
  const double mass = model.rigid[body].setup.mass;
  const Pose to_center = model.rigid[body].center.inverse();
  std::size_t root = body;
  while (model.rigid[root].whole) root = *model.rigid[root].whole;
  for (std::size_t k = 0; k < desc.fractures.size(); ++k) {
    const FractureDesc& plane = desc.fractures[k];
    const rigid::CutSurface cut = rigid::cut_surface(surface, plane.point, plane.normal);
    if (cut.above.triangles.empty() || cut.below.triangles.empty()) {
      if (root != body) continue;  // of a piece: this plane cuts another piece
      throw InputError(
          fmt::format("rigid '{}': the plane of fracture {} does not intersect it; move point or normal",
                      desc.name, k + 1));
    }
    if (pieces_of(model, root) + 2 > most_pieces)
      throw InputError(
          fmt::format("rigid '{}': its fractures create more than {} pieces; use fewer fracture planes",
                      model.rigid[root].name, most_pieces));
    RigidModel::Fracture fracture;
    fracture.point = to_center * plane.point;
    fracture.normal = to_center.q * plane.normal.normalized();
    RigidModel sides[] = {make(piece_of(desc, k, "a"), cut.above), make(piece_of(desc, k, "b"), cut.below)};
    // Masses sum to the whole's mass, whatever the description says.
    const double factor = mass / (sides[0].setup.mass + sides[1].setup.mass);
    for (const bool below : {false, true}) {
      RigidModel& piece = sides[below ? 1 : 0];
      piece.setup.mass *= factor;
      piece.setup.inertia *= factor;
      piece.whole = body;
      (below ? fracture.below : fracture.above) = model.rigid.size();
      (below ? fracture.center_below : fracture.center_above) = to_center * piece.center.p;
      if (!below) fracture.mass_above = piece.setup.mass;
      model.scene.rigid.push_back(piece_of(desc, k, below ? "b" : "a"));
      model.rigid.push_back(std::move(piece));
    }
    model.rigid[body].fractures.push_back(fracture);
  }
}

Vec3 force_through(const RigidModel::Fracture& plane, double mass, const Vec3& above_acceleration,
                   const Vec3& below_acceleration, const PlaneLoad& load) {
  const Vec3 needed_above = plane.mass_above * above_acceleration - load.above;
  const Vec3 needed_below = (mass - plane.mass_above) * below_acceleration - load.below;
  return (needed_above - needed_below) / 2;
}

}  // namespace prosector
