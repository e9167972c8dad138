#include "client/app/desk/desk_panel.h"

namespace prosector {
namespace {

constexpr std::chrono::seconds request_interval{1};
constexpr double farthest_drag = 4;                     // m from the eye
constexpr std::chrono::milliseconds send_interval{40};  // the server accepts at most 50 commands a second
constexpr std::chrono::seconds placing_timeout{1};      // until the server reports the released pose
constexpr double arrived = 1e-5;                        // m

}  // namespace

bool is_panel_head(const PanelPoint& point) {
  return !point.control && point.at.y() > panel_head_bottom;
}

std::optional<double> DeskPanel::accuracy_at(const Ray& pointer) const {
  if (!shown_ || !effort_ || (effort_->prices.empty() && !effort_->may_ask)) return std::nullopt;
  const std::vector<Price>& prices = effort_->prices;
  const auto cell = picked_price_cell(pointer, *shown_, prices.size());
  if (!cell) return std::nullopt;
  return prices.empty() ? 0 : accuracy_of(prices[*cell]);
}

double DeskPanel::bottom() const {
  if (!effort_) return -panel_height / 2;
  const bool has_prices = effort_->may_ask || !effort_->prices.empty();
  return has_prices ? price_strip_y - price_strip_height / 2 : strip_y - strip_height / 2;
}

bool DeskPanel::follow(const std::optional<Panel>& panel, const std::optional<ShownEffort>& effort,
                       std::size_t hidden_lines) {
  const bool is_new = panel && (!shown_ || shown_->body != panel->body);
  if (is_new || !panel) {
    place_.reset();
    held_.reset();
    unsent_placing_.reset();
  } else if (place_ && !held_ && !unsent_placing_) {
    const bool is_there = (panel->pose.p - place_->p).norm() < arrived;
    if (is_there || std::chrono::steady_clock::now() - release_time_ > placing_timeout) place_.reset();
  }
  scroll_.follow(panel, hidden_lines);
  shown_ = panel;
  effort_ = effort;
  if (!panel) return false;
  if (place_) shown_->pose.p = place_->p;
  return is_new;
}

void DeskPanel::take_hold(const Ray& pointer, const PanelPoint& at, const Vec3& back) {
  const Vec3 held = pointer.from + at.distance * pointer.along;
  held_ = Hold{held, back, shown_->pose.p - held};
}

void DeskPanel::drag(const Ray& pointer) {
  if (!held_ || !shown_) return;
  const double distance = (held_->at - pointer.from).dot(held_->back) / pointer.along.dot(held_->back);
  if (!(distance > 0 && distance < farthest_drag)) return;
  shown_->pose.p = pointer.from + distance * pointer.along + held_->from_middle;
  place_ = shown_->pose;
  unsent_placing_ = PanelPlacement::put;
}

void DeskPanel::let_go() {
  if (held_) release_time_ = std::chrono::steady_clock::now();
  held_.reset();
}

void DeskPanel::put_back() {
  held_.reset();
  place_.reset();
  unsent_placing_ = PanelPlacement::put_back;
}

std::optional<CommandBody> DeskPanel::take_placing() {
  const auto now = std::chrono::steady_clock::now();
  if (!unsent_placing_ || !shown_ || now - last_sent_ < send_interval) return std::nullopt;
  last_sent_ = now;
  OpenPanel out{shown_->body, *unsent_placing_};
  if (*unsent_placing_ == PanelPlacement::put) out.at = shown_->pose.p;
  unsent_placing_.reset();
  return out;
}

bool DeskPanel::should_keep_open(const Ray& pointer) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_request_ < request_interval || !covers(pointer)) return false;
  last_request_ = now;
  return true;
}

}  // namespace prosector
