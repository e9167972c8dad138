// prosector-vrpn-twin: a simulated VRPN server with a haptic arm in a modelled hand.
#include <fmt/format.h>

#include <iostream>

#include "common/clock.h"
#include "common/version.h"
#include "twins/arms/arm_twin_program.h"
#include "twins/arms/vrpn_server.h"
#include "twins/base/twin_program.h"

namespace prosector {
namespace {

int run(int argc, char** argv) {
  CLI::App app("A simulated VRPN server with a haptic arm, on this machine. Prints a line when ready.",
               "prosector-vrpn-twin");
  app.set_version_flag("--version", version_line("prosector-vrpn-twin"));
  std::uint16_t port = 0;
  std::string name = "Arm0";
  ArmTwinSettings settings;
  app.add_option("port", port, "TCP port of the VRPN server (0 = any free port)")->required();
  app.add_option("--name", name, "Name of the arm")->capture_default_str();
  add_arm_options(app, settings, "reports");
  if (const auto status = parse(app, argc, argv)) return *status;
  ArmLog log(settings.log);
  VrpnTwin twin({held_arm_options(settings), name, settings.seed, settings.garbage}, monotonic_ns());
  VrpnServer server(twin, port);
  std::cout << fmt::format("ready: vrpn:{}@localhost:{}", name, server.port()) << std::endl;
  serve_arm(
      settings,
      [&](std::int64_t now) {
        server.serve(now);
        if (twin.has_client()) log.write(now, twin.arm());
      },
      [&](std::int64_t now) { twin.go_on(now); });
  return 0;
}

}  // namespace
}  // namespace prosector

int main(int argc, char** argv) try {
  return prosector::run(argc, argv);
} catch (const std::exception& error) {
  std::cerr << "prosector-vrpn-twin: " << error.what() << "\n";
  return 2;
}
