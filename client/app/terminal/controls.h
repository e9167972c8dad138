#pragma once
// Table of all keys and controls. The help in the window and at the terminal is generated from it, and a test
// compares docs/do/join.md with it.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/language/catalogue.h"
#include "common/ids.h"

namespace prosector {

/// Group of controls that the help lists together, by input device; `recording` is for the playback of a
/// recording. Mouse and keyboard move the view of every user with a window, and the hand of users without
/// other devices.
enum class ControlDevice : std::uint8_t { view, hand, gamepad, headset, terminal, recording };

struct Control {
  ControlDevice device;
  Role least;  // lowest role that has the control
  std::string_view input, does;
};

inline constexpr std::array controls = {
    Control{ControlDevice::hand, Role::dissector, msg("mouse"),
            msg("your hand hovers above what is under the pointer")},
    Control{ControlDevice::hand, Role::dissector, msg("wheel"), msg("hover height, down to pressing in")},
    Control{ControlDevice::hand, Role::dissector, msg("hold left button"), msg("touches, grasps and pulls")},
    Control{ControlDevice::hand, Role::dissector, msg("with wheel"),
            msg("pulls; with a blade: how deep it cuts")},
    Control{ControlDevice::hand, Role::dissector, msg("left drag with a blade"),
            msg("cuts along the pointer; a click beside releases")},
    Control{ControlDevice::hand, Role::dissector, msg("Shift, Alt + wheel"), msg("rolls, bends the wrist")},
    Control{ControlDevice::hand, Role::dissector, msg("P, middle button"),
            msg("the panel of the part under the pointer")},
    Control{ControlDevice::hand, Role::dissector, msg("left button on it"),
            msg("operates the panel's controls")},
    Control{ControlDevice::hand, Role::dissector, msg("drag its head"),
            msg("moves it for everyone; double click: back")},
    Control{ControlDevice::hand, Role::dissector, msg("wheel on it"), msg("scrolls its text")},
    Control{ControlDevice::hand, Role::dissector, msg("Z"), msg("undoes your last cut")},
    Control{ControlDevice::view, Role::observer, msg("right drag"), msg("rotates the view")},
    Control{ControlDevice::view, Role::observer, msg("Shift + right drag"), msg("pans the view")},
    Control{ControlDevice::view, Role::observer, msg("+ -, Ctrl + wheel, pinch"),
            msg("zooms; also Ctrl + right drag")},
    Control{ControlDevice::view, Role::observer, msg("Home"), msg("back to the first view")},
    Control{ControlDevice::view, Role::observer, msg("G, double click"),
            msg("fits what is under the pointer into the view")},
    Control{ControlDevice::view, Role::observer, msg("1 to 9"),
            msg("views: front, left, right, above; Ctrl saves")},
    Control{ControlDevice::view, Role::observer, msg("L, N"),
            msg("list of parts: find, hide, colour; their names")},
    Control{ControlDevice::view, Role::observer, msg("W A S D Q E"), msg("fly through the scene")},
    Control{ControlDevice::view, Role::observer, msg("F"), msg("rotates about the eye or about the object")},
    Control{ControlDevice::view, Role::observer, msg("Tab"), msg("shows the view of the next participant")},
    Control{ControlDevice::view, Role::observer, msg("X"), msg("section plane on or off")},
    Control{ControlDevice::view, Role::observer, msg("hold X, wheel"), msg("moves the section plane")},
    Control{ControlDevice::view, Role::observer, msg("V"), msg("colours organs by strain, residual, error")},
    Control{ControlDevice::view, Role::observer, msg("C"), msg("shows collision shapes")},
    Control{ControlDevice::view, Role::observer, msg("I"), msg("frame, network and simulation figures")},
    Control{ControlDevice::view, Role::observer, msg("F11, F12"),
            msg("full screen; saves a screenshot (Shift: x 2)")},
    Control{ControlDevice::view, Role::host, msg("Space, comma, full stop"),
            msg("stops or resumes time; half speed; one tick")},
    Control{ControlDevice::view, Role::observer, msg("H, F1"), msg("this help")},
    Control{ControlDevice::view, Role::observer, msg("Esc"), msg("closes the list; leaves the session")},
    Control{ControlDevice::gamepad, Role::observer, msg("left stick, bumpers"), msg("fly")},
    Control{ControlDevice::gamepad, Role::observer, msg("right stick"),
            msg("rotates the view; pressed: as F")},
    Control{ControlDevice::gamepad, Role::observer, msg("left trigger + left stick"), msg("zooms")},
    Control{ControlDevice::gamepad, Role::observer, msg("left stick pressed"), msg("back to the first view")},
    Control{ControlDevice::gamepad, Role::observer, msg("upper button"),
            msg("shows the view of the next participant")},
    Control{ControlDevice::gamepad, Role::observer, msg("cross left, right"), msg("as keys V and C")},
    Control{ControlDevice::gamepad, Role::observer, msg("back, start"), msg("figures; this help")},
    Control{ControlDevice::gamepad, Role::observer, msg("left trigger + start, back"),
            msg("list of parts; their names")},
    Control{ControlDevice::gamepad, Role::observer, msg("left trigger + right stick"),
            msg("moves the pointer")},
    Control{ControlDevice::gamepad, Role::observer, msg("right trigger, lower button"),
            msg("as the left mouse button")},
    Control{ControlDevice::gamepad, Role::observer, msg("cross up, down"), msg("as the wheel")},
    Control{ControlDevice::gamepad, Role::dissector, msg("left trigger + bumpers"), msg("roll the wrist")},
    Control{ControlDevice::gamepad, Role::dissector, msg("left trigger + cross"), msg("bends the wrist")},
    Control{ControlDevice::gamepad, Role::dissector, msg("left button"),
            msg("the panel of the part under the pointer")},
    Control{ControlDevice::gamepad, Role::dissector, msg("right button"), msg("undoes your last cut")},
    Control{ControlDevice::headset, Role::dissector, msg("tracker, glove"), msg("moves your hand")},
    Control{ControlDevice::headset, Role::dissector, msg("make a fist"),
            msg("grasps; open the hand: releases")},
    Control{ControlDevice::headset, Role::dissector, msg("index and little finger"),
            msg("the panel of what you point at")},
    Control{ControlDevice::headset, Role::dissector, msg("extended index finger"),
            msg("operates the panel, scrolls its text")},
    Control{ControlDevice::headset, Role::dissector, msg("fist at the panel's head"),
            msg("carries the panel; a second fist: back")},
    Control{ControlDevice::headset, Role::dissector, msg("index to ring finger"),
            msg("opens or closes the list of parts")},
    Control{ControlDevice::headset, Role::dissector, msg("extended index finger on it"),
            msg("operates it; along the names: scrolls")},
    Control{ControlDevice::terminal, Role::dissector, "undo", "undoes your last cut"},
    Control{ControlDevice::terminal, Role::dissector, "detach PART, attach PART",
            "takes it out; puts it back"},
    Control{ControlDevice::terminal, Role::dissector, "reset BODY", "undoes everything done to it"},
    Control{ControlDevice::terminal, Role::dissector, "inspect PART [SCALE]", "shows it enlarged by SCALE"},
    Control{ControlDevice::terminal, Role::dissector, "end PART", "ends the inspection"},
    Control{ControlDevice::terminal, Role::observer, "cuts", "lists the cuts, their authors and revisions"},
    Control{ControlDevice::terminal, Role::observer, "parts [SEARCH]", "lists parts and their holders"},
    Control{ControlDevice::terminal, Role::observer, "hide PART, show PART",
            "only for you; show all: as in the scene"},
    Control{ControlDevice::terminal, Role::observer, "isolate PART [40 %]",
            "hides or fades the others; isolate: shows them"},
    Control{ControlDevice::terminal, Role::observer, "opacity PART 40 %", "only for you"},
    Control{ControlDevice::terminal, Role::observer, "colour PART COLOUR",
            "only for you; own: original colour"},
    Control{ControlDevice::terminal, Role::observer, "labels", "part names on or off"},
    Control{ControlDevice::terminal, Role::observer, "picture FILE", "saves a screenshot (PNG)"},
    Control{ControlDevice::terminal, Role::observer, "look X Y Z X Y Z", "offscreen: sets eye and target, m"},
    Control{ControlDevice::terminal, Role::observer, "look", "camera of the scene"},
    Control{ControlDevice::terminal, Role::observer, "what", "reports what is under the pointer"},
    Control{ControlDevice::terminal, Role::host, "give NAME ROLE", "role: host, dissector or observer"},
    Control{ControlDevice::terminal, Role::host, "rewind PART REVISION", "restores everything to that state"},
    Control{ControlDevice::terminal, Role::host, "stop, go", "stops or resumes time for everyone"},
    Control{ControlDevice::terminal, Role::host, "slow SHARE", "slow motion, fraction of real time"},
    Control{ControlDevice::terminal, Role::host, "step [TICKS]",
            "while time is stopped: steps so many ticks"},
    Control{ControlDevice::terminal, Role::host, "reset all", "restores the initial state of the session"},
    Control{ControlDevice::terminal, Role::host, "effort PART STEPS",
            "solver effort: 0 exact to 3 coarse; or all"},
    Control{ControlDevice::terminal, Role::host, "accuracy PART [5 %]",
            "remodels it; without %: lists what is available"},
    Control{ControlDevice::terminal, Role::observer, "seek TIME", "recordings: to 1:15, or by +10, -10 s"},
    Control{ControlDevice::terminal, Role::observer, "fast TIMES",
            "recordings: multiple of real time, 1 to 8"},
    Control{ControlDevice::recording, Role::observer, msg("bar: click, drag"), msg("seeks to that time")},
    Control{ControlDevice::recording, Role::observer, msg("Left, Right"), msg("10 s back; 10 s forward")},
    Control{ControlDevice::recording, Role::observer, msg("Page up, Page down"),
            msg("1 minute back; 1 minute forward")},
    Control{ControlDevice::recording, Role::observer, msg("Backspace"), msg("back to the beginning")},
    Control{ControlDevice::recording, Role::observer, msg("Up, Down"), msg("doubles or halves the speed")},
    Control{ControlDevice::recording, Role::observer, msg("Space, full stop"),
            msg("pauses or resumes; one tick")},
};

/// Separator between the two columns of the help text: blanks for monospaced fonts, a tab for text in a
/// frame.
enum class HelpColumns : std::uint8_t { blanks, tabs };

/// Returns the help text on the controls that a user with this role has with these devices: one line per
/// control, with the input and its effect in two columns. Terminal commands and their help stay English.
std::string help_text(Role role, std::span<const ControlDevice> devices,
                      HelpColumns columns = HelpColumns::blanks, const Catalogue& words = {});

/// Returns the first hints on how to use the client, for a user with this role and these devices, one per
/// line.
std::vector<std::string> first_hints(Role role, std::span<const ControlDevice> devices,
                                     const Catalogue& words = {});

/// Returns a Markdown table of the device's controls for the documentation: the input, its effect, and the
/// required role.
std::string controls_in_markdown(ControlDevice device);

}  // namespace prosector
