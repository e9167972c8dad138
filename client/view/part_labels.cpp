#include "client/view/part_labels.h"

#include <algorithm>
#include <cmath>

#include "client/text/text_block.h"
#include "client/view/set_text.h"

namespace prosector {
namespace {

constexpr double cell_points = 4;                                             // of a cell of the item map
constexpr int most_cells_across = 240;                                        // of the item map
constexpr double name_height = 12, least_name_height = 9, widest_name = 190;  // points
constexpr double widest_name_share = 0.28;                                    // fraction of the free width
constexpr double column_gap = 22;       // points from the anatomy's outline to a column
constexpr double anchor_gap = 8;        // points from a column to an anchor
constexpr double column_slack = 14;     // points: hysteresis of the columns' positions
constexpr double depth_slack = 0.15;    // hysteresis, as a fraction of the depth
constexpr double near_surface = 0.004;  // m that an anchor may be behind the visible surface
constexpr std::size_t least_cells = 10, least_cells_of_shown = 4;
constexpr double leader_width = 1.2, casing_width = 3, dot_width = 4.5, dot_casing = 6.5;  // points
const Vec3 leader_color{0.80, 0.84, 0.88}, casing_color{0.004, 0.004, 0.004};

DrawText label_text(std::string_view name, double wrap) {
  return {.text = std::string(name),
          .overlay = false,
          .height = name_height,
          .wrap = wrap,
          .least_height = least_name_height,
          .tallest = 1.001 * height_of_lines(1) * name_height};
}

constexpr double name_box_height = height_of_lines(1) * name_height + 2 * ground_above;
// Texts in the room are aligned to whole pixels, so two boxes may come a pixel closer.
constexpr double name_box_spacing = name_box_height + text_margin + 2.5;

}  // namespace

/// The data for one frame's labels.
struct PartLabels::Frame {
  const DrawList& list;
  const DrawCamera& camera;
  Eigen::AlignedBox2d free;  // points
  ItemIdBuffer map;
  std::vector<std::int32_t> part_of_item;  // −1: not labelled

  Eigen::Vector2d points() const { return Eigen::Vector2d(camera.width, camera.height) / list.scale; }
  Eigen::Vector2d point_of_cell(const Eigen::Vector2i& cell) const {
    return (cell.cast<double>().array() + 0.5) * points().array() / Eigen::Array2d(map.width, map.height);
  }
  std::optional<Placed> placed(const Vec3& at) const;
  std::int32_t part_at(int x, int y) const {
    const std::int32_t item = map.at(x, y).item;
    return item < 0 ? -1 : part_of_item[static_cast<std::size_t>(item)];
  }
  /// Returns whether the part is visible at and around a position of the map: in the four nearest cells, or
  /// in one that is very near.
  bool is_clearly_of(std::uint32_t part, const Eigen::Vector2d& at) const;
  Vec3 room_place(const DrawCamera& eye, const Eigen::Vector2d& point, double depth) const;
  Vec3 room_place(const Eigen::Vector2d& point, double depth) const {
    return room_place(camera, point, depth);
  }
};

namespace {

/// Returns the projection of a point: points from the viewport's top left in x, y, and depth in z. The depth
/// is 0 or less behind the near plane.
Vec3 seen_place(const DrawCamera& camera, double scale, const Vec3& at) {
  const Vec3 x = camera.pose.inverse() * at;
  const double depth = -x.z();
  if (depth <= camera.near) return Vec3::Zero();
  return {(x.x() / depth - camera.left) / (camera.right - camera.left) * camera.width / scale,
          (camera.top - x.y() / depth) / (camera.top - camera.bottom) * camera.height / scale, depth};
}

const DrawItem* item_of(const DrawList& list, std::uint64_t mesh, std::uint64_t revision) {
  for (const DrawItem& item : list.items)
    if (item.mesh && item.mesh->id == mesh) return item.mesh->revision == revision ? &item : nullptr;
  return nullptr;
}

Vec3 room_place_of(const DrawItem& item, std::uint32_t vertex) {
  return item.shape * (item.pose * item.mesh->positions[vertex].cast<double>().eval());
}

/// City-block distance transform, capped at `most`: the distance, in cells, from each cell of `part` to the
/// nearest cell outside, over the bounding box of `cells`.
class Depths {
 public:
  template <class Inside>
  Depths(const std::vector<Eigen::Vector2i>& cells, const Inside& inside) {
    for (const Eigen::Vector2i& cell : cells) box_.extend(cell);
    width_ = box_.sizes().x() + 3;
    depths_.assign(static_cast<std::size_t>(width_ * (box_.sizes().y() + 3)), 0);
    for (const Eigen::Vector2i& cell : cells)
      if (inside(cell)) at(cell) = most;
    const std::array<Eigen::Vector2i, 2> before = {{{-1, 0}, {0, -1}}};
    for (const Eigen::Vector2i& cell : cells)
      for (const auto& step : before) at(cell) = std::min(at(cell), at(cell + step) + 1);
    for (auto cell = cells.rbegin(); cell != cells.rend(); ++cell)
      for (const auto& step : before) at(*cell) = std::min(at(*cell), at(*cell - step) + 1);
  }
  int& at(const Eigen::Vector2i& cell) {
    const Eigen::Vector2i place = cell - box_.min() + Eigen::Vector2i::Ones();
    return depths_[static_cast<std::size_t>(place.y() * width_ + place.x())];
  }
  static constexpr int most = 4;

