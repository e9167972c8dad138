#include "client/setup/devices_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "client/setup/draft_changes.h"
#include "client/setup/side_by_side.h"

namespace prosector {
namespace {

constexpr std::int64_t look_again_ns = 2'000'000'000, assign_ns = 6'000'000'000;

struct RoleWord {
  StationRole role;
  const char* key;
  const char* name;
  const char* instruction;
};
constexpr std::array<RoleWord, 3> roles = {
    {{StationRole::right_hand, "right", msg("right hand"), msg("Move your right hand.")},
     {StationRole::left_hand, "left", msg("left hand"), msg("Move your left hand.")},
     {StationRole::head, "head", msg("head"), msg("Move your head.")}}};

const std::string& address_in(const ClientConfig& config, std::size_t field) {
  switch (field) {
    case 0:
      return config.tracker;
    case 1:
      return config.gloves[right_hand].address;
    case 2:
      return config.gloves[left_hand].address;
    default:
      return config.arm.address;
  }
}

std::string pose_words(const Pose& pose) {
  return fmt::format("{:+.3f} {:+.3f} {:+.3f} m   {:+.2f} {:+.2f} {:+.2f} {:+.2f}", pose.p.x(), pose.p.y(),
                     pose.p.z(), pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z());
}

}  // namespace

void DevicesPage::draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns) {
  look(draft, now_ns);
  const auto which = [&] {
    draw_addresses(ui, draft);
    draw_status(ui);
    ImGui::Separator();
    if (draw_draft_changes(ui, draft, said_)) watch_.reset();
  };
  draw_side_by_side(ui, 0.44, which, [&] { draw_device(ui, draft, now_ns); });
}

/// Opens the devices of the draft, reads them, and regularly searches for connected ones.
void DevicesPage::look(const ConfigDraft& draft, std::int64_t now_ns) {
  if (!watch_) {
    watch_ = std::make_unique<DeviceWatch>(draft.config());
    for (std::size_t k = 0; k < fields_.size(); ++k) fields_[k].text = address_in(draft.config(), k);
  }
  watch_->poll(now_ns);
  if (found_ns_ != 0 && now_ns - found_ns_ < look_again_ns) return;
  found_ns_ = now_ns;
  found_ = found_devices();
}

void DevicesPage::change(ConfigDraft& draft, const std::vector<ConfigChange>& changes,
                         const std::string& done) {
  if (const std::string why = draft.change(changes); !why.empty()) {
    said_ = {why, true};
    return;
  }
  said_ = {done, false};
  watch_.reset();
}

void DevicesPage::draw_addresses(Interface& ui, ConfigDraft& draft) {
  title(ui.tr("Devices"));
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    AddressField& field = fields_[k];
    if (edit_address(ui, field, found_, ui.tr("No serial port or glove is connected.")) &&
        field.text != address_in(draft.config(), k))
      change(draft, {{field.key, field.text}},
             fmt::format("{}: {}", ui.tr(field.name), field.text.empty() ? ui.tr("none") : field.text));
  }
  if (!draft.problem().empty()) warning(draft.problem());
}

void DevicesPage::draw_status(Interface& ui) {
  const std::vector<WatchedDevice>& devices = watch_ ? watch_->devices() : std::vector<WatchedDevice>();
  ImGui::Separator();
  if (devices.empty()) {
    quiet(ui.tr("No device is configured. Enter an address, DRIVER:PATH, or choose a connected device."));
    return;
  }
  for (std::size_t k = 0; k < devices.size(); ++k) {
    const WatchedDevice& device = devices[k];
    double rate = 0;
    for (const WatchedStation& station : device.stations) rate = std::max(rate, station.rate);
    const std::string label =
        ui.tr("{}: {}, {:.0f} Hz, {} records, {} resyncs, {} reconnects", ui.tr(device.name),
              ui.tr(std::string(health_name(device.status.health))), rate, device.status.records,
              device.status.resyncs, device.status.reopens) +
        "###" + device.name;
    if (ImGui::Selectable(label.c_str(), k == shown_)) shown_ = k;
    ui.note(device.name);
    if (!device.status.message.empty()) warning(device.status.message);
  }
}

