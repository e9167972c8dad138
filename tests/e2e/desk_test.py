#!/usr/bin/python3
"""desk_test.py BIN OUT, run under deploy/with_display.sh: a person at a desk. A real server, a real window, and xdotool for the mouse and the
keys: P over an organ brings up its panel, a click presses a button, a drag moves the slider, the button held over the
organ goes in, touches and holds it. What came of it is read in the client's pictures and log and in the server's summary.
"""

import os
import pathlib
import sys
import time

from PIL import Image, ImageChops, ImageFilter, ImageGrab

from desk_person import Processes, View, act, corner, minus, wait_until, window_of

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
WIDTH, HEIGHT = 800, 600
START, BEFORE, PANEL, WORKED = 3, 9, 13, 23  # s after joining: when the client takes its pictures
AUDIENCE = 820, 20, 440, 240  # x, y, width, height, beside the window
BOARD = 0.26 / 0.318  # of the height of what comes up: the strip of effort is below the board
# Of the board, as parts of its width and height from its upper left corner: common/panel.h.
LIGHT_SHAFT = ((0.15 + 0.071) / 0.30, (0.13 + 0.012) / 0.26)
KNOB, KNOB_RIGHT = (0.5, (0.13 + 0.096) / 0.26), (0.8, (0.13 + 0.096) / 0.26)

SCENE = '''name = "desk"
[camera]
eye = [0, 1.2, 1.3]
target = [0, 1.2, 0]
[[soft]]
name = "jelly"
description = "an organ to work on"
shape = "ball"
size = [0.2, 0.2, 0.2]
cell = 0.04
surface_cell = 0.02
position = [0, 1, 0]
gravity = false
damping_mass = 4
anatomy = true
color = [0.9, 0.1, 0.1]
  [[soft.attach]]
  center = [0, 0.9, 0]
  radius = 0.05
  stiffness = 1e6
[[light]]
name = "lamp"
kind = "spot"
position = [0.5, 2, 1]
direction = [-0.3, -0.7, -0.7]
color = [1, 1, 1]
intensity = 0.6
cone = 0.6
[[light]]
name = "room"
kind = "point"
position = [0, 2, 2]
color = [1, 1, 1]
intensity = 0.5
'''


def picture(seconds):
    """What the window shows that long after joining."""
    file = OUT / f"{seconds}.png"

    def whole():
        try:
            return Image.open(file).convert("RGB")
        except OSError:
            return None  # not there, or still being written

    return wait_until(file.name, whole)


def point_at(part):
    """Moves the mouse to a place on the panel."""
    x, y = (round(a + p * (b - a)) for p, (a, b) in zip(part, panel))
    act("mousemove", left + x, top + y)
    time.sleep(0.2)


def changed(before, after):
    """White where two pictures differ."""
    bands = ImageChops.difference(before, after).split()
    most = ImageChops.lighter(ImageChops.lighter(bands[0], bands[1]), bands[2])
    return most.point(lambda level: 255 if level > 8 else 0)


def extent(mask, axis):
    """First and one past the last row (axis 1) or column (axis 0) of which an eighth is white."""
    size = (mask.width, 1) if axis == 0 else (1, mask.height)
    lit = [i for i, level in enumerate(mask.resize(size, Image.BOX).getdata()) if level > 255 / 8]
    assert len(lit) > 60, "no panel came up where P was pressed"
    return lit[0], lit[-1] + 1


def red_share(image, axis):
    """The share of the picture's width (axis 0) or height that the red organ takes."""
    red, green, _ = image.split()
    lit = ImageChops.subtract(red, green).point(lambda level: 255 if level > 40 else 0).getbbox()
    return (lit[axis + 2] - lit[axis]) / image.size[axis] if lit else 0


def touches():
    """What the right hand touches, as the client knows."""
    return view.last_line().get("touches", {}).get("mouse, right", {}).get("body")


def holders():
    return view.last_line().get("parts", {}).get("jelly", {}).get("holders", [])


def share(mask, x, y):
    """White part of the panel's area x by y, each from … to, as parts of it."""
    (a, b), (c, d) = panel
    area = mask.crop([round(v) for v in (a + x[0] * (b - a), c + y[0] * (d - c), a + x[1] * (b - a), c + y[1] * (d - c))])
    return area.resize((1, 1), Image.BOX).getpixel((0, 0)) / 255


