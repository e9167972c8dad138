#!/usr/bin/python3
"""setup_eyes_test.py PROGRAMS OUT: a person with a simulated receiver on a worn display lays crosses over a mark in the room, by the keyboard
alone, in the set-up window. What is written is compared with the eyes that the twin's poses were made for, which the window never sees."""

import math
import os
import pathlib
import sys
import time
import tomllib

from checks import check, finish
from desk_person import Processes, act, cross, minus, plus, times, wait_until
from setup_window import SetupWindow

PROGRAMS, OUT = map(pathlib.Path, sys.argv[1:3])

CROSSES, COLUMNS, ROWS, STRIDE, PLACES = 12, 5, 4, 7, 20  # of each eye, as the window shows them
MARK = (0, 1.2, -1.0)  # as the page proposes it
APART, CONVERGENCE = 0.066, 0.8  # m
HALF = (math.tan(math.radians(20)), math.tan(math.radians(15.5)))  # of an eye's field of view
MOUNT = (0.01, -0.09, -0.06)  # the point between the eyes, in the receiver's frame, whose axes are the head's


def turned(q, v):
    """A vector turned by a unit quaternion."""
    w, axis = q[0], q[1:]
    t = times(2, cross(axis, v))
    return plus(plus(v, times(w, t)), cross(axis, t))


def head_poses():
    """Where the receiver is when each cross lies over the mark: left eye's, right eye's."""
    out = []
    for n in range(2 * CROSSES):
        right, place = n >= CROSSES, n % CROSSES * STRIDE % PLACES
        u, v = (place % COLUMNS + 0.5) / COLUMNS, (place // COLUMNS + 0.5) / ROWS
        side = 0.5 if right else -0.5
        far = 0.6 if n % 2 == 0 else 1.6
        x = far * ((2 * u - 1) * HALF[0] - side * APART / CONVERGENCE)
        seen = (x + side * APART, far * (1 - 2 * v) * HALF[1], -far)
        angle = 0.15 * math.sin(2.4 * n)
        q = (math.cos(angle / 2), 0.3 * math.sin(angle / 2), math.sqrt(1 - 0.09) * math.sin(angle / 2), 0)
        out.append((*minus(MARK, turned(q, plus(MOUNT, seen))), *q))
    return out


with Processes(OUT) as processes:
    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config")
    os.environ["XDG_CACHE_HOME"] = str(OUT / "cache")
    rows, held = ["time,station,x,y,z,qw,qx,qy,qz", "0,2,0.3,1.2,0.5,1,0,0,0"], []
    for pose in head_poses():
        held.append(0.1 * (len(held) + 1))
        rows.append(f"{held[-1]:.2f},2," + ",".join(f"{v:.6f}" for v in pose))
    (OUT / "head.csv").write_text("\n".join(rows) + "\n")
    config = OUT / "client.toml"
    config.write_text(f"""[tracker]
address = "fastrak:{OUT}/tracker"
hemisphere = [0, 0, -1]
room.position = [0, 0.5, 0.5]

[tracker.stations]
head.station = 2  # on the visor
""")
    twin = processes.start("tracker.log", PROGRAMS / "prosector-fastrak-twin", "--script", OUT / "head.csv", "--link", OUT / "tracker",
                           "--wait-client", "--hold", ",".join(f"{t:.2f}" for t in held), "--room-device", "0,0.5,0.5,1,0,0,0",
                           "--noise-cm", "0.01", "--noise-deg", "0.01", "--seed", "5")
    wait_until("the tracker", lambda: (OUT / "tracker").exists())
    (OUT / "scenes").mkdir()
    user = SetupWindow(processes, PROGRAMS, "Ada", "--config", config, "--scenes", OUT / "scenes")
    user.click("Pictures")
    user.click("by crosses")
    user.sees("crosses 12")
    user.picture("setup-eyes.png")
    user.click(f"crosses {CROSSES}")
    user.click("begin eyes")
    began = time.monotonic()
    for n in range(2 * CROSSES):
        wait_until(f"cross {n + 1}", lambda: user.words() == f"Cross {n + 1} of {2 * CROSSES}")
        while user.words() == f"Cross {n + 1} of {2 * CROSSES}":  # as soon as the head is still
            act("key", "space")
            time.sleep(0.08)
        if n == CROSSES + 3:
            user.picture("setup-crosses.png")
        twin.stdin.write(b"\n")
        twin.stdin.flush()
    wait_until("the end", lambda: user.words() == "Done.")
    print(f"{2 * CROSSES} crosses took {time.monotonic() - began:.0f} s")
    user.click("save")
    wait_until("the file", lambda: "[eyes]" in config.read_text())
    user.picture("setup-eyes-done.png")
    user.end()
    written = tomllib.loads(config.read_text())
    eyes, mount = written["eyes"], written["tracker"]["stations"]["head"]["mount"]["position"]
    print(eyes, mount)
    check("eyes are as far apart as they are", abs(eyes["distance"] - APART) < 2e-3)
    check("they see as much", abs(eyes["fov_horizontal"] - 40) < 0.5 and abs(eyes["fov_vertical"] - 31) < 0.5)
    check("pictures coincide where they do", abs(eyes["convergence"] - CONVERGENCE) < 0.1)
    check("the eyes are where they are on the receiver", math.dist(mount, MOUNT) < 3e-3)
    check("comments stay", "# on the visor" in config.read_text())
finish()
