#include "drivers/twins/openxr/double_settings.h"

#include <CLI/CLI.hpp>
#include <cstdlib>

namespace prosector {
namespace {

void add_span(CLI::App& app, const std::string& name, Span& span, const std::string& help) {
  app.add_option_function<std::vector<double>>(
         name,
         [&span](const std::vector<double>& v) {
           span = {v[0], v[1]};
         },
         help)
      ->expected(2);
}

}  // namespace

DoubleSettings settings_of_double() {
  DoubleSettings out;
  const char* words = std::getenv("PROSECTOR_OPENXR");
  if (words == nullptr) return out;
  CLI::App app("", "PROSECTOR_OPENXR");
  app.add_option("--script", out.script, "CSV of the wearer's motion");
  app.add_option("--waits-for", out.waits_for, "File without which time stands still");
  app.add_option("--pictures", out.pictures, "Folder for left.ppm and right.ppm");
  app.add_option("--rate", out.rate, "Frames a second");
  app.add_option("--width", out.width, "Of an eye's picture");
  app.add_option("--height", out.height, "Of an eye's picture");
  app.add_flag("--controllers", out.controllers, "Controllers instead of bare hands");
  app.add_flag("--held", out.held, "Controllers in bare hands");
  app.add_flag("--no-stage", out.no_stage, "The floor isn't known");
  app.add_flag("--glx", out.glx, "Pictures by GLX, not by EGL");
  add_span(app, "--unfocused", out.unfocused, "Another program has the hands");
  add_span(app, "--away", out.away, "There is no runtime");
  add_span(app, "--garbage", out.garbage, "Poses and angles are no numbers");
  app.add_option("--session-lost", out.session_lost, "When the session is lost");
  app.add_option("--instance-lost", out.instance_lost, "When the instance is lost");
  app.add_option("--frame-refused", out.frame_refused, "When a frame is refused");
  app.add_option("--centred-anew", out.centred_anew, "When the stage moves by 0.1 m to the right");
  app.add_option("--left", out.left, "When the wearer leaves the program");
  try {
    app.parse(words, false);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return {};
  }
  return out;
}

}  // namespace prosector
