#!/usr/bin/python3
"""tool_test.py BIN OUT: somebody holds a real instrument with a printed board before a synthetic camera, and looks through that camera. In the
session the instrument is the scene's scalpel: it is fetched, and cuts the block along the way of the real tip. An observer sees the cut."""
import pathlib
import shutil
import signal
import sys
import time

import numpy

from checks import check, finish
from program import Program
from session_log import SessionLog
from tablet_scene import FLAT, TABLE, Scene, about, quaternion

HERE = pathlib.Path(__file__).parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SHAFT = 0.12  # m, from the board's middle to the tip
X, TOP, AROUND = -0.06, 0.97, 16  # m, of the block's middle and its top; s, after which the way begins anew
TURN = about((1, 0, 0), -0.4)  # the shaft leans away from who holds it
HOLDER = "Holder, right"

shutil.rmtree(OUT, ignore_errors=True)
scene = Scene(OUT / "scene")
scene.hold(0, (0, 1.5, 2), numpy.eye(3), [0.1] * 5)  # a hand behind the camera
config = scene.write(60)


def board(x, y, z):
    return (*(numpy.array((x, y, z)) + TURN @ (0, SHAFT, 0)), *quaternion(TURN))


# The tip hovers until the scalpel is there, goes in, is drawn towards the user, and lifted.
way = [(0, (X, TOP + 0.06, -0.04)), (7, (X, TOP + 0.06, -0.04)), (8, (X, TOP - 0.02, -0.04)), (11, (X, TOP - 0.02, 0.05)),
       (12, (X, TOP + 0.06, 0.05)), (AROUND, (X, TOP + 0.06, -0.04))]
rows = [[t, *board(*at)] for t, at in way]
(OUT / "scene/instrument.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + "\n".join(",".join(f"{v:.6g}" for v in row) for row in rows) + "\n")
text = (OUT / "scene/scene.toml").read_text()
text = text[:text.index('[[board]]\nknown = "tablet"')]  # neither tablet nor hand
(OUT / "scene/scene.toml").write_text(text + '[[board]]\nknown = "instrument"\nmotion = "instrument.csv"\nloop = true\n')
config.write_text(
    f'[tracker]\naddress = "tags:synthetic:{OUT / "scene/scene.toml"}"\n[tracker.table]\nboard = "table"\nposition = [0, {TABLE}, 0.05]\n'
    f'orientation = {FLAT}\n[tracker.stations]\ninstrument.station = 1\ninstrument.tool = "scalpel"\n')

LOG = SessionLog(OUT / "observer.jsonl")
programs = []


def start(*words):
    programs.append(Program(*words))
    return programs[-1]


def parts(name):
    return [line["parts"][name] for line in LOG.lines() if name in line["parts"]]


def holds():
    return any(HOLDER in part.get("holders", []) for part in parts("scalpel"))


def revision():
    return max((part["revision"] for part in parts("organ") if "revision" in part), default=0)


session = f"tool{time.time_ns()}"
try:
    start(BIN / "prosector-server", HERE / "tool.toml", "--session", session, "--cache", OUT / "cache").wait("is open", seconds=120)
    observer = start(BIN / "prosector-client", "observe", "--name", "Watcher", "--session", session, "--display", "offscreen", "--size", "640x480",
                     "--session-log", LOG.file)
    observer.wait("everything is here")
    holder = start(BIN / "prosector-client", "join", "--name", "Holder", "--session", session, "--display", "ar:offscreen", "--size", "640x480",
                   "--no-overlay", "--config", config)
    holder.wait("everything is here")
    check("the instrument's hand takes the scalpel up", LOG.wait(holds, 20))
    uncut = revision()
    check("it cuts the block", LOG.wait(lambda: revision() > uncut, 30))
    time.sleep(1)
    holder.say(f"picture {OUT / 'holder.png'}")
    observer.say(f"picture {OUT / 'observer.png'}")
    time.sleep(2)
    for program in (holder, observer):
        program.end(signal.SIGINT)
        check("a client ends well", program.process.returncode == 0)
finally:
    for program in programs:
        program.end(signal.SIGKILL)
    if "-v" in sys.argv:
        print("\n".join(line for program in programs for line in program.lines))
finish()
