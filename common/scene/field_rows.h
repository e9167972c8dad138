#pragma once
// Functions that make the rows of the field tables, one per value type. Private to common/scene.

#include <memory>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "common/ids.h"
#include "common/scene/scene_fields.h"

namespace prosector {

using enum Hashed;

inline constexpr Range coordinate{-max_coordinate, max_coordinate};
inline constexpr Range unit_interval{0, 1};
inline constexpr Range friction{0, 10};

/// Returns a pointer to the member reached by a chain of member pointers: in<RigidDesc, &RigidDesc::pose,
/// &Pose::p>.
template <class Struct, auto... Path>
FieldRef in(void* object) {
  return &(*static_cast<Struct*>(object).*....*Path);
}

template <class Struct>
std::shared_ptr<void> fresh() {
  return std::make_shared<Struct>();
}

template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// Appends a struct to the list `Member`, or emplaces the optional `Member`; returns the struct.
template <class Struct, auto Member>
void* add_item(void* object) {
  auto& member = static_cast<Struct*>(object)->*Member;
  using T = std::decay_t<decltype(member)>;
  if constexpr (is_list<T>)
    return &member.emplace_back();
  else if constexpr (is_optional<T>)
    return member ? &*member : &member.emplace();
  else
    return &member;
}

/// Returns the structs in `Member`: a list's elements, an optional's value, or the member itself.
template <class Struct, auto Member>
std::vector<void*> present_items(void* object) {
  auto& member = static_cast<Struct*>(object)->*Member;
  using T = std::decay_t<decltype(member)>;
  std::vector<void*> out;
  if constexpr (is_list<T>) {
    for (auto& item : member) out.push_back(&item);
  } else if constexpr (is_optional<T>) {
    if (member) out.push_back(&*member);
  } else {
    out.push_back(&member);
  }
  return out;
}

template <class Struct, auto Member>
inline constexpr Items items = {add_item<Struct, Member>, present_items<Struct, Member>};

template <class Struct, auto... Path>
Field number(std::string_view key, Hashed hashed, std::string_view unit, Range range,
             std::string_view description) {
  return {.key = key,
          .in = in<Struct, Path...>,
          .hashed = hashed,
          .unit = unit,
          .range = range,
          .description = description};
}

template <class Struct, auto... Path>
Field plain(std::string_view key, Hashed hashed, std::string_view description) {  // bool, quaternion
  return {.key = key, .in = in<Struct, Path...>, .hashed = hashed, .description = description};
}

template <class Struct, auto... Path>
Field words(std::string_view key, Hashed hashed, std::vector<std::string_view> words,
            std::string_view description) {
  return {.key = key,
          .in = in<Struct, Path...>,
          .hashed = hashed,
          .words = std::move(words),
          .description = description};
}

template <class Struct, auto... Path>
Field text(std::string_view key, Hashed hashed, std::string_view description, bool required = false) {
  return {.key = key,
          .in = in<Struct, Path...>,
          .hashed = hashed,
          .max_length = max_text_length,
          .required = required,
          .description = description};
}

template <class Struct, auto... Path>
Field name(std::string_view key, Hashed hashed, bool required, std::string_view description) {
  return {.key = key,
          .in = in<Struct, Path...>,
          .hashed = hashed,
          .text = Text::name,
          .required = required,
          .description = description};
}

template <class Struct, auto... Path>
Field quantity(std::string_view key, Hashed hashed, std::string_view unit, Range range,
               std::string_view description) {
  return number<Struct, Path...>(key, hashed, unit, range, description);
}

template <class Struct, auto... Path>
Field identifier(std::string_view key, Hashed hashed, std::string_view description) {
  return {.key = key,
          .in = in<Struct, Path...>,
          .hashed = hashed,
          .text = Text::identifier,
          .description = description};
}

template <class Struct, auto... Path>
Field names(std::string_view key, Hashed hashed, std::string_view description) {
  return {.key = key,
          .in = in<Struct, Path...>,
          .hashed = hashed,
          .text = Text::name,
          .description = description};
}

/// Adds the pose fields shared by rigid parts, rigid bodies and soft bodies.
template <class Struct>
void add_pose(std::vector<Field>& fields, std::string_view frames) {
  fields.push_back(number<Struct, &Struct::pose, &Pose::p>("position", compiled, "m", coordinate, frames));
  fields.push_back(plain<Struct, &Struct::pose, &Pose::q>(
      "rotation", compiled,
      "orientation as a quaternion [w, x, y, z]; normalised when read, never all zero"));
}

}  // namespace prosector
