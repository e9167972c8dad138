#pragma once
// Functions that make the rows of the field tables, one per value type. Private to common/scene.

#include <cstdint>
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

/// Returns a pointer to the member of `*object`, a Struct, that a chain of member pointers reaches. Example:
/// in<RigidDesc, &RigidDesc::pose, &Pose::p>.
template <class Struct, auto... Path>
FieldRef in(void* object) {
  auto& member = (*static_cast<Struct*>(object).*....*Path);
  using Member = std::decay_t<decltype(member)>;
  if constexpr (std::is_enum_v<Member>) {
    static_assert(std::is_same_v<std::underlying_type_t<Member>, std::uint8_t>, "stored as one byte");
    return reinterpret_cast<std::uint8_t*>(&member);
  } else {
    return &member;
  }
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

/// Makes the member at the end of `Path`, in the Struct `*object`, ready to be filled. Appends an element to
/// a list, or emplaces an optional without a value. Returns a pointer to the element, the value, or the
/// member itself.
template <class Struct, auto... Path>
void* add_item(void* object) {
  auto& member = (*static_cast<Struct*>(object).*....*Path);
  using T = std::decay_t<decltype(member)>;
  if constexpr (is_list<T>)
    return &member.emplace_back();
  else if constexpr (is_optional<T>)
    return member ? &*member : &member.emplace();
  else
    return &member;
}

/// Returns pointers to the structs in the member at the end of `Path`, in the Struct `*object`. These are a
/// list's elements, an optional's value if there is one, or the member itself.
template <class Struct, auto... Path>
std::vector<void*> present_items(void* object) {
  auto& member = (*static_cast<Struct*>(object).*....*Path);
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

template <class Struct, auto... Path>
inline constexpr Items items = {add_item<Struct, Path...>, present_items<Struct, Path...>};

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

/// Appends the scene keys for a pose (position and rotation), which rigid parts, rigid bodies and soft bodies
/// share. `frames` describes the frame of the position.
template <class Struct>
void add_pose(std::vector<Field>& fields, std::string_view frames) {
  fields.push_back(number<Struct, &Struct::pose, &Pose::p>("position", compiled, "m", coordinate, frames));
  fields.push_back(plain<Struct, &Struct::pose, &Pose::q>(
      "rotation", compiled, "orientation as a quaternion; normalised when read"));
}

}  // namespace prosector
