#include "drivers/camera/base/camera_calibration.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "drivers/files/toml_fields.h"

namespace prosector {
namespace {

constexpr double guessed_view = 60 * std::numbers::pi / 180;  // rad, horizontal field of view
constexpr int least_side = 16, most_side = 8192;              // pixels
constexpr double most_focal = 1e5;                            // pixels
constexpr double most_bend = 20;

CameraCalibration read(const TomlFields& fields) {
  (void)fields.whole("version", 1, 1);
  CameraCalibration out;
  out.camera = fields.text("camera");
  out.lens.width = fields.whole("width", least_side, most_side);
  out.lens.height = fields.whole("height", least_side, most_side);
  std::array<double, 2> focal{}, centre{};
  fields.numbers("focal", focal, 1, most_focal);
  fields.numbers("centre", centre, -most_side, most_side);
  std::array<double, 5> bend{};
  fields.numbers("distortion", bend, -most_bend, most_bend);
  out.lens.fx = focal[0];
  out.lens.fy = focal[1];
  out.lens.cx = centre[0];
  out.lens.cy = centre[1];
  out.lens.k1 = bend[0];
  out.lens.k2 = bend[1];
  out.lens.p1 = bend[2];
  out.lens.p2 = bend[3];
  out.lens.k3 = bend[4];
  out.response = fields.number("response", 0.5, 4, default_response);
  out.error = fields.number("error", 0, most_side, 0);
  fields.reject_unknown_keys();
  return out;
}

}  // namespace

CameraCalibration guessed_calibration(int width, int height) {
  CameraCalibration out;
  out.camera = "unknown";
  out.lens.width = width;
  out.lens.height = height;
  out.lens.fx = out.lens.fy = width / 2.0 / std::tan(guessed_view / 2);
  out.lens.cx = (width - 1) / 2.0;
  out.lens.cy = (height - 1) / 2.0;
  return out;
}

CameraCalibration load_calibration(const std::filesystem::path& file) {
  return read(TomlFields::load(file, "camera's calibration"));
}

CameraCalibration parse_calibration(const std::string& toml, const std::string& file) {
  return read(TomlFields::parse(toml, file, "camera's calibration"));
}

std::string write_calibration(const CameraCalibration& c) {
  std::string name;
  for (const char letter : c.camera)  // drops characters that a TOML string would need to escape
    if (static_cast<unsigned char>(letter) >= 0x20 && letter != '"' && letter != '\\') name += letter;
  return fmt::format(
      "# A camera's calibration, written by `prosector-client camera calibrate`.\nversion = 1\ncamera = "
      "\"{}\"\nwidth = {}\nheight = {}  # pixels\nfocal = [{:.4f}, {:.4f}]  # pixels\ncentre = [{:.4f}, "
      "{:.4f}]  # pixels; the first pixel's centre is 0, 0\ndistortion = [{:.7f}, {:.7f}, {:.7f}, {:.7f}, "
      "{:.7f}]  # k1 k2 p1 p2 k3\nresponse = {:.3f}  # exponent from light to brightness\nerror = {:.4f}  # "
      "pixels RMS, in views not used for the fit\n",
      name, c.lens.width, c.lens.height, c.lens.fx, c.lens.fy, c.lens.cx, c.lens.cy, c.lens.k1, c.lens.k2,
      c.lens.p1, c.lens.p2, c.lens.k3, c.response, c.error);
}

}  // namespace prosector
