#!/usr/bin/python3
"""setup_window_test.py PROGRAMS SCENES OUT: a person with a mouse and a fresh home opens the set-up window, hosts a session in it in two
clicks, takes part, comes back, and closes it. Another one sees the session and who is in, and watches it."""

import os
import pathlib
import sys

from checks import check, finish
from desk_person import Processes, wait_until, window_of
from setup_window import SetupWindow, some_scenes

PROGRAMS, SCENES, OUT = map(pathlib.Path, sys.argv[1:4])

with Processes(OUT) as processes:
    scenes = some_scenes(OUT / "scenes", SCENES, "minimal.toml", "rigid.toml")
    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config")
    os.environ["XDG_CACHE_HOME"] = str(OUT / "cache")
    host = SetupWindow(processes, PROGRAMS, "Ada", "--scenes", scenes)
    host.sees("scene minimal")
    host.click("scene minimal")
    host.click("host")
    window_of(host.process, "^Prosector: anatomy", "the session's window", 60)
    wait_until("everything of it", lambda: processes.says("Ada.log", "everything is here"), 60)
    check("two clicks lead into a hosted session", True)
    check("as its host", processes.says("Ada.log", "joined session 'anatomy' as Ada"))

    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config2")
    guest = SetupWindow(processes, PROGRAMS, "Bea", "--scenes", scenes)
    guest.sees("session anatomy")
    guest.click("session anatomy")
    guest.click("watch")
    wait_until("the scenes' pictures", lambda: len(list((OUT / "cache").rglob("*-scene.png"))) == 2, 60)
    guest.picture("setup-enter.png")
    guest.click("enter")
    wait_until("the guest", lambda: processes.says("Bea.log", "observing session 'anatomy' as Bea"), 30)
    wait_until("everything for the guest", lambda: processes.says("Bea.log", "everything is here"), 60)

    for person in (guest, host):
        person.leave()
    wait_until("the guest's room", lambda: guest.words() == "You left the session.", 30)
    check("the session's window leads back to the set-up window", True)
    wait_until("the host's room", lambda: host.words() == "You left the session.", 30)
    host.end()
    check("it ends cleanly", host.process.returncode == 0)
    wait_until("the end of the session", lambda: "enter" not in guest.read()["controls"], 30)
    check("and with it its session", True)
    guest.end()

    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config")
    memory = (OUT / "config/prosector/anteroom.toml").read_text()
    check("what was chosen is kept", 'name = "Ada"' in memory.replace("'", '"') and "anatomy" in memory and "minimal.toml" in memory)
finish()
