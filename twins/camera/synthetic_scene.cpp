#include "twins/camera/synthetic_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "common/error.h"
#include "common/eye_distance.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/paths.h"
#include "drivers/camera/base/camera_frames.h"
#include "drivers/camera/base/image_reader.h"
#include "drivers/camera/tags/standard_boards.h"
#include "drivers/files/toml_fields.h"
#include "twins/camera/painted_clock.h"

namespace prosector {
namespace {

constexpr double most_seconds = 86400;
constexpr int most_side_px = 4096;
constexpr double most_metres = 10;
constexpr int wood_side = 512;  // pixels

struct FaultName {
  const char* name;
  CameraFault fault;
};
constexpr std::array<FaultName, 6> fault_names = {{{"torn", CameraFault::torn},
                                                   {"black", CameraFault::black},
                                                   {"resized", CameraFault::resized},
                                                   {"upside_down", CameraFault::upside_down},
                                                   {"slow", CameraFault::slow},
                                                   {"unplugged", CameraFault::unplugged}}};

Carrier read_carrier(const TomlFields& fields, const std::string& name) {
  Carrier carrier{fields.text("name", name), fields.pose(), {}, 0, fields.flag("loop", false), {}};
  if (fields.has("motion")) carrier.motion = MotionScript::load(fields.file("motion"));
  carrier.station = static_cast<std::size_t>(fields.whole("station", 1, max_stations, 1) - 1);
  return carrier;
}

Lens read_lens(const TomlFields& fields) {
  Lens lens;
  lens.width = fields.whole("width", 16, most_side_px, lens.width);
  lens.height = fields.whole("height", 16, most_side_px, lens.height);
  lens.fx = lens.fy = fields.number("focal", 50, 1e5, 600);
  std::array<double, 2> centre = {0.5 * (lens.width - 1), 0.5 * (lens.height - 1)};
  if (fields.has("centre")) fields.numbers("centre", centre, 0, most_side_px);
  lens.cx = centre[0];
  lens.cy = centre[1];
  std::array<double, 5> bend{};
  if (fields.has("distortion")) fields.numbers("distortion", bend, -1, 1);
  lens.k1 = bend[0];
  lens.k2 = bend[1];
  lens.p1 = bend[2];
  lens.p2 = bend[3];
  lens.k3 = bend[4];
  return lens;
}

void read_camera(const TomlFields& fields, SyntheticScene& scene) {
  scene.lens = read_lens(fields);
  scene.rate = fields.number("rate", 0.1, 240, scene.rate);
  scene.exposure = fields.number("exposure", 0, 1, scene.exposure);
  scene.readout = fields.number("readout", 0, 1, scene.readout);
  scene.delay = fields.number("delay", 0, 10, scene.delay);
  scene.rays = fields.whole("rays", 1, 8, scene.rays);
  scene.clock = fields.flag("clock", scene.clock);
  if (scene.clock && clock_cell(scene.lens.width) == 0)
    fields.fail("clock", "the clock needs images at least 40 pixels wide");
  scene.sensor.light = fields.number("light", 0, 4, scene.sensor.light);
  scene.sensor.blur = fields.number("blur", 0, 10, scene.sensor.blur);
  scene.sensor.noise = fields.number("noise", 0, 100, scene.sensor.noise);
  scene.sensor.response = fields.number("response", 1, 3, scene.sensor.response);
  scene.sensor.jpeg = fields.whole("jpeg", 0, 100, scene.sensor.jpeg);
  scene.sensor.seed = static_cast<unsigned>(fields.whole("seed", 0, 1 << 30, 1));
  scene.camera = read_carrier(fields, "camera");
  fields.reject_unknown_keys();
}

CameraFaultSpan read_fault(const TomlFields& fields) {
  const std::string name = fields.text("kind");
  const auto* at = std::find_if(fault_names.begin(), fault_names.end(),
                                [&](const FaultName& row) { return name == row.name; });
  if (at == fault_names.end())
    fields.fail("kind", "must be torn, black, resized, upside_down, slow or unplugged");
  const CameraFaultSpan span{at->fault, fields.number("from", 0, most_seconds),
                             fields.number("to", 0, most_seconds)};
  fields.reject_unknown_keys();
  return span;
}

Image plain(const std::array<double, 3>& colour) {
  Image image{1, 1, {}};
  for (const double c : colour) image.rgb.push_back(static_cast<std::uint8_t>(c));
  return image;
}

TexturedQuad read_plate(const TomlFields& fields, const Response& response) {
  TexturedQuad thing;
  thing.width = fields.number("width", 1e-3, most_metres);
  thing.both_sides = true;
  if (fields.has("picture")) {
    const Image picture = read_image(fields.file("picture"));
    thing.texture = std::make_shared<Texture>(picture, true, response);
    thing.height = thing.width * picture.height / picture.width;
  } else {
    thing.height = fields.number("height", 1e-3, most_metres);
    if (fields.flag("wood", false)) {
      thing.texture = std::make_shared<Texture>(wood(wood_side, 1), true, response);
    } else {
      std::array<double, 3> colour{};
      fields.numbers("colour", colour, 0, 255);
      thing.texture = std::make_shared<Texture>(plain(colour), false, response);
    }
  }
  return thing;
}

FaceMesh read_face(const TomlFields& fields) {
  if (!fields.flag("ct", false))
    return make_face(fields.number("eye_distance", 0.04, 0.1, default_interpupillary_distance));
  try {
    return load_ct_face(default_data_dir() / "head.nii");
  } catch (const InputError& error) {
    fields.fail("ct", error.what());
  }
}

/// Returns a tag as an image with one pixel per cell. Ink isn't quite black, paper not quite white.
Image printed(int code) {
  constexpr std::uint8_t ink = 25, paper = 235;
  Image image{tag_cells, tag_cells, {}};
  for (const auto& row : tag_ink(code))
    for (const bool black : row) image.rgb.insert(image.rgb.end(), 3, black ? ink : paper);
  return image;
}

}  // namespace

std::size_t SyntheticScene::add_board(const Board& board, Carrier carrier) {
  const Response response(sensor.response);
  const std::size_t index = carriers.size();
  carriers.push_back(std::move(carrier));
  boards.push_back(board);
  board_carriers.push_back(index);
  const auto paper = std::make_shared<const Texture>(plain({235, 235, 235}), false, response);
  const double rim = static_cast<double>(tag_cells) / black_cells;
  if (board.picture) {
    things.push_back({index,
                      {},
                      board.picture->width,
                      board.picture->height(),
                      std::make_shared<const Texture>(board.picture->image, true, response),
                      false});
    return index;
  }
  if (board.is_flat()) {
    Eigen::AlignedBox2d box;
    for (const BoardTag& tag : board.tags)
      for (const Vec3& corner : tag.corners()) box.extend(corner.head<2>());
    const Eigen::Vector2d middle = box.center(), size = box.sizes();
    const double more = board.tags.front().size * (rim - 1);
    things.push_back({index,
                      {{middle.x(), middle.y(), 0}, Quat::Identity()},
                      size.x() + more,
                      size.y() + more,
                      paper,
                      true});
  }
  for (const BoardTag& tag : board.tags)
    things.push_back({index, tag.pose, rim * tag.size, rim * tag.size,
                      std::make_shared<const Texture>(printed(tag.code), false, response), false});
  return index;
}

SyntheticScene SyntheticScene::load(const std::filesystem::path& file) {
  const TomlFields fields = TomlFields::load(file, "synthetic scene");
  SyntheticScene scene;
  for (const TomlFields& camera : fields.tables("camera")) read_camera(camera, scene);
  scene.ambient = fields.number("ambient", 0, 1, scene.ambient);
  for (const TomlFields& plate : fields.tables("plate")) {
    TexturedQuad thing = read_plate(plate, Response(scene.sensor.response));
    thing.carrier = scene.carriers.size();
    scene.carriers.push_back(read_carrier(plate, fmt::format("plate {}", scene.carriers.size() + 1)));
    scene.things.push_back(thing);
    plate.reject_unknown_keys();
  }
  for (const TomlFields& one : fields.tables("board")) {
    const std::string known = one.text("known", "");
    const Board board = known.empty() ? load_board(one.file("file")) : find_board(known);
    Carrier carrier = read_carrier(one, board.name);
    if (one.flag("worn", false)) carrier.offset = board_wearer_pose(known).inverse();
    scene.add_board(board, std::move(carrier));
    one.reject_unknown_keys();
  }
  for (const TomlFields& hand : fields.tables("hand")) {
    scene.hands.push_back({scene.carriers.size(), hand.flag("left", false) ? left_hand : right_hand,
                           hand.number("size", 0.5, 2, 1)});
    scene.carriers.push_back(read_carrier(hand, fmt::format("hand {}", scene.hands.size())));
    hand.reject_unknown_keys();
  }
  for (const TomlFields& face : fields.tables("face")) {
    scene.faces.push_back({scene.carriers.size(), std::make_shared<const FaceMesh>(read_face(face))});
    scene.carriers.push_back(read_carrier(face, fmt::format("face {}", scene.faces.size())));
    face.reject_unknown_keys();
  }
  for (const TomlFields& fault : fields.tables("fault")) scene.faults.push_back(read_fault(fault));
  fields.reject_unknown_keys();
  return scene;
}

SyntheticTruth SyntheticScene::truth(double seconds) const {
  SyntheticTruth truth{seconds, camera.at(seconds) * device_camera, {}};
  for (const Carrier& carrier : carriers) truth.room_things.push_back(carrier.at(seconds));
  return truth;
}

}  // namespace prosector
