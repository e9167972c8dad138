// prosector-inverse3-twin: a simulated Haply Inverse3 behind its service's WebSocket, in a modelled hand.
#include <fmt/format.h>

#include <iostream>

#include "common/clock.h"
#include "common/version.h"
#include "twins/arms/arm_twin_program.h"
#include "twins/arms/inverse3_server.h"
#include "twins/base/twin_program.h"

namespace prosector {
namespace {

int run(int argc, char** argv) {
  CLI::App app(
      "A simulated Haply Inverse3 arm and the WebSocket of Haply's service on this machine. Prints a line "
      "when ready.",
      "prosector-inverse3-twin");
  app.set_version_flag("--version", version_line("prosector-inverse3-twin"));
  std::uint16_t port = 0;
  ArmTwinSettings settings;
  app.add_option("port", port, "TCP port of the WebSocket (0 = any free port)")->required();
  add_arm_options(app, settings, "texts");
  if (const auto status = parse(app, argc, argv)) return *status;
  ArmLog log(settings.log);
  Inverse3Twin twin({held_arm_options(settings), settings.seed, settings.garbage}, monotonic_ns());
  Inverse3Server server(twin, port);
  std::cout << fmt::format("ready: inverse3:localhost:{}", server.port()) << std::endl;
  serve_arm(
      settings,
      [&](std::int64_t now) {
        server.serve();
        twin.advance(now);
        if (server.has_client()) log.write(now, twin.arm());
      },
      [&](std::int64_t now) { twin.go_on(now); });
  return 0;
}

}  // namespace
}  // namespace prosector

int main(int argc, char** argv) try {
  return prosector::run(argc, argv);
} catch (const std::exception& error) {
  std::cerr << "prosector-inverse3-twin: " << error.what() << "\n";
  return 2;
}
