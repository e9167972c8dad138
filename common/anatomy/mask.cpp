#include "common/anatomy/mask.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "common/error.h"

namespace prosector {
namespace {

using Index = std::array<std::int64_t, 3>;

std::size_t number(const Volume& v, const Index& i) {
  return static_cast<std::size_t>(i[0] + v.dims[0] * (i[1] + v.dims[1] * i[2]));
}

Vec3 as_vector(const Index& i) {
  return {static_cast<double>(i[0]), static_cast<double>(i[1]), static_cast<double>(i[2])};
}

// Crops the volume to the box of the inside voxels, with a margin of zeros.
template <class Inside>
bool crop(const Volume& whole, int margin, Inside&& inside, Mask& out) {
  Index low = whole.dims, high = {-1, -1, -1}, i;
  std::size_t n = 0;
  for (i[2] = 0; i[2] < whole.dims[2]; ++i[2])
    for (i[1] = 0; i[1] < whole.dims[1]; ++i[1])
      for (i[0] = 0; i[0] < whole.dims[0]; ++i[0])
        if (inside(whole.values[n++]))
          for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], i[k]);
            high[k] = std::max(high[k], i[k]);
          }
  if (high[0] < 0) return false;
  out.volume.voxel_size = whole.voxel_size;
  std::size_t size = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    out.volume.dims[k] = high[k] - low[k] + 1 + 2 * margin;
    size *= static_cast<std::size_t>(out.volume.dims[k]);
  }
  out.volume.values.assign(size, 0.f);
  out.origin = whole.position(0.5 * (as_vector(low) + as_vector(high)));
  for (i[2] = low[2]; i[2] <= high[2]; ++i[2])
    for (i[1] = low[1]; i[1] <= high[1]; ++i[1])
      for (i[0] = low[0]; i[0] <= high[0]; ++i[0])
        if (inside(whole.at(i[0], i[1], i[2])))
          out.volume.values[number(
              out.volume, {i[0] - low[0] + margin, i[1] - low[1] + margin, i[2] - low[2] + margin})] = 1;
  return true;
}

/// A run of voxels of equal value along x.
struct Run {
  std::int64_t first, end;  // x
  std::size_t at;           // index of the first voxel
  bool inside;
  std::uint32_t piece;  // union-find parent: face-connected runs share the root
};

// Labels connected components, inside and outside, by runs, which are far fewer than voxels.
std::vector<Run> find_pieces(const Volume& v) {
  std::vector<Run> runs;
  const auto find = [&](std::uint32_t i) {
    while (runs[i].piece != i) i = runs[i].piece = runs[runs[i].piece].piece;
    return i;
  };
  std::vector<std::uint32_t> row_start;  // index of the first run of each row, and the end
  const auto join_rows = [&](std::size_t row, std::size_t other) {
    std::uint32_t a = row_start[row], b = row_start[other];
    const auto a_end = static_cast<std::uint32_t>(runs.size());
    const std::uint32_t b_end = row_start[other + 1];
    while (a < a_end && b < b_end) {
      const bool overlap = runs[a].first < runs[b].end && runs[b].first < runs[a].end;
      if (overlap && runs[a].inside == runs[b].inside) runs[find(a)].piece = find(b);
      (runs[a].end < runs[b].end ? a : b) += 1;
    }
  };
  const auto ny = static_cast<std::size_t>(v.dims[1]);
  std::size_t at = 0, row = 0;
  for (std::int64_t k = 0; k < v.dims[2]; ++k)
    for (std::int64_t j = 0; j < v.dims[1]; ++j, ++row) {
      row_start.push_back(static_cast<std::uint32_t>(runs.size()));
      for (std::int64_t i = 0; i < v.dims[0]; ++i, ++at) {
        const bool inside = v.values[at] != 0;
        if (i == 0 || runs.back().inside != inside)
          runs.push_back({i, i + 1, at, inside, static_cast<std::uint32_t>(runs.size())});
        else
          runs.back().end = i + 1;
      }
      if (j > 0) join_rows(row, row - 1);
      if (k > 0) join_rows(row, row - ny);
    }
  for (std::uint32_t n = 0; n < runs.size(); ++n) runs[n].piece = find(n);
  return runs;
}

void fill(Volume& v, const Run& run, float value) {
  std::fill_n(v.values.begin() + static_cast<std::ptrdiff_t>(run.at), run.end - run.first, value);
}

// Keeps the largest piece and fills cavities that aren't connected to the outside: they are noise, not
// anatomy.
void keep_largest_component(Mask& mask) {
  Volume& v = mask.volume;
  const auto runs = find_pieces(v);
  std::vector<std::size_t> size(runs.size());
  std::size_t total = 0, best = 0;
  for (const Run& run : runs) {
    if (!run.inside) continue;
    const auto length = static_cast<std::size_t>(run.end - run.first);
    size[run.piece] += length;
    total += length;
  }
  for (std::size_t n = 0; n < size.size(); ++n) {
    if (size[n] > 0) ++mask.dropped_pieces;
    if (size[n] > size[best]) best = n;
  }
  --mask.dropped_pieces;  // all but the largest
  mask.dropped_voxels = total - size[best];
  for (const Run& run : runs)
    if (run.inside && run.piece != best) fill(v, run, 0);
  if (v.values.front() != 0) return;  // no border: the outside is unknown
  const auto cleaned = find_pieces(v);
  for (const Run& run : cleaned)
    if (!run.inside && run.piece != cleaned.front().piece) {
      fill(v, run, 1);
      mask.filled_voxels += static_cast<std::size_t>(run.end - run.first);
    }
}

