#pragma once
// The strip below a panel's effort strip: what its part can have at what price, as a curve with one cell a
// way of modelling it, the cheapest left. The host's pointer chooses; fingers pass it. In the panel's frame
// (common/panel.h), m.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "client/view/effort_strip.h"
#include "common/messages.h"

namespace prosector {

inline constexpr double price_strip_height = 0.056;
inline constexpr double price_strip_y = strip_y - strip_height / 2 - strip_gap - price_strip_height / 2;

/// Returns the middle of a cell, of so many.
inline Vec3 price_cell(std::size_t cell, std::size_t cells) {
  const double share = (static_cast<double>(cell) + 0.5) / static_cast<double>(cells) - 0.5;
  return {share * (panel_width - 2 * panel_margin), price_strip_y, 0};
}
/// Returns a place of the curve for each price: as high as its error, in its logarithm.
std::vector<Vec3> price_curve(const std::vector<Price>& prices);
/// Returns the cell that a ray meets, of so many; nullopt: it meets no strip.
std::optional<std::size_t> meet_price(const Ray& ray, const Panel& panel, std::size_t cells);
/// Returns what a cell says: error, and cost below it.
std::string in_words(const Price& price);

/// Returns what to ask for so that a choice meets this price again, %.
double accuracy_of(const Price& price);

inline constexpr const char* price_question = msg("what can it have, at what price?");

}  // namespace prosector
