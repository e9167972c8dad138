#include "client/view/label_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosector {
namespace {

constexpr double bonus_of_shown = 1.5;  // factor of the weight
constexpr double side_band = 0.08;      // fraction of the columns' distance: a label keeps its side until its
                                        // anchor is this far past the middle

using Side = std::vector<const LabelWanted*>;  // labels of a column, from the top

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return c_side * d_side <= 0 && a_side * b_side <= 0 &&
         Eigen::AlignedBox2d(a.cwiseMin(b), a.cwiseMax(b))
             .intersects(Eigen::AlignedBox2d(c.cwiseMin(d), c.cwiseMax(d)));
}

bool has(const std::vector<std::uint32_t>& ids, std::uint32_t id) {
  return std::ranges::find(ids, id) != ids.end();
}

std::size_t capacity_of(const LabelColumns& columns) {
  const double room = columns.bottom - columns.top - columns.height;
  return room < 0 ? 0 : static_cast<std::size_t>(room / columns.spacing) + 1;
}

/// Keeps the labels with the largest weights, at most `most`.
void choose(std::vector<LabelWanted>& wanted, std::size_t most, const LabelOrder& before) {
  const auto rank = [&](const LabelWanted& label) {
    const bool shown = has(before.left, label.id) || has(before.right, label.id);
    return std::pair(-label.weight * (shown ? bonus_of_shown : 1), label.id);
  };
  std::ranges::sort(wanted, {}, rank);
  if (wanted.size() > most) wanted.resize(most);
}

/// Returns the tops of boxes as near to the wanted heights (ascending) as possible without overlap: isotonic
/// regression by pooling adjacent violators.
std::vector<double> tops_for(const std::vector<double>& wanted, const LabelColumns& columns) {
  if (wanted.empty()) return {};
  struct Pool {
    double sum;
    std::size_t count;
    double mean() const { return sum / static_cast<double>(count); }
  };
  std::vector<Pool> pools;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    pools.push_back({wanted[k] - columns.spacing * static_cast<double>(k), 1});
    while (pools.size() > 1 && pools[pools.size() - 2].mean() >= pools.back().mean()) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().sum += last.sum;
      pools.back().count += last.count;
    }
  }
  const double lowest =
      std::max(columns.bottom - columns.height - columns.spacing * static_cast<double>(wanted.size() - 1),
               columns.top);
  std::vector<double> out;
  for (const Pool& pool : pools)
    for (std::size_t k = 0; k < pool.count; ++k)
      out.push_back(std::clamp(pool.mean(), columns.top, lowest) +
                    columns.spacing * static_cast<double>(out.size()));
  return out;
}

/// Returns the ports of a column's leaders, from the top.
std::vector<Eigen::Vector2d> ports_of(const Side& side, bool at_left, const LabelColumns& columns) {
  std::vector<double> heights;
  for (const LabelWanted* label : side) heights.push_back(label->anchor.y() - columns.height / 2);
  std::ranges::sort(heights);
  std::vector<Eigen::Vector2d> out;
  for (const double top : tops_for(heights, columns))
    out.emplace_back(at_left ? columns.left : columns.right, top + columns.height / 2);
  return out;
}

bool is_free_of_crossings(const Side& side, const std::vector<Eigen::Vector2d>& ports) {
  for (std::size_t i = 0; i < side.size(); ++i)
    for (std::size_t j = i + 1; j < side.size(); ++j)
      if (segments_meet(ports[i], side[i]->anchor, ports[j], side[j]->anchor)) return false;
  return true;
}

/// Orders a column so that no leaders cross. The top port takes the anchor for which all other anchors are
/// below the leader. The remaining ports and anchors are then below that leader, too.
void match(Side& side, const std::vector<Eigen::Vector2d>& ports) {
  for (std::size_t k = 0; k < side.size(); ++k) {
    const auto direction = [&](const LabelWanted* label) {
      const Eigen::Vector2d way = label->anchor - ports[k];
      const double far = std::max(std::abs(way.x()), 1e-9);
      return std::tuple(way.y() / far, far, label->id);
    };
    const auto first = side.begin() + static_cast<std::ptrdiff_t>(k);
    std::iter_swap(first, std::ranges::min_element(first, side.end(), {}, direction));
  }
}

