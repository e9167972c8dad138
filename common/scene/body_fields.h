#pragma once
// Field tables of bodies, and the fields that rigid and soft bodies share. Private to common/scene.

#include "common/scene/field_rows.h"

namespace prosector {

const Table& rigid_table();
const Table& soft_table();
const Table& atlas_table();

inline constexpr Range density{1, 25000};
inline constexpr Range scale{0, 1e6, true};

/// Returns the names of the built-in implicit shapes (common/anatomy/implicit.h), as allowed in a scene file.
inline std::vector<std::string_view> implicit_shape_words() {
  return {"liver", "kidney", "gallbladder", "femur",   "foot",     "block",
          "ball",  "beam",   "cylinder",    "capsule", "horseshoe"};
}

/// The struct at the end of a path of member pointers; Struct itself for an empty path.
template <class Struct, auto... Group>
using Inner = std::remove_reference_t<decltype((std::declval<Struct&>().*....*Group))>;

/// Appends the scene keys for collision that rigid and soft bodies share: shape, groups, and continuous
/// detection. `shape` describes the key of the collision shape. `Group` is the
/// path of member pointers from the body's description to the struct that stores them.
template <class Struct, auto... Group>
void add_collision(std::vector<Field>& fields, std::string_view shape) {
  fields.push_back(words<Struct, Group..., &Inner<Struct, Group...>::collision>(
      "collision", by_value, {fidelity_names.begin(), fidelity_names.end()}, shape));
  fields.push_back(name<Struct, Group..., &Inner<Struct, Group...>::group>(
      "group", by_value, false, "its collision group; hands are in `hand`"));
  fields.push_back(names<Struct, Group..., &Inner<Struct, Group...>::touches>(
      "touches", by_value, "collision groups that it touches, if they also touch its group; default: all"));
  fields.push_back(plain<Struct, Group..., &Inner<Struct, Group...>::continuous>(
      "continuous", by_value,
      "true: continuous collision detection of rigid against soft bodies; fast rigid bodies never pass "
      "through each other"));
}

/// Appends the scene keys that control how a body's mesh and volume files are read: origin and allowed volume
/// error.
template <class Struct, auto... Group>
void add_file_reading(std::vector<Field>& fields) {
  fields.push_back(number<Struct, Group..., &Inner<Struct, Group...>::mesh_origin>(
      "mesh_origin", compiled, "file units", {-1e9, 1e9},
      "mesh files: the file's point that becomes the body's origin, for files far from their origin"));
  fields.push_back(quantity<Struct, Group..., &Inner<Struct, Group...>::max_volume_error>(
      "max_volume_error", not_hashed, "%", {0, 1000, true},
      "allowed relative difference between the body's volume and that of its file; more is refused, more "
      "than 2 % is reported; default: 20 %"));
}

/// Appends the scene keys for the pose of a body's fallback shape, which replaces a missing file. The shape's
/// origin and axes may differ from the file's.
template <class Struct, auto... Group>
void add_fallback_pose(std::vector<Field>& fields) {
  fields.push_back(number<Struct, Group..., &Inner<Struct, Group...>::fallback_pose, &Pose::p>(
      "fallback_position", compiled, "m", {-10, 10}, "the fallback's centre in the body's frame"));
  fields.push_back(plain<Struct, Group..., &Inner<Struct, Group...>::fallback_pose, &Pose::q>(
      "fallback_rotation", compiled, "the fallback's orientation in the body's frame, as rotation"));
}

template <class Struct>
void add_appearance(std::vector<Field>& fields) {
  fields.push_back(words<Struct, &Struct::appearance, &Appearance::surface>(
      "surface", not_hashed, {"plain", "tissue", "bone", "metal", "skin", "cloth", "glass", "emissive"},
      "visible material; emissive: emits light"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::color>(
      "color", not_hashed, "", unit_interval, "linear red, green, blue"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::roughness>(
      "roughness", not_hashed, "", unit_interval, "0: mirror, 1: matt"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::wetness>(
      "wetness", not_hashed, "", unit_interval, "0: dry, 1: covered by a thin film of liquid"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::refractive_index>(
      "refractive_index", not_hashed, "", {min_refractive_index, max_refractive_index},
      "glass: at 587.6 nm (n_d); water 1.33, crown glass 1.52, flint 1.62"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::abbe_number>(
      "abbe_number", not_hashed, "", {min_abbe_number, max_abbe_number},
      "glass: V_d; lower values disperse more; crown glass 64, flint 36"));
  fields.push_back(number<Struct, &Struct::appearance, &Appearance::transmittance>(
      "transmittance", not_hashed, "", unit_interval,
      "glass: transmitted fraction of red, green, blue light after 10 mm"));
}

}  // namespace prosector
