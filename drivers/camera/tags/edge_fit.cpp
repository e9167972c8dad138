#include "drivers/camera/tags/edge_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace prosector {
namespace {

constexpr int rounds = 4;
constexpr double least_cell = 2.2;                 // pixels; with smaller cells, edges blur into each other
constexpr double half_of_cell = 0.5;               // half width of the profile across an edge, in cells …
constexpr double least_half = 1.0, most_half = 4;  // … limited to this range in pixels
constexpr double most_spacing_across = 0.5,
                 spacing_along = 1;   // pixels, spacing of samples across and along an edge
constexpr double end_share = 0.08;    // share of an edge left out at each end, near the adjacent edges
constexpr int level_window = 6;       // number of crossings on each side that share dark and bright levels
constexpr double least_contrast = 4;  // multiple of the noise around an edge
constexpr double least_share = 0.1;   // share of the contrast that the strongest tenth of the samples exceed
constexpr double noise_slack = 3;  // standard deviations of noise by which brightness may exceed its levels
constexpr double most_off = 0.7;   // share of the half width; an edge with a larger offset is rejected
constexpr double level_slack = 0.35;  // share of the contrast that brightness may always exceed its levels by
constexpr int least_samples = 12;
constexpr double huber = 1.345;  // multiple of the residuals' robust standard deviation

using Row6 = Eigen::Matrix<double, 1, 6>;

/// A measured position on an edge.
struct Sample {
  double off;       // pixels along the normal, from the predicted position
  double contrast;  // in linear light, 0 to 255
  Row6 slope;       // derivative of the predicted position with respect to the pose
};

/// Light on both sides of an edge.
struct Levels {
  double dark = 0, bright = 0;
  double noise = 0;  // standard deviation
};

/// Linear light (0 to 255) for each grey value.
using LightTable = std::array<float, 256>;

LightTable light_table(double response) {
  LightTable out{};
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<float>(255 * std::pow(static_cast<double>(i) / 255, response));
  return out;
}

double light_at(const GreyImage& image, const LightTable& light, const Vec2& at) {
  const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
  const double a = at.x() - x, b = at.y() - y;
  const auto pixel = [&](int i, int j) {
    return static_cast<double>(
        light[image.grey[static_cast<std::size_t>(j) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(i)]]);
  };
  return (1 - b) * ((1 - a) * pixel(x, y) + a * pixel(x + 1, y)) +
         b * ((1 - a) * pixel(x, y + 1) + a * pixel(x + 1, y + 1));
}

bool is_inside(const GreyImage& image, const Vec2& at, double margin) {
  return at.x() >= margin && at.y() >= margin && at.x() < image.width - 1 - margin &&
         at.y() < image.height - 1 - margin;
}

/// Profile of light across an edge at one point along it.
struct EdgeProfile {
  Row6 slope;  // derivative of the predicted position along the normal with respect to the pose
  std::vector<double> bright;
};

class EdgeReader {
 public:
  EdgeReader(const GreyImage& image, const Lens& lens, double response)
      : image_(image), lens_(lens), light_(light_table(response)) {}

  /// Samples the edge between two adjacent corners, with the tag on the left. `opposite` is the corner after
  /// `to`. Corners are in the camera's frame.
  void read(const Vec3& from, const Vec3& to, const Vec3& opposite, std::vector<Sample>& out) const {
    if (from.z() <= 0 || to.z() <= 0 || opposite.z() <= 0) return;
    const Vec2 a = lens_.project(from), b = lens_.project(to), c = lens_.project(opposite);
    // An obliquely viewed tag has narrower cells across the edge than along it.
    const double length = (b - a).norm(),
                 across = std::abs((b - a).dot(Vec2(c.y() - b.y(), b.x() - c.x()))) / length;
    const double cell = std::min(length, across) / black_cells;
    if (cell < least_cell) return;
    const double half = std::clamp(half_of_cell * cell, least_half, most_half);
    const std::vector<EdgeProfile> crossings = crossings_of(from, to, length, half);
    const auto count = static_cast<int>(crossings.size());
    for (int k = 0; k < count; ++k) {
      const EdgeProfile& here = crossings[static_cast<std::size_t>(k)];
      if (here.bright.empty()) continue;
      const Levels levels = levels_at(crossings, k);
      if (const auto off = place(here.bright, levels, half))
        out.push_back({*off, levels.bright - levels.dark, here.slope});
    }
  }

 private:
  std::vector<EdgeProfile> crossings_of(const Vec3& from, const Vec3& to, double length, double half) const {
    std::vector<EdgeProfile> out;
    const int count = std::max(3, static_cast<int>(length * (1 - 2 * end_share) / spacing_along));
    const int steps =
        static_cast<int>(std::ceil(2 * half / most_spacing_across));  // same number of steps on both sides
    for (int k = 0; k < count; ++k) {
      // Even steps on the edge aren't even in the image; each point is on the edge, which is all that
      // matters.
      const Vec3 point = from + (end_share + (1 - 2 * end_share) * (k + 0.5) / count) * (to - from);
      const Eigen::Matrix<double, 2, 3> slope = lens_.projection_jacobian(point);
      const Vec2 along = (slope * (to - from)).normalized(), outward(-along.y(), along.x());
      EdgeProfile crossing{outward.transpose() * slope * point_jacobian(point), {}};
      const Vec2 at = lens_.project(point);
      if (is_inside(image_, at, half + 1))
        for (int i = 0; i <= steps; ++i)
          crossing.bright.push_back(light_at(image_, light_, at + half * (2.0 * i / steps - 1) * outward));
      out.push_back(std::move(crossing));
    }
    return out;
  }

