#!/usr/bin/python3
"""desk_cut_test.py BIN OUT, run under xvfb-run: a person at a desk cuts the liver of cut.toml with the mouse, as
docs/understand/cutting.md tells: from above, takes up the knife, turns the wrist with Shift and Alt and the wheel, lowers the blade into
the left lobe with the wheel, draws it through, lets go, and takes the cut back with Z. What came of it is read in the client's log, in the server's summary and in
pictures."""

import os
import pathlib
import sys
import time

from desk_person import Processes, View, act, wait_until, windows

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SCENE = pathlib.Path(__file__).parents[2] / "deploy/scenes/cut.toml"
SIZE = 640, 480
FOV = 0.75  # the scene's camera's
HANDLE = 0.23, 0.91, 0.12  # the knife's, as it lies
BEHIND_LOBE = 0.03, 0.9, -0.11  # where the knife's tip is brought, so that the blade is over the lobe
BEFORE_LOBE = 0.03, 0.95, 0.08  # where it is drawn to
HIGH, DEEP = 16, 35  # notches of a centimetre: above the surface, and from there down


def parts():
    """Of the scene, by name."""
    return view.last_line().get("parts", {})


def topology():
    """All meshes' hash."""
    return view.last_line().get("topology")


def revision():
    return parts().get("liver", {}).get("revision", 0)


def holds_knife():
    return "mouse, right" in parts().get("knife", {}).get("holders", [])


def pieces():
    return [name for name, part in parts().items() if name.startswith("liver piece") and not part.get("hidden")]


with Processes(OUT) as processes:
    session = f"desk-cut-{os.getpid()}"
    server = processes.start("server.log", BIN / "prosector-server", SCENE, "--session", session, "--domain", 92,
                             "--summary", OUT / "server.json", "--journal", OUT / "journal.sqlite")
    wait_until("the server", lambda: processes.says("server.log", "is open on this machine"), 60)
    client = processes.start("client.log", BIN / "prosector-client", "join", "--name", "mouse", "--session", session, "--domain", 92,
                             "--size", "x".join(map(str, SIZE)), "--quality", "low", "--no-overlay", "--session-log", OUT / "log.jsonl")
    window = wait_until("the window", lambda: windows(f"Prosector: {session}"))[0]
    act("windowfocus", window)
    wait_until("the scene", lambda: processes.says("client.log", "everything is here"))
    view = View(window, SIZE, FOV, OUT / "log.jsonl")
    view.eyes()
    view.picture().save(OUT / "start.png")
    act("key", "4")  # from above
    view.wheel(-5, "ctrl")  # so that the knife is in the picture, too
    view.settle()
    view.picture().save(OUT / "before.png")

    view.point_at(HANDLE)
    time.sleep(1)
    act("mousedown", 1)
    wait_until("the knife in the hand", holds_knife, 10)
    view.hand_settles()  # it goes up
    view.wheel(-HIGH)
    view.hand_settles()
    view.roll(-1.6)  # the edge down
    view.wheel(-3, "alt")  # the tip lower than the hand
    view.hand_settles()
    view.draw(HANDLE, BEHIND_LOBE, 20)
    view.hand_settles()
    view.picture().save(OUT / "above.png")
    assert revision() == 0, "cut before the knife came down"
    for _ in range(DEEP):
        view.wheel(1)
        time.sleep(0.1)
    strokes = 0
    for way in (BEHIND_LOBE, BEFORE_LOBE), (BEFORE_LOBE, BEHIND_LOBE), (BEHIND_LOBE, BEFORE_LOBE):
        view.draw(*way, 20)
        strokes += 1
        time.sleep(1)
        if pieces():
            break
    view.picture().save(OUT / "through.png")
    assert revision() > 0, "the knife cut nothing"
    cut_off = pieces()
    act("mouseup", 1)
    wait_until("the knife let go", lambda: not holds_knife(), 10)
    time.sleep(1)
    view.picture().save(OUT / "cut.png")
    print("revision", revision(), "pieces", cut_off)

    assert cut_off, "nothing came off"
    undone = 0
    while pieces():  # what came off may have been nicked when it lay beside the blade: that is a later cut
        assert undone < 3 * strokes, f"{undone} cuts taken back after {strokes} strokes, and still off: {pieces()}"
        before = topology()
        act("key", "z")
        wait_until("a cut taken back", lambda: topology() not in (None, before), 10)
        undone += 1
        time.sleep(1)
    shift = parts()["liver"]["shift"]
    assert max(map(abs, shift)) < 0.005, f"the liver is not where it was: {shift} m"
    view.picture().save(OUT / "undone.png")
    commands = processes.leave(client, server)
    assert commands["grasp"]["granted"] == 1 and commands["undo"] == {"granted": undone, "refused": 0}, commands
