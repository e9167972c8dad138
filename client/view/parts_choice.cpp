#include "client/view/parts_choice.h"

#include <algorithm>

#include "client/language/catalogue.h"

namespace prosector {

std::vector<NamedColor> part_colors() {
  return {{msg("orange"), {0.791, 0.347, 0.000}}, {msg("sky blue"), {0.093, 0.456, 0.815}},
          {msg("green"), {0.000, 0.342, 0.171}},  {msg("yellow"), {0.871, 0.768, 0.054}},
          {msg("blue"), {0.000, 0.168, 0.445}},   {msg("red"), {0.665, 0.112, 0.000}},
          {msg("pink"), {0.604, 0.191, 0.386}},   {msg("grey"), {0.503, 0.503, 0.503}}};
}

void PartsChoice::obey(const PartsOrder& order) {
  using Kind = PartsOrder::Kind;
  if (order.kind == Kind::labels) labels_ = !labels_;
  if (order.kind == Kind::reset_all) {
    looks_.clear();
    isolated_.clear();
  }
  if (order.kind == Kind::isolate) isolate(order.parts, order.opacity);
  if (order.kind == Kind::isolate_next) {
    const bool same = isolated_ == std::set(order.parts.begin(), order.parts.end());
    if (same && others_ <= 0)
      isolate({}, 0);
    else
      isolate(order.parts, same ? 0 : faint_opacity);
  }
  if (order.kind == Kind::show || order.kind == Kind::hide || order.kind == Kind::opacity ||
      order.kind == Kind::color)
    for (const std::string& part : order.parts) change(part, order);
}

void PartsChoice::isolate(const std::vector<std::string>& parts, double others) {
  isolated_ = {parts.begin(), parts.end()};
  others_ = std::clamp(others, 0.0, 1.0);
  for (const std::string& part : parts) change(part, {.kind = PartsOrder::Kind::show});
}

void PartsChoice::change(const std::string& part, const PartsOrder& order) {
  using Kind = PartsOrder::Kind;
  PartLook look = own_look(part);
  if (order.kind == Kind::show || order.kind == Kind::hide) look.hidden = order.kind == Kind::hide;
  if (order.kind == Kind::opacity) look.opacity = std::clamp(order.opacity, least_opacity, 1.0);
  if (order.kind == Kind::color) look.color = order.color;
  if (look == PartLook())
    looks_.erase(part);
  else
    looks_[part] = look;
}

PartLook PartsChoice::own_look(const std::string& part) const {
  const auto found = looks_.find(part);
  return found == looks_.end() ? PartLook() : found->second;
}

PartLook PartsChoice::look_of(const std::string& part, bool in_anatomy) const {
  PartLook look = own_look(part);
  if (!isolates() || !in_anatomy || is_isolated(part)) return look;
  look.hidden = look.hidden || others_ <= 0;
  look.opacity = std::min(look.opacity, others_);
  return look;
}

}  // namespace prosector
