#pragma once
// The strip below a panel's effort strip: the available model configurations of its part as a curve of error
// against cost. One cell per configuration, the cheapest on the left. Operated by the host's pointer; fingers
// pass through. In the panel's frame (common/panel.h), m.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "client/view/effort_strip.h"
#include "common/error_estimate.h"
#include "common/math.h"
#include "common/part_messages.h"

namespace prosector {

inline constexpr double price_strip_height = 0.056;
inline constexpr double price_strip_y = strip_y - strip_height / 2 - strip_gap - price_strip_height / 2;

/// Returns the centre of a cell of the price strip in the panel's frame, m. `cell` is its index from the
/// left, `cells` the number of cells.
inline Vec3 price_cell_centre(std::size_t cell, std::size_t cells) {
  const double share = (static_cast<double>(cell) + 0.5) / static_cast<double>(cells) - 0.5;
  return {share * (panel_width - 2 * panel_margin), price_strip_y, 0};
}
/// Returns the curve of error against cost that the price strip shows: for each model configuration a point
/// in the panel's frame, m. Heights are proportional to the logarithm of the error.
std::vector<Vec3> price_curve(const std::vector<Price>& prices);
/// Returns the index of the price strip's cell that the ray meets, given the number of cells; nullopt if the
/// ray misses the strip.
std::optional<std::size_t> picked_price_cell(const Ray& ray, const Panel& panel, std::size_t cells);
/// Returns the text of a model configuration's cell on the price strip: its error, and below it its cost.
std::string in_words(const Price& price);

/// Returns the accuracy (permitted error, %) to request from the server so that it chooses this model
/// configuration. It is rounded up slightly, so that the configuration meets it.
double accuracy_of(const Price& price);

inline constexpr const char* price_question = msg("list available accuracies and costs");

}  // namespace prosector
