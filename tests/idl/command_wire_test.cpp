// Each command through the wire and back, and the fields of the wire form that it uses. Peers and recordings
// of them rely on these.

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <random>
#include <tuple>

#include "idl/wire/codec.h"
#include "idl/wire/convert.h"

namespace prosector {
namespace {

prosector_Command wire_form(const CommandBody& body) {
  WireArena arena;
  prosector_Command out;
  to_wire(Command{7, 3, body}, out, arena);
  return out;
}

/// Returns all fields of a wire form, to be compared.
auto fields(const prosector_Command& w) {
  return std::tuple(w.participant, w.number, w.kind, w.hand, w.body, w.subject, w.role,
                    std::to_array(w.shape.a), std::to_array(w.shape.p), w.control_id, w.value, w.revision);
}

TEST(CommandWire, NumbersAndNamesStay) {
  constexpr std::array<std::string_view, 23> names = {
      "join",        "grasp",  "release",    "reset",           "leave",       "set_role",
      "detach",      "attach", "inspect",    "end_inspect",     "open_panel",  "close_panel",
      "set_control", "undo",   "rewind",     "keyframe",        "set_pace",    "step_ticks",
      "reset_all",   "seek",   "set_effort", "set_all_efforts", "set_accuracy"};
  for (std::size_t k = 0; k < names.size(); ++k) EXPECT_EQ(command_names[k], names[k]);
}

/// A command, and how its wire form differs from that of a command without members.
struct Form {
  CommandBody body;
  std::function<void(prosector_Command&)> set;
};

std::vector<Form> forms() {
  using W = prosector_Command;
  const auto nothing = [](W&) {};
  const auto body_3 = [](W& w) { w.body = 3; };
  const Affine shape{(Mat3() << 2, 0.5, 0, 0, 3, 0, 0, 0, 4).finished(), {0.25, 1, -1}};
  return {{Join{}, nothing},
          {Grasp{left_hand}, [](W& w) { w.hand = 0; }},
          {Grasp{right_hand, 3}, [](W& w) { w.body = 3, w.revision = 1; }},
          {Grasp{right_hand, 0}, [](W& w) { w.revision = 1; }},
          {Release{left_hand}, [](W& w) { w.hand = 0; }},
          {ResetBody{3, left_hand}, [](W& w) { w.body = 3, w.hand = 0; }},
          {Leave{}, nothing},
          {SetRole{9, Role::host}, [](W& w) { w.subject = 9, w.role = 2; }},
          {Detach{3}, body_3},
          {Attach{3}, body_3},
          {Inspect{3, shape},
           [](W& w) {
             w.body = 3;
             w.shape = {{2, 0.5, 0, 0, 3, 0, 0, 0, 4}, {0.25, 1, -1}};
           }},
          {EndInspect{3}, body_3},
          {OpenPanel{3}, body_3},
          {OpenPanel{3, PanelPlacement::put, {1, 2, 3}},
           [](W& w) {
             w.body = 3;
             w.revision = 1;
             for (int k = 0; k < 3; ++k) w.shape.p[k] = k + 1;
           }},
          {OpenPanel{3, PanelPlacement::put_back}, [](W& w) { w.body = 3, w.revision = 2; }},
          {ClosePanel{}, nothing},
          {SetControl{PanelControl::stiffness, 0.75}, [](W& w) { w.control_id = 5, w.value = 0.75; }},
          {Undo{}, nothing},
          {Rewind{3, 12}, [](W& w) { w.body = 3, w.revision = 12; }},
          {RequestKeyframe{3}, body_3},
          {SetPace{2}, [](W& w) { w.value = 2; }},
          {StepTicks{60}, [](W& w) { w.revision = 60; }},
          {ResetAll{}, nothing},
          {Seek{4711}, [](W& w) { w.revision = 4711; }},
          {SetEffort{3, 2}, [](W& w) { w.body = 3, w.revision = 2; }},
          {SetAllEfforts{2}, [](W& w) { w.revision = 2; }},
          {SetAccuracy{3, 5}, [](W& w) { w.body = 3, w.value = 5; }}};
}

TEST(CommandWire, EachCommandUsesItsFieldsAndNoOther) {
  std::array<bool, command_kinds> seen{};
  for (const Form& form : forms()) {
    SCOPED_TRACE(command_names[form.body.index()]);
    seen.at(form.body.index()) = true;
    prosector_Command expected{};
    expected.participant = 7;
    expected.number = 3;
    expected.kind = static_cast<std::uint8_t>(form.body.index());
    expected.hand = right_hand;
    for (const int diagonal : {0, 4, 8}) expected.shape.a[diagonal] = 1;
    form.set(expected);
    EXPECT_EQ(fields(wire_form(form.body)), fields(expected));
  }
  for (std::size_t k = 0; k < command_kinds; ++k) EXPECT_TRUE(seen[k]) << command_names[k];
}

/// Draws valid values of members.
class Drawn {
 public:
  std::uint8_t hand() { return static_cast<std::uint8_t>(below(2)); }
  BodyId body() { return below(max_bodies); }
  std::uint32_t number() { return below(std::numeric_limits<std::uint32_t>::max()); }
  double within(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  Vec3 position() { return {within(-1000, 1000), within(-1000, 1000), within(-1000, 1000)}; }
  Affine shape() {
    Affine out{Mat3::Identity() * within(1, 50), position()};
    out.A(0, 1) = within(-50, 50);
    out.A(2, 0) = within(-1, 1);
    return out;
  }
  std::uint32_t below(std::uint32_t end) {
    return std::uniform_int_distribution<std::uint32_t>(0, end - 1)(random_);
  }
  /// Returns a command of each kind.
  std::array<CommandBody, command_kinds> commands() {
    return {Join{},
            Grasp{hand(), below(2) == 0 ? std::nullopt : std::optional(body())},
            Release{hand()},
            ResetBody{body(), hand()},
            Leave{},
            SetRole{std::uint64_t{number()} << 32 | number(), static_cast<Role>(below(3))},
            Detach{body()},
            Attach{body()},
            Inspect{body(), shape()},
            EndInspect{body()},
            OpenPanel{body(), static_cast<PanelPlacement>(below(3)), position()},
            ClosePanel{},
            SetControl{static_cast<PanelControl>(below(panel_control_count)), within(0, 1)},
            Undo{},
            Rewind{body(), number()},
            RequestKeyframe{body()},
            SetPace{within(0, max_pace)},
            StepTicks{number()},
            ResetAll{},
            Seek{number()},
            SetEffort{body(), number()},
            SetAllEfforts{number()},
            SetAccuracy{body(), within(0, max_accuracy)}};
  }

 private:
  std::mt19937 random_{20};
};

TEST(CommandWire, RandomCommandsComeBackEqual) {
  Drawn drawn;
  for (int round = 0; round < 200; ++round)
    for (const CommandBody& body : drawn.commands()) {
      SCOPED_TRACE(command_names[body.index()]);
      Message received;
      std::size_t bytes = 0;
      const Refusal refusal = through_the_wire(Command{7, 3, body}, received, bytes);
      ASSERT_FALSE(refusal) << refusal.why();
      const Command& command = std::get<Command>(received);
      EXPECT_EQ(command.participant, 7u);
      EXPECT_EQ(command.sequence, 3u);
      ASSERT_EQ(command.body.index(), body.index());
      EXPECT_EQ(fields(wire_form(command.body)), fields(wire_form(body)));
    }
}

struct Malformed {
  std::function<void(prosector_Command&)> spoil;
  const char* reason;
};

TEST(CommandWire, MalformedFieldsAreRefusedAlsoWhereTheCommandDoesNotUseThem) {
  using W = prosector_Command;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Malformed> table = {
      {[](W& w) { w.shape.p[1] = 1e6; }, "the offset of a part's displayed shape is out of range"},
      {[](W& w) { w.shape.a[5] = nan; }, "shape out of range"},
      {[](W& w) { w.shape.a[8] = 0; }, "the transform of an inspected body is singular"},
      {[](W& w) { w.participant = 0; }, "participant id 0"},
      {[](W& w) { w.kind = command_kinds; }, "unknown kind"},
      {[](W& w) { w.kind = 255; }, "unknown kind"},
      {[](W& w) { w.role = 3; }, "unknown role"},
      {[](W& w) { w.control_id = 6; }, "unknown control"},
      {[](W& w) { w.value = nan; }, "value out of range"},
      {[](W& w) { w.value = -0.1; }, "value out of range"},
      {[](W& w) { w.value = max_accuracy + 1; }, "value out of range"},
      {[](W& w) { w.hand = 2; }, "no such hand"},
      {[](W& w) { w.body = max_bodies; }, "no such body"}};
  for (const Form& form : forms())
    for (const Malformed& row : table) {
      SCOPED_TRACE(command_names[form.body.index()]);
      prosector_Command w = wire_form(form.body);
      row.spoil(w);
      Command received;
      EXPECT_EQ(from_wire(w, received).why(), row.reason);
    }
}

TEST(CommandWire, ValuesAreBoundedByTheKindOfCommand) {
  const auto refused = [](const CommandBody& body, double value) {
    prosector_Command w = wire_form(body);
    w.value = value;
    Command received;
    return static_cast<bool>(from_wire(w, received));
  };
  for (const auto& [body, most] : {std::pair<CommandBody, double>(SetPace{}, max_pace),
                                   {SetAccuracy{}, max_accuracy},
                                   {SetControl{}, 1},
                                   {Undo{}, 1}}) {
    EXPECT_FALSE(refused(body, most)) << command_names[body.index()];
    EXPECT_TRUE(refused(body, most + 0.01)) << command_names[body.index()];
  }
}

}  // namespace
}  // namespace prosector
