// Table of the device drivers.
#include <algorithm>

#include "drivers/camera/devices/face_device.h"
#include "drivers/camera/devices/hands_device.h"
#include "drivers/camera/devices/tags_device.h"
#include "drivers/config/device_config.h"
#include "drivers/device/device_address.h"
#include "drivers/device/driver_table.h"
#include "drivers/gloves/five_dt.h"
#include "drivers/recordings/recorded.h"
#include "drivers/trackers/fastrak.h"
#include "drivers/trackers/igtl_device.h"
#include "drivers/trackers/leap_device.h"
#include "drivers/trackers/space_mouse.h"
#include "drivers/trackers/vrpn_device.h"

namespace prosector {
namespace {

using Path = const std::string&;
using Config = const DeviceConfig&;

}  // namespace

const std::vector<DriverRow>& drivers() {
  static const std::vector<DriverRow> rows = {
      {"fastrak", "Polhemus FASTRAK tracker on a serial port, e.g. fastrak:/dev/ttyS0",
       [](Path path, Config c) { return open_fastrak(path, c.placement, c.fastrak); }},
      {"5dt", "5DT Data Glove 5 on a serial port, e.g. 5dt:/dev/ttyS1",
       [](Path path, Config c) { return open_five_dt(path, c.gestures, c.glove); }},
      {"5dt-wireless", "wireless 5DT Data Glove at its receiver's serial port, e.g. 5dt-wireless:/dev/ttyS1",
       [](Path path, Config c) { return open_five_dt_wireless(path, c.gestures, c.glove); }},
      {"5dt-usb", "5DT Data Glove Ultra over USB, e.g. 5dt-usb:/dev/hidraw0",
       [](Path path, Config c) { return open_five_dt_usb(path, c.gestures, c.glove); }},
      {"vrpn", "a tracker, buttons, analog or dials of a VRPN server, e.g. vrpn:Tracker0@lab",
       [](Path path, Config c) { return open_vrpn_device(path, c.placement, c.gestures, c.glove); }},
      {"igtl", "a tracker of an OpenIGTLink server, as igtl:HOST[:PORT][/TOOL,TOOL,...]",
       [](Path path, Config c) { return open_igtl(path, c.placement); }},
      {"leap", "both hands by Ultraleap's WebSocket, e.g. leap:localhost:6437",
       [](Path path, Config c) { return open_leap(path, c.placement, c.gestures); }, true},
      {"spacemouse", "a SpaceMouse by spacenavd's socket, e.g. spacemouse:/run/spnav.sock",
       [](Path path, Config c) { return open_space_mouse(path, c.placement); }},
      {"tags",
       "printed boards tracked by a camera, e.g. tags:0, tags:/dev/video0, tags:clip.mkv, "
       "tags:synthetic:SCENE.toml",
       [](Path path, Config c) { return open_tags(path, c.placement, c.camera, c.tags); }, false, true},
      {"hands", "bare hands tracked by one or two cameras, as hands:CAMERA[,CAMERA], e.g. hands:0",
       [](Path path, Config c) { return open_hands(path, c.placement, c.camera, c.hands, c.gestures); }, true,
       true},
      {"face", "the eyes tracked by a camera, as face:CAMERA, e.g. face:0; station 1 is between the eyes",
       [](Path path, Config c) { return open_face(path, c.placement, c.camera, c.face); }, false, true, true},
      {"recorded", "samples from a CSV file, played once, e.g. recorded:hand.csv",
       [](Path path, Config) { return open_recorded(path); }},
      {"recorded-loop", "samples from a CSV file, played repeatedly, e.g. recorded-loop:hand.csv",
       [](Path path, Config) { return open_recorded_loop(path); }},
  };
  return rows;
}

DeviceAddress parse_device_address(const std::string& address) {
  return split_address("device", address, drivers());
}

const DriverRow& driver_of(const std::string& address) {
  const DeviceAddress parsed = parse_device_address(address);
  return *std::find_if(drivers().begin(), drivers().end(),
                       [&](const DriverRow& r) { return parsed.driver == r.name; });
}

std::string first_camera(const std::string& address) {
  if (address.empty() || !driver_of(address).is_camera) return "";
  const std::string path = parse_device_address(address).path;
  return path.substr(0, path.find(','));
}

std::unique_ptr<Device> open_device(const std::string& address, const DeviceConfig& config) {
  return driver_of(address).open(parse_device_address(address).path, config);
}

}  // namespace prosector
