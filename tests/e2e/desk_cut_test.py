#!/usr/bin/python3
"""desk_cut_test.py BIN OUT, run under deploy/with_display.sh: a person at a desk cuts the liver of cut.toml with the mouse, as docs/do/join.md
tells: from above, takes up the knife, draws it over the liver with the button held, puts it down with a click beside the liver, and
takes the cut back with Z. What came of it is read in the client's log, in the server's summary and in pictures."""

import os
import pathlib
import re
import sys
import time

from PIL import Image

from desk_person import Processes, View, act, minus, plus, times, wait_until

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SCENE = pathlib.Path(__file__).parents[2] / "deploy/scenes/cut.toml"
SIZE = 640, 480
FOV = 0.75  # the scene's camera's
HANDLE = 0.23, 0.91, 0.12  # the knife's, as it lies
BEGIN, END = (-0.08, 1.03, -0.02), (0.06, 1.03, -0.02)  # of the drawn cut, on the liver
BESIDE = 0.2, 0.9, -0.2  # where no tissue is
TOLD = re.compile(r"cut: (\d+) mm long, (\d+) mm deep, in the liver")


def revision():
    return view.parts().get("liver", {}).get("revision", 0)


def holds_knife():
    return "mouse, right" in view.parts().get("knife", {}).get("holders", [])


def take_up_the_knife():
    """Takes it up with a click, and again where it was let go of: the server does that when a client stands still for half a
    second. How often it was taken."""
    for times_taken in 1, 2, 3:
        view.point_at(HANDLE)
        view.hand_settles()
        act("mousedown", 1)
        wait_until("the knife in the hand", holds_knife)
        act("mouseup", 1)
        view.hand_settles()
        if holds_knife():
            return times_taken
        reasons = [line for line in (OUT / "server.log").read_text().splitlines() if " released" in line]
        print("the knife did not stay in the hand:", *reasons[-1:])
    raise AssertionError("the knife did not stay in the hand three times")


def told():
    """Length and depth of the cuts that the client told of, mm."""
    return [tuple(map(int, found)) for found in TOLD.findall((OUT / "client.log").read_text())]


def share_of_dark(image, start, end):
    """Of places along the line in the picture, those with something darker than half of what is beside them."""
    grey, dark, places = image.convert("L"), 0, 40
    for k in range(places + 1):
        x, y = (round(a - b) for a, b in zip(view.pixel(plus(start, times(k / places, minus(end, start)))), (view.left, view.top)))
        beside = sorted(grey.getpixel((x, y + d)) for d in (-20, -16, 16, 20))[1]
        dark += min(grey.getpixel((x, y + d)) for d in range(-9, 10)) < 0.5 * beside
    return dark / (places + 1)


def dark_along_the_cut():
    """The share of dark places along the drawn way, but for its ends, in the window now."""
    return share_of_dark(view.picture(), plus(BEGIN, (0.03, 0, 0)), plus(END, (-0.03, 0, 0)))


def sheet(names):
    """The pictures of these names side by side: what is around the liver."""
    out = Image.new("RGB", (len(names) * 300, 184))
    for k, name in enumerate(names):
        out.paste(Image.open(OUT / f"{name}.png").crop((200, 120, 500, 304)), (k * 300, 0))
    out.save(OUT / "sheet.png")


with Processes(OUT) as processes:
    server, client, window = processes.host_and_join(BIN, SCENE, f"desk-cut-{os.getpid()}", SIZE)
    view = View(window, SIZE, FOV, OUT / "log.jsonl")
    view.eyes()
    view.picture().save(OUT / "start.png")
    view.after(lambda: act("key", "4"))  # from above
    view.after(lambda: view.wheel(-5, "ctrl"))  # so that the knife is in the picture, too
    view.picture().save(OUT / "before.png")

    taken = take_up_the_knife()
    view.draw(HANDLE, BEGIN, 10)
    view.hand_settles()
    view.picture().save(OUT / "above.png")
    assert revision() == 0, "cut before the button went down"
    act("mousedown", 1)
    view.draw(BEGIN, END, 20)
    view.hand_settles()  # a person looks whether the blade is there, however slow the pictures are
    view.picture().save(OUT / "drawn.png")
    act("mouseup", 1)
    length, depth = wait_until("the figures of the cut", told)[0]
    view.draw(END, BESIDE, 5)
    time.sleep(1)
    view.picture().save(OUT / "cut.png")
    dark = dark_along_the_cut()
    print("revision", revision(), "length", length, "depth", depth, "dark", dark)
    assert 60 <= length <= 250 and 6 <= depth <= 18, f"{length} mm long, {depth} mm deep"
    assert dark > 0.8, f"the line of the cut is seen along {dark:.0%} of its way"
    sheet(["above", "drawn", "cut"])
    act("click", 1)
    wait_until("the knife let go", lambda: not holds_knife(), 10)
    before = view.topology()
    act("key", "z")
    wait_until("the cut taken back", lambda: view.topology() not in (None, before), 10)
    wait_until("the line of the cut gone", lambda: dark_along_the_cut() < 0.2, 10)
    view.picture().save(OUT / "undone.png")
    wait_until("no piece left", lambda: not view.pieces(), 10)
    commands = processes.leave(client, server)
    assert commands["grasp"]["granted"] == taken and commands["undo"] == {"granted": 1, "refused": 0}, commands
