#pragma once
// One function per kind of value; each row of a field table is one call. Private to common/scene.

#include <memory>
#include <string_view>
#include <vector>

#include "common/scene/scene_fields.h"

namespace prosector {

inline constexpr Range coordinate{-max_coordinate, max_coordinate};
inline constexpr Range unit_interval{0, 1};
inline constexpr Range friction{0, 10};

/// Returns the field that a chain of member pointers leads to: in<RigidDesc, &RigidDesc::pose, &Pose::p>.
template <class Struct, auto... Path>
FieldRef in(void* object) {
  return &(*static_cast<Struct*>(object).*....*Path);
}

template <class Struct>
std::shared_ptr<void> fresh() {
  return std::make_shared<Struct>();
}

template <class Struct, auto List>
void* append(void* object) {
  return &(static_cast<Struct*>(object)->*List).emplace_back();
}

template <auto Member>
void* member(void* scene) {
  return &(static_cast<SceneDesc*>(scene)->*Member);
}

template <class Struct, auto... Path>
Field number(std::string_view key, std::string_view unit, Range range, std::string_view description) {
  return {.key = key, .in = in<Struct, Path...>, .unit = unit, .range = range, .description = description};
}

template <class Struct, auto... Path>
Field plain(std::string_view key, std::string_view description) {  // bool, quaternion
  return {.key = key, .in = in<Struct, Path...>, .description = description};
}

template <class Struct, auto... Path>
Field words(std::string_view key, std::vector<std::string_view> words, std::string_view description) {
  return {.key = key, .in = in<Struct, Path...>, .words = std::move(words), .description = description};
}

template <class Struct, auto... Path>
Field text(std::string_view key, std::string_view description, bool required = false) {
  return {.key = key,
          .in = in<Struct, Path...>,
          .max_length = max_text_length,
          .required = required,
          .description = description};
}

template <class Struct, auto... Path>
Field name(std::string_view key, bool required, std::string_view description) {
  return {.key = key,
          .in = in<Struct, Path...>,
          .text = Text::name,
          .required = required,
          .description = description};
}

template <class Struct, auto... Path>
Field quantity(std::string_view key, std::string_view unit, Range range, std::string_view description) {
  return number<Struct, Path...>(key, unit, range, description);
}

template <class Struct, auto... Path>
Field identifier(std::string_view key, std::string_view description) {
  return {.key = key, .in = in<Struct, Path...>, .text = Text::identifier, .description = description};
}

template <class Struct, auto... Path>
Field names(std::string_view key, std::string_view description) {
  return {.key = key, .in = in<Struct, Path...>, .text = Text::name, .description = description};
}

/// Adds the pose that rigid parts, rigid bodies and soft bodies share.
template <class Struct>
void add_pose(std::vector<Field>& fields, std::string_view frames) {
  fields.push_back(number<Struct, &Struct::pose, &Pose::p>("position", "m", coordinate, frames));
  fields.push_back(plain<Struct, &Struct::pose, &Pose::q>(
      "rotation", "orientation as a quaternion [w, x, y, z]; normalised when read, never all zero"));
}

}  // namespace prosector
