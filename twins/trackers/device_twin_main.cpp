// prosector-device-twin: simulated devices behind a network connection or a socket.
#include <array>
#include <iostream>

#include "twins/base/twin_program.h"
#include "twins/trackers/igtl_twin.h"
#include "twins/trackers/leap_twin.h"
#include "twins/trackers/space_mouse_twin.h"
#include "twins/trackers/vrpn_tracker_twin.h"

namespace prosector {
namespace {

struct Kind {
  const char* name;
  const char* address;  // address prefix before HOST:PORT or the socket
  std::unique_ptr<Twin> (*make)(const TrackerTwinOptions& options, std::int64_t now_ns);
};

std::unique_ptr<Twin> make_vrpn(const TrackerTwinOptions& options, std::int64_t now_ns) {
  return std::make_unique<VrpnTrackerTwin>("Tracker0", options, now_ns);
}

std::unique_ptr<Twin> make_igtl(const TrackerTwinOptions& options, std::int64_t now_ns) {
  return std::make_unique<IgtlTwin>(options, now_ns);
}

std::unique_ptr<Twin> make_leap(const TrackerTwinOptions& options, std::int64_t now_ns) {
  return std::make_unique<LeapTwin>(options, now_ns);
}

std::unique_ptr<Twin> make_space_mouse(const TrackerTwinOptions& options, std::int64_t now_ns) {
  return std::make_unique<SpaceMouseTwin>(options, now_ns);
}

constexpr std::array<Kind, 4> kinds = {{{"vrpn", "vrpn:Tracker0@", make_vrpn},
                                        {"igtl", "igtl:", make_igtl},
                                        {"leap", "leap:", make_leap},
                                        {"spacemouse", "spacemouse:", make_space_mouse}}};

const Kind* find_kind(const std::string& name) {
  for (const Kind& kind : kinds)
    if (name == kind.name) return &kind;
  return nullptr;
}

int run_device_twin(int argc, char** argv) {
  CLI::App app(
      "A simulated device, reached through the network or a socket. Its first output line is its address.",
      "prosector-device-twin");
  std::string kind, where;
  TwinProgramOptions options;
  TrackerTwinOptions tracker;
  std::vector<double> room = {0, 0, 0, 1, 0, 0, 0}, wrong_version;
  std::set<std::string> names;
  for (const Kind& row : kinds) names.emplace(row.name);
  app.add_option("DRIVER", kind, "driver of the device to simulate, as in its address DRIVER:PATH")
      ->required()
      ->check(CLI::IsMember(names));
  app.add_option(
         "WHERE", where,
         "where to listen: a TCP port on this machine (0 = any free port), or the path of a Unix socket")
      ->required();
  add_options(app, options);
  app.remove_option(app.get_option("--link"));
  app.add_option("--room-device", room, "x,y,z,qw,qx,qy,qz: pose of the device's frame in the room")
      ->expected(7)
      ->delimiter(',');
  app.add_option("--stations", tracker.stations, "number of stations")
      ->check(CLI::Range(std::size_t{1}, max_stations))
      ->capture_default_str();
  app.add_option("--rate", tracker.rate, "records per second of each station")
      ->check(CLI::Range(1.0, 1000.0))
      ->capture_default_str();
  app.add_option("--bad-crc", tracker.bad_checksum_fraction,
                 "with DRIVER igtl: fraction of messages with a wrong checksum, from 0 to 1")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--wrong-version", wrong_version,
                 "FROM,TO: greet clients with another protocol version between these times, s")
      ->expected(2)
      ->delimiter(',');
  if (const auto status = parse(app, argc, argv)) return *status;
  if (where.find_first_not_of("0123456789") != std::string::npos)
    options.server.socket = where;
  else if (where.size() <= 5 && std::stoul(where) <= 65535)
    options.server.port = static_cast<std::uint16_t>(std::stoul(where));
  else
    return std::cerr << where << ": must be a TCP port from 0 to 65535, or the path of a Unix socket\n", 2;
  const Kind& row = *find_kind(kind);
  options.address = row.address;
  return run_twin(options, [&](MotionScript script, std::int64_t now_ns) {
    tracker.script = std::move(script);
    tracker.room_device = {Vec3(room[0], room[1], room[2]),
                           Quat(room[3], room[4], room[5], room[6]).normalized()};
    tracker.timing = options.timing;
    tracker.seed = options.seed;
    tracker.wrong_version = from_to(wrong_version);
    return row.make(tracker, now_ns);
  });
}

}  // namespace
}  // namespace prosector

int main(int argc, char** argv) {
  return prosector::run_device_twin(argc, argv);
}
