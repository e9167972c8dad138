#include "drivers/camera/calibration/lens_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <set>

#include "common/error.h"
#include "drivers/camera/tags/edge_fit.h"

namespace prosector {
namespace {

constexpr std::size_t least_tags = 4;  // tags per view; views with fewer don't count
constexpr int usual_rounds = 2;        // number of times that corners are recomputed
constexpr double least_response = 1, most_response = 3;
constexpr int response_steps = 7;          // iterations of the golden-section search
constexpr std::size_t response_views = 5;  // number of views used to find the response
constexpr std::size_t holdout_interval = 5;
constexpr double most_rms = 2;                  // pixels; a fit with a larger error is rejected
constexpr double most_rough_rms = 1;            // pixels, for a fit to the tag detector's corners
constexpr double least_share_with_edges = 0.5;  // of views with enough edges, for a fit by edges
constexpr double outlier_px = 0.15,
                 outlier_ratio = 4;  // factor of the median error; tags with a larger error are left out
constexpr int solver_flags = cv::CALIB_FIX_K3;

/// Corners of one tag in one view.
struct TagCorners {
  const BoardTag* tag;
  std::array<Vec2, 4> pixels;
};
using ViewCorners = std::vector<TagCorners>;

struct Solved {
  Lens lens;
  double rms = 0;
};

Solved solve(std::span<const ViewCorners> views, int width, int height) {
  std::vector<std::vector<cv::Point3f>> board;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const ViewCorners& view : views) {
    auto& b = board.emplace_back();
    auto& p = pixels.emplace_back();
    for (const TagCorners& tag : view) {
      const auto corners = tag.tag->corners();
      for (std::size_t c = 0; c < corners.size(); ++c) {
        b.emplace_back(static_cast<float>(corners[c].x()), static_cast<float>(corners[c].y()), 0.0f);
        p.emplace_back(static_cast<float>(tag.pixels[c].x()), static_cast<float>(tag.pixels[c].y()));
      }
    }
  }
  cv::Matx33d k = cv::Matx33d::eye();
  cv::Mat bend = cv::Mat::zeros(5, 1, CV_64F);
  std::vector<cv::Mat> turns, places;
  Solved out;
  try {
    out.rms = cv::calibrateCamera(board, pixels, {width, height}, k, bend, turns, places, solver_flags);
  } catch (const cv::Exception&) {
    out.rms = std::numeric_limits<double>::infinity();
    return out;
  }
  out.lens = {width,
              height,
              k(0, 0),
              k(1, 1),
              k(0, 2),
              k(1, 2),
              bend.at<double>(0),
              bend.at<double>(1),
              bend.at<double>(2),
              bend.at<double>(3),
              bend.at<double>(4)};
  return out;
}

/// Computes a tag's corners from its edges, for a given lens and response.
std::optional<std::array<Vec2, 4>> corners_by_edges(const GreyImage& picture, const Lens& lens,
                                                    double response, const BoardTag& tag,
                                                    const std::array<Vec2, 4>& near) {
  const BoardTag alone{tag.code, tag.size, {}};
  const Board board{"", {alone}};
  const Lens pinhole = lens.pinhole();
  std::vector<DetectedCorner> seen;
  const auto corners = alone.corners();
  for (std::size_t c = 0; c < corners.size(); ++c)
    seen.push_back({corners[c], lens.undistorted_pixel(near[c])});
  const auto poses = solve_board(seen, pinhole);
  if (poses.empty()) return std::nullopt;
  const std::array<int, 1> codes = {tag.code};
  const auto fit = fit_edges(picture, lens, board, codes, poses.front().camera_board, response);
  if (!fit) return std::nullopt;
  std::array<Vec2, 4> out;
  for (std::size_t c = 0; c < corners.size(); ++c) out[c] = lens.project(fit->camera_board * corners[c]);
  return out;
}

std::vector<ViewCorners> corners_of(const Board& board, std::span<const LensView> views) {
  std::vector<ViewCorners> out;
  for (const LensView& view : views) {
    ViewCorners& corners = out.emplace_back();
    for (const DetectedTag& seen : view.tags)
      if (const BoardTag* tag = board.find(seen.code)) corners.push_back({tag, seen.corners});
  }
  return out;
}

std::vector<ViewCorners> refined(const std::vector<ViewCorners>& rough, std::span<const LensView> views,
                                 const Lens& lens, double response) {
  std::vector<ViewCorners> out(rough.size());
  for (std::size_t v = 0; v < rough.size(); ++v)
    for (const TagCorners& tag : rough[v])
      if (const auto pixels = corners_by_edges(views[v].picture, lens, response, *tag.tag, tag.pixels))
        out[v].push_back({tag.tag, *pixels});
  return out;
}

bool has_enough(const ViewCorners& view) {
  return view.size() >= least_tags;
}

bool has_enough(const std::vector<ViewCorners>& views) {
  return std::all_of(views.begin(), views.end(), [](const ViewCorners& v) { return has_enough(v); });
}

/// Returns the views in which the edges of enough tags are found.
std::vector<LensView> views_with_edges(const Board& board, std::span<const LensView> views,
                                       const Lens& lens) {
  const auto fine = refined(corners_of(board, views), views, lens, default_response);
  std::vector<LensView> out;
  for (std::size_t v = 0; v < views.size(); ++v)
    if (has_enough(fine[v])) out.push_back(views[v]);
  return out;
}

/// Returns the RMS reprojection error of each tag of a view, pixels, at the view's best pose.
std::vector<double> tag_errors(const Lens& lens, const ViewCorners& view) {
  const Lens pinhole = lens.pinhole();
  std::vector<DetectedCorner> seen;
  for (const TagCorners& tag : view) {
    const auto corners = tag.tag->corners();
    for (std::size_t c = 0; c < corners.size(); ++c)
      seen.push_back({corners[c], lens.undistorted_pixel(tag.pixels[c])});
  }
  const auto poses = solve_board(seen, pinhole);
  std::vector<double> out(view.size(), std::numeric_limits<double>::infinity());
  if (poses.empty()) return out;
  for (std::size_t t = 0; t < view.size(); ++t) {
    double sum = 0;
    for (std::size_t c = 0; c < 4; ++c)
      sum += (lens.project(poses.front().camera_board * seen[4 * t + c].board) - view[t].pixels[c])
                 .squaredNorm();
    out[t] = std::sqrt(sum / 4);
  }
  return out;
}

/// Returns the RMS reprojection error of views that the lens wasn't fitted to, pixels. The pose of each view
/// is fitted.
double error_of(const Lens& lens, std::span<const ViewCorners> views) {
  double sum = 0;
  int count = 0;
  for (const ViewCorners& view : views)
    for (const double error : tag_errors(lens, view))
      if (std::isfinite(error)) {
        sum += error * error;
        ++count;
      }
  return count == 0 ? 0 : std::sqrt(sum / count);
}

/// Removes tags with errors far above the median, such as half hidden ones at the image border.
std::vector<ViewCorners> without_outliers(const Lens& lens, const std::vector<ViewCorners>& views) {
  std::vector<std::vector<double>> errors;
  std::vector<double> sorted;
  for (const ViewCorners& view : views) {
    errors.push_back(tag_errors(lens, view));
    sorted.insert(sorted.end(), errors.back().begin(), errors.back().end());
  }
  std::sort(sorted.begin(), sorted.end());
  const double bound = std::max(outlier_px, outlier_ratio * sorted[sorted.size() / 2]);
  std::vector<ViewCorners> out(views.size());
  for (std::size_t v = 0; v < views.size(); ++v)
    for (std::size_t t = 0; t < views[v].size(); ++t)
      if (errors[v][t] <= bound) out[v].push_back(views[v][t]);
  return out;
}

Solved solve_with(const std::vector<ViewCorners>& rough, std::span<const LensView> views, const Lens& first,
                  double response, int rounds, std::vector<ViewCorners>* corners = nullptr) {
  Solved out{first, std::numeric_limits<double>::infinity()};
  for (int round = 0; round < rounds; ++round) {
    const std::vector<ViewCorners> fine = refined(rough, views, out.lens, response);
    if (!has_enough(fine)) return out;
    out = solve(fine, first.width, first.height);
    const std::vector<ViewCorners> kept = without_outliers(out.lens, fine);
    if (!has_enough(kept)) return out;
    out = solve(kept, first.width, first.height);
    if (corners != nullptr) *corners = kept;
  }
  return out;
}

/// Finds the response with the least error by golden-section search (Kiefer 1953).
double find_response(const std::vector<ViewCorners>& rough, std::span<const LensView> views,
                     const Lens& first, const std::stop_token& stop) {
  constexpr double golden = 0.6180339887498949;
  double a = least_response, b = most_response;
  const Solved near = solve_with(rough, views, first, default_response, usual_rounds);
  const auto error = [&](double response) {
    if (stop.stop_requested()) throw InputError("the fit was stopped");
    return solve_with(rough, views, near.lens, response, 1).rms;
  };
  double x = b - golden * (b - a), y = a + golden * (b - a);
  double at_x = error(x), at_y = error(y);
  for (int step = 0; step < response_steps; ++step) {
    if (at_x < at_y) {
      b = y;
      y = x;
      at_y = at_x;
      x = b - golden * (b - a);
      at_x = error(x);
    } else {
      a = x;
      x = y;
      at_x = at_y;
      y = a + golden * (b - a);
      at_y = error(y);
    }
  }
  return (a + b) / 2;
}

double held_out_error(const std::vector<ViewCorners>& corners, const Lens& lens) {
  std::vector<ViewCorners> fitted, left_out;
  for (std::size_t v = 0; v < corners.size(); ++v)
    (v % holdout_interval == holdout_interval - 1 ? left_out : fitted).push_back(corners[v]);
  return error_of(solve(fitted, lens.width, lens.height).lens, left_out);
}

/// Fits the lens to tag edges, in the views where edges are found. Returns nothing if there are too few such
/// views.
std::optional<LensFit> lens_by_edges(const Board& board, std::span<const LensView> views, const Lens& first,
                                     const std::stop_token& stop) {
  const std::vector<LensView> used = views_with_edges(board, views, first);
  const double share = static_cast<double>(used.size()) / static_cast<double>(views.size());
  if (used.size() < min_views || share < least_share_with_edges) return std::nullopt;
  const std::vector<ViewCorners> rough = corners_of(board, used);
  const std::span<const LensView> some = std::span(used).first(std::min(response_views, used.size()));
  LensFit out;
  out.calibration.response = find_response(
      {rough.begin(), rough.begin() + static_cast<std::ptrdiff_t>(some.size())}, some, first, stop);
  std::vector<ViewCorners> corners;
  const Solved best = solve_with(rough, used, first, out.calibration.response, usual_rounds, &corners);
  if (!(best.rms < most_rms)) return std::nullopt;
  out.calibration.lens = best.lens;
  out.rms = best.rms;
  out.held_out = out.calibration.error = held_out_error(corners, best.lens);
  return out;
}

/// Fits the lens to the tag detector's corners. Throws InputError if they are too blurred.
LensFit lens_by_corners(const std::vector<ViewCorners>& rough, const Lens& first) {
  const std::vector<ViewCorners> kept = without_outliers(first, rough);
  const std::vector<ViewCorners>& corners = has_enough(kept) ? kept : rough;
  const Solved best = solve(corners, first.width, first.height);
  if (!(best.rms < most_rough_rms))
    throw InputError("the board's edges are too blurred: hold it still, nearer, in more light");
  LensFit out;
  out.by_edges = false;
  out.calibration.lens = best.lens;
  out.calibration.response = default_response;
  out.rms = best.rms;
  out.held_out = out.calibration.error = held_out_error(corners, best.lens);
  return out;
}

}  // namespace