 private:
  Eigen::AlignedBox2i box_;
  int width_ = 0;
  std::vector<int> depths_;
};

}  // namespace

std::optional<PartLabels::Placed> PartLabels::Frame::placed(const Vec3& at) const {
  const Vec3 seen = seen_place(camera, list.scale, at);
  if (seen.z() <= 0) return std::nullopt;
  return Placed{at, seen.head<2>(), seen.z()};
}

bool PartLabels::Frame::is_clearly_of(std::uint32_t part, const Eigen::Vector2d& at) const {
  constexpr double very_near = 0.2;  // cells
  const auto is_of = [&](const Eigen::Vector2d& place) {
    if (place.minCoeff() < 0 || place.x() >= map.width || place.y() >= map.height) return false;
    return part_at(static_cast<int>(place.x()), static_cast<int>(place.y())) ==
           static_cast<std::int32_t>(part);
  };
  const Eigen::Vector2d middle = at.array().floor() + 0.5;
  if (!is_of(at)) return false;
  if ((at - middle).cwiseAbs().maxCoeff() < very_near) return true;
  const std::array<Eigen::Vector2d, 4> corners = {{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};
  return std::ranges::all_of(corners, [&](const Eigen::Vector2d& corner) { return is_of(at + corner); });
}

Vec3 PartLabels::Frame::room_place(const DrawCamera& eye, const Eigen::Vector2d& point, double depth) const {
  const Eigen::Vector2d share =
      point.cwiseProduct(Eigen::Vector2d(list.scale / eye.width, list.scale / eye.height));
  return eye.pose * Vec3(depth * (eye.left + (eye.right - eye.left) * share.x()),
                         depth * (eye.top + (eye.bottom - eye.top) * share.y()), -depth);
}

void PartLabels::add(DrawList& list, std::span<const NamedItem> named, const Eigen::AlignedBox2d& free) {
  if (named.empty() || list.cameras.empty() || free.isEmpty()) return;
  const DrawCamera& camera = list.cameras.front();
  const int width =
      std::clamp(static_cast<int>(camera.width / list.scale / cell_points), 1, most_cells_across);
  const int height =
      std::max(static_cast<int>(std::lround(static_cast<double>(width) * camera.height / camera.width)), 1);
  Frame frame{list, camera, free, rasterize_items(list, camera, width, height), {}};
  frame.part_of_item.assign(list.items.size(), -1);
  for (const NamedItem& item : named) frame.part_of_item[item.item] = static_cast<std::int32_t>(item.part);
  std::map<std::uint32_t, Seen> seen = seen_parts(frame, named);
  keep_depth(seen, frame);
  if (!depth_) return;
  clip_to_all_eyes(frame);
  const LabelColumns columns = columns_for(seen, frame);
  for (auto& [part, one] : seen) anchor(part, one, frame);
  std::erase_if(seen, [&](const auto& entry) { return !anchors_.contains(entry.first); });
  std::vector<LabelWanted> wanted;
  for (const auto& [part, one] : seen)
    wanted.push_back({part, one.anchor.point, one.width, static_cast<double>(one.cells.size())});
  LabelLayout layout = lay_out_labels(std::move(wanted), columns, order_);
  order_ = layout.order;
  drop_crossings(layout, frame, seen);
  draw(list, frame, layout, seen);
}

/// Returns the parts with enough visible cells, with their cells row by row.
std::map<std::uint32_t, PartLabels::Seen> PartLabels::seen_parts(const Frame& frame,
                                                                 std::span<const NamedItem> named) {
  std::map<std::uint32_t, Seen> out;
  for (const NamedItem& item : named) out[item.part].name = item.name;
  for (int y = 0; y < frame.map.height; ++y)
    for (int x = 0; x < frame.map.width; ++x)
      if (const std::int32_t part = frame.part_at(x, y); part >= 0)
        out[static_cast<std::uint32_t>(part)].cells.emplace_back(x, y);
  const double most = std::min(widest_name, widest_name_share * frame.free.sizes().x());
  std::erase_if(out, [&](const auto& entry) {
    return entry.second.cells.size() < (anchors_.contains(entry.first) ? least_cells_of_shown : least_cells);
  });
  std::erase_if(anchors_, [&](const auto& entry) { return !out.contains(entry.first); });
  for (auto& [part, one] : out) measure(one, most);
  return out;
}

/// Measures a name's label, background included. A name longer than `most` (points) is wrapped to that width.
void PartLabels::measure(Seen& seen, double most) {
  if (!typesetter_) typesetter_.emplace();
  const double natural = set_text(*typesetter_, label_text(seen.name, 0), 1).width();
  if (natural > most) seen.wrap = most;
  seen.width = 2 * ground_beside + set_text(*typesetter_, label_text(seen.name, seen.wrap), 1).width();
}

/// Places the columns next to the outline of the labelled parts, or at the view's borders if the outline
/// fills the view. The columns move only when they are off by more than a tolerance.
LabelColumns PartLabels::columns_for(const std::map<std::uint32_t, Seen>& seen, const Frame& frame) {
  double left = frame.free.max().x(), right = frame.free.min().x(), widest_label = 0;
  for (const auto& [part, one] : seen) {
    for (const Eigen::Vector2i& cell : one.cells) {
      left = std::min(left, frame.point_of_cell(cell).x());
      right = std::max(right, frame.point_of_cell(cell).x());
    }
    widest_label = std::max(widest_label, one.width);
  }
  const double least = frame.free.min().x() + widest_label, most = frame.free.max().x() - widest_label;
  const std::array<double, 2> wanted = {left - column_gap, right + column_gap};
  if (!columns_) columns_ = wanted;
  for (std::size_t k = 0; k < 2; ++k) {
    const double followed = std::clamp((*columns_)[k], wanted[k] - column_slack, wanted[k] + column_slack);
    (*columns_)[k] = std::min(std::max(followed, least), most);
  }
  return {frame.free.min().y(), frame.free.max().y(), (*columns_)[0], (*columns_)[1],
          name_box_spacing,     name_box_height,      most_labels};
}

/// Sets the part's anchor: the previous one if it is still visible, otherwise a new one; none if there is no
/// suitable position.
void PartLabels::anchor(std::uint32_t part, Seen& seen, const Frame& frame) {
  std::optional<Placed> place;
  if (const auto known = anchors_.find(part); known != anchors_.end())
    place = still_there(known->second, part, frame);
  if (!place) {
    anchors_.erase(part);
    const auto chosen = choose_anchor(seen, frame);
    if (chosen) place = still_there(*chosen, part, frame);
    if (place) anchors_[part] = *chosen;
  }
  if (place) seen.anchor = *place;
}

std::optional<PartLabels::Placed> PartLabels::still_there(const Anchor& anchor, std::uint32_t part,
                                                          const Frame& frame) const {
  const DrawItem* item = item_of(frame.list, anchor.mesh, anchor.revision);
  if (item == nullptr) return std::nullopt;
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k)
    corners.col(k) = room_place_of(*item, anchor.vertices[static_cast<std::size_t>(k)]);
  const Vec3 at = corners * anchor.shares.cast<double>();
  const Vec3 outwards = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
  const double turned = item->shape.A.determinant() < 0 ? -1 : 1;
  if (turned * outwards.dot(frame.camera.pose.p - at) <= 0) return std::nullopt;
  const auto placed = frame.placed(at);
  if (!placed ||
      !(placed->point.x() > (*columns_)[0] + anchor_gap && placed->point.x() < (*columns_)[1] - anchor_gap))
    return std::nullopt;
  const Eigen::Vector2d in_map =
      placed->point.cwiseQuotient(frame.points()).array() * Eigen::Array2d(frame.map.width, frame.map.height);
  if (!frame.is_clearly_of(part, in_map)) return std::nullopt;
  const ItemIdBuffer::Cell& cell = frame.map.at(static_cast<int>(in_map.x()), static_cast<int>(in_map.y()));
  // On a slanted surface, a cell covers a range of depths.
  const double slack =
      near_surface + 2 * placed->depth * (frame.camera.right - frame.camera.left) / frame.map.width;
  return std::abs(placed->depth - 1 / static_cast<double>(cell.nearness)) < slack ? placed : std::nullopt;
}

/// Returns the point deepest inside the visible area of the part. Of several, returns the one nearest to the
/// area's centre.
std::optional<PartLabels::Anchor> PartLabels::choose_anchor(const Seen& seen, const Frame& frame) const {
  const auto is_between = [&](const Eigen::Vector2i& cell) {
    const double x = frame.point_of_cell(cell).x();
    return x > (*columns_)[0] + anchor_gap && x < (*columns_)[1] - anchor_gap;
  };
  Depths depths(seen.cells, is_between);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2i& cell : seen.cells)
    middle += cell.cast<double>() / static_cast<double>(seen.cells.size());
  const Eigen::Vector2i* best = nullptr;
  std::pair<int, double> best_rank{0, 0};
  for (const Eigen::Vector2i& cell : seen.cells)
    if (const std::pair rank(depths.at(cell), -(cell.cast<double>() - middle).squaredNorm());
        rank > best_rank || (best == nullptr && rank.first > 0)) {
      best = &cell;
      best_rank = rank;
    }
  if (best == nullptr) return std::nullopt;
  const ItemIdBuffer::Cell& cell = frame.map.at(best->x(), best->y());
  const DrawItem& item = frame.list.items[static_cast<std::size_t>(cell.item)];
  Anchor out{item.mesh->id, item.mesh->revision, {}, {}};
  const auto& triangle = triangles_of(item)[cell.triangle];
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k) {
    const auto vertex = triangle[static_cast<std::size_t>(k)];
    out.vertices[static_cast<std::size_t>(k)] = vertex;
    corners.col(k) = room_place_of(item, vertex);
  }
  const Vec3 seen_at = frame.room_place(frame.point_of_cell(*best), 1 / static_cast<double>(cell.nearness));
  Eigen::Matrix4d system;  // barycentric coordinates: their weighted sum is the point, their sum is 1
  system << corners, Vec3::Zero(), 1, 1, 1, 0;
  out.shares = system.leftCols<3>().colPivHouseholderQr().solve(seen_at.homogeneous().eval()).cast<float>();
  return out;
}

