#!/usr/bin/python3
"""desk_piece_test.py BIN OUT, run under deploy/with_display.sh: a person at a desk cuts the skin of sheet_cut.toml right through with the mouse, sees
its halves part, and has it whole again with one Z. What came of it is read in the client's log, in the server's summary and in pictures."""

import os
import pathlib
import sys
import time

from PIL import Image

from desk_person import Processes, View, act, wait_until

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SCENE = pathlib.Path(__file__).parents[2] / "deploy/scenes/sheet_cut.toml"
SIZE = 640, 480
FOV = 0.75  # the scene's camera's
HANDLE = 0.24, 0.902, 0.1  # the scalpel's, as it lies
BEGIN, END = (-0.13, 0.99, 0.03), (0.13, 0.99, 0.03)  # of the drawn cut: off the skin at both ends
ACROSS = [(0.03, 0.99, 0.002 * k) for k in range(36)]  # places on a line that crosses the drawn cut where it gapes, m
AWAY = 0.25, 0.9, -0.05  # where neither hand nor words hide the skin


def holds_scalpel():
    return "mouse, right" in view.parts().get("scalpel", {}).get("holders", [])


def shows_skin(image):
    """Tells whether all places across the drawn line show the skin's colour, which is redder than the table below it. The cut's edges
    curl, so that the gap is not always seen exactly where the blade went."""
    for place in ACROSS:
        x, y = (round(a - b) for a, b in zip(view.pixel(place), (view.left, view.top)))
        red, _, blue = image.getpixel((x, y))
        if red - blue < 8:
            return False
    return True


def picture(name):
    """The window now, kept."""
    image = view.picture()
    image.save(OUT / f"{name}.png")
    return image


with Processes(OUT) as processes:
    server, client, window = processes.host_and_join(BIN, SCENE, f"desk-piece-{os.getpid()}", SIZE)
    view = View(window, SIZE, FOV, OUT / "log.jsonl")
    view.settle()
    view.point_at(HANDLE)
    view.hand_settles()
    assert shows_skin(picture("start")), "the skin is not seen where it lies"
    whole = view.topology()

    act("mousedown", 1)
    wait_until("the scalpel in the hand", holds_scalpel)
    act("mouseup", 1)
    view.hand_settles()
    assert holds_scalpel(), "the scalpel did not stay in the hand"
    view.draw(HANDLE, BEGIN, 10)
    view.hand_settles()
    picture("above")
    assert view.topology() == whole, "cut before the button went down"
    act("mousedown", 1)
    view.draw(BEGIN, END, 60)
    view.hand_settles()  # a person looks whether the blade is there, however slow the pictures are
    picture("drawn")
    act("mouseup", 1)
    wait_until("a half that came off", lambda: any(max(size) > 0.15 for size in view.pieces().values()), 60)
    view.draw(END, AWAY, 5)
    wait_until("the cut open", lambda: not shows_skin(view.picture()), 20)
    time.sleep(1)
    picture("off")
    print("came off:", view.pieces())
    act("key", "z")
    wait_until("one skin again", lambda: "skin" in view.parts() and not view.pieces(), 20)
    wait_until("the cut shut", lambda: shows_skin(view.picture()), 20)
    time.sleep(1)
    picture("back")
    act("key", "z")
    wait_until("word that nothing is left to take back", lambda: processes.says("client.log", "you have no cut to undo"), 10)
    sheet = Image.new("RGB", (3 * 320, 240))
    for k, name in enumerate(("above", "off", "back")):
        sheet.paste(Image.open(OUT / f"{name}.png").resize((320, 240)), (k * 320, 0))
    sheet.save(OUT / "sheet.png")
    commands = processes.leave(client, server)
    assert commands["undo"] == {"granted": 1, "refused": 1}, commands
