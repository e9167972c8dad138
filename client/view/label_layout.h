#pragma once
// Boundary labelling: labels in two columns next to the objects that they name, with leader lines that do not
// cross. In points of a view, y downwards.

#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Label that is shown if there is room, and the position it names. Lengths: logical pixels of the view.
struct LabelWanted {
  std::uint32_t id = 0;
  Eigen::Vector2d anchor;  // end of its leader, between the columns
  double width = 0;        // of its box, at most the column's width
  double weight = 0;       // labels with larger weights are shown first
};

struct LabelColumns {
  double top = 0, bottom = 0;  // vertical range of the boxes
  double left = 0, right = 0;  // inner borders of the left and the right column
  double spacing = 0;          // from one box's top to the next one's, more than the boxes' height
  double height = 0;           // of a box
  std::size_t most = 0;        // maximum number of labels
};

struct PlacedLabel {
  std::uint32_t id = 0;
  bool at_left = false;
  Eigen::Vector2d anchor, port;  // leader from the port, at the box, to the anchor
  Eigen::AlignedBox2d box = {};
  double weight = 0;
};

/// Ids of the labels that the last layout showed in each column, from the top. With it, the next layout stays
/// similar to the last one.
struct LabelOrder {
  std::vector<std::uint32_t> left, right;
};

struct LabelLayout {
  std::vector<PlacedLabel> labels;
  LabelOrder order;
};

/// Places labels in two columns so that no two boxes overlap and no two leader lines cross. Shows the labels
/// with the largest weights; weights of labels in `before` (the last layout) count 1.5 times. A label keeps
/// its side and its position in the order as long as no leaders cross. Boxes are as near to their anchors'
/// heights as the other boxes allow.
LabelLayout lay_out_labels(std::vector<LabelWanted> wanted, const LabelColumns& columns,
                           const LabelOrder& before);

/// Returns whether the leader lines of two labels (from box to anchor) have a point in common.
bool leaders_cross(const PlacedLabel& a, const PlacedLabel& b);

}  // namespace prosector
