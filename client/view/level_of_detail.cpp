#include "client/view/level_of_detail.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace prosector {
namespace {

// Hysteresis: fraction of the allowed error below which a coarser level is chosen.
constexpr double reserve = 0.7;
constexpr int frames_until_settled = 20;  // frames without change before a mesh's levels are made
constexpr std::uint64_t frames_cached = 300;

/// Returns whether the item can have levels of detail. Painted items show the colours of all vertices; light
/// shafts have no surface.
bool can_have_levels(const DrawItem& item) {
  return item.mesh && !item.painted && !item.shaft && item.mesh->triangles.size() >= min_detail_triangles;
}

const std::vector<Eigen::Vector3f>& rest_of(const DrawMesh& mesh) {
  return mesh.rest_positions.empty() ? mesh.positions : mesh.rest_positions;
}

/// Returns the size in metres of a pixel at the sphere's point nearest to an eye; 0: an eye is inside the
/// sphere.
double smallest_pixel_size(const std::vector<DrawCamera>& cameras, const Sphere& bounds) {
  double finest = std::numeric_limits<double>::infinity();
  for (const DrawCamera& camera : cameras) {
    const double distance = (bounds.center - camera.pose.p).norm() - bounds.radius;
    finest = std::min(finest, std::max(distance, 0.0) * (camera.top - camera.bottom) / camera.height);
  }
  return finest;
}

}  // namespace

void add_detail(DrawList& list) {
  std::map<std::uint64_t, std::shared_ptr<const Detail>> made;  // by mesh id
  for (DrawItem& item : list.items) {
    if (!can_have_levels(item) || item.detail) continue;
    std::shared_ptr<const Detail>& detail = made[item.mesh->id];
    if (!detail)
      detail = std::make_shared<const Detail>(make_detail(rest_of(*item.mesh), item.mesh->triangles));
    item.detail = detail;
  }
}

void LevelOfDetail::choose(DrawList& list, double pixels) {
  ++picture_;
  if (pixels <= 0) {
    for (DrawItem& item : list.items) item.level = 0;
    return;
  }
  take_made();
  for (DrawItem& item : list.items) {
    item.level = 0;
    if (!can_have_levels(item)) continue;
    Known& known = know(item);
    item.detail = known.detail;
    const double error =
        pixels * smallest_pixel_size(list.cameras, placed(known.bounds, item)) / stretch_of(item);
    item.level = known.level = level_of(known, *item.mesh, error);
  }
  std::erase_if(known_,
                [&](const auto& entry) { return entry.second.last_picture + frames_cached < picture_; });
}

void LevelOfDetail::take_made() {
  if (making_.valid() && making_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    const Made made = making_.get();
    const auto known = known_.find(made.mesh);
    if (known != known_.end() && known->second.revision == made.revision) known->second.detail = made.detail;
  }
  if (making_.valid() || wanted_.empty()) return;
  making_ = std::async(std::launch::async, [next = std::move(wanted_.front())] {
    return Made{next.mesh, next.revision,
                std::make_shared<const Detail>(make_detail(next.rest, next.triangles))};
  });
  wanted_.pop_front();
}

LevelOfDetail::Known& LevelOfDetail::know(const DrawItem& item) {
  const DrawMesh& mesh = *item.mesh;
  const auto [found, is_new] = known_.try_emplace(mesh.id);
  Known& known = found->second;
  if (is_new || known.revision != mesh.revision) {
    known = Known();
    known.revision = mesh.revision;
    known.bounds = bounds_of(mesh.positions);
  } else if (known.positions_revision != mesh.positions_revision) {
    known.bounds = bounds_of(mesh.positions);
    known.errors.clear();
  }
  known.positions_revision = mesh.positions_revision;
  known.last_picture = picture_;
  if (item.detail) known.detail = item.detail;
  if (!known.detail && ++known.frames_unchanged == frames_until_settled)
    wanted_.push_back({mesh.id, mesh.revision, rest_of(mesh), mesh.triangles});
  return known;
}

bool LevelOfDetail::is_within(Known& known, const DrawMesh& mesh, std::size_t level, double error) {
  const std::size_t levels = known.detail->coarser.size();
  if (known.errors.size() != levels) {
    known.errors.assign(levels, std::numeric_limits<double>::infinity());
    known.measured_to.assign(levels, -1);
  }
  double& known_error = known.errors[level - 1];
  double& measured_to = known.measured_to[level - 1];
  const bool exact = known_error <= measured_to;
  if (!exact && (measured_to < 0 || known_error <= error)) {
    known_error = error_of(known.detail->coarser[level - 1], mesh.positions, mesh.normals, error);
    measured_to = error;
  }
  return known_error <= error;
}

std::size_t LevelOfDetail::level_of(Known& known, const DrawMesh& mesh, double error) {
  if (!known.detail) return 0;
  std::size_t level = std::min(known.level, known.detail->coarser.size());
  while (level > 0 && !is_within(known, mesh, level, error)) --level;
  if (level < known.level) return level;
  while (level < known.detail->coarser.size() && is_within(known, mesh, level + 1, reserve * error)) ++level;
  return level;
}

}  // namespace prosector
