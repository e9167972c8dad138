#include "client/app/terminal/parts_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "client/app/terminal/split_line.h"

namespace prosector {
namespace {

using Kind = PartsOrder::Kind;
using Parsed = std::variant<PartsOrder, std::string>;

/// Removes a percentage from the end of the text and returns it as a fraction: "left kidney 40 %", "left
/// kidney 40%".
std::optional<double> take_percentage(std::string& text) {
  if (text.empty() || text.back() != '%') return std::nullopt;
  const auto [before, number] = split_last(trimmed(text.substr(0, text.size() - 1)));
  const std::string& digits = number.empty() ? before : number;
  double percent = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), percent);
  if (error != std::errc() || end != digits.data() + digits.size() || !(percent >= 0 && percent <= 100))
    return std::nullopt;
  text = number.empty() ? "" : before;
  return percent / 100;
}

Parsed order_for(Kind kind, const std::string& name, const PartsData& known) {
  PartsOrder order{.kind = kind, .parts = parts_called(known, name)};
  if (order.parts.empty()) return fmt::format("no part is called \"{}\"; list them with `parts`", name);
  return order;
}

Parsed isolate(std::string rest, const PartsData& known) {
  if (rest.empty()) return PartsOrder{.kind = Kind::isolate};
  const std::optional<double> others = take_percentage(rest);
  Parsed out = order_for(Kind::isolate, rest, known);
  if (PartsOrder* order = std::get_if<PartsOrder>(&out)) order->opacity = others.value_or(0);
  return out;
}

Parsed opacity(std::string rest, const PartsData& known) {
  const std::optional<double> share = take_percentage(rest);
  if (!share || *share < least_opacity || rest.empty())
    return fmt::format("opacity PART PERCENT %: {:.0f} to 100", 100 * least_opacity);
  Parsed out = order_for(Kind::opacity, rest, known);
  if (PartsOrder* order = std::get_if<PartsOrder>(&out)) order->opacity = *share;
  return out;
}

/// Removes a colour from the end of the text and returns it. Outer nullopt: there is none; inner nullopt: the
/// part's own colour.
std::optional<std::optional<Vec3>> take_color(std::string& text) {
  const auto ends = [&](std::string_view word) {
    if (!text.ends_with(word) || text.size() <= word.size() || text[text.size() - word.size() - 1] != ' ')
      return false;
    text = trimmed(text.substr(0, text.size() - word.size()));
    return true;
  };
  for (const NamedColor& color : part_colors())
    if (ends(color.name)) return std::optional(color.color);
  if (ends("own")) return std::optional<Vec3>();
  return std::nullopt;
}

Parsed color(std::string rest, const PartsData& known) {
  const auto chosen = take_color(rest);
  if (!chosen) {
    std::string names;
    for (const NamedColor& one : part_colors()) names += std::string(one.name) + ", ";
    return "colour PART COLOUR: " + names + "or own";
  }
  Parsed out = order_for(Kind::color, rest, known);
  if (PartsOrder* order = std::get_if<PartsOrder>(&out)) order->color = *chosen;
  return out;
}

}  // namespace

std::optional<Parsed> parse_parts_line(const std::string& line, const PartsData& known,
                                       const PartsChoice& choice) {
  const auto [verb, rest] = split_first(line);
  if (verb == "parts") return rows_as_text(part_rows(known, choice, rest));
  if (verb == "labels" && rest.empty()) return PartsOrder{.kind = Kind::labels};
  if (verb == "show" && rest == "all") return PartsOrder{.kind = Kind::reset_all};
  if (verb == "show" || verb == "hide") {
    if (rest.empty()) return fmt::format("{} PART: give a part", verb);
    return order_for(verb == "show" ? Kind::show : Kind::hide, rest, known);
  }
  if (verb == "isolate") return isolate(rest, known);
  if (verb == "opacity") return opacity(rest, known);
  if (verb == "colour" || verb == "color") return color(rest, known);
  return std::nullopt;
}

}  // namespace prosector
