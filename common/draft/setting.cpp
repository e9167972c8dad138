#include "common/draft/setting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/appearance.h"
#include "common/draft/toml_text.h"
#include "common/math.h"

namespace prosector {

Vec3 shift_onto_table(const Eigen::AlignedBox3d& box) {
  const Vec3 middle = box.center();
  return {-middle[0], table_top + above_table - box.min()[1], -middle[2]};
}

std::string scalpel_toml(const Eigen::AlignedBox3d& box) {
  constexpr double beside = 0.06, half_handle = 0.002;  // m
  return fmt::format(
      R"(
[[rigid]]
name = "{}"
description = "scalpel"
position = {}
density = 7900
friction = 0.5
tool = "scalpel"
surface = "metal"
color = [0.7, 0.72, 0.74]
roughness = 0.2

  [[rigid.part]]  # handle
  size = [0.01, 0.004, 0.12]
  rounding = 0.001

  [[rigid.part]]  # blade
  size = [0.007, 0.001, 0.04]
  position = [0, 0, -0.08]

  [[rigid.edge]]  # along the blade ...
  from = [-0.0035, 0, -0.06]
  to = [-0.0035, 0, -0.1]

  [[rigid.edge]]  # ... and across its tip
  from = [-0.0035, 0, -0.1]
  to = [0.0035, 0, -0.1]
)",
      scalpel_name, toml_numbers({box.max()[0] + beside, table_top + half_handle, 0}));
}

std::string setting_toml(const Eigen::AlignedBox3d& box) {
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
