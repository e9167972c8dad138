#include "common/scene/scene_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/scene/body_fields.h"
#include "common/scene_messages.h"

namespace prosector {
namespace {

const Table& session_table() {
  using S = SessionDesc;
  static const Table table{
      "[session]",
      "Session name and limits.",
      {name<S, &S::name>("name", not_hashed, false, "name by which clients find the session"),
       number<S, &S::capacity>("capacity", not_hashed, "people", {1, 1024},
                               "maximum number of participants, observers included"),
       number<S, &S::observers>("observers", not_hashed, "people", {0, 1024},
                                "maximum number of observers among the participants"),
       number<S, &S::input_timeout>("input_timeout", not_hashed, "s", {0.05, 60},
                                    "time after which a hand that is no longer tracked releases its hold; "
                                    "hands of a silent client stay for at least 5 s")},
      {},
      fresh<S>};
  return table;
}

const Table& hand_table() {
  using H = HandDesc;
  static const Table table{
      "[hand]",
      "The table `[hand]` sets the virtual coupling that pulls a simulated hand to its tracked pose.",
      {number<H, &H::mass>("mass", by_value, "kg", {0.01, 10}, "mass of the simulated hand"),
       number<H, &H::stiffness>("stiffness", by_value, "N/m", {0, 1e5, true},
                                "stiffness of the coupling to the tracked pose"),
       number<H, &H::max_force>("max_force", by_value, "N", {0, 1000, true},
                                "maximum force of the coupling to the tracked pose; one fifth of it for each "
                                "finger"),
       number<H, &H::tear_force>("tear_force", by_value, "N", {0, 1e4, true},
                                 "force between a hand and the held body above which the grasp is lost"),
       number<H, &H::friction>("friction", by_value, "", friction,
                               "Coulomb friction coefficient of the hand's skin")},
      {},
      fresh<H>};
  return table;
}

const Table& room_table() {
  using R = RoomDesc;
  static const Table table{
      "[room]",
      "The table `[room]` sets the room around the scene, 7 m by 7 m. A body that leaves the room is moved "
      "back to its initial position. Hands pass through the room's floor and walls.",
      {plain<R, &R::floor>("floor", by_value,
                           "true: bodies rest on the floor; false: they fall through the drawn floor"),
       plain<R, &R::walls>("walls", by_value,
                           "true: the walls stop bodies; false: bodies pass through them")},
      {},
      fresh<R>};
  return table;
}

const Table& camera_table() {
  using C = CameraInfo;
  static const Table table{
      "[camera]",
      "Default view of clients.",
      {number<C, &C::eye>("eye", not_hashed, "m", coordinate, "position of the view's eye in the room"),
       number<C, &C::target>("target", not_hashed, "m", coordinate,
                             "point at the view's centre; must differ from eye"),
       number<C, &C::fov>("fov", not_hashed, "rad", {0, 3, true}, "vertical field of view")},
      {},
      fresh<C>};
  return table;
}

const Table& patient_table() {
  using P = PatientFrame;
  static const Table table{
      "[patient]",
      "Orientation of the patient. In a scene with the table `[patient]`, the axes in the corner of the view "
      "are labelled R, L (right, left), A, P (anterior, posterior), S, I (superior, inferior).",
      {number<P, &P::right>("right", not_hashed, "", {-1000, 1000},
                            "direction towards the patient's right; of any length"),
       number<P, &P::head>("head", not_hashed, "", {-1000, 1000},
                           "direction from feet to head, perpendicular to right; of any length")},
      {},
      fresh<P>};
  return table;
}

const Table& light_table() {
  using L = LightDesc;
  static const Table table{
      "[[light]]",
      "",
      {name<L, &L::name>("name", not_hashed, false, "unique among the lights"),
       words<L, &L::kind>("kind", not_hashed, {"directional", "point", "spot"}, "type of light"),
       name<L, &L::carrier>(
           "body", not_hashed, false,
           "body that the light is fixed to; position and direction are then in the body's frame"),
       number<L, &L::position>("position", not_hashed, "m", coordinate,
                               "point, spot: position of the light in the room"),
       number<L, &L::direction>("direction", not_hashed, "", {-1000, 1000},
                                "directional, spot: direction of the light; any non-zero length"),
       number<L, &L::color>("color", not_hashed, "", unit_interval, "linear red, green, blue"),
       number<L, &L::intensity>("intensity", not_hashed, "", {0, 1000}, "factor of the colour"),
       number<L, &L::cone>("cone", not_hashed, "rad", {0, 1.57, true}, "spot: half angle"),
       number<L, &L::softness>("softness", not_hashed, "", unit_interval,
                               "spot: fraction of the cone over which the light fades")},
      {},
      fresh<L>};
  return table;
}

std::string interval(const Range& r) {
  return fmt::format("{}{}, {}{}", r.open_min ? '(' : '[', r.min, r.max, r.open_max ? ')' : ']');
}

}  // namespace

const Table& scene_table() {
  using SD = SceneDesc;
  static const Table table{
      "",
      "Top-level keys of a scene file, written before its first table:",
      {name<SD, &SD::name>("name", not_hashed, true, "the scene's name"),
       text<SD, &SD::description>("description", not_hashed, "description for users"),
       text<SD, &SD::labels>("labels", not_hashed,
                             "table of body names in several languages, with ids of Terminologia Anatomica; "
                             "format: see [[atlas]]"),
       number<SD, &SD::gravity>("gravity", by_value, "m/s²", {-100, 100}, "y is up"),
       number<SD, &SD::tick_rate>("tick_rate", by_value, "Hz", {10, 1000}, "steps per simulated second"),
       number<SD, &SD::contact_stiffness>("contact_stiffness", by_value, "", {0, 1e4, true},
                                          "contact stiffness with a soft body, relative to that body's own "
                                          "stiffness over one surface cell")},
      {{"session", session_table, false, 1, items<SD, &SD::session>},
       {"hand", hand_table, false, 1, items<SD, &SD::hand>},
       {"room", room_table, false, 1, items<SD, &SD::room>},
       {"camera", camera_table, false, 1, items<SD, &SD::camera>},
       {"patient", patient_table, false, 1, items<SD, &SD::patient>},
       {"rigid", rigid_table, true, max_bodies, items<SD, &SD::rigid>},
       {"soft", soft_table, true, max_bodies, items<SD, &SD::soft>},
       {"atlas", atlas_table, true, max_atlases, items<SD, &SD::atlases>},
       {"light", light_table, true, max_lights, items<SD, &SD::lights>}},
      fresh<SD>};
  return table;
}

std::string allowed(const Field& field, const FieldRef& value) {
  if (!field.words.empty()) return fmt::format("one of: {}", fmt::join(field.words, ", "));
  struct {
    const Field& f;
    std::string operator()(double*) const { return "in " + interval(f.range); }
    std::string operator()(int*) const { return "a whole number in " + interval(f.range); }
    std::string operator()(bool*) const { return "true or false"; }
    std::string operator()(Vec3*) const { return "three numbers in " + interval(f.range); }
    std::string operator()(Quat*) const { return "four numbers [w, x, y, z], not all zero"; }
    std::string operator()(std::uint8_t*) const { return ""; }  // always has words
    std::string operator()(Quantity*) const {
      return fmt::format("text: a number in {} and its unit, e.g. \"2 {}\"", interval(f.range), f.unit);
    }
    std::string operator()(std::vector<std::string>*) const {
      return fmt::format("a list of names, each at most {} bytes", f.max_length);
    }
    std::string operator()(std::vector<double>*) const {
      return fmt::format("a list of at most {1} numbers in {0}", interval(f.range), f.max_length);
    }
    std::string operator()(std::vector<Vec3>*) const {
      return fmt::format("a list of at most {1} points [x, y, z] in {0}", interval(f.range), f.max_length);
    }
    std::string operator()(std::string*) const {
      if (f.text == Text::identifier)
        return "a word of a-z, 0-9 and _ that starts with a letter; maximum length: " +
               std::to_string(f.max_length);
      const char* what = f.text == Text::name ? "1 to {} bytes of text without control characters"
                                              : "text of at most {} bytes";
      return fmt::format(fmt::runtime(what), f.max_length);
    }
  } describe{field};
  return std::visit(describe, value);
}

}  // namespace prosector
