#!/usr/bin/python3
"""openxr_test.py BIN OUT hands|controllers|faults: a client with a headset by OpenXR, whose runtime is our double: its wearer looks at a soft
ball and presses it. `faults`: whatever a runtime may do to a program, which comes back by itself each time."""
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from PIL import Image

from checks import check, figures, finish
from openxr_eyes import HEAD, look
from program import Program

HERE = pathlib.Path(__file__).parent
BIN, OUT, WHAT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
SIZE = 320  # pixels of an eye's picture, each way
RATE = 20  # frames a second of the headset with controllers: fewer than the client draws by itself
FAULTS = {  # s: what the double does, and what the user is told
    "--unfocused 0.2 0.8": ("hand tracking paused", "hand tracking restored"),
    "--garbage 1 1.5": (),
    "--recentred 1.7": ("re-centred",),
    "--session-lost 2.5": ("the session is lost",),
    "--frame-refused 4": ("the runtime failed",),
    "--instance-lost 5.5 --away 5.5 6.3": ("the runtime failed", "no runtime responds"),
    "--left 8": ("taken off",),
}

shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)


def told():
    """What the server says of the wearer, over time."""
    out = []
    for line in open(OUT / "client.jsonl"):
        try:
            out.append(json.loads(line))
        except json.JSONDecodeError:
            break
    return out


def wait_for(what, holds, seconds=20):
    end = time.monotonic() + seconds
    while not any(map(holds, told()[-1:])):
        if time.monotonic() > end:
            return check(what, False)
        time.sleep(0.1)
    check(what, True)


def near(place, wanted):
    return place is not None and math.dist(place["at"], wanted) < 0.01


def wearer(line):
    return line["people"].get("Wearer", {})


session = f"openxr{os.getpid()}"
words = f"--waits-for {OUT}/go --script {HERE / 'openxr_wearer.csv'} --pictures {OUT} --width {SIZE} --height {SIZE}"
words += {"hands": " --session-lost 4", "controllers": f" --controllers --no-stage --rate {RATE}", "faults": " " + " ".join(FAULTS)}[WHAT]
env = {"XR_RUNTIME_JSON": str(BIN.parent / "lib/twins/openxr_double.json"), "PROSECTOR_OPENXR": words}
programs = []
try:
    server = Program(BIN / "prosector-server", HERE.parents[1] / "deploy/scenes/minimal.toml", "--session", session)
    programs.append(server)
    server.wait("is open")
    client = [BIN / "prosector-client", "join", "--name", "Wearer", "--display", "openxr", "--session", session, "--no-overlay", "--summary", OUT / "client.json"]
    if WHAT == "faults":
        refused = subprocess.run(client, env={**os.environ, "XR_RUNTIME_JSON": "/none.json"}, capture_output=True, text=True, timeout=40)
        check("without a runtime the client says so", refused.returncode != 0 and "active_runtime.json" in refused.stderr)
    user = Program(*client, "--session-log", OUT / "client.jsonl", env=env)
    programs.append(user)
    user.wait("simulated headset by Prosector's OpenXR double")
    begin = time.monotonic()
    user.wait("everything is here")
    if WHAT == "controllers":
        user.wait("floor height unknown")
    wait_for("head and both hands arrive", lambda line: near(wearer(line).get("eyes"), HEAD)
             and near(wearer(line).get("left"), (-0.25, 1.1, 0.1)) and near(wearer(line).get("right"), (0.3, 1.2, 0.1)))
    if WHAT != "faults":
        look({eye: Image.open(OUT / f"{eye}.ppm").convert("RGB") for eye in ("left", "right")}, told()[-1]["parts"]["ball"]["at"])
    (OUT / "go").touch()
    if WHAT != "faults":
        rest = told()[-1]["parts"]["ball"]["size"][1]
        wait_for("the hand presses the ball", lambda line: line["parts"]["ball"]["size"][1] < rest - 0.005)
        user.wait("you hold the ball")  # once the hand is closed
    if WHAT == "hands":
        user.wait("the session is lost")
        user.wait("simulated headset by", 2)
        wait_for("what the wearer does then arrives again", lambda line: near(wearer(line).get("left"), (-0.25, 1.3, 0.1)))
    if WHAT == "faults":
        for lines in FAULTS.values():
            for line in lines:
                user.wait(line)
        user.ended(10)
        check("the client ends well when the headset's menu ends it", user.process.returncode == 0)
        check("it came back three times", sum("simulated headset by" in line for line in user.lines) == 4)
        places = [place["at"] for line in told() for place in [wearer(line).get("right")] if place]
        check("no garbage arrived", all(math.dist(at, (0.15, 1.1, 0.1)) < 0.4 for at in places))
        check("re-centred, the hand is elsewhere", any(abs(at[0] + 0.1) < 0.02 for at in places))
    if WHAT == "controllers":
        seconds = time.monotonic() - begin
        user.end(signal.SIGINT)
        pictures = figures(OUT / "client.json")["pictures"]
        print(f"{pictures} pictures in {seconds:.2f} s")
        check("the headset sets the rhythm", 5 < pictures < RATE * (seconds + 0.3))
    check("the client keeps to the specification", not any("simulated OpenXR: error:" in line for line in user.lines))
finally:
    for program in programs:
        program.end(signal.SIGINT)
if WHAT == "faults" or "-v" in sys.argv:
    print("\n".join(user.lines))
finish()
