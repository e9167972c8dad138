#pragma once
// What one viewer chose to see of the parts of a scene: nobody else is concerned.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/messages.h"

namespace prosector {

/// How a viewer wants to see a part.
struct PartLook {
  bool hidden = false;
  double opacity = 1;         // 0 … 1, times what everybody sees
  std::optional<Vec3> color;  // linear red, green, blue; nullopt: its own
  bool operator==(const PartLook&) const = default;
};

/// A change of what a viewer sees. Parts are named as the scene's author does (authors_name()).
struct PartsOrder {
  enum class Kind : std::uint8_t { show, hide, isolate, isolate_next, opacity, color, reset_all, labels };
  /// `isolate_next`: of these parts, the others become faint; then hidden, then back.
  Kind kind = Kind::show;
  std::vector<std::string> parts = {};  // of `isolate` none: the others are back
  double opacity = 1;                   // of `opacity`; of `isolate`, of the other parts: 0 hides them
  std::optional<Vec3> color = {};       // of `color`; nullopt: its own
};

inline constexpr double least_opacity = 0.05;  // of a part that is not hidden
inline constexpr double faint_opacity = 0.12;  // of what is beside an isolated part

/// The colours to choose from: told apart by people of any colour vision (Okabe and Ito 2008).
struct NamedColor {
  std::string_view name;
  Vec3 color;  // linear red, green, blue
};
std::vector<NamedColor> part_colors();

class PartsChoice {
 public:
  void obey(const PartsOrder& order);

  /// Returns how the part is seen. `in_anatomy`: it is hidden or faint while others are isolated.
  PartLook look_of(const std::string& part, bool in_anatomy) const;
  /// Returns what was chosen for the part alone, whatever is isolated.
  PartLook own_look(const std::string& part) const;
  bool is_isolated(const std::string& part) const { return isolated_.contains(part); }
  bool isolates() const { return !isolated_.empty(); }
  /// Tells whether names stand beside the anatomy.
  bool labels() const { return labels_; }

 private:
  std::map<std::string, PartLook> looks_;  // of those that are not as the scene has them
  std::set<std::string> isolated_;
  double others_ = 0;
  bool labels_ = false;

  void isolate(const std::vector<std::string>& parts, double others);
  void change(const std::string& part, const PartsOrder& order);
};

/// Returns the bodies that bodies were cut off, by their ids: each one's organ, or itself. `piece_of` returns
/// what a body was cut off; −1: nothing.
template <class PieceOf>
std::vector<BodyId> organs_of(const SceneInfo& scene, const PieceOf& piece_of) {
  std::vector<BodyId> out(scene.bodies.size());
  for (BodyId body = 0; body < out.size(); ++body) {
    out[body] = body;
    // A piece has a higher id than what it was cut off.
    if (const std::int32_t from = piece_of(body); from >= 0 && static_cast<BodyId>(from) < body)
      out[body] = out[static_cast<BodyId>(from)];
  }
  return out;
}

}  // namespace prosector
