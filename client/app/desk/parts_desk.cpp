#include "client/app/desk/parts_desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "client/text/utf8.h"

namespace prosector {
namespace {

constexpr double lines_per_notch = 3;
constexpr std::size_t longest_search = 60;  // characters

}  // namespace

bool PartsDesk::take(const WindowEvent& event, const Eigen::Vector2d& pointer) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) return key->down && take_key(*key);
  if (const auto* typed = std::get_if<CharacterTyped>(&event)) {
    const bool own = std::exchange(opened_by_key_, false);
    if (state_.typing && !own) type(typed->character);
    return true;
  }
  if (!open_ || !list_) return false;
  if (std::get_if<MouseMoved>(&event)) follow(pointer);
  if (const auto* button = std::get_if<MouseButtonEvent>(&event)) return take_button(*button, pointer);
  const auto* wheel = std::get_if<WheelTurned>(&event);
  if (wheel == nullptr || !spot_at(*list_, pointer)) return false;
  scroll(-lines_per_notch * wheel->y);
  return true;
}

bool PartsDesk::take_key(const KeyEvent& key) {
  if (key.key == Key::escape) return !key.repeat && take_escape();
  if (state_.typing) return take_typing(key.key);
  if (key.repeat) return false;
  if (key.key == key_of('L')) return toggle_open(), true;
  if (key.key == key_of('N')) return orders_.push_back({.kind = PartsOrder::Kind::labels}), true;
  return false;
}

/// Closes the innermost open element: colour palette, search, list.
bool PartsDesk::take_escape() {
  if (!open_) return false;
  if (state_.palette)
    state_.palette.reset();
  else if (state_.typing || !state_.search.empty())
    state_.search.clear(), state_.typing = false;
  else
    toggle_open();
  return true;
}

/// Handles a key while the search is typed: consumes all but F1, F11 and Tab.
bool PartsDesk::take_typing(Key key) {
  if (key == Key::enter) state_.typing = false;
  if (key == Key::up) scroll(-1);
  if (key == Key::down) scroll(1);
  if (key == Key::backspace && !state_.search.empty()) {
    std::u32string characters = characters_of(state_.search);
    characters.pop_back();
    state_.search = utf8_of(characters);
    state_.first = 0;
  }
  return key != Key::f1 && key != Key::f11 && key != Key::tab;
}

void PartsDesk::type(char32_t character) {
  if (characters_of(state_.search).size() >= longest_search) return;
  state_.search += utf8_of(std::u32string(1, character));
  state_.first = 0;
}

/// Opens the list ready to type a search, or closes it; the search text is preserved.
void PartsDesk::toggle_open() {
  open_ = !open_;
  state_.typing = opened_by_key_ = open_;
  state_.hovered.reset();
  state_.palette.reset();
  slides_.reset();
  list_.reset();
}

void PartsDesk::toggle_without_search() {
  toggle_open();
  state_.typing = opened_by_key_ = false;
}

void PartsDesk::lay_out(std::vector<PartRow> rows, std::optional<BodyId> pointed,
                        const Eigen::Vector2d& picture) {
  opened_by_key_ = false;
  if (!open_) return;
  const bool is_new = pointed && pointed != state_.pointed;
  state_.pointed = pointed;
  if (slides_ && *slides_ >= rows.size()) slides_.reset();
  list_ = lay_out_parts(std::move(rows), state_, picture);
  const auto at_pointed = [&](const PartRow& row) {
    return std::ranges::find(row.bodies, *pointed) != row.bodies.end();
  };
  if (is_new && !state_.hovered)
    if (const auto row = std::ranges::find_if(list_->rows, at_pointed); row != list_->rows.end())
      scroll_to(list_->state, *list_, static_cast<std::size_t>(row - list_->rows.begin()));
  state_.first = list_->state.first;
}

bool PartsDesk::take_button(const MouseButtonEvent& button, const Eigen::Vector2d& pointer) {
  if (button.button == MouseButton::right) return false;
  if (!button.down) {
    slides_.reset();
    return button.button == MouseButton::left && std::exchange(presses_, false);
  }
  const auto spot = spot_at(*list_, pointer);
  state_.typing = spot && spot->kind == PartsSpot::Kind::search;
  if (!spot) return false;
  if (button.button == MouseButton::left) presses_ = true, press(*spot, pointer);
  return true;
}

void PartsDesk::press(const PartsSpot& spot, const Eigen::Vector2d& pointer) {
  using Kind = PartsSpot::Kind;
  if (spot.kind == Kind::reset) orders_.push_back({.kind = PartsOrder::Kind::reset_all});
  if (spot.kind < Kind::name) return;
  const PartRow& row = list_->rows[spot.row];
  if (spot.kind == Kind::name) framed_.insert(framed_.end(), row.bodies.begin(), row.bodies.end());
  if (spot.kind == Kind::eye) order(row.look.hidden ? PartsOrder::Kind::show : PartsOrder::Kind::hide, row);
  if (spot.kind == Kind::isolate) order(PartsOrder::Kind::isolate_next, row);
  if (spot.kind == Kind::slider) slides_ = spot.row, slide(pointer);
  if (spot.kind == Kind::swatch)
    state_.palette = state_.palette == row.text ? std::nullopt : std::optional(row.text);
  if (spot.kind == Kind::color) {
    const auto colors = part_colors();
    order(PartsOrder::Kind::color, row);
    if (spot.color < colors.size()) orders_.back().color = colors[spot.color].color;
    state_.palette.reset();
  }
}

void PartsDesk::order(PartsOrder::Kind kind, const PartRow& row) {
  orders_.push_back({.kind = kind, .parts = row.parts});
}

void PartsDesk::follow(const Eigen::Vector2d& pointer) {
  state_.hovered = spot_at(*list_, pointer);
  if (slides_) slide(pointer);
}

void PartsDesk::slide(const Eigen::Vector2d& pointer) {
  if (*slides_ >= list_->rows.size()) return;
  order(PartsOrder::Kind::opacity, list_->rows[*slides_]);
  orders_.back().opacity = slider_opacity(*list_, pointer);
}

void PartsDesk::scroll(double lines) {
  const double most = static_cast<double>(list_ ? list_->all_lines : 0);
  state_.first =
      static_cast<std::size_t>(std::clamp(static_cast<double>(state_.first) + std::round(lines), 0.0, most));
}

std::vector<BodyId> PartsDesk::hovered_bodies() const {
  if (shown() == nullptr || !state_.hovered || state_.hovered->kind < PartsSpot::Kind::name) return {};
  return state_.hovered->row < list_->rows.size() ? list_->rows[state_.hovered->row].bodies
                                                  : std::vector<BodyId>();
}

std::vector<PartsOrder> PartsDesk::take_orders() {
  return std::exchange(orders_, {});
}

std::vector<BodyId> PartsDesk::take_framed() {
  return std::exchange(framed_, {});
}

}  // namespace prosector
