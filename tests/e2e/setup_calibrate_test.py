#!/usr/bin/python3
"""setup_calibrate_test.py PROGRAMS OUT: a person calibrates a simulated tracker and glove in the set-up window, by guided steps, in less than
three minutes, and saves. What is written is compared with what the twins were told, which the window never sees."""

import math
import os
import pathlib
import sys
import time
import tomllib

from checks import check, finish
from desk_person import Processes, wait_until
from setup_window import SetupWindow

PROGRAMS, OUT = map(pathlib.Path, sys.argv[1:3])

ROOM = (0.3, 0.8, 0.5, math.cos(0.1), 0.0, math.sin(0.1), 0.0)  # where the twin's transmitter stands, and how it is turned
POINTS = [(0, 0.9, 0), (0.4, 0.9, 0), (0, 0.9, 0.4), (0.4, 0.9, 0.4)]  # as the page proposes them
NOISE = ["--noise-cm", "0.046", "--noise-deg", "0.0866", "--seed", "22"]  # the FASTRAK's, an axis


def touching():
    """A receiver that goes from point to point, and when it is at each."""
    rows, times = ["time,station,x,y,z,qw,qx,qy,qz", "0,1,0.2,1.1,0.2,1,0,0,0"], []
    for k, point in enumerate(POINTS):
        times.append(0.5 * (k + 1))
        rows.append(f"{times[-1]},1,{','.join(map(str, point))},1,0,0,0")
    return "\n".join(rows + [f"{times[-1] + 0.5},1,0.2,1.1,0.2,1,0,0,0"]) + "\n", times


def bending():
    """A hand that is flat, a fist, and bends each finger, and when it is so."""
    bends = [[0] * 5, [1] * 5] + [[1 if i == f else 0 for i in range(5)] for f in range(5)]
    times = [0.4 * (k + 1) for k in range(len(bends))]
    rows = [f"{t:.1f},{','.join(map(str, bend))}" for t, bend in zip(times, bends)]
    return "\n".join(["time,thumb,index,middle,ring,little", "0,0.5,0.5,0.5,0.5,0.5", *rows]) + "\n", times


def go_through(user, twin, steps, what):
    """Lets the twin's person do what the window asks for, one step after the other."""
    for step in range(2, steps + 1):
        wait_until(f"step {step} of {what}", lambda: user.words() == f"Step {step} of {steps}" or user.words() == "Done.", 60)
        twin.stdin.write(b"\n")
        twin.stdin.flush()
    wait_until(what, lambda: user.words() == "Done.", 60)


with Processes(OUT) as processes:
    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config")
    os.environ["XDG_CACHE_HOME"] = str(OUT / "cache")
    holds = {}
    for name, (text, times) in (("touching", touching()), ("bending", bending())):
        (OUT / f"{name}.csv").write_text(text)
        holds[name] = ",".join(f"{t:.1f}" for t in times)
    config = OUT / "client.toml"
    config.write_text(f"""# my laboratory
[tracker]
address = "fastrak:{OUT}/tracker"
hemisphere = [0, 0, -1]

[glove.right]
address = "5dt-usb:{OUT}/glove"  # the left one is at the repair shop
""")
    tracker = processes.start("tracker.log", PROGRAMS / "prosector-fastrak-twin", "--script", OUT / "touching.csv", "--link", OUT / "tracker",
                    "--wait-client", "--hold", holds["touching"], "--room-device", ",".join(map(str, ROOM)), *NOISE)
    glove = processes.start("glove.log", PROGRAMS / "prosector-5dt-twin", "--script", OUT / "bending.csv", "--link", OUT / "glove", "--wait-client",
                            "--hold", holds["bending"], "--hid", "--noise-counts", "3")
    wait_until("the devices", lambda: (OUT / "tracker").exists() and (OUT / "glove").exists())
    (OUT / "scenes").mkdir()
    user = SetupWindow(processes, PROGRAMS, "Ada", "--config", config, "--scenes", OUT / "scenes")
    began = time.monotonic()
    user.click("Tracker")
    user.click("Position in the room")
    user.sees("begin")
    user.click("begin")
    wait_until("the first step", lambda: user.words().startswith("Step"))
    user.picture("setup-calibrate.png")
    go_through(user, tracker, len(POINTS), "the tracker's place")
    user.picture("setup-calibrated.png")
    user.click("save")
    wait_until("the file", lambda: "room" in config.read_text())
    user.click("Glove")
    user.click("Sensor range")
    user.click("begin")
    go_through(user, glove, 7, "the glove's counts")
    user.click("save")
    wait_until("the file", lambda: "closed" in config.read_text())
    took = time.monotonic() - began
    print(f"tracker and glove took {took:.0f} s")
    check("a tracker and a glove are calibrated in less than three minutes", took < 180)
    user.end()

    text = config.read_text()
    written = tomllib.loads(text)
    place = written["tracker"]["room"]["position"]
    turn = written["tracker"]["room"]["orientation"]
    off = math.dist(place, ROOM[:3])
    angle = 2 * math.acos(min(1, abs(sum(a * b for a, b in zip(turn, ROOM[3:])))))
    print(f"the tracker's place is {1e3 * off:.2f} mm off, its turn {math.degrees(angle):.3f} degrees")
    check("the tracker stands where it was put, within 3 mm", off < 3e-3)
    check("and as it was turned, within half a degree", math.degrees(angle) < 0.5)
    opened, closed = written["glove"]["right"]["open"], written["glove"]["right"]["closed"]
    print(f"open {opened}, closed {closed}")
    check("counts are those of the glove", all(abs(o - 800) < 5 and abs(c - 1300) < 5 for o, c in zip(opened, closed)))
    check("comments stay", "# my laboratory" in text and "# the left one is at the repair shop" in text)
finish()
