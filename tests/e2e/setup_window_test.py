#!/usr/bin/env python3
"""setup_window_test.py PROGRAMS SCENES OUT: a person with a mouse and a fresh home opens the set-up window, hosts a session in it in two
clicks, takes part, comes back, and closes it. Another one sees the session and who is in, and watches it."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from PIL import ImageGrab

from checks import check, failures
from desk_person import Processes, act, corner, wait_until, windows

PROGRAMS, SCENES, OUT = map(pathlib.Path, sys.argv[1:4])
DOMAIN = 93


class SetupWindow:
    """The set-up window of one person, acted on by a mouse."""

    def __init__(self, processes, name):
        self.layout = processes.out / f"{name}.json"
        self.process = processes.start(f"{name}.log", PROGRAMS / "prosector-client", "setup", "--scenes", OUT / "scenes", "--domain", DOMAIN,
                                       "--name", name, "--layout-log", self.layout)
        self.window = wait_until("the set-up window", lambda: windows("^Prosector$"))[0]

    def read(self):
        try:
            return json.loads(self.layout.read_text())
        except (OSError, json.JSONDecodeError):
            return {"controls": {}, "words": ""}

    def words(self):
        return self.read()["words"]

    def click(self, control):
        left, top, right, bottom = wait_until(control, lambda: self.read()["controls"].get(control))
        x, y = corner(self.window)
        act("mousemove", x + (left + right) / 2, y + (top + bottom) / 2)
        time.sleep(0.1)
        act("click", 1)
        time.sleep(0.3)

    def leave(self):
        """Ends the client that it started."""
        clients = subprocess.run(["pgrep", "-P", str(self.process.pid), "-f", "--", "--session anatomy --name"], capture_output=True, text=True)
        os.kill(int(clients.stdout.split()[0]), signal.SIGINT)

    def sees(self, control, seconds=30):
        return wait_until(control, lambda: self.read()["controls"].get(control), seconds)


def picture(name):
    ImageGrab.grab(xdisplay="").save(OUT / name)


with Processes(OUT) as processes:
    scenes = OUT / "scenes"
    scenes.mkdir()
    for scene in ("minimal.toml", "rigid.toml", "touch.toml", "cut.toml"):
        shutil.copy(SCENES / scene, scenes)
    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config")
    os.environ["XDG_CACHE_HOME"] = str(OUT / "cache")
    host = SetupWindow(processes, "Ada")
    host.sees("scene minimal")
    host.click("scene minimal")
    host.click("host")
    session = wait_until("the session's window", lambda: windows("^Prosector: anatomy"), 60)[0]
    wait_until("everything of it", lambda: processes.says("Ada.log", "everything is here"), 60)
    check("two clicks lead into a hosted session", True)
    check("as its host", processes.says("Ada.log", "joined session 'anatomy' as Ada"))

    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config2")
    guest = SetupWindow(processes, "Bea")
    guest.sees("session anatomy")
    guest.click("session anatomy")
    guest.click("watch")
    wait_until("a picture of the scene", lambda: (OUT / "cache/prosector/pictures").is_dir())
    time.sleep(3)
    picture("setup-enter.png")
    guest.click("enter")
    wait_until("the guest", lambda: processes.says("Bea.log", "observing session 'anatomy' as Bea"), 30)
    wait_until("everything for the guest", lambda: processes.says("Bea.log", "everything is here"), 60)

    for person in (guest, host):
        person.leave()
    wait_until("the guest's room", lambda: guest.words() == "You are back from the session.", 30)
    check("the session's window leads back to the set-up window", True)
    wait_until("the host's room", lambda: host.words() == "You are back from the session.", 30)
    host.window = guest.window = None
    host.process.terminate()
    host.process.wait(20)
    check("it ends cleanly", host.process.returncode == 0)
    wait_until("the end of the session", lambda: "enter" not in guest.read()["controls"], 30)
    check("and with it its session", True)
    guest.process.terminate()
    guest.process.wait(20)

    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config")
    memory = (OUT / "config/prosector/anteroom.toml").read_text()
    check("what was chosen is kept", 'name = "Ada"' in memory.replace("'", '"') and "anatomy" in memory and "minimal.toml" in memory)
sys.exit("\n".join(failures) if failures else 0)
