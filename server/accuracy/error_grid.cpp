#include "server/accuracy/error_grid.h"

#include <algorithm>
#include <cmath>

#include "common/error_map.h"

namespace prosector {

ErrorGrid::ErrorGrid(const TetMesh& mesh, std::size_t vertices) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < vertices; ++i) box.extend(mesh.positions[i]);
  empty_.corner = box.min();
  empty_.cell = std::max(box.sizes().maxCoeff() / (max_error_map_side - 1), 1e-9);
  std::size_t values = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(box.sizes()[static_cast<int>(axis)] / empty_.cell - 1e-6);
    empty_.size[axis] = static_cast<std::uint8_t>(std::clamp(cells + 1, 1., double{max_error_map_side}));
    values *= empty_.size[axis];
  }
  sum_.resize(values);
  weight_.resize(values);
  filled_.resize(values);
  for (std::size_t i = 0; i < vertices; ++i) {
    auto& shares = shares_.emplace_back();
    for (std::size_t corner = 0; corner < 8; ++corner) {
      Share share{0, 1};
      std::size_t stride = 1;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double at = (mesh.positions[i] - empty_.corner)[static_cast<int>(axis)] / empty_.cell;
        const double last = empty_.size[axis] - 1;
        const double low = std::clamp(std::floor(at), 0., std::max(0., last - 1));
        const bool upper = (corner >> axis & 1) != 0;
        share.weight *= std::max(0., upper ? at - low : 1 - (at - low));
        share.value += static_cast<std::uint32_t>(
            stride * static_cast<std::size_t>(std::min(low + (upper ? 1 : 0), last)));
        stride *= empty_.size[axis];
      }
      shares[corner] = share;
    }
  }
}

ErrorMap ErrorGrid::map_of(std::span<const double> errors) {
  std::fill(sum_.begin(), sum_.end(), 0);
  std::fill(weight_.begin(), weight_.end(), 0);
  for (std::size_t i = 0; i < shares_.size(); ++i)
    for (const Share& share : shares_[i]) {
      sum_[share.value] += share.weight * errors[i];
      weight_[share.value] += share.weight;
    }
  for (std::size_t k = 0; k < sum_.size(); ++k) sum_[k] = weight_[k] > 0 ? sum_[k] / weight_[k] : 0;
  fill();
  ErrorMap out = empty_;
  out.levels.reserve(sum_.size());
  for (const double error : sum_) out.levels.push_back(level_of(error));
  return out;
}

/// Gives each value without vertices the mean of its neighbours that have a value, until all have one.
void ErrorGrid::fill() {
  const std::array<std::size_t, 3> size = {empty_.size[0], empty_.size[1], empty_.size[2]};
  const std::array<std::size_t, 3> stride = {1, size[0], size[0] * size[1]};
  for (std::size_t pass = 0; pass < 3 * max_error_map_side; ++pass) {
    filled_ = weight_;
    bool all = true;
    for (std::size_t k = 0; k < sum_.size(); ++k) {
      if (weight_[k] > 0) continue;
      double sum = 0, count = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t place = k / stride[axis] % size[axis];
        if (place > 0 && weight_[k - stride[axis]] > 0) sum += sum_[k - stride[axis]], ++count;
        if (place + 1 < size[axis] && weight_[k + stride[axis]] > 0) sum += sum_[k + stride[axis]], ++count;
      }
      if (count == 0) {
        all = false;
        continue;
      }
      sum_[k] = sum / count;
      filled_[k] = 1;
    }
    weight_.swap(filled_);
    if (all) return;
  }
}

}  // namespace prosector
