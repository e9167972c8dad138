#pragma once
// One viewer's choice of which parts are visible and how. It affects no other viewer.

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/ids.h"
#include "common/math.h"
#include "common/scene_messages.h"

namespace prosector {

/// Display of an anatomical part for one viewer: whether it is hidden, its opacity and its colour.
struct PartLook {
  bool hidden = false;
  double opacity = 1;         // 0 … 1, factor of the shared opacity
  std::optional<Vec3> color;  // linear red, green, blue; nullopt: the part's own
  bool operator==(const PartLook&) const = default;
};

/// Command that changes how one viewer sees anatomical parts. Parts are named as in the scene file
/// (authors_name()).
struct PartsOrder {
  enum class Kind : std::uint8_t { show, hide, isolate, isolate_next, opacity, color, reset_all, labels };
  /// Kind of the command. `isolate_next` cycles through three states of the parts that are not named: nearly
  /// transparent, hidden, and shown again.
  Kind kind = Kind::show;
  std::vector<std::string> parts = {};  // for `isolate`, empty: ends the isolation
  double opacity = 1;                   // for `opacity`; for `isolate`, that of the other parts: 0 hides them
  std::optional<Vec3> color = {};       // for `color`; nullopt: the part's own
};

inline constexpr double least_opacity = 0.05;  // of a part that is not hidden
inline constexpr double faint_opacity = 0.12;  // of the parts next to an isolated part

/// Colour that a viewer can choose for a part, with its name. The colours are distinguishable with any colour
/// vision (Okabe and Ito 2008).
struct NamedColor {
  std::string_view name;
  Vec3 color;  // linear red, green, blue
};
std::vector<NamedColor> part_colors();

class PartsChoice {
 public:
  void obey(const PartsOrder& order);

  /// Returns how the viewer sees the part, including the effect of isolating other parts. `in_anatomy`:
  /// whether the part belongs to the anatomy; only then it is hidden or nearly transparent while others are
  /// isolated.
  PartLook look_of(const std::string& part, bool in_anatomy) const;
  /// Returns the hiding, opacity and colour that the viewer chose for the part itself, ignoring isolation of
  /// other parts.
  PartLook own_look(const std::string& part) const;
  bool is_isolated(const std::string& part) const { return isolated_.contains(part); }
  bool isolates() const { return !isolated_.empty(); }
  /// Returns whether the viewer has switched on labels with the names of the anatomical parts.
  bool labels() const { return labels_; }

 private:
  std::map<std::string, PartLook> looks_;  // only of parts that differ from the scene
  std::set<std::string> isolated_;
  double others_ = 0;
  bool labels_ = false;

  void isolate(const std::vector<std::string>& parts, double others);
  void change(const std::string& part, const PartsOrder& order);
};

/// Returns for each body, by body id, the organ that it was originally cut from, or its own id if it is no
/// cut-off piece. `piece_of` returns the body that a body was cut from; −1: none.
template <class PieceOf>
std::vector<BodyId> organs_of(const SceneInfo& scene, const PieceOf& piece_of) {
  std::vector<BodyId> out(scene.bodies.size());
  for (BodyId body = 0; body < out.size(); ++body) {
    out[body] = body;
    // A piece has a higher id than the body it was cut from.
    if (const std::int32_t from = piece_of(body); from >= 0 && static_cast<BodyId>(from) < body)
      out[body] = out[static_cast<BodyId>(from)];
  }
  return out;
}

}  // namespace prosector
