#include "client/view/price_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/percent_text.h"

namespace prosector {
namespace {

constexpr double curve_y = price_strip_y + 0.014, curve_height = 0.018;  // centre; total height
constexpr double rounding_up = 1.001;

}  // namespace

std::vector<Vec3> price_curve(const std::vector<Price>& prices) {
  std::vector<Vec3> out;
  if (prices.empty()) return out;
  const auto height = [](const Price& price) { return std::log(std::max(1e-6, price.error)); };
  const auto [least, most] = std::ranges::minmax(prices, {}, height);
  const double low = height(least), range = std::max(1e-9, height(most) - low);
  for (std::size_t k = 0; k < prices.size(); ++k) {
    Vec3 at = price_cell_centre(k, prices.size());
    at.y() = curve_y + curve_height * ((height(prices[k]) - low) / range - 0.5);
    out.push_back(at);
  }
  return out;
}

std::optional<std::size_t> picked_price_cell(const Ray& ray, const Panel& panel, std::size_t cells) {
  const auto at = intersect_panel_plane(ray, panel);
  if (!at || std::abs(at->x()) > panel_width / 2 ||
      std::abs(at->y() - price_strip_y) > price_strip_height / 2)
    return std::nullopt;
  const double share = std::clamp(at->x() / (panel_width - 2 * panel_margin) + 0.5, 0., 1 - 1e-9);
  return static_cast<std::size_t>(share * static_cast<double>(std::max<std::size_t>(1, cells)));
}

std::string in_words(const Price& price) {
  return fmt::format("{}\n{:.2g} ms", percent_text(price.error), price.ms);
}

double accuracy_of(const Price& price) {
  return std::clamp(100 * price.error * rounding_up, min_accuracy, max_accuracy);
}

}  // namespace prosector
