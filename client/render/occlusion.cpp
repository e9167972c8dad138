#include "client/render/occlusion.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace prosector {
namespace {

constexpr GLsizei least_indices = 3 * 1000;  // drawing fewer is faster than a query
constexpr int query_interval = 8;            // frames between queries of visible items

using Corners = std::array<Vec3, 8>;

/// Returns the corners of the item's bounding box in the room, extended by `margin` (m) on each side.
Corners corners_of(const QueuedItem& queued, double margin) {
  const DrawItem& item = *queued.item;
  Corners out;
  const Eigen::AlignedBox3d box = queued.mesh->box.cast<double>();
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Vec3 corner = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
    out[k] = item.shape * (item.pose * Vec3(corner + margin * (corner - box.center()).cwiseSign()));
  }
  return out;
}

/// Returns a pixel's width at the item's farthest point, m: the bound of rounding errors.
double margin_of(const DrawCamera& camera, const QueuedItem& queued) {
  const double farthest = (queued.bounds.center - camera.pose.p).norm() + queued.bounds.radius;
  return farthest * (camera.top - camera.bottom) / camera.height;
}

/// The area of a box on the screen, in tangents, and its nearest depth.
struct Outline {
  Eigen::AlignedBox2d area;
  double nearest = std::numeric_limits<double>::infinity();  // m ahead of the eye
};

/// Returns the outline of the item's box; nullopt: the box reaches behind the near plane, or the item is
/// scaled or sheared.
std::optional<Outline> outline_of(const DrawCamera& camera, const QueuedItem& queued) {
  if (!queued.item->shape.A.isIdentity(0)) return std::nullopt;
  const Pose eye_from_room = camera.pose.inverse();
  Outline out;
  for (const Vec3& corner : corners_of(queued, margin_of(camera, queued))) {
    const Vec3 at = eye_from_room * corner;
    if (-at.z() <= camera.near) return std::nullopt;
    out.nearest = std::min(out.nearest, -at.z());
    out.area.extend(Eigen::Vector2d(at.x() / -at.z(), at.y() / -at.z()));
  }
  return out;
}

// Two triangles per face. All faces are drawn, so the winding does not matter.
constexpr std::array<std::uint8_t, 36> box_triangles = {0, 1, 2, 1, 2, 3, 4, 5, 6, 5, 6, 7,  //
                                                        0, 1, 4, 1, 4, 5, 2, 3, 6, 3, 6, 7,  //
                                                        0, 2, 4, 2, 4, 6, 1, 3, 5, 3, 5, 7};

}  // namespace

Occlusion::Occlusion(const Gl& gl, const std::filesystem::path& shaders)
    : gl_(gl), program_(gl, shaders, "shadow") {
  gl_.GenVertexArrays(1, &box_);
  gl_.BindVertexArray(box_);
  gl_.GenBuffers(1, &vertices_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_.EnableVertexAttribArray(position_attribute);
  gl_.VertexAttribPointer(position_attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  gl_.BindVertexArray(0);
}

Occlusion::~Occlusion() {
  gl_.DeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
  gl_.DeleteBuffers(1, &vertices_);
  gl_.DeleteVertexArrays(1, &box_);
}

std::vector<const QueuedItem*> Occlusion::take_query_candidates(const DrawCamera& camera,
                                                                std::vector<const QueuedItem*>& solids) {
  std::vector<Outline> before;  // of items that are drawn in any case
  std::vector<const QueuedItem*> covered;
  std::erase_if(solids, [&](const QueuedItem* queued) {
    const auto outline = outline_of(camera, *queued);
    if (!outline) return false;
    const bool is_covered = std::ranges::any_of(before, [&](const Outline& other) {
      return other.nearest < outline->nearest && other.area.contains(outline->area);
    });
    const bool is_worth = queued->mesh->levels.at(queued->item->level).indices >= least_indices;
    const auto seen = frames_since_visible_.find(queued->item->mesh->id);
    const bool is_due = seen == frames_since_visible_.end() || --seen->second <= 0;
    if (is_covered && is_worth && is_due) {
      covered.push_back(queued);
      return true;
    }
    before.push_back(*outline);
    return false;
  });
  return covered;
}

void Occlusion::draw_box(const DrawCamera& camera, const QueuedItem& queued) const {
  const Corners corners = corners_of(queued, margin_of(camera, queued));
  std::array<Eigen::Vector3f, box_triangles.size()> triangles;
  for (std::size_t k = 0; k < triangles.size(); ++k) triangles[k] = corners[box_triangles[k]].cast<float>();
  gl_.BufferData(GL_ARRAY_BUFFER, sizeof(triangles), triangles.data(), GL_STREAM_DRAW);
  gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
}

std::vector<const QueuedItem*> Occlusion::shown(const DrawCamera& camera,
                                                const std::vector<const QueuedItem*>& covered) {
  if (covered.empty()) return {};
  if (queries_.size() < covered.size()) {
    gl_.DeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
    queries_.resize(covered.size());
    gl_.GenQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
  }
  gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl_.DepthMask(GL_FALSE);
  gl_.Disable(GL_CULL_FACE);
  gl_.BindVertexArray(box_);
  gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  program_.use();
  program_.set("clip_from_mesh", view_projection_of(camera));
  for (std::size_t k = 0; k < covered.size(); ++k) {
    gl_.BeginQuery(GL_ANY_SAMPLES_PASSED, queries_[k]);
    draw_box(camera, *covered[k]);
    gl_.EndQuery(GL_ANY_SAMPLES_PASSED);
  }
  gl_.Enable(GL_CULL_FACE);
  gl_.DepthMask(GL_TRUE);
  gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  std::vector<const QueuedItem*> out;
  for (std::size_t k = 0; k < covered.size(); ++k) {
    GLuint any = 1;
    gl_.GetQueryObjectuiv(queries_[k], GL_QUERY_RESULT, &any);
    if (any == 0) continue;
    out.push_back(covered[k]);
    frames_since_visible_[covered[k]->item->mesh->id] = query_interval;
  }
  hidden_ += covered.size() - out.size();
  return out;
}

}  // namespace prosector
