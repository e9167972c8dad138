#include "client/app/commands/calibrate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <fstream>
#include <functional>

#include "client/app/commands/guided_run.h"
#include "common/error.h"
#include "common/former_option_name.h"
#include "drivers/config/tracker_roles.h"
#include "drivers/device/driver_table.h"
#include "drivers/files/csv.h"
#include "drivers/fitting/eyes_guide.h"
#include "drivers/fitting/field_guide.h"
#include "drivers/fitting/glove_guide.h"
#include "drivers/fitting/phantom_guide.h"
#include "drivers/fitting/room_guide.h"
#include "drivers/fitting/timed_guides.h"
#include "drivers/fitting/tip_guide.h"

namespace prosector {
namespace {

/// Input of every calibration procedure.
struct Calibration {
  const CalibrateOptions& options;
  ClientConfig config;
  StationRole role;
  ClientConfig seen = config_for_role(config, role);  // configuration of the tracker that measures this role
};

std::vector<double> parse_numbers(const std::string& text, char between) {
  std::vector<double> out;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(between, at), text.size());
    double value = 0;
    const auto [stop, error] = std::from_chars(text.data() + at, text.data() + end, value);
    if (error != std::errc() || stop != text.data() + end) return {};
    out.push_back(value);
    at = end + 1;
  }
  return out;
}

StationRole parse_role(const std::string& name, const ClientConfig& config) {
  if (name.empty()) return pointer_role(config);
  for (const StationRole role :
       {StationRole::head, StationRole::left_hand, StationRole::right_hand, StationRole::instrument})
    if (name == role_name(role)) return role;
  throw InputError(fmt::format("--station {}: must be head, right, left or instrument", name));
}

void check_tracker(const Calibration& c) {
  if (c.config.tracker.empty())
    throw InputError(fmt::format("{}: configures no tracker", c.options.config.string()));
}

std::unique_ptr<Device> open_tracker(const Calibration& c, const DeviceConfig& device) {
  check_tracker(c);
  return open_device(c.seen.tracker, device);
}

/// Parses an option's points, each x,y,z in m.
std::vector<Vec3> parse_places(const char* option, const std::vector<std::string>& texts) {
  std::vector<Vec3> out;
  for (const std::string& text : texts) {
    const std::vector<double> p = parse_numbers(text, ',');
    if (p.size() != 3) throw InputError(fmt::format("{} {}: must be x,y,z in m", option, text));
    out.emplace_back(p.data());
  }
  return out;
}

GuideOutcome calibrate_room(const Calibration& c) {
  RoomGuide guide(c.seen, c.role, parse_places("--point", c.options.points));
  run_guide(guide, *open_tracker(c, RoomGuide::device(c.seen)), c.options.time_limit);
  return guide.outcome();
}

GuideOutcome calibrate_phantom(const Calibration& c) {
  PhantomGuide guide(c.config, c.role, parse_places("--point", c.options.points),
                     parse_places("--target", c.options.targets));
  check_tracker(c);
  run_guide(guide, *open_device(board_tracker_address(c.config.tracker), PhantomGuide::device(c.config)),
            c.options.time_limit);
  return guide.outcome();
}

GuideOutcome calibrate_tip(const Calibration& c) {
  TipGuide guide(c.seen, c.role);
  run_guide(guide, *open_tracker(c, TipGuide::device(c.seen, c.role)), c.options.time_limit);
  return guide.outcome();
}

GuideOutcome calibrate_field(const Calibration& c) {
  const CalibrateOptions& o = c.options;
  FieldGrid grid{Vec3(o.low.data()), Vec3(o.high.data()), o.grid, std::nullopt};
  if (!o.orientation.empty())
    grid.orientation =
        Quat(o.orientation[0], o.orientation[1], o.orientation[2], o.orientation[3]).normalized();
  FieldGuide guide(c.seen, c.role, grid, o.map.string());
  run_guide(guide, *open_tracker(c, FieldGuide::device(c.seen)), o.time_limit);
  const FieldFit fit = guide.fit();
  if (o.write) {
    const std::filesystem::path file = o.config.parent_path() / o.map;
    save_config_text(file, write_field_map(fit.map));
    fmt::print("wrote {}\n", file.string());
  }
  return guide.outcome_of(fit);
}

