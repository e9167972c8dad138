#pragma once
// Labels in two columns beside what they name, with leader lines that do not cross (boundary labelling). In
// points of a picture, y downwards.

#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector {

/// A label that would be shown if there is room.
struct LabelWanted {
  std::uint32_t id = 0;
  Eigen::Vector2d anchor;  // that its leader ends at, between the columns
  double width = 0;        // of its box, no more than a column
  double weight = 0;       // the heavier it is, the sooner it is shown
};

struct LabelColumns {
  double top = 0, bottom = 0;  // that boxes stay between
  double left = 0, right = 0;  // inner ends of the left and the right column
  double spacing = 0;          // from one box's top to the next one's, above a box's height
  double height = 0;           // of a box
  std::size_t most = 0;        // labels
};

struct PlacedLabel {
  std::uint32_t id = 0;
  bool at_left = false;
  Eigen::Vector2d anchor, port;  // of its leader: from the port, at the box, to the anchor
  Eigen::AlignedBox2d box = {};
  double weight = 0;
};

/// Which labels were shown where, from the top: what keeps the next layout like the last one.
struct LabelOrder {
  std::vector<std::uint32_t> left, right;
};

struct LabelLayout {
  std::vector<PlacedLabel> labels;
  LabelOrder order;
};

/// Places labels so that no two boxes overlap and no two leaders cross. The heaviest are shown; those that
/// were there before count half as much again. A label stays on its side, and in its place of the order, as
/// long as no leaders cross. Boxes stand as near to the heights of their anchors as the others let them.
LabelLayout lay_out_labels(std::vector<LabelWanted> wanted, const LabelColumns& columns,
                           const LabelOrder& before);

/// Tells whether two leaders have a point in common.
bool leaders_cross(const PlacedLabel& a, const PlacedLabel& b);

}  // namespace prosector