with Processes(OUT) as processes:
    (OUT / "desk.toml").write_text(SCENE)
    session = f"desk-{os.getpid()}"
    server = processes.start("server.log", BIN / "prosector-server", OUT / "desk.toml", "--session", session, "--domain", 77, "--summary",
                   OUT / "server.json")
    wait_until("the server", lambda: processes.says("server.log", "is open on this machine"), process=server)
    client = processes.start("client.log", BIN / "prosector-client", "join", "--name", "mouse", "--session", session, "--domain", 77,
                   "--size", f"{WIDTH}x{HEIGHT}", "--no-overlay", "--session-log", OUT / "log.jsonl", "--spectator-window", *(word for t in (START, BEFORE, PANEL, WORKED) for word in ("--screenshot", f"{OUT / str(t)}.png@{t}")))
    window = window_of(client, f"Prosector: {session}")
    audience = window_of(client, "Prosector: audience", "the audience's window")
    act("windowsize", audience, *AUDIENCE[2:], "windowmove", audience, *AUDIENCE[:2])
    left, top = corner(window)
    act("windowfocus", window)

    # The organ fills most of the picture, and its middle is the picture's.
    red = [red_share(picture(START), axis) for axis in (0, 1)]
    assert 0.5 < max(red) < 0.7, f"the organ takes {red} of the picture's width and height"
    view = View(window, (WIDTH, HEIGHT), 0.8, OUT / "log.jsonl")
    view.wheel(-10, "ctrl")  # so that there is room for the panel
    before = picture(BEFORE)
    shown_to_all = ImageGrab.grab(xdisplay="")
    x, y, across, down = AUDIENCE
    # A picture of 4 to 3, between black bars.
    seen = shown_to_all.crop((x + (across - down * 4 // 3) // 2, y, x + (across + down * 4 // 3) // 2, y + down))
    expected = before.resize(seen.size, Image.BILINEAR)
    off = changed(expected.filter(ImageFilter.GaussianBlur(2)), seen.filter(ImageFilter.GaussianBlur(2)))
    assert off.resize((1, 1), Image.BOX).getpixel((0, 0)) < 13, "the audience sees something else"  # 5 %
    assert shown_to_all.crop((x, y, x + 20, y + down)).getextrema() == ((0, 0),) * 3, "no black bar"
    act("key", "p")
    after = picture(PANEL)
    mask = changed(before, after)
    top_row, end = extent(mask, 1)
    panel = extent(mask, 0), (top_row, top_row + BOARD * (end - top_row))
    print("panel at", panel)

    point_at(LIGHT_SHAFT)
    act("click", 1)
    time.sleep(1)
    point_at(KNOB)
    act("mousedown", 1)
    for step in range(1, 11):
        point_at(tuple(a + (b - a) * step / 10 for a, b in zip(KNOB, KNOB_RIGHT)))
    act("mouseup", 1)
    worked = picture(WORKED)

    # Beside the panel the same button goes in and holds; what is held follows the pointer, and is let go.
    middle = left + WIDTH // 2, top + HEIGHT // 2
    act("mousemove", *middle)
    time.sleep(1)
    pressed = time.monotonic()
    act("mousedown", 1)
    wait_until("a touch", lambda: touches() == "jelly", 5)
    print(f"touched {time.monotonic() - pressed:.2f} s after the button went down")
    wait_until("a hold", lambda: "mouse, right" in holders(), 5)
    held_at = view.hand()
    for step in range(1, 6):
        act("mousemove", middle[0] + 8 * step, middle[1])
        time.sleep(0.1)
    time.sleep(1)
    drawn = minus(view.hand(), held_at)
    assert drawn[0] > 0.02 and abs(drawn[2]) < 0.5 * drawn[0], f"the hand moved by {drawn} m, not to the right"
    view.picture().save(OUT / "held.png")
    act("mouseup", 1)
    wait_until("it let go", lambda: not holders(), 5)

    act("mousemove", left + 40, top + HEIGHT - 40)  # over nothing
    before = view.eyes()
    act("click", 1, "click", 1)
    time.sleep(0.5)
    assert view.eyes() == before, "a double click over nothing moved the view"
    view.after(lambda: act("mousemove", *middle, "click", 1, "click", 1))  # frames the organ
    assert view.eyes() != before
    view.picture().save(OUT / "framed.png")
    act("mousemove", left + 40, top + HEIGHT - 40, "mousedown", 1)
    time.sleep(1)
    act("mouseup", 1)
    time.sleep(0.5)
    commands = processes.leave(client, server)
    # By the key, then once a second while it was pointed at, so that it stays.
    assert commands["open_panel"]["granted"] >= 1 and commands["open_panel"]["refused"] == 0, commands
    assert commands["set_control"]["granted"] >= 3, commands  # the button, and the slider on its way
    assert commands["set_control"]["refused"] == 0, commands
    assert commands["grasp"] == {"granted": 1, "refused": 1}, commands  # the organ; over nothing
    # The slider's knob is where the pointer left it, and not where it was.
    mask = changed(after, worked)
    for x, _ in KNOB, KNOB_RIGHT:
        assert share(mask, (x - 0.03, x + 0.03), (KNOB[1] - 0.03, KNOB[1] + 0.03)) > 0.3, f"the slider did not change at {x}"