GuideOutcome calibrate_glove(const Calibration& c) {
  const std::size_t hand = c.options.hand == "left" ? left_hand : right_hand;
  const GloveSettings& glove = c.config.gloves[hand];
  if (glove.address.empty())
    throw InputError(fmt::format("{}: configures no {} glove", c.options.config.string(), c.options.hand));
  GloveGuide guide(hand, GloveGuide::least_span_of(glove.address));
  run_guide(guide, *open_device(glove.address, glove.device), c.options.time_limit);
  return guide.outcome();
}

GuideOutcome calibrate_noise(const Calibration& c) {
  RestGuide guide(station_of_role(c.seen, c.role), c.options.seconds);
  run_guide(guide, *open_tracker(c, c.seen.tracker_device), c.options.time_limit);
  return guide.outcome();
}

/// Reads a station's positions from a twin's log with columns time_ns,station,record,x,y,z and more.
void take_log(const std::filesystem::path& file, std::size_t station, DelayGuide& guide) {
  std::ifstream in(file);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (number == 1) continue;
    const std::vector<double> v = parse_numbers(line, ',');
    if (v.size() < 6)
      throw InputError(fmt::format("{}:{}: the row must start with the columns time_ns,station,record,x,y,z",
                                   file.string(), number));
    if (v[1] == static_cast<double>(station + 1))
      guide.add_other_position(static_cast<std::int64_t>(v[0]), Vec3(v[3], v[4], v[5]));
  }
}

GuideOutcome calibrate_latency(const Calibration& c) {
  const std::size_t station = station_of_role(c.seen, c.role);
  DelayGuide guide(station, c.options.seconds);
  const auto device = open_tracker(c, c.seen.tracker_device);
  if (std::filesystem::exists(c.options.against)) {
    run_guide(guide, *device, c.options.time_limit);
    take_log(c.options.against, station, guide);
    return guide.outcome();
  }
  const auto other = open_device(c.options.against, {});
  std::vector<DeviceSample> samples;
  run_guide(guide, *device, c.options.time_limit, [&] {
    samples.clear();
    other->poll(samples);
    for (const DeviceSample& s : samples)
      if (s.has_pose && s.station == 0) guide.add_other_position(s.time_ns, s.pose.p);
  });
  return guide.outcome();
}

EyeFit fit_seen(const std::filesystem::path& file, const std::array<int, 2>& size) {
  const CsvTable table(file, {"x", "y", "z", "u", "v"});
  std::vector<SeenPoint> seen;
  for (std::size_t i = 0; i < table.rows(); ++i)
    seen.push_back({{table.required(i, "x"), table.required(i, "y"), table.required(i, "z")},
                    {table.required(i, "u"), table.required(i, "v")}});
  try {
    return fit_eye(seen, size[0], size[1]);
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", file.string(), e.what()));
  }
}

GuideOutcome calibrate_eyes(const Calibration& c) {
  const CalibrateOptions& o = c.options;
  if (o.seen.size() == 2) {
    const EyeFit left = fit_seen(o.seen[0], o.size), right = fit_seen(o.seen[1], o.size);
    return eyes_outcome(left, right, join_eyes(left, right));
  }
  GuideOutcome out;
  const EyeDistance eyes = eye_distance_by_sighting(o.marks, o.screen, o.rod);
  out.words.push_back(fmt::format("eyes {:.1f} ± {:.1f} mm apart", 1e3 * eyes.distance, 1e3 * eyes.error));
  out.changes = {{"eyes.distance", eyes.distance}};
  return out;
}

/// Name and function of a calibration procedure.
struct Procedure {
  const char* name;
  GuideOutcome (*run)(const Calibration&);
};
constexpr std::array<Procedure, 8> procedures = {{{"room", calibrate_room},
                                                  {"tip", calibrate_tip},
                                                  {"field", calibrate_field},
                                                  {"glove", calibrate_glove},
                                                  {"noise", calibrate_noise},
                                                  {"latency", calibrate_latency},
                                                  {"eyes", calibrate_eyes},
                                                  {"phantom", calibrate_phantom}}};

void print_outcome(const GuideOutcome& outcome, const CalibrateOptions& o) {
  for (const std::string& line : outcome.words) fmt::print("{}\n", line);
  if (outcome.changes.empty()) return;
  const std::string before = read_config_text(o.config);
  const std::string after = write_client_config(before, outcome.changes, o.config.string());
  fmt::print("{} of {}:\n", o.write ? "new lines" : "lines for --write", o.config.string());
  for (const ConfigChange& change : outcome.changes)
    fmt::print("  {} = {}\n", change.key, to_toml(change.value));
  if (!o.write) return;
  save_config_text(o.config, after);
  fmt::print("wrote {}\n", o.config.string());
}