/// Updates the labels' depth: the median depth of the labelled parts. Small changes are ignored.
void PartLabels::keep_depth(const std::map<std::uint32_t, Seen>& seen, const Frame& frame) {
  std::vector<float> nearness;
  for (const auto& [part, one] : seen)
    for (const Eigen::Vector2i& cell : one.cells)
      nearness.push_back(frame.map.at(cell.x(), cell.y()).nearness);
  if (nearness.empty()) return;
  const auto middle = nearness.begin() + static_cast<std::ptrdiff_t>(nearness.size() / 2);
  std::ranges::nth_element(nearness, middle);
  const double depth = 1 / static_cast<double>(*middle);
  depth_ = std::clamp(depth_.value_or(depth), (1 - depth_slack) * depth, (1 + depth_slack) * depth);
}

/// Restricts the free area to the region that all eyes see at the labels' depth.
void PartLabels::clip_to_all_eyes(Frame& frame) const {
  for (const DrawCamera& eye : frame.list.cameras) {
    if (eye.inset || &eye == &frame.camera) continue;
    const Eigen::Vector2d size = Eigen::Vector2d(eye.width, eye.height) / frame.list.scale;
    Eigen::AlignedBox2d seen;
    // Texts are aligned to whole pixels.
    const Eigen::Vector2d pixel = Eigen::Vector2d::Ones() / frame.list.scale;
    for (const Eigen::Vector2d& corner : {pixel, Eigen::Vector2d(size - pixel)})
      seen.extend(seen_place(frame.camera, frame.list.scale, frame.room_place(eye, corner, *depth_))
                      .head<2>()
                      .eval());
    frame.free = frame.free.intersection(seen);
  }
}

