#pragma once
// Labels with the names of visible parts, and leader lines to the parts.

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "client/text/typesetter.h"
#include "client/view/item_id_buffer.h"
#include "client/view/label_layout.h"

namespace prosector {

/// Item of a draw list that belongs to a part to be labelled, and the part's name. A part may have several
/// items.
struct NamedItem {
  std::uint32_t part = 0;
  std::size_t item = 0;  // index in the list
  std::string_view name;
};

class PartLabels {
 public:
  static constexpr std::size_t most_labels = 48;

  /// Adds labels with the names of the parts that the list's first camera sees, and leader lines to the
  /// parts. They are drawn for all cameras but insets, at the depth of the parts. Labels stay in `free`,
  /// given in points from the first camera's top left.
  void add(DrawList& list, std::span<const NamedItem> named, const Eigen::AlignedBox2d& free);

 private:
  /// Point on a part's surface to which its label's leader line points. It is stored by triangle and
  /// barycentric coordinates, and so moves with the surface.
  struct Anchor {
    std::uint64_t mesh = 0, revision = 0;
    std::array<std::uint32_t, 3> vertices{};
    Eigen::Vector3f shares = Eigen::Vector3f::Zero();  // barycentric coordinates
  };
  struct Placed {
    Vec3 at;                // m, world frame
    Eigen::Vector2d point;  // points of the first camera's viewport
    double depth;           // m, along the first camera's axis
  };
  /// Part that the first camera sees: its name, the cells of the item-id buffer that show it, and its label's
  /// size and anchor.
  struct Seen {
    std::string_view name;
    std::vector<Eigen::Vector2i> cells;
    double width = 0, wrap = 0;  // points: of its label; wrap width of a name that is too long
    Placed anchor{};
  };
  struct Frame;

  std::optional<Typesetter> typesetter_;  // made at the first use, because it searches for fonts
  std::map<std::uint32_t, Anchor> anchors_;
  LabelOrder order_;
  std::optional<std::array<double, 2>> columns_;  // inner borders, points
  std::optional<double> depth_;                   // m, of the labels

  std::map<std::uint32_t, Seen> seen_parts(const Frame& frame, std::span<const NamedItem> named);
  LabelColumns columns_for(const std::map<std::uint32_t, Seen>& seen, const Frame& frame);
  void anchor(std::uint32_t part, Seen& seen, const Frame& frame);
  std::optional<Placed> still_there(const Anchor& anchor, std::uint32_t part, const Frame& frame) const;
  std::optional<Anchor> choose_anchor(const Seen& seen, const Frame& frame) const;
  void measure(Seen& seen, double most);
  void keep_depth(const std::map<std::uint32_t, Seen>& seen, const Frame& frame);
  void clip_to_all_eyes(Frame& frame) const;
  void drop_crossings(LabelLayout& layout, const Frame& frame,
                      const std::map<std::uint32_t, Seen>& seen) const;
  void draw(DrawList& list, const Frame& frame, const LabelLayout& layout,
            const std::map<std::uint32_t, Seen>& seen) const;
};

}  // namespace prosector