void add_field(CLI::App& app, CalibrateOptions& o) {
  app.add_option("--low", o.low,
                 "For field: position x,y,z of the grid's corner with the lowest coordinates, m")
      ->delimiter(',');
  app.add_option("--high", o.high,
                 "For field: position x,y,z of the grid's corner with the highest coordinates, m")
      ->delimiter(',');
  app.add_option("--grid", o.grid, "For field: number of grid points along x,y,z (default 5,5,5)")
      ->delimiter(',');
  app.add_option("--orientation", o.orientation,
                 "For field: the receiver's orientation in the room, quaternion w,x,y,z (default: as "
                 "measured nearest to the transmitter)")
      ->expected(4)
      ->delimiter(',');
  app.add_option(
         "--map", o.map,
         "For field: name of the file for the distortion map, in the folder of the configuration file")
      ->capture_default_str();
}

void add_eyes(CLI::App& app, CalibrateOptions& o) {
  app.add_option("--marks", o.marks,
                 "For eyes: distance between the two marks on the screen that the left and the right eye see "
                 "behind the rod, m");
  app.add_option("--screen", o.screen, "For eyes: distance from the eyes to the screen, m");
  app.add_option("--rod", o.rod,
                 "For eyes: distance from the eyes to the rod that is held before the screen, m");
  app.add_option("--seen", o.seen,
                 "For eyes: two CSV files, of the left and the right eye, with rows x,y,z,u,v: a point in "
                 "the head receiver's frame, m, and the pixel at which the eye sees it")
      ->expected(2)
      ->check(CLI::ExistingFile);
  app.add_option("--size", o.size,
                 "For eyes: image size for each eye in pixels, WIDTH,HEIGHT (default 800,600)")
      ->delimiter(',');
}

}  // namespace

void add_calibrate(CLI::App& app, CalibrateOptions& o) {
  std::vector<std::string> names;
  for (const Procedure& p : procedures) names.emplace_back(p.name);
  app.add_option("WHAT", o.what,
                 "What to calibrate. room: pose of the tracker in the room; tip: position of an instrument's "
                 "tip; field: distortion of positions by metal; glove: range of its sensors; noise: noise of "
                 "a receiver at rest; latency: delay relative to another device; eyes: distance between the "
                 "eyes and size of the display; phantom: pose of a real body that occludes others")
      ->check(CLI::IsMember(names))
      ->required();
  app.add_option("--config", o.config, "Client configuration file (TOML) that defines the devices")
      ->check(CLI::ExistingFile)
      ->required();
  app.add_flag(
      "--write", o.write,
      "Write the results to the configuration file, which is otherwise unchanged (default: only print them)");
  app.add_option("--station", o.station,
                 "Role of the receiver to calibrate: head, right, left or instrument (default: instrument if "
                 "a receiver has this role, else right)");
  app.add_option("--point", o.points,
                 "For room and phantom: position x,y,z of a known point, m (repeatable, in the order in "
                 "which you touch the points)");
  app.add_option("--target", o.targets,
                 "For phantom: position x,y,z at which the expected error is reported, m (repeatable; "
                 "default: the centre of the points)");
  add_field(app, o);
  app.add_option("--hand", o.hand, "glove: left or right")
      ->check(CLI::IsMember({"left", "right"}))
      ->capture_default_str();
  app.add_option("--seconds", o.seconds, "For noise and latency: duration of the measurement, s")
      ->check(CLI::Range(1.0, 3600.0))
      ->capture_default_str();
  CLI::Option* reference =
      app.add_option("--reference", o.against,
                     "For latency: log file of a simulated device, or DRIVER:PATH of a second device that "
                     "moves together with the receiver");
  accept_former_name(app, *reference, "--against");
  add_eyes(app, o);
  CLI::Option* timeout = app.add_option("--timeout", o.time_limit,
                                        "Time limit, s: stop with an error if the calibration takes longer");
  timeout->check(CLI::Range(1.0, 86400.0))->capture_default_str();
  accept_former_name(app, *timeout, "--patience");
}

int calibrate(const CalibrateOptions& o) {
  const ClientConfig config = load_client_config(o.config);
  const Calibration c{o, config, parse_role(o.station, config)};
  const auto row = std::find_if(procedures.begin(), procedures.end(),
                                [&](const Procedure& p) { return o.what == p.name; });
  print_outcome(row->run(c), o);
  return 0;
}

}  // namespace prosector