  /// Returns the levels around crossing k, which must be inside the image.
  static Levels levels_at(const std::vector<EdgeProfile>& crossings, int k) {
    Levels out;
    const std::vector<double>* before = nullptr;
    double squares = 0;
    int levels = 0, pairs = 0;
    for (int j = std::max(0, k - level_window);
         j <= std::min(static_cast<int>(crossings.size()) - 1, k + level_window); ++j) {
      const std::vector<double>& values = crossings[static_cast<std::size_t>(j)].bright;
      if (values.empty()) continue;
      out.dark += values.front();
      out.bright += values.back();
      ++levels;
      if (before != nullptr) {
        squares +=
            std::pow(values.front() - before->front(), 2) + std::pow(values.back() - before->back(), 2);
        ++pairs;
      }
      before = &values;
    }
    out.dark /= levels;
    out.bright /= levels;
    if (pairs > 0)
      out.noise = std::sqrt(squares / (4 * pairs));  // a difference contains the noise of two values
    return out;
  }

  /// Returns the edge's offset in one profile, or nothing if there is no edge.
  static std::optional<double> place(const std::vector<double>& values, const Levels& levels, double half) {
    const double contrast = levels.bright - levels.dark;
    if (contrast <= least_contrast * levels.noise || contrast <= 0) return std::nullopt;
    const double slack = std::max(level_slack, noise_slack * levels.noise / contrast);
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double share = (values[i] - levels.dark) / contrast;
      if (share < -slack || share > 1 + slack) return std::nullopt;
      sum += share * (i == 0 || i + 1 == values.size() ? 0.5 : 1);
    }
    const double spacing = 2 * half / static_cast<double>(values.size() - 1);
    const double off = half - sum * spacing;
    if (std::abs(off) > most_off * half) return std::nullopt;
    return off;
  }

  const GreyImage& image_;
  const Lens& lens_;
  const LightTable light_;
};

/// Removes samples with much lower contrast than the others, such as shadows and stains.
void remove_low_contrast(std::vector<Sample>& samples) {
  if (samples.empty()) return;
  std::vector<double> contrasts;
  for (const Sample& sample : samples) contrasts.push_back(sample.contrast);
  const auto strong = contrasts.begin() + static_cast<std::ptrdiff_t>(contrasts.size() * 9 / 10);
  std::nth_element(contrasts.begin(), strong, contrasts.end());
  std::erase_if(samples, [&](const Sample& sample) { return sample.contrast < least_share * *strong; });
}

std::vector<Sample> samples_at(const EdgeReader& reader, const Board& board, std::span<const int> codes,
                               const Pose& camera_board) {
  std::vector<Sample> out;
  for (const int code : codes) {
    const BoardTag* tag = board.find(code);
    if (tag == nullptr) continue;
    const Pose camera_tag = camera_board * tag->pose;
    if ((camera_tag.q * Vec3::UnitZ()).dot(camera_tag.p) >= 0) continue;  // back side is visible
    const auto corners = tag->corners();
    // The corners run counter-clockwise as seen by the camera, so the tag is on the left of each edge.
    for (std::size_t c = 0; c < corners.size(); ++c)
      reader.read(camera_board * corners[c], camera_board * corners[(c + 1) % corners.size()],
                  camera_board * corners[(c + 2) % corners.size()], out);
  }
  remove_low_contrast(out);
  return out;
}

double spread_of(const std::vector<Sample>& samples) {
  std::vector<double> off;
  for (const Sample& sample : samples) off.push_back(std::abs(sample.off));
  std::nth_element(off.begin(), off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2), off.end());
  return std::max(1e-3, 1.4826 * off[off.size() / 2]);
}

}  // namespace

std::optional<EdgeFit> fit_edges(const GreyImage& image, const Lens& lens, const Board& board,
                                 std::span<const int> codes, const Pose& camera_board, double response) {
  const EdgeReader reader(image, lens, response);
  EdgeFit fit{camera_board, 0, 0, MotionCovariance::Zero()};
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Sample> samples = samples_at(reader, board, codes, fit.camera_board);
    if (static_cast<int>(samples.size()) < least_samples) return std::nullopt;
    const double bound = huber * spread_of(samples);
    MotionCovariance sum = MotionCovariance::Zero();
    SmallMotion right = SmallMotion::Zero();
    double squares = 0, weights = 0;
    for (const Sample& sample : samples) {
      const double weight = std::min(1.0, bound / std::max(bound, std::abs(sample.off)));
      sum += weight * sample.slope.transpose() * sample.slope;
      right += weight * sample.off * sample.slope.transpose();
      squares += weight * sample.off * sample.off;
      weights += weight;
    }
    const Eigen::LDLT<MotionCovariance> solver(sum);
    if (solver.info() != Eigen::Success || solver.vectorD().minCoeff() <= 0) return std::nullopt;
    const SmallMotion step = solver.solve(right);
    if (!step.allFinite()) return std::nullopt;
    fit.camera_board = moved(fit.camera_board, step);
    fit.rms = std::sqrt(squares / weights);
    fit.samples = static_cast<int>(samples.size());
    fit.covariance = fit.rms * fit.rms * solver.solve(MotionCovariance::Identity());
  }
  return fit;
}

}  // namespace prosector
