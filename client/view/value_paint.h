#pragma once
// Soft bodies coloured by strain or accuracy, and the scale of the colours.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "client/language/catalogue.h"
#include "client/view/draw_list.h"
#include "common/error_estimate.h"
#include "common/math.h"

namespace prosector {

/// Quantity that the colours of soft bodies show; `none`: bodies have their normal colours.
enum class Shown : std::uint8_t { none, strain, residual, error };

struct ValueScale {
  std::string_view name;   // name on the command line
  std::string_view about;  // displayed description, with the unit
  double least = 0, most = 1;
  double factor = 1;  // factor of the legend's numbers
  bool logarithmic = false;

  bool operator==(const ValueScale&) const = default;
};
inline constexpr std::array<ValueScale, 4> value_scales = {
    {{"none", ""},
     {"strain", msg("strain, %"), 0, 0.3, 100, false},  // its end follows the shown values: AutoRange
     {"residual", msg("largest residual of\nthe last second\n(gray: unknown)"), 1e-8, 1, 1, true},
     {"error", msg("estimated error, %,\nby its source\n(gray: unknown)"), 0, 0.2, 100, false}}};
constexpr const ValueScale& scale_of(Shown shown) {
  return value_scales[static_cast<std::size_t>(shown)];
}

/// Returns the linear RGB colour of a value on the scale, under direct light. Values beyond the scale have
/// the colour of its end; unknown values (NaN) are gray.
Vec3 value_color(const ValueScale& scale, double value);
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Returns the surface strain at each vertex: the largest principal stretch − 1 relative to the rest
/// positions. It is the mean of the adjacent triangles, weighted by rest area. Triangles without rest area
/// are ignored.
std::vector<double> surface_strains(const DrawMesh& mesh);

/// Vertex colours of one mesh that show a quantity, cached until the mesh, the colour scale or the value
/// changes.
class PaintedMesh {
 public:
  explicit PaintedMesh(std::uint64_t id) { mesh_->id = id; }
  /// Returns a copy of `mesh` with colours instead of rest positions, for DrawItem::painted. `value`: value
  /// of the whole mesh; nullopt: the strains of its vertices. `map`: values by rest position that replace
  /// `value` at vertices; null or empty: none.
  std::shared_ptr<const DrawMesh> of(const DrawMesh& mesh, const ValueScale& scale,
                                     std::optional<double> value, const ErrorMap* map = nullptr);
  /// Returns the strains at the mesh's vertices, as surface_strains() computes them, cached.
  const std::vector<double>& strains(const DrawMesh& mesh);

 private:
  std::shared_ptr<DrawMesh> mesh_ = std::make_shared<DrawMesh>();
  std::optional<ValueScale> scale_;
  std::vector<double> strains_;
  // The mesh's revisions for which strains_ was computed.
  std::optional<std::array<std::uint64_t, 2>> strained_;
  std::optional<double> value_;
  std::vector<std::uint8_t> levels_;  // of the map
  std::array<std::uint64_t, 2> revisions_{};
};

/// Adds a legend at the lower right of the view: a bar of the scale's colours with its numbers.
void add_legend(DrawList& list, const ValueScale& scale);

}  // namespace prosector
