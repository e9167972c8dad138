#!/usr/bin/python3
"""setup_face_test.py PROGRAMS SCENES OUT: a person makes the screen a window into the room in the set-up window: names a synthetic camera that
sees a face, types what a ruler says, reads where the eyes are told to be, saves, hosts a session, and looks into it through the screen."""

import math
import os
import pathlib
import re
import sys
import time
import tomllib

from checks import check, finish
from desk_person import Processes, skip, wait_until, window_of
from setup_window import SetupWindow, some_scenes

PROGRAMS, SCENES, OUT = map(pathlib.Path, sys.argv[1:4])
DATA = pathlib.Path(os.environ.get("PROSECTOR_DATA") or pathlib.Path(os.environ.get("XDG_DATA_HOME") or pathlib.Path.home() / ".local/share") / "prosector")
EYES = (0.08, 0.06, 0.65)  # m, from the screen's middle; apart as people's are in the mean
CAMERA_UP = 0.17

if not (DATA / "models/face_short_range.tflite").exists():
    skip("the network that finds faces isn't here; deploy/fetch_models.sh fetches it")


def told(user):
    """What the page tells of the eyes, mm: from the camera."""
    for control in user.read()["controls"]:
        if found := re.match(r"reported: eyes (\d+) mm from the camera", control):
            return float(found.group(1))
    return None


with Processes(OUT) as processes:
    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config")
    os.environ["XDG_CACHE_HOME"] = str(OUT / "cache")
    scenes = some_scenes(OUT / "scenes", SCENES, "minimal.toml")
    face = OUT / "face.toml"
    face.write_text(f"[[camera]]\nrate = 8\nrays = 1\nposition = [0, {CAMERA_UP}, 0]\norientation = [0, 0, 1, 0]\n"
                    f"[[face]]\nposition = [{', '.join(map(str, EYES))}]\n")
    config = OUT / "client.toml"
    config.write_text("# my screen\n")
    user = SetupWindow(processes, PROGRAMS, "Ada", "--config", config, "--scenes", scenes)
    user.click("Window")
    user.click("window.address")
    user.type(f"face:synthetic:{face}")
    for field, value in (("height", "310"), ("camera up", f"{1e3 * CAMERA_UP:.0f}")):
        user.click(field)
        user.type(value)
    time.sleep(2)  # it looks anew with what was typed
    wait_until("the eyes", lambda: told(user), 60)
    away = 1e3 * math.dist(EYES, (0, CAMERA_UP, 0))
    print(f"the eyes are {away:.0f} mm from the camera, and told to be {told(user):.0f} mm")
    check("a ruler says the same within a tenth", abs(told(user) - away) < 0.1 * away)
    user.picture("setup-window.png")
    user.click("save")
    wait_until("the file", lambda: "window" in config.read_text())
    written = tomllib.loads(config.read_text())["window"]
    check("what was typed is written", written["address"] == f"face:synthetic:{face}" and written["height"] == 0.31
          and written["camera"]["position"] == [0, CAMERA_UP, 0])
    check("comments stay", "# my screen" in config.read_text())

    user.click("Join")
    user.sees("scene minimal")
    user.click("scene minimal")
    user.click("host")
    window_of(user.process, "^Prosector: anatomy", "the session's window", 60)
    wait_until("the eyes in the session", lambda: processes.says("Ada.log", f"window face:synthetic:{face}: streaming"), 60)
    check("who enters looks through the screen as through a window", True)
    user.leave()
    wait_until("the room", lambda: user.words() == "You left the session.", 30)
    user.end()
    check("it ends cleanly", user.process.returncode == 0)
finish()