void blur_axis(Volume& v, std::size_t axis, const std::vector<float>& kernel) {
  const auto radius = static_cast<std::int64_t>(kernel.size() / 2);
  const std::int64_t stride = axis == 0 ? 1 : axis == 1 ? v.dims[0] : v.dims[0] * v.dims[1];
  const std::int64_t length = v.dims[axis];
  std::vector<float> line(static_cast<std::size_t>(length + 2 * radius), 0.f);
  const std::size_t u = (axis + 1) % 3, w = (axis + 2) % 3;
  Index i{};
  for (i[w] = 0; i[w] < v.dims[w]; ++i[w])
    for (i[u] = 0; i[u] < v.dims[u]; ++i[u]) {
      i[axis] = 0;
      float* first = v.values.data() + number(v, i);
      bool any = false;
      for (std::int64_t k = 0; k < length; ++k) {
        const float value = first[k * stride];
        line[static_cast<std::size_t>(k + radius)] = value;
        any = any || value != 0;
      }
      if (!any) continue;
      for (std::int64_t k = 0; k < length; ++k) {
        float sum = 0;
        for (std::size_t m = 0; m < kernel.size(); ++m)
          sum += kernel[m] * line[static_cast<std::size_t>(k) + m];
        first[k * stride] = sum;
      }
    }
}

// A Gaussian shrinks convex shapes (by about σ²/r). Returns the level that keeps the number of inside voxels.
double volume_preserving_level(const Volume& smoothed, const Volume& mask) {
  constexpr float least = 0.02f;  // values below it are outside; omitting them speeds up the sorting
  std::vector<float> values;
  for (const float v : smoothed.values)
    if (v > least) values.push_back(v);
  const auto inside = static_cast<std::size_t>(std::count(mask.values.begin(), mask.values.end(), 1.f));
  if (inside >= values.size()) return 0.5;
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(inside);
  std::nth_element(values.begin(), nth, values.end(), std::greater<>());
  return std::clamp(static_cast<double>(*nth), 0.1, 0.9);
}

/// Returns the labels of a volume as text in ascending order; consecutive labels are given as "first to
/// last".
std::string labels_text(const Volume& volume) {
  constexpr int max_label = 65535;
  std::vector<bool> present(max_label + 2);
  bool grey = false;
  for (const float v : volume.values) {
    if (v > 0 && v <= static_cast<float>(max_label) && v == std::floor(v))
      present[static_cast<std::size_t>(v)] = true;
    else
      grey = grey || v != 0;
  }
  std::vector<std::string> ranges;
  for (std::size_t label = 1; label <= max_label; ++label) {
    if (!present[label]) continue;
    const std::size_t first = label;
    while (present[label + 1]) ++label;
    ranges.push_back(first == label ? fmt::format("{}", first) : fmt::format("{} to {}", first, label));
  }
  constexpr std::size_t shown = 32;
  const std::size_t more = ranges.size() - std::min(ranges.size(), shown);
  ranges.resize(ranges.size() - more);
  return fmt::format("{}{}{}", fmt::join(ranges, ", "),
                     more > 0 ? fmt::format(", and {} more ranges", more) : std::string(),
                     grey || more > 0 ? " (a grey volume? use threshold)" : "");
}

}  // namespace

Mask mask_of_label(const Volume& volume, int label, int margin, const std::string& name) {
  Mask out;
  const auto wanted = static_cast<float>(label);
  if (!crop(
          volume, margin, [&](float v) { return v == wanted; }, out)) {
    throw InputError(
        fmt::format("{}: label {} does not occur; allowed: {}", name, label, labels_text(volume)));
  }
  keep_largest_component(out);
  return out;
}

Mask mask_above(const Volume& volume, double threshold, int margin, const std::string& name) {
  Mask out;
  const auto [low, high] = std::minmax_element(volume.values.begin(), volume.values.end());
  const auto inside = [&](float v) { return static_cast<double>(v) > threshold; };
  if (inside(*low) || !crop(volume, margin, inside, out))
    throw InputError(fmt::format("{}: threshold {} leaves {}; allowed: from {} to below {}", name, threshold,
                                 inside(*low) ? "everything inside" : "nothing inside", *low, *high));
  keep_largest_component(out);
  return out;
}

double Mask::inside_volume() const {
  const auto inside = std::count(volume.values.begin(), volume.values.end(), 1.f);
  return static_cast<double>(inside) * volume.voxel_size.prod();
}

int smoothing_margin(double sigma) {
  return static_cast<int>(std::ceil(3 * std::max(sigma, 0.0))) + 2;
}

SolidField smooth_solid(const Mask& mask, double sigma) {
  auto volume = std::make_shared<Volume>(mask.volume);
  if (sigma > 0) {
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    std::vector<float> kernel;
    double sum = 0;
    for (int k = -radius; k <= radius; ++k) sum += std::exp(-0.5 * k * k / (sigma * sigma));
    for (int k = -radius; k <= radius; ++k)
      kernel.push_back(static_cast<float>(std::exp(-0.5 * k * k / (sigma * sigma)) / sum));
    for (std::size_t axis = 0; axis < 3; ++axis) blur_axis(*volume, axis, kernel);
  }
  const double level = volume_preserving_level(*volume, mask.volume);
  const Vec3 origin = mask.origin;
  const Vec3 corner = volume->position(Vec3::Zero());
  return {[volume, origin, level](const Vec3& x) { return level - sample(*volume, x - origin); },
          {origin + corner, origin - corner}};
}

}  // namespace prosector
