#pragma once
// Every key and control, once: the help in the window and at the terminal is made of this table, and
// docs/do/join.md is held to it.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "client/language/catalogue.h"
#include "common/messages.h"

namespace prosector {

/// What people have in their hands; `recording`: time, while one is watched. Mouse and keyboard move the view
/// of everyone who has a window, and the hand of those who have no other device.
enum class ControlDevice : std::uint8_t { view, hand, gamepad, headset, terminal, recording };

struct Control {
  ControlDevice device;
  Role least;  // who has that role or a higher one
  std::string_view input, does;
};

inline constexpr std::array controls = {
    Control{ControlDevice::hand, Role::dissector, msg("mouse"),
            msg("your hand hovers over what the pointer is at")},
    Control{ControlDevice::hand, Role::dissector, msg("wheel"),
            msg("how high it hovers, down to pressing in")},
    Control{ControlDevice::hand, Role::dissector, msg("hold left button"),
            msg("goes in, takes hold and draws")},
    Control{ControlDevice::hand, Role::dissector, msg("wheel meanwhile"),
            msg("pulls; with a blade: how deep it cuts")},
    Control{ControlDevice::hand, Role::dissector, msg("left drag with a blade"),
            msg("cuts along the pointer; a click beside lets go")},
    Control{ControlDevice::hand, Role::dissector, msg("Shift, Alt + wheel"), msg("rolls, bends the wrist")},
    Control{ControlDevice::hand, Role::dissector, msg("P, middle button"),
            msg("the panel of the part under the pointer")},
    Control{ControlDevice::hand, Role::dissector, msg("left button on it"),
            msg("works the panel's controls")},
    Control{ControlDevice::hand, Role::dissector, msg("drag its head"),
            msg("moves it for everyone; double click: back")},
    Control{ControlDevice::hand, Role::dissector, msg("wheel on it"), msg("scrolls its text")},
    Control{ControlDevice::hand, Role::dissector, msg("Z"), msg("takes back your last cut")},
    Control{ControlDevice::view, Role::observer, msg("right drag"), msg("turns the view")},
    Control{ControlDevice::view, Role::observer, msg("Shift + right drag"),
            msg("moves it along the picture")},
    Control{ControlDevice::view, Role::observer, msg("+ -, Ctrl + wheel, pinch"),
            msg("zooms; Ctrl + right drag, too")},
    Control{ControlDevice::view, Role::observer, msg("Home"), msg("back to the first view")},
    Control{ControlDevice::view, Role::observer, msg("G, double click"),
            msg("frames what is under the pointer")},
    Control{ControlDevice::view, Role::observer, msg("1 to 9"),
            msg("views: front, left, right, above; Ctrl saves")},
    Control{ControlDevice::view, Role::observer, msg("L, N"),
            msg("list of parts: find, hide, colour; their names")},
    Control{ControlDevice::view, Role::observer, msg("W A S D Q E"), msg("flies")},
    Control{ControlDevice::view, Role::observer, msg("F"),
            msg("turns about the eye, or again about what is seen")},
    Control{ControlDevice::view, Role::observer, msg("Tab"), msg("through the eyes of the next user")},
    Control{ControlDevice::view, Role::observer, msg("X"),
            msg("opens what you see at a plane, or closes it")},
    Control{ControlDevice::view, Role::observer, msg("hold X, wheel"), msg("moves the plane")},
    Control{ControlDevice::view, Role::observer, msg("V"), msg("colours organs by strain, residual, error")},
    Control{ControlDevice::view, Role::observer, msg("C"), msg("what bodies collide as")},
    Control{ControlDevice::view, Role::observer, msg("I"),
            msg("figures of pictures, network and simulation")},
    Control{ControlDevice::view, Role::observer, msg("F11, F12"),
            msg("fills the screen; keeps a picture (Shift: x 2)")},
    Control{ControlDevice::view, Role::host, msg("Space, comma, full stop"),
            msg("stops time, or goes on; half its pace; a tick")},
    Control{ControlDevice::view, Role::observer, msg("H, F1"), msg("these lines")},
    Control{ControlDevice::view, Role::observer, msg("Esc"), msg("shuts the list; leaves")},
    Control{ControlDevice::gamepad, Role::observer, msg("left stick, bumpers"), msg("fly")},
    Control{ControlDevice::gamepad, Role::observer, msg("right stick"), msg("turns the view; pressed, as F")},
    Control{ControlDevice::gamepad, Role::observer, msg("left trigger + left stick"), msg("zooms")},
    Control{ControlDevice::gamepad, Role::observer, msg("left stick pressed"), msg("back to the first view")},
    Control{ControlDevice::gamepad, Role::observer, msg("upper button"),
            msg("through the eyes of the next user")},
    Control{ControlDevice::gamepad, Role::observer, msg("cross left, right"), msg("as V, as C")},
    Control{ControlDevice::gamepad, Role::observer, msg("back, start"), msg("figures, these lines")},
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
    Control{ControlDevice::gamepad, Role::dissector, msg("right button"), msg("takes back your last cut")},
    Control{ControlDevice::headset, Role::dissector, msg("tracker, glove"),
            msg("your hand is where yours is")},
    Control{ControlDevice::headset, Role::dissector, msg("make a fist"),
            msg("takes hold; open the hand: lets go")},
    Control{ControlDevice::headset, Role::dissector, msg("index and little finger"),
            msg("the panel of what you point at")},
    Control{ControlDevice::headset, Role::dissector, msg("a stretched index"),
            msg("works the panel's controls, scrolls its text")},
    Control{ControlDevice::headset, Role::dissector, msg("a fist at its head"),
            msg("carries it; a second fist: back")},
    Control{ControlDevice::headset, Role::dissector, msg("index to ring finger"),
            msg("list of parts on a board; again: away")},
    Control{ControlDevice::headset, Role::dissector, msg("a stretched index on it"),
            msg("works it; along names: scrolls")},
    Control{ControlDevice::terminal, Role::dissector, "undo", "takes back your last cut"},
    Control{ControlDevice::terminal, Role::dissector, "detach PART, attach PART",
            "out of its place; back into it"},
    Control{ControlDevice::terminal, Role::dissector, "reset BODY", "undoes all that was done to it"},
    Control{ControlDevice::terminal, Role::dissector, "inspect PART [SCALE]",
            "shows it SCALE times as large"},
    Control{ControlDevice::terminal, Role::dissector, "end PART", "puts it back to where it was"},
    Control{ControlDevice::terminal, Role::observer, "cuts", "what was cut, by whom, and the revisions"},
    Control{ControlDevice::terminal, Role::observer, "parts [SEARCH]", "lists them, and who holds them"},
    Control{ControlDevice::terminal, Role::observer, "hide PART, show PART",
            "for you alone; show all: as the scene has them"},
    Control{ControlDevice::terminal, Role::observer, "isolate PART [40 %]",
            "the others hidden, or faint; isolate: they are back"},
    Control{ControlDevice::terminal, Role::observer, "opacity PART 40 %", "for you alone"},
    Control{ControlDevice::terminal, Role::observer, "colour PART COLOUR", "for you alone; own: its own"},
    Control{ControlDevice::terminal, Role::observer, "labels", "names beside the parts, or none"},
    Control{ControlDevice::terminal, Role::observer, "picture FILE",
            "takes a picture of what is shown (PNG)"},
    Control{ControlDevice::terminal, Role::observer, "look X Y Z X Y Z", "offscreen: from there to there, m"},
    Control{ControlDevice::terminal, Role::observer, "look", "as the scene has it"},
    Control{ControlDevice::terminal, Role::observer, "what", "says what the pointer is at"},
    Control{ControlDevice::terminal, Role::host, "give NAME ROLE", "makes them host, dissector or observer"},
    Control{ControlDevice::terminal, Role::host, "rewind PART REVISION", "everything as it was then"},
    Control{ControlDevice::terminal, Role::host, "stop, go", "time stands still for everyone; goes on"},
    Control{ControlDevice::terminal, Role::host, "slow SHARE", "slow motion, a share of real time"},
    Control{ControlDevice::terminal, Role::host, "step [TICKS]", "while time stands still: so many ticks"},
    Control{ControlDevice::terminal, Role::host, "reset all", "everything as it was at the server's start"},
    Control{ControlDevice::terminal, Role::host, "effort PART STEPS",
            "how it is solved: 0 exact to 3 coarse; all"},
    Control{ControlDevice::terminal, Role::host, "accuracy PART [5 %]",
            "models it anew, so exactly; alone: what it can have"},
    Control{ControlDevice::terminal, Role::observer, "seek TIME", "a recording: to 1:15, or by +10, -10 s"},
    Control{ControlDevice::terminal, Role::observer, "fast TIMES",
            "a recording: as fast as real time, 1 to 8"},
    Control{ControlDevice::recording, Role::observer, msg("bar: click, drag"), msg("goes to that time")},
    Control{ControlDevice::recording, Role::observer, msg("Left, Right"), msg("10 s back; 10 s on")},
    Control{ControlDevice::recording, Role::observer, msg("Page up, Page down"),
            msg("a minute back; a minute on")},
    Control{ControlDevice::recording, Role::observer, msg("Backspace"), msg("back to its beginning")},
    Control{ControlDevice::recording, Role::observer, msg("Up, Down"), msg("twice as fast; half as fast")},
    Control{ControlDevice::recording, Role::observer, msg("Space, full stop"),
            msg("stands, or goes on; by a tick")},
};

/// What divides the columns of help: blanks, for letters of one width, or a tab, for a picture's text.
enum class HelpColumns : std::uint8_t { blanks, tabs };

/// Returns the help for who has that role and those devices: a line a control, in two columns. What is typed
/// at the terminal stays English, as its commands are.
std::string help_text(Role role, std::span<const ControlDevice> devices,
                      HelpColumns columns = HelpColumns::blanks, const Catalogue& words = {});

/// Returns what to tell first to who has that role and those devices, a line each.
std::vector<std::string> first_words(Role role, std::span<const ControlDevice> devices,
                                     const Catalogue& words = {});

/// Returns the rows of one device as a table in Markdown.
std::string controls_in_markdown(ControlDevice device);

}  // namespace prosector
