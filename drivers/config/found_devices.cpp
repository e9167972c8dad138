#include "drivers/config/found_devices.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace prosector {
namespace {

namespace fs = std::filesystem;

constexpr const char* glove_vendor = "5D70";  // USB vendor id of the 5DT Data Glove Ultra

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> out;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) out.push_back(entry.path().filename());
  std::sort(out.begin(), out.end());
  return out;
}

/// Returns the value of NAME=VALUE in a device's uevent file; empty if it is missing.
std::string uevent_value(const fs::path& file, const std::string& name) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(name + "=")) return line.substr(name.size() + 1);
  return {};
}

/// Returns the first line of a file; empty if it is unreadable.
std::string first_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

bool is_serial_port(const fs::path& root, const std::string& name) {
  if (name.starts_with("ttyUSB") || name.starts_with("ttyACM")) return true;
  if (!name.starts_with("ttyS")) return false;
  // The kernel also lists ports that do not exist; existing ports have an address.
  std::ifstream in(root / "sys/class/tty" / name / "port");
  std::string port;
  return in >> port && port != "0x0";
}

}  // namespace

std::vector<FoundDevice> found_devices(const fs::path& root) {
  std::vector<FoundDevice> out;
  for (const std::string& name : names_in(root / "sys/class/tty")) {
    if (!is_serial_port(root, name)) continue;
    const std::string path = "/dev/" + name;
    const std::string driver = uevent_value(root / "sys/class/tty" / name / "device/uevent", "DRIVER");
    out.push_back(
        {driver.empty() ? name : fmt::format("{}: {}", name, driver), {"fastrak:" + path, "5dt:" + path}});
  }
  for (const std::string& name : names_in(root / "sys/class/hidraw")) {
    const fs::path uevent = root / "sys/class/hidraw" / name / "device/uevent";
    if (uevent_value(uevent, "HID_ID").find(glove_vendor) == std::string::npos) continue;
    out.push_back({fmt::format("{}: {}", name, uevent_value(uevent, "HID_NAME")), {"5dt-usb:/dev/" + name}});
  }
  return out;
}

std::vector<FoundDevice> found_cameras(const fs::path& root) {
  std::vector<FoundDevice> out;
  for (const std::string& name : names_in(root / "sys/class/video4linux")) {
    const fs::path folder = root / "sys/class/video4linux" / name;
    // A device's further files provide metadata instead of images.
    if (first_line(folder / "index") != "0") continue;
    out.push_back({fmt::format("{}: {}", name, first_line(folder / "name")), {"/dev/" + name}});
  }
  return out;
}

}  // namespace prosector
