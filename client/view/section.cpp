#include "client/view/section.h"

#include <cmath>

#include "client/view/soft_body_mesh.h"

namespace prosector {
namespace {

constexpr double close_to_axis = 0.26;  // rad
// Where solids overlap, such as neighbours in an atlas, their caps are this far apart to avoid z-fighting.
constexpr double layer = 1e-5;  // m
constexpr std::uint32_t layers = 16;

/// Transforms the cap into the section's plane in the room.
void lay(const Cap& cap, const SectionPlane& section, double lift, DrawMesh& mesh) {
  const Pose frame = frame_of(section);
  mesh.positions.clear();
  mesh.rest_positions.clear();
  for (const OutlinePoint& corner : cap.corners) {
    mesh.positions.push_back((frame * Vec3(corner.at.x(), corner.at.y(), lift)).cast<float>());
    mesh.rest_positions.push_back(corner.rest);
  }
  mesh.normals.assign(cap.corners.size(), section.normal.cast<float>());
  mesh.triangles = cap.triangles;
  ++mesh.revision;
}

}  // namespace

bool is_openable(const Appearance& appearance) {
  return appearance.surface == Surface::tissue || appearance.surface == Surface::bone ||
         appearance.surface == Surface::skin;
}

SectionPlane section_facing(const Vec3& back, const Vec3& middle) {
  Eigen::Index axis = 0;
  const double most = back.cwiseAbs().maxCoeff(&axis);
  const Vec3 along = Vec3::Unit(axis) * (back[axis] < 0 ? -1.0 : 1.0);
  const Vec3 normal = most > std::cos(close_to_axis) ? along : back;
  return {normal, normal.dot(middle)};
}

void SectionCaps::close(const DrawList& list, const std::vector<std::size_t>& items, Closed& closed) const {
  std::vector<Face> faces;
  for (const std::size_t k : items) {
    const DrawItem& item = list.items[k];
    faces.push_back(
        {item.mesh->id, item.mesh->revision, item.mesh->positions_revision, item.pose, item.shape});
  }
  if (closed.section == list.section && closed.faces == faces) return;
  closed.faces = faces;
  closed.section = list.section;
  std::vector<OutlineEdge> outline;
  for (const std::size_t k : items) add_outline(list.items[k], *list.section, outline);
  lay(fill(outline), *list.section, layer * (list.items[items.front()].solid % layers), *closed.mesh);
}

std::vector<std::pair<std::uint32_t, std::size_t>> SectionCaps::add(DrawList& list,
                                                                    std::uint64_t& next_mesh_id) {
  std::vector<std::pair<std::uint32_t, std::size_t>> out;
  if (!list.section) return out;
  std::map<std::uint32_t, std::vector<std::size_t>> solids;
  for (std::size_t k = 0; k < list.items.size(); ++k)
    if (list.items[k].solid != 0) solids[list.items[k].solid].push_back(k);
  for (const auto& [solid, items] : solids) {
    Closed& closed = closed_[solid];
    if (!closed.mesh) {
      closed.mesh = std::make_shared<DrawMesh>();
      closed.mesh->id = next_mesh_id++;
    }
    close(list, items, closed);
    if (closed.mesh->triangles.empty()) continue;
    DrawItem cap = list.items[items.front()];
    cap.mesh = closed.mesh;
    cap.pose = {};
    cap.shape = {};
    cap.appearance = inner_appearance(cap.appearance);
    cap.detail = nullptr;
    cap.level = 0;
    cap.painted = false;
    cap.seen_from_inside = false;
    cap.solid = 0;
    out.emplace_back(solid, list.items.size());
    list.items.push_back(std::move(cap));
  }
  return out;
}

}  // namespace prosector
