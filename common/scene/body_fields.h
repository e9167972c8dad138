#pragma once
// The tables of bodies, and what those of rigid and of soft ones share. Private to common/scene.

#include "common/scene/field_rows.h"

namespace prosector {

const Table& rigid_table();
const Table& soft_table();
const Table& atlas_table();

inline constexpr Range density{1, 25000};
inline constexpr Range scale{0, 1e6, true};

/// Names of the shapes that common/anatomy can make by itself.
inline std::vector<std::string_view> implicit_shape_words() {
  return {"liver", "kidney", "gallbladder", "femur",   "foot",     "block",
          "ball",  "beam",   "cylinder",    "capsule", "horseshoe"};
}

/// Adds the fields of rigid and soft bodies for who touches them, and how finely.
template <class Struct>
void add_collision(std::vector<Field>& fields, std::vector<std::string_view> fidelities,
                   std::string_view shape) {
  fields.push_back(words<Struct, &Struct::collision>("collision", by_value, std::move(fidelities), shape));
  fields.push_back(name<Struct, &Struct::group>(
      "group", by_value, false, "collision group that it belongs to; people's hands are in `hand`"));
  fields.push_back(names<Struct, &Struct::touches>(
      "touches", by_value, "groups that it touches, if they touch its own as well; none given: all"));
  fields.push_back(plain<Struct, &Struct::continuous>(
      "continuous", by_value,
      "true: what it would pass through within a tick is found, where it first touches "
      "(rigid against soft bodies, and rigid ones of one convex piece)"));
}

/// Adds the fields for how files of meshes and volumes are taken.
template <class Struct>
void add_file_reading(std::vector<Field>& fields) {
  fields.push_back(number<Struct, &Struct::mesh_origin>(
      "mesh_origin", compiled, "file units", {-1e9, 1e9},
      "mesh files: the point of the file that becomes the body's origin, for files far from theirs"));
  fields.push_back(
      quantity<Struct, &Struct::max_volume_error>("max_volume_error", not_hashed, "%", {0, 1000, true},
                                                  "how far the body's volume may be from what its file "
                                                  "encloses or labels: more is refused, and more than "
                                                  "2 % is reported; not given: 20 %"));
}

/// Adds the fields for a stand-in's pose: a missing file's origin and axes need not be its shape's.
template <class Struct>
void add_fallback_pose(std::vector<Field>& fields) {
  fields.push_back(number<Struct, &Struct::fallback_pose, &Pose::p>(
      "fallback_position", compiled, "m", {-10, 10}, "the fallback's centre in the body's frame"));
  fields.push_back(plain<Struct, &Struct::fallback_pose, &Pose::q>(
      "fallback_rotation", compiled, "the fallback's orientation in the body's frame, as rotation"));
}

template <class Struct>
void add_appearance(std::vector<Field>& fields) {
  fields.push_back(words<Struct, &Struct::appearance, &Appearance::surface>(
      "surface", not_hashed, {"plain", "tissue", "bone", "metal", "skin", "cloth", "glass", "emissive"},
      "what it is made of, as far as it can be seen; emissive: shines by itself"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::color>(
      "color", not_hashed, "", unit_interval, "linear red, green, blue"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::roughness>(
      "roughness", not_hashed, "", unit_interval, "0 is a mirror, 1 matt"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::wetness>(
      "wetness", not_hashed, "", unit_interval, "0 is dry, 1 a thin film of liquid over the surface"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::refractive_index>(
      "refractive_index", not_hashed, "", {min_refractive_index, max_refractive_index},
      "glass: of light of 587.6 nm (n_d); water 1.33, crown glass 1.52, flint 1.62"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::abbe_number>(
      "abbe_number", not_hashed, "", {min_abbe_number, max_abbe_number},
      "glass: V_d, the lower the more dispersion; crown glass 64, flint 36"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::transmittance>(
      "transmittance", not_hashed, "", unit_interval,
      "glass: share of red, green, blue light left after 10 mm of it"));
}

// ---- The tables.

}  // namespace prosector
