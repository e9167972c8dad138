#include "tests/bench/face_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "common/eye_distance.h"
#include "tests/hands/face_errors.h"
#include "tests/real_data.h"

namespace prosector {
namespace {

struct FaceTrial {
  const char* varied;
  double value;
  FaceCase what;
};

constexpr double radian = 180 / std::numbers::pi;  // degrees

std::vector<FaceTrial> face_trials() {
  std::vector<FaceTrial> out;
  for (const double d : {0.4, 0.6, 0.8, 1.2}) out.push_back({"distance m", d, {.distance = d}});
  for (const double a : {0.1, 0.2, 0.3}) out.push_back({"lateral offset m", a, {.aside = a}});
  for (const double t : {10., 20., 30.}) out.push_back({"yaw deg", t, {.yaw = t / radian}});
  for (const double s : {0.1, 0.3, 0.6})
    out.push_back({"speed m/s", s, {.aside = -0.15, .speed = s, .places = 4, .pictures = 30}});
  for (const double l : {0.3, 0.1}) out.push_back({"light", l, {.light = l}});
  for (const int h : {240, 720}) out.push_back({"lines of 4:3", static_cast<double>(h), {.height = h}});
  return out;
}

double share_of(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

ReportRow face_row(const std::string& face, const FaceTrial& trial, const FaceErrors& found) {
  ReportRow row = {{"board", face},
                   {"varied", trial.varied},
                   {"value", trial.value},
                   {"seen", static_cast<double>(found.seen) / found.pictures},
                   {"depth_mm", share_of(found.depth, 0.5)},
                   {"depth_95_mm", share_of(found.depth, 0.95)},
                   {"lateral_mm", share_of(found.across, 0.5)},
                   {"turn_deg", radian * share_of(found.gaze, 0.5)},
                   {"turn_95_deg", radian * share_of(found.gaze, 0.95)},
                   {"scatter_along_mm", found.jitter_along},
                   {"scatter_across_mm", found.jitter_across},
                   {"rest_along_mm", found.rest_along},
                   {"rest_across_mm", found.rest_across},
                   {"find_ms", share_of(found.find_ms, 0.5)},
                   {"fit_ms", share_of(found.smooth_ms, 0.5)}};
  if (!found.lag.empty()) row["lag_ms"] = 1e3 * share_of(found.lag, 0.5);
  return row;
}

}  // namespace

void measure_faces(bool quick, const std::function<void(const ReportRow&)>& take) {
  const std::filesystem::path net = find_in_data("face_short_range.tflite"), ct = find_in_data("head.nii");
  if (net.empty()) {
    fmt::print("faces skipped: run deploy/fetch_models.sh to fetch the face detection network\n");
    return;
  }
  const auto own = std::make_shared<const FaceMesh>(make_face(default_interpupillary_distance));
  for (FaceTrial trial : face_trials()) {
    if (quick) trial.what.places = trial.what.pictures = 2;
    take(face_row("face", trial, face_errors(trial.what, own, net.parent_path())));
    if (quick) return;
  }
  if (ct.empty()) return;
  const FaceTrial trial{"distance m", 0.6, {}};
  take(face_row(
      "CT", trial,
      face_errors(trial.what, std::make_shared<const FaceMesh>(load_ct_face(ct)), net.parent_path())));
}

}  // namespace prosector
