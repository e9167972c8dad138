#pragma once
// Names beside the parts in view, with leader lines to what they name.

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "client/text/typesetter.h"
#include "client/view/label_layout.h"
#include "client/view/seen_map.h"

namespace prosector {

/// An item of a list whose part is to be named; a part may have several.
struct NamedItem {
  std::uint32_t part = 0;
  std::size_t item = 0;  // of the list
  std::string_view name;
};

class PartLabels {
 public:
  static constexpr std::size_t most_labels = 48;

  /// Adds labels of the parts that are seen in the list, as the first camera has them, to all its cameras but
  /// insets. They stand in `free` (points from the first camera's top left), at the depth of what they name.
  void add(DrawList& list, std::span<const NamedItem> named, const Eigen::AlignedBox2d& free);

 private:
  /// A place on a surface, which goes with it.
  struct Anchor {
    std::uint64_t mesh = 0, revision = 0;
    std::array<std::uint32_t, 3> vertices{};
    Eigen::Vector3f shares = Eigen::Vector3f::Zero();  // of the vertices
  };
  struct Placed {
    Vec3 at;                // m, world frame
    Eigen::Vector2d point;  // points of the first camera's picture
    double depth;           // m, along its view
  };
  /// A part as it is seen.
  struct Seen {
    std::string_view name;
    std::vector<Eigen::Vector2i> cells;
    double width = 0, wrap = 0;  // points: of its label, of a text that is too long for it
    Placed anchor{};
  };
  struct Frame;

  std::optional<Typesetter> typesetter_;  // made when names are first asked for: it looks for fonts
  std::map<std::uint32_t, Anchor> anchors_;
  LabelOrder order_;
  std::optional<std::array<double, 2>> columns_;  // inner ends, points
  std::optional<double> depth_;                   // m, of the labels

  std::map<std::uint32_t, Seen> seen_parts(const Frame& frame, std::span<const NamedItem> named);
  LabelColumns columns_for(const std::map<std::uint32_t, Seen>& seen, const Frame& frame);
  void anchor(std::uint32_t part, Seen& seen, const Frame& frame);
  std::optional<Placed> still_there(const Anchor& anchor, std::uint32_t part, const Frame& frame) const;
  std::optional<Anchor> choose_anchor(const Seen& seen, const Frame& frame) const;
  void measure(Seen& seen, double most);
  void keep_depth(const std::map<std::uint32_t, Seen>& seen, const Frame& frame);
  void keep_in_all_eyes(Frame& frame) const;
  void drop_crossings(LabelLayout& layout, const Frame& frame,
                      const std::map<std::uint32_t, Seen>& seen) const;
  void draw(DrawList& list, const Frame& frame, const LabelLayout& layout,
            const std::map<std::uint32_t, Seen>& seen) const;
};

}  // namespace prosector