/// Removes crossings of leaders. They end at different depths, so they may cross for another eye; the label
/// with the smaller weight is then omitted.
void PartLabels::drop_crossings(LabelLayout& layout, const Frame& frame,
                                const std::map<std::uint32_t, Seen>& seen) const {
  std::ranges::sort(layout.labels, std::ranges::greater(), &PlacedLabel::weight);
  for (const DrawCamera& eye : frame.list.cameras) {
    if (eye.inset) continue;
    const auto as_seen = [&](PlacedLabel label) {
      const double scale = frame.list.scale;
      label.port = seen_place(eye, scale, frame.room_place(label.port, *depth_)).head<2>();
      label.anchor = seen_place(eye, scale, seen.at(label.id).anchor.at).head<2>();
      return label;
    };
    std::vector<PlacedLabel> kept;
    std::erase_if(layout.labels, [&](const PlacedLabel& label) {
      const PlacedLabel here = as_seen(label);
      if (std::ranges::any_of(kept, [&](const PlacedLabel& one) { return leaders_cross(here, one); }))
        return true;
      kept.push_back(here);
      return false;
    });
  }
}

void PartLabels::draw(DrawList& list, const Frame& frame, const LabelLayout& layout,
                      const std::map<std::uint32_t, Seen>& seen) const {
  const auto add_leaders = [&](const Vec3& color, double width, double dot) {
    for (const PlacedLabel& label : layout.labels) {
      const Vec3& at = seen.at(label.id).anchor.at;
      list.lines.push_back({frame.room_place(label.port, *depth_), at, color, width, false, true});
      list.lines.push_back({at, at, color, dot, false, true});
    }
  };
  add_leaders(casing_color, casing_width, dot_casing);
  add_leaders(leader_color, leader_width, dot_width);
  for (const PlacedLabel& label : layout.labels) {
    const Seen& one = seen.at(label.id);
    const Eigen::Vector2d below(label.box.center().x(), label.box.max().y() - ground_above);
    list.texts.push_back(label_text(one.name, one.wrap));
    list.texts.back().at = frame.room_place(below, *depth_);
  }
}

}  // namespace prosector
