#include "server/accuracy/act.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "server/accuracy/foot.h"
#include "server/accuracy/outer_surface.h"

namespace prosector {
namespace {

constexpr double fingertip = 6e-3;   // m: radius of the patch that a fingertip presses
constexpr double dent = 2e-3;        // m: depth by which a push dents a half-space
constexpr double thin = 1. / 4;      // of the thickness: radius of the patch on a thin body
constexpr double shallow = 1. / 20;  // of the thickness: depth of the dent in a thin body
constexpr double tilt = 0.3;         // of gravity: its sideways component in a tilt
constexpr std::size_t candidates_to_press = 40;
constexpr double steepest = 0.2;  // least cosine between a face's normal and the push for it to bear pressure

double softest(const SoftDesc& desc) {
  double least = desc.material.youngs_modulus;
  for (const RegionDesc& region : desc.material.regions)
    if (region.youngs_modulus > 0) least = std::min(least, region.youngs_modulus);
  return least;
}

/// Returns the unit direction across gravity along which the body is longest.
Vec3 sideways(const TetMesh& mesh, const Vec3& gravity) {
  const Vec3 axis = down(gravity);
  const Vec3 one = axis.unitOrthogonal(), other = axis.cross(one);
  const Vec3 longest = extent(mesh, one).length() >= extent(mesh, other).length() ? one : other;
  return longest;
}

/// Returns `count` faces that are far from each other: the highest, then always the one farthest from those
/// chosen.
std::vector<OuterFace> spread_faces(const TetMesh& mesh, const Vec3& up, std::vector<OuterFace> faces,
                                    std::size_t count) {
  std::vector<OuterFace> out;
  while (!faces.empty() && out.size() < count) {
    const auto distance = [&](const OuterFace& face) {
      if (out.empty()) return up.dot(middle(mesh, face));
      double least = std::numeric_limits<double>::infinity();
      for (const OuterFace& taken : out)
        least = std::min(least, (middle(mesh, face) - middle(mesh, taken)).norm());
      return least;
    };
    out.push_back(*std::max_element(faces.begin(), faces.end(),
                                    [&](const auto& a, const auto& b) { return distance(a) < distance(b); }));
    std::erase(faces, out.back());
  }
  return out;
}

/// Returns faces that are not near a tie. Half of them are far from each other. The others are those of 40
/// candidates below which the body is thinnest, where elements have the largest errors.
std::vector<OuterFace> pressed_faces(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity,
                                     const std::vector<OuterFace>& faces, int count) {
  std::vector<OuterFace> loose = faces;
  std::erase_if(loose, [&](const OuterFace& face) {
    return std::any_of(desc.attach.begin(), desc.attach.end(), [&](const AttachDesc& tie) {
      return (middle(mesh, face) - tie.center).norm() < tie.radius + fingertip;
    });
  });
  std::vector<OuterFace> out = spread_faces(mesh, -down(gravity), loose, candidates_to_press);
  const auto spread = std::min<std::ptrdiff_t>(std::ssize(out), (count + 1) / 2);
  std::stable_sort(out.begin() + spread, out.end(), [&](const auto& a, const auto& b) {
    return depth_below(mesh, faces, a) < depth_below(mesh, faces, b);
  });
  out.resize(std::min(out.size(), static_cast<std::size_t>(count)));
  return out;
}

/// Adds the forces of a press on the nodes. They sum to the press's force.
void add_press(const Press& press, const StaticBody& body, VecX& load) {
  const TetMesh& mesh = body.mesh();
  const auto near = [&](const OuterFace& face) {
    const Vec3 area = area_vector(mesh, face);
    return (middle(mesh, face) - press.point).norm() < 2 * (std::sqrt(area.norm()) + press.radius) &&
           area.dot(press.inward) < -steepest * area.norm();
  };
  VecX share = VecX::Zero(body.mass().size());
  for_surface_points(body, near, [&](const SurfacePoint& point) {
    const Vec3 away = point.at - press.point;
    const double r2 = (away - away.dot(press.inward) * press.inward).squaredNorm();
    if (r2 >= press.radius * press.radius) return;
    const double force = point.area * std::sqrt(1 - r2 / (press.radius * press.radius));
    for (std::size_t k = 0; k < point.node.size(); ++k) share[point.node[k]] += point.shape[k] * force;
  });
  const double scale = press.force / share.sum();
  for (Eigen::Index i = 0; i < share.size(); ++i) load.segment<3>(3 * i) += scale * share[i] * press.inward;
}

}  // namespace

std::vector<Act> acts_of(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity, int presses) {
  std::vector<Act> out;
  if (!gravity.isZero()) {
    if (desc.gravity) out.push_back({"under its weight", gravity, {}});
    out.push_back({"hung", -gravity, {}});
    out.push_back({"on its side", gravity.norm() * sideways(mesh, gravity), {}});
  }
  const std::vector<OuterFace> faces = outer_faces(mesh);
  const double thick = thickness(mesh, faces);
  Press press;
  press.radius = std::min(fingertip, thin * thick);
  press.force = 2 * softest(desc) / (1 - desc.material.poisson_ratio * desc.material.poisson_ratio) *
                press.radius * std::min(dent, shallow * thick);
  int place = 0;
  for (const OuterFace& face : pressed_faces(desc, mesh, gravity, faces, presses)) {
    press.point = middle(mesh, face);
    press.inward = -area_vector(mesh, face).normalized();
    ++place;
    out.push_back({place == 1 ? "pressed" : fmt::format("pressed at place {}", place), Vec3::Zero(), press});
  }
  return out;
}

std::vector<Act> tilts(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity) {
  if (tied(desc, mesh) || !desc.gravity || gravity.isZero()) return {};
  const Vec3 along = sideways(mesh, gravity), across = down(gravity).cross(along);
  const auto towards = [&](const Vec3& side, const std::string& name) {
    const Vec3 weight = gravity + tilt * gravity.norm() * side.normalized();
    return Act{name, weight, {}, down(weight)};
  };
  return {towards(2 * along + across, "tilted"), towards(2 * across - along, "tilted across")};
}

VecX load_of(const Act& act, const StaticBody& body) {
  VecX load = body.weight(act.weight);
  if (act.press) add_press(*act.press, body, load);
  return load;
}

}  // namespace prosector
