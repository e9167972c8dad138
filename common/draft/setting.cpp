#include "common/draft/setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/draft/toml_text.h"
#include "common/messages.h"

namespace prosector {

Vec3 onto_table(const Eigen::AlignedBox3d& box) {
  const Vec3 middle = box.center();
  return {-middle[0], table_top + above_table - box.min()[1], -middle[2]};
}

std::string setting_for(const Eigen::AlignedBox3d& box) {
  const double radius = 0.5 * box.sizes().norm();
  const Vec3 middle = box.center();
  const double far = 1.15 * radius / std::sin(0.5 * CameraInfo{}.fov);
  const Vec3 eye = middle + far * Vec3(0.35, 0.5, 1).normalized();
  const double table = std::max(0.6, 1.5 * std::max(box.sizes()[0], box.sizes()[2]));
  constexpr double thick = 0.04;
  const double lamp_height = std::max(2., box.max()[1] + 2 * radius);
  const Vec3 lamp(0.4 * radius, lamp_height, 0.6 * radius);
  return fmt::format(
      R"([camera]
eye = {}
target = {}

[[rigid]]
name = "table"
description = "table"
fixed = true
friction = 0.8
surface = "metal"
color = [0.5, 0.52, 0.55]
roughness = 0.4

  [[rigid.part]]
  size = {}
  position = {}
  rounding = 0.005

  [[rigid.part]]
  shape = "cylinder"
  size = {}
  position = {}

[[light]]
name = "lamp"
kind = "spot"
position = {}
direction = {}
cone = {}

[[light]]
name = "room"
kind = "point"
position = [-1.2, 2.2, 1]
intensity = 0.5
)",
      toml_numbers(eye), toml_numbers(middle), toml_numbers({table, thick, table}),
      toml_numbers({0, table_top - thick / 2, 0}), toml_numbers({0.08, table_top - thick, 0.08}),
      toml_numbers({0, (table_top - thick) / 2, 0}), toml_numbers(lamp), toml_numbers(middle - lamp),
      toml_number(std::clamp(std::atan2(1.5 * radius, lamp_height - middle[1]), 0.3, 1.2)));
}

}  // namespace prosector
