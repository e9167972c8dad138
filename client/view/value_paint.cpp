#include "client/view/value_paint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "client/view/overlay_frame.h"
#include "common/error_map.h"

namespace prosector {
namespace {

// The scale's colours from cold to hot: lightness rises up to the middle, after which the hue changes.
const std::array<Vec3, 5> stops = {
    {{0.02, 0.04, 0.30}, {0.01, 0.30, 0.40}, {0.60, 0.70, 0.10}, {0.90, 0.26, 0.01}, {0.52, 0.01, 0.01}}};
const Vec3 gray(0.25, 0.25, 0.25);

/// Returns the position on the scale, 0 … 1; NaN for NaN.
double share_of(const ValueScale& scale, double value) {
  if (std::isnan(value)) return value;
  if (!scale.logarithmic) return std::clamp((value - scale.least) / (scale.most - scale.least), 0.0, 1.0);
  return std::log(std::clamp(value, scale.least, scale.most) / scale.least) /
         std::log(scale.most / scale.least);
}

Vec3 color_at(double share) {
  if (std::isnan(share)) return gray;
  const double place = share * (stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const double t = place - static_cast<double>(below);
  return (1 - t) * stops[below] + t * stops[below + 1];
}

double value_at(const ValueScale& scale, double share) {
  return scale.logarithmic ? scale.least * std::pow(scale.most / scale.least, share)
                           : scale.least + share * (scale.most - scale.least);
}

/// Returns a triangle's edges from its first corner, as columns.
Eigen::Matrix<double, 3, 2> edges(const std::vector<Eigen::Vector3f>& at,
                                  const std::array<std::uint32_t, 3>& corners) {
  Eigen::Matrix<double, 3, 2> out;
  for (int k = 0; k < 2; ++k)
    out.col(k) = (at[corners[static_cast<std::size_t>(k) + 1]] - at[corners[0]]).cast<double>();
  return out;
}

}  // namespace

Vec3 value_color(const ValueScale& scale, double value) {
  return color_at(share_of(scale, value));
}

std::vector<double> surface_strains(const DrawMesh& mesh) {
  std::vector<double> sum(mesh.positions.size(), 0.0), weight(mesh.positions.size(), 0.0);
  if (mesh.rest_positions.size() != mesh.positions.size()) return sum;
  constexpr double least_share = 1e-6;  // minimum ratio of det G to the product of the squared edge lengths
  for (const auto& corners : mesh.triangles) {
    // With G and g the edges' Gram matrices at rest and now, C = G⁻¹g has the squared principal stretches as
    // eigenvalues (Bonet and Wood 2008, ch. 4).
    const Eigen::Matrix<double, 3, 2> rest = edges(mesh.rest_positions, corners);
    const Eigen::Matrix<double, 3, 2> now = edges(mesh.positions, corners);
    const Eigen::Matrix2d G = rest.transpose() * rest, g = now.transpose() * now;
    if (!(G.determinant() > least_share * G(0, 0) * G(1, 1))) continue;
    const Eigen::Matrix2d C = G.inverse() * g;
    const double half = C.trace() / 2;
    const double largest = half + std::sqrt(std::max(half * half - C.determinant(), 0.0));
    const double area = std::sqrt(G.determinant()) / 2;
    for (const std::uint32_t v : corners) {
      sum[v] += area * (std::sqrt(largest) - 1);
      weight[v] += area;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (weight[v] > 0) sum[v] /= weight[v];
  return sum;
}

const std::vector<double>& PaintedMesh::strains(const DrawMesh& mesh) {
  const std::array<std::uint64_t, 2> revisions = {mesh.revision, mesh.positions_revision};
  if (strained_ != revisions) strains_ = surface_strains(mesh);
  strained_ = revisions;
  return strains_;
}

std::shared_ptr<const DrawMesh> PaintedMesh::of(const DrawMesh& mesh, const ValueScale& scale,
                                                std::optional<double> value, const ErrorMap* map) {
  const std::array<std::uint64_t, 2> revisions = {mesh.revision, mesh.positions_revision};
  const bool same_value = value == value_ || (value && value_ && std::isnan(*value) && std::isnan(*value_));
  const std::vector<std::uint8_t> levels = map != nullptr ? map->levels : std::vector<std::uint8_t>();
  if (scale_ == scale && same_value && revisions_ == revisions && levels == levels_) return mesh_;
  scale_ = scale;
  value_ = value;
  levels_ = levels;
  revisions_ = revisions;
  mesh_->positions = mesh.positions;
  mesh_->normals = mesh.normals;
  mesh_->triangles = mesh.triangles;
  ++mesh_->revision;
  if (!levels.empty() && mesh.rest_positions.size() == mesh.positions.size()) {
    mesh_->rest_positions.clear();
    for (const Eigen::Vector3f& place : mesh.rest_positions)
      mesh_->rest_positions.push_back(
          value_color(scale, error_at(*map, place.cast<double>()).value_or(not_known)).cast<float>());
    return mesh_;
  }
  if (value) {
    mesh_->rest_positions.assign(mesh.positions.size(), value_color(scale, *value).cast<float>());
    return mesh_;
  }
  mesh_->rest_positions.clear();
  for (const double strain : strains(mesh))
    mesh_->rest_positions.push_back(value_color(scale, strain).cast<float>());
  return mesh_;
}

void add_legend(DrawList& list, const ValueScale& scale) {
  constexpr double right = 150, below = 60, height = 160, bar = 14, row = 2;  // points
  constexpr double text_height = 12;
  constexpr int numbers = 4;
  const OverlayFrame frame(list);
  const double left = frame.width - right, top = frame.height - below - height;
  for (double y = 0; y < height; y += row)
    list.lines.push_back({frame.at(left, top + y + row / 2), frame.at(left + bar, top + y + row / 2),
                          color_at(1 - (y + row / 2) / height), row, true});
  for (int k = 0; k <= numbers; ++k) {
    const double share = static_cast<double>(k) / numbers;
    const double number = scale.factor * value_at(scale, share);
    list.texts.push_back(
        {.text = k == numbers ? list.words.tr("{:.3g} or more", number) : fmt::format("{:.3g}", number),
         .at = {left + bar + 8, top + (1 - share) * height - text_height / 2, 0},
         .height = text_height});
  }
  list.texts.push_back({.text = list.words.tr(std::string(scale.about)),
                        .at = {left, top + height + text_height, 0},
                        .height = text_height});
}

}  // namespace prosector