void DevicesPage::draw_device(Interface& ui, ConfigDraft& draft, std::int64_t now_ns) {
  if (!watch_ || shown_ >= watch_->devices().size()) {
    title(ui.tr("Reported data"));
    quiet(ui.tr("Choose a device on the left."));
    return;
  }
  const WatchedDevice& device = watch_->devices()[shown_];
  title(ui.tr(device.name) + "   " + device.address);
  if (device.stations.empty()) quiet(ui.tr("No data received yet."));
  for (const WatchedStation& station : device.stations) {
    const DeviceSample& s = station.last;
    ImGui::Separator();
    if (device.kind == WatchedKind::tracker)
      wrapped(ui.tr("Receiver {}   {:.0f} Hz ± {:.1f} ms   moved {:.2f} m", s.station + 1, station.rate,
                    1e3 * station.jitter, station.moved));
    if (s.has_pose) {
      wrapped(ui.tr("in the room   {}", pose_words(s.pose)));
      if (device.kind == WatchedKind::tracker)
        quiet(ui.tr("as sent   {:.3f} {:.3f} {:.3f}   {:.3f} {:.3f} {:.3f} {:.3f}", s.raw_pose[0],
                    s.raw_pose[1], s.raw_pose[2], s.raw_pose[3], s.raw_pose[4], s.raw_pose[5],
                    s.raw_pose[6]));
    }
    if (s.buttons != 0) wrapped(ui.tr("buttons {:#b}", s.buttons));
    constexpr std::array names = {msg("thumb"), msg("index"), msg("middle"), msg("ring"), msg("little")};
    for (std::size_t f = 0; s.has_flexion && f < fingers; ++f) {
      ImGui::ProgressBar(static_cast<float>(s.flexion[f]), {0.6f * ImGui::GetContentRegionAvail().x, 0},
                         fmt::format("{} {:.2f}", ui.tr(names[f]), s.flexion[f]).c_str());
      ImGui::SameLine();
      quiet(fmt::format("{}", s.raw_flexion[f]));
    }
  }
  if (device.kind == WatchedKind::tracker) draw_roles(ui, draft, device, now_ns);
}

void DevicesPage::draw_roles(Interface& ui, ConfigDraft& draft, const WatchedDevice& tracker,
                             std::int64_t now_ns) {
  ImGui::Separator();
  title(ui.tr("Receiver assignment"));
  for (const RoleWord& role : roles) {
    const auto& stations = draft.config().stations;
    const auto at = std::find(stations.begin(), stations.end(), role.role);
    ImGui::AlignTextToFramePadding();
    wrapped(fmt::format("{}: {}", ui.tr(role.name),
                        at == stations.end() ? std::string(ui.tr("nothing"))
                                             : ui.tr("receiver {}", at - stations.begin() + 1)));
    ImGui::SameLine(220 * static_cast<float>(ui.scale()));
    if (ImGui::Button(fmt::format("{}##{}", ui.tr("Assign by moving"), role.key).c_str())) {
      assigned_ = role.role;
      assigned_until_ns_ = now_ns + assign_ns;
    }
    ui.note(fmt::format("move {}", role.key));
    if (at != stations.end()) {
      ImGui::SameLine();
      const bool taken = ImGui::Button(fmt::format("{}##{}", ui.tr("Remove"), role.key).c_str());
      ui.note(fmt::format("free {}", role.key));
      if (taken) {
        free_role(ui, draft, role.role);
        return;
      }
    }
    if (assigned_ != role.role) continue;
    const auto moving = moving_station(tracker);
    if (moving) {
      assigned_.reset();
      assign(ui, draft, role.role, *moving);
      return;
    }
    if (now_ns > assigned_until_ns_) {
      assigned_.reset();
      said_ = {msg("No receiver moved clearly farther than the others. Try again, and move only one."), true};
      return;
    }
    wrapped(ui.tr(role.instruction));
  }
}

/// Removes the receiver from a role. Its mount stays in the configuration.
void DevicesPage::free_role(const Interface& ui, ConfigDraft& draft, StationRole role) {
  const auto& stations = draft.config().stations;
  if (std::count(stations.begin(), stations.end(), StationRole::none) + 1 ==
      static_cast<std::ptrdiff_t>(stations.size())) {
    said_ = {
        "This is the only receiver in use, so it cannot be removed. To use no receiver, clear the tracker "
        "with the arrow next to its field.",
        true};
    return;
  }
  const auto word =
      std::find_if(roles.begin(), roles.end(), [&](const RoleWord& w) { return w.role == role; });
  change(draft, {{fmt::format("tracker.stations.{}.station", word->key), 0.}},
         ui.tr("No receiver is assigned to the {}.", ui.tr(word->name)));
}

/// Assigns a receiver to a role. If it had another role, the two receivers swap roles.
void DevicesPage::assign(const Interface& ui, ConfigDraft& draft, StationRole role, std::uint32_t station) {
  const auto& stations = draft.config().stations;
  const auto word_of = [&](StationRole wanted) {
    return std::find_if(roles.begin(), roles.end(),
                        [&](const RoleWord& word) { return word.role == wanted; });
  };
  const auto set = [](const RoleWord& word, std::size_t to) {
    return ConfigChange{fmt::format("tracker.stations.{}.station", word.key), static_cast<double>(to + 1)};
  };
  const RoleWord& own = *word_of(role);
  std::vector<ConfigChange> changes = {set(own, station)};
  const auto other = word_of(stations[station]);
  const auto before = std::find(stations.begin(), stations.end(), role);
  if (other != roles.end() && other->role != role) {
    if (before == stations.end()) {
      said_ = {ui.tr("Receiver {} is assigned to the {}: assign another receiver to that role first.",
                     station + 1, ui.tr(other->name)),
               true};
      return;
    }
    changes.push_back(set(*other, static_cast<std::size_t>(before - stations.begin())));
  }
  change(draft, changes, ui.tr("Receiver {} is assigned to the {}.", station + 1, ui.tr(own.name)));
}

}  // namespace prosector
