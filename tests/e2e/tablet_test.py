#!/usr/bin/python3
"""tablet_test.py BIN OUT [liver]: a user before a synthetic camera, with a bare right hand and a tablet of printed tags, looks through that
camera. The hand presses the organ, makes a fist in it, opens, goes to the tablet and stays at a button; and again. An observer sees the organ deformed, the
panel where the tablet is, and the button pressed. `liver`: it is the CT's, in the scene that ships."""
import os
import pathlib
import shutil
import signal
import sys
import time

import numpy

from anatomy import ON_LIVER, anatomy
from checks import check, finish
from program import Program
from session_log import SessionLog
from tablet_scene import OPEN, FIST, POINT, TABLET, Scene, about, looking, wrist_for

HERE = pathlib.Path(__file__).parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
LIVER = "liver" in sys.argv[3:]
DATA = pathlib.Path(os.environ.get("PROSECTOR_DATA") or anatomy("models").parent)
if not (DATA / "models/palm_full.tflite").exists():
    print("skipped: the networks that find hands aren't here; deploy/fetch_models.sh fetches them")
    sys.exit(77)
if LIVER and not anatomy("liver.inr.gz").exists():
    print("skipped: the CT's liver isn't here; deploy/fetch_anatomy.sh fetches it")
    sys.exit(77)
SHIPPED = HERE.parent.parent / "deploy/scenes/touch.toml"
ORGAN = "liver" if LIVER else "organ"
TOP = numpy.array(ON_LIVER if LIVER else [-0.06, 1.03, 0.02])
DEEP = 0.045  # m that the tips are to go below the top: a bare hand's depth is off by some 2 cm
BUTTON = "light shaft"  # deploy's table of controls, common/panel.h
AT_BUTTON = (0.071, -0.012)

shutil.rmtree(OUT, ignore_errors=True)
scene = Scene(OUT / "scene")
flat = about((1, 0, 0), 0.3)  # fingers ahead and a little up: from above, a fist is recognised best this way (docs/do/bare-hands.md)
press = wrist_for(TOP, flat, 0.1)
pointing = looking(numpy.array([0.28, 1.3, 0.5]), scene.on_tablet(*AT_BUTTON, 0.01))
point = wrist_for(scene.on_tablet(*AT_BUTTON, 0.009), pointing, 0.05)
way = [(0, press + (0, 0.07, 0), flat, OPEN), (4, press + (0, 0.07, 0), flat, OPEN), (5, press - (0, DEEP, 0), flat, OPEN),
       (7, press - (0, DEEP, 0), flat, OPEN), (7.5, press - (0, DEEP, 0), flat, FIST), (9.5, press + (0, 0.01, 0), flat, FIST),
       (12, press + (0, 0.01, 0), flat, FIST), (12.5, press + (0, 0.03, 0), flat, OPEN), (13.2, press + (0, 0.1, 0), flat, OPEN),
       (14.5, point + pointing @ (0, 0, 0.03), pointing, POINT), (15, point, pointing, POINT), (20, point, pointing, POINT),
       (21, point + pointing @ (0, 0, 0.1), pointing, POINT)]  # a person waits where few pictures come a second
for key in way:
    scene.hold(*key)
config = scene.write(120, 0.04)

LOG = SessionLog(OUT / "observer.jsonl")
session = f"tablet{os.getpid()}"
programs = []


def start(*words):
    programs.append(Program(*words))
    return programs[-1]


def panels():
    return [line["panels"]["Holder"] for line in LOG.lines() if "Holder" in line["panels"]]


def organs():
    return [line["parts"][ORGAN] for line in LOG.lines() if {"shift"} <= line["parts"].get(ORGAN, {}).keys()]


try:
    start(BIN / "prosector-server", SHIPPED if LIVER else HERE / "tablet.toml", "--session", session, "--cache", OUT / "cache").wait("is open", seconds=120)
    observer = start(BIN / "prosector-client", "observe", "--name", "Watcher", "--session", session, "--display", "offscreen", "--size", "640x480",
                     "--session-log", LOG.file)
    observer.wait("everything is here")
    record = ["--record", OUT / "through.avi"] if "record" in sys.argv[3:] else []
    holder = start(BIN / "prosector-client", "join", "--name", "Holder", "--session", session, "--display", "ar:offscreen", "--size", "640x480",
                   "--no-overlay", "--config", config, *record)
    holder.wait("everything is here")
    begun = time.monotonic()
    check("the tablet is the panel", LOG.wait(panels, 20))
    check("the bare hand presses the organ", LOG.wait(lambda: any(force > 0.2 for force in LOG.pushes("Holder, right", ORGAN)), 20))
    holder.say(f"picture {OUT / 'holder_press.png'}")
    observer.say(f"picture {OUT / 'observer_press.png'}")
    check("its finger presses the tablet's button", LOG.wait(lambda: any(panel["controls"][BUTTON]["on"] for panel in panels()), 45))
    holder.say(f"picture {OUT / 'holder_button.png'}")
    observer.say(f"picture {OUT / 'observer_button.png'}")
    check("its fist takes hold of the organ, then or the next time around",
          LOG.wait(lambda: any("Holder, right" in organ.get("holders", []) for organ in organs()), 40))
    time.sleep(1)
    print(f"after {time.monotonic() - begun:.1f} s")
    for program in (holder, observer):
        program.end(signal.SIGINT)
        check("a client ends well", program.process.returncode == 0)
finally:
    for program in programs:
        program.end(signal.SIGKILL)
    if "-v" in sys.argv:
        print("\n".join(line for program in programs for line in program.lines))
off = [numpy.linalg.norm(numpy.array(panel["at"]) - TABLET) for panel in panels()]
print(f"the panel is {1e3 * numpy.median(off):.1f} mm from the tablet's mean place (median), {1e3 * max(off):.1f} at most")
check("the panel is where the tablet is", numpy.median(off) < 0.008 and max(off) < 0.02)
check("it is the organ's", {panel["part"] for panel in panels()} == {ORGAN})
others = {name for panel in panels() for name, control in panel["controls"].items() if control["on"] and name not in (BUTTON, "attach", "room bright")}
check(f"no other button was pressed: {others}", not others)
moved = max((numpy.linalg.norm(organ["shift"]) for organ in organs()), default=0)
print(f"the organ's middle went {1e3 * moved:.1f} mm; its hardest press {max(LOG.pushes('Holder, right', ORGAN), default=0):.2f} N")
check("the observer sees the organ deformed", moved > 0.0005)
finish()