/// Restores the previous order of a column's labels, and inserts new ones by their anchors' heights.
void keep_order(Side& side, const std::vector<std::uint32_t>& before) {
  const auto place = [&](const LabelWanted* label) { return std::ranges::find(before, label->id); };
  const auto fresh = std::stable_partition(side.begin(), side.end(),
                                           [&](const LabelWanted* l) { return place(l) != before.end(); });
  Side added(fresh, side.end());
  side.erase(fresh, side.end());
  std::ranges::sort(side, {}, place);
  for (const LabelWanted* label : added)
    side.insert(std::ranges::find_if(
                    side, [&](const LabelWanted* other) { return other->anchor.y() > label->anchor.y(); }),
                label);
}

struct Sides {
  Side left, right;
};

/// Distributes the labels between the columns by the side of their anchors. With `before`, a label stays on
/// its side until its anchor is far past the middle.
Sides share_out(const std::vector<LabelWanted>& labels, const LabelColumns& columns,
                const LabelOrder* before) {
  const double middle = (columns.left + columns.right) / 2, band = side_band * (columns.right - columns.left);
  std::vector<std::pair<double, const LabelWanted*>> from_left;
  for (const LabelWanted& label : labels) {
    double x = label.anchor.x() - middle;
    if (before != nullptr && has(before->left, label.id)) x -= band;
    if (before != nullptr && has(before->right, label.id)) x += band;
    from_left.emplace_back(x, &label);
  }
  std::ranges::sort(from_left, {},
                    [](const auto& entry) { return std::pair(entry.first, entry.second->id); });
  const auto left = static_cast<std::size_t>(
      std::ranges::count_if(from_left, [](const auto& entry) { return entry.first < 0; }));
  const std::size_t capacity = capacity_of(columns), all = from_left.size();
  const std::size_t at_left = std::clamp(left, all - std::min(all, capacity), std::min(all, capacity));
  Sides out;
  for (std::size_t k = 0; k < all; ++k) (k < at_left ? out.left : out.right).push_back(from_left[k].second);
  return out;
}

void place(const Side& side, const std::vector<Eigen::Vector2d>& ports, bool at_left,
           const LabelColumns& columns, LabelLayout& out) {
  for (std::size_t k = 0; k < side.size(); ++k) {
    PlacedLabel label{.id = side[k]->id,
                      .at_left = at_left,
                      .anchor = side[k]->anchor,
                      .port = ports[k],
                      .weight = side[k]->weight};
    const double left = at_left ? ports[k].x() - side[k]->width : ports[k].x();
    label.box.extend(Eigen::Vector2d(left, ports[k].y() - columns.height / 2));
    label.box.extend(Eigen::Vector2d(left + side[k]->width, ports[k].y() + columns.height / 2));
    out.labels.push_back(label);
    (at_left ? out.order.left : out.order.right).push_back(label.id);
  }
}

LabelLayout laid_out(Sides sides, const LabelColumns& columns, const LabelOrder& before) {
  LabelLayout out;
  for (const bool at_left : {true, false}) {
    Side& side = at_left ? sides.left : sides.right;
    const std::vector<Eigen::Vector2d> ports = ports_of(side, at_left, columns);
    keep_order(side, at_left ? before.left : before.right);
    if (!is_free_of_crossings(side, ports)) match(side, ports);
    place(side, ports, at_left, columns, out);
  }
  return out;
}

bool has_crossings(const LabelLayout& layout) {
  for (std::size_t i = 0; i < layout.labels.size(); ++i)
    for (std::size_t j = i + 1; j < layout.labels.size(); ++j)
      if (leaders_cross(layout.labels[i], layout.labels[j])) return true;
  return false;
}

}  // namespace

LabelLayout lay_out_labels(std::vector<LabelWanted> wanted, const LabelColumns& columns,
                           const LabelOrder& before) {
  if (columns.left >= columns.right) return {};
  choose(wanted, std::min(columns.most, 2 * capacity_of(columns)), before);
  const LabelLayout like_before = laid_out(share_out(wanted, columns, &before), columns, before);
  if (!has_crossings(like_before)) return like_before;
  return laid_out(share_out(wanted, columns, nullptr), columns, before);
}

bool leaders_cross(const PlacedLabel& a, const PlacedLabel& b) {
  return segments_meet(a.port, a.anchor, b.port, b.anchor);
}

}  // namespace prosector
