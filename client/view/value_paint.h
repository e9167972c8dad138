#pragma once
// Soft bodies coloured by how far their shape is to be relied on, and the scale that says what a colour
// means.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "client/language/catalogue.h"
#include "client/view/draw_list.h"
#include "common/messages.h"

namespace prosector {

/// What a body's colour tells; `none`: its own.
enum class Shown : std::uint8_t { none, strain, residual, error };

struct ValueScale {
  std::string_view name;   // as the command line has it
  std::string_view about;  // for people, with the unit
  double least = 0, most = 1;
  double factor = 1;  // of the legend's numbers
  bool logarithmic = false;

  bool operator==(const ValueScale&) const = default;
};
inline constexpr std::array<ValueScale, 4> value_scales = {
    {{"none", ""},
     {"strain", msg("strain, %"), 0, 0.3, 100, false},  // its end follows what is shown: AutoRange
     {"residual", msg("worst residual of\nthe last second\n(gray: not known)"), 1e-8, 1, 1, true},
     {"error", msg("estimated error, %,\nby where it comes from\n(gray: not known)"), 0, 0.2, 100, false}}};
constexpr const ValueScale& scale_of(Shown shown) {
  return value_scales[static_cast<std::size_t>(shown)];
}

/// Returns the linear colour, as drawn where light falls straight on it. Values beyond the scale have the
/// colour of its end; those that are not numbers, because they are not known, are gray.
Vec3 value_color(const ValueScale& scale, double value);
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Returns the largest principal stretch − 1 of the drawn surface from its rest positions, at each vertex.
/// That is the mean of the triangles around, weighted by their area at rest. Triangles without area at rest
/// don't count.
std::vector<double> surface_strains(const DrawMesh& mesh);

/// The colours of one mesh, kept as long as neither it, nor the scale, nor the value changed.
class PaintedMesh {
 public:
  explicit PaintedMesh(std::uint64_t id) { mesh_->id = id; }
  /// Returns `mesh` in colours instead of rest positions, for DrawItem::painted. `value` is that of the whole
  /// mesh; without one, its strains are shown. `map`: what vertices have instead, by their rest positions;
  /// null or empty: none.
  std::shared_ptr<const DrawMesh> of(const DrawMesh& mesh, const ValueScale& scale,
                                     std::optional<double> value, const ErrorMap* map = nullptr);
  /// Returns the surface_strains() of the mesh.
  const std::vector<double>& strains(const DrawMesh& mesh);

 private:
  std::shared_ptr<DrawMesh> mesh_ = std::make_shared<DrawMesh>();
  std::optional<ValueScale> scale_;
  std::vector<double> strains_;
  std::optional<std::array<std::uint64_t, 2>> strained_;  // the mesh's revisions that strains_ are of
  std::optional<double> value_;
  std::vector<std::uint8_t> levels_;  // of the map
  std::array<std::uint64_t, 2> revisions_{};
};

/// Adds a bar of the scale's colours with its numbers, at the lower right of the picture.
void add_legend(DrawList& list, const ValueScale& scale);

}  // namespace prosector
