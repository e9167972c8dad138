#!/usr/bin/python3
"""desk_parts_test.py BIN OUT, run under deploy/with_display.sh: a person at a desk and the list of parts. A real server, a real window, and
xdotool for the mouse and the keys: L opens the list, typing searches it, a click on an eye hides an organ and shows it again,
one on a ring makes the others faint, Esc shuts one thing after the other, N writes names. No click on the list reaches a hand.
"""

import os
import pathlib
import sys

from PIL import ImageChops

from desk_person import Processes, View, act, wait_until, window_of

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
WIDTH, HEIGHT = 800, 600
# Pixels of the window, of the first row that a search finds: client/view/parts_list_dimensions.h.
LIST_LEFT, LIST_BOTTOM, EYE, RING = 470, 150, (699, 80), (721, 80)

BALL = '''[[soft]]
name = "{name}"
shape = "ball"
size = [0.14, 0.14, 0.14]
cell = 0.04
position = [{x}, 1.2, 0]
gravity = false
anatomy = true
color = {color}
  [[soft.attach]]
  center = [{x}, 1.13, 0]
  radius = 0.03
  stiffness = 1e6
'''
SCENE = '''name = "parts"
[camera]
eye = [0.1, 1.2, 0.9]
target = [0.1, 1.2, 0]
[[light]]
name = "room"
kind = "point"
position = [0, 2, 2]
intensity = 0.8
''' + BALL.format(name="red jelly", x=-0.14, color="[0.9, 0.05, 0.05]") + BALL.format(name="green jelly", x=0.06, color="[0.05, 0.7, 0.05]")


def share(band, other):
    """How much of the picture below the list is of one colour rather than the other."""
    bands = view.picture().crop((0, LIST_BOTTOM, WIDTH, HEIGHT)).split()
    lit = ImageChops.subtract(bands[band], bands[other]).point(lambda level: 255 if level > 60 else 0)
    return lit.resize((1, 1), 4).getpixel((0, 0)) / 255


def red():
    return share(0, 1)


def green():
    return share(1, 0)


def click(spot):
    act("mousemove", view.left + spot[0], view.top + spot[1], "sleep", 0.3, "click", 1)


with Processes(OUT) as processes:
    (OUT / "parts.toml").write_text(SCENE)
    session = f"parts-{os.getpid()}"
    server = processes.start("server.log", BIN / "prosector-server", OUT / "parts.toml", "--session", session, "--domain", 78,
                             "--summary", OUT / "server.json")
    wait_until("the server", lambda: processes.says("server.log", "is open on this machine"), process=server)
    client = processes.start("client.log", BIN / "prosector-client", "join", "--name", "mouse", "--session", session,
                             "--domain", 78, "--size", f"{WIDTH}x{HEIGHT}", "--no-overlay", "--session-log", OUT / "log.jsonl")
    window = window_of(client, f"Prosector: {session}")
    act("windowfocus", window)
    view = View(window, (WIDTH, HEIGHT), 0.8, OUT / "log.jsonl")
    view.settle()
    act("mousemove", view.left + 40, view.top + HEIGHT - 40)
    wait_until("both organs", lambda: red() > 0.01 and green() > 0.01)
    before = red(), green()
    eyes = view.eyes()

    act("key", "l", "sleep", 0.5, "type", "RED")
    wait_until("the list", lambda: sum(view.picture().getpixel((LIST_LEFT + 20, 90))) < 200)
    click(EYE)
    wait_until("red is hidden", lambda: red() < 0.1 * before[0])
    assert green() > 0.5 * before[1], "the search found green, too"
    click(EYE)
    wait_until("red is back", lambda: red() > 0.8 * before[0])
    click(RING)
    wait_until("green is faint", lambda: green() < 0.5 * before[1])
    view.picture().save(OUT / "isolated.png")
    click(RING)
    wait_until("green is hidden", lambda: green() < 0.1 * before[1])
    click(RING)
    wait_until("green is back", lambda: green() > 0.8 * before[1])
    assert view.eyes() == eyes, "typing moved the view"

    act("mousemove", view.left + 40, view.top + HEIGHT - 40)
    act("key", "Escape", "sleep", 0.5, "key", "Escape")
    wait_until("the list is shut", lambda: sum(view.picture().getpixel((LIST_LEFT + 20, 90))) > 200)
    plain = view.picture()
    act("key", "n")

    def names():
        """Bright pixels that were not there before."""
        new = ImageChops.subtract(view.picture().convert("L"), plain.convert("L"))
        return sum(new.point(lambda level: 1 if level > 50 else 0).getdata())

    wait_until("names", lambda: names() > 100)
    view.picture().save(OUT / "named.png")
    assert client.poll() is None, "Esc left while the list was open"
    commands = processes.leave(client, server)
    assert commands.get("grasp", {"granted": 0})["granted"] == 0, commands