std::set<ImageCell> covered_cells(std::span<const LensView> views) {
  std::set<ImageCell> cells;
  for (const LensView& view : views)
    for (const DetectedTag& tag : view.tags)
      for (const Vec2& corner : tag.corners)
        cells.insert(
            {std::clamp(static_cast<int>(corner.x() * cells_across / view.picture.width), 0,
                        cells_across - 1),
             std::clamp(static_cast<int>(corner.y() * cells_down / view.picture.height), 0, cells_down - 1)});
  return cells;
}

double covered_share(std::span<const LensView> views) {
  return static_cast<double>(covered_cells(views).size()) / (cells_across * cells_down);
}

LensFit fit_lens(const Board& board, std::span<const LensView> views, const std::string& camera,
                 const std::stop_token& stop) {
  if (views.size() < min_views)
    throw InputError(fmt::format("the lens fit needs at least {} views of the board; there are {}", min_views,
                                 views.size()));
  const int width = views.front().picture.width, height = views.front().picture.height;
  const std::vector<ViewCorners> rough = corners_of(board, views);
  if (!has_enough(rough))
    throw InputError(fmt::format("each view must show at least {} tags of the board", least_tags));
  const Solved first = solve(rough, width, height);
  if (!(first.rms < most_rms) || !(first.lens.fx > 0))
    throw InputError(
        "the views are not consistent with one lens: use a flat board, and tilt it in different directions");
  const std::optional<LensFit> by_edges = lens_by_edges(board, views, first.lens, stop);
  LensFit out = by_edges ? *by_edges : lens_by_corners(rough, first.lens);
  out.calibration.camera = camera;
  out.covered = covered_share(views);
  return out;
}

}  // namespace prosector
