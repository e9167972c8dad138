#!/usr/bin/python3
"""hands_test.py BIN OUT: a bare hand before a synthetic camera presses tissue in a real session, makes a fist and opens again. Then the
camera gives torn and black pictures, and is unplugged: each is told in words or passed over, and the hand comes back by itself."""
import os
import pathlib
import signal
import sys
import time

from checks import check, failures
from program import Program
from session_log import SessionLog

HERE = pathlib.Path(__file__).parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
DATA = pathlib.Path(os.environ.get("PROSECTOR_DATA") or pathlib.Path(os.environ.get("XDG_DATA_HOME") or pathlib.Path.home() / ".local/share") / "prosector")
if not (DATA / "models/palm_full.tflite").exists():
    print("skipped: the networks that find hands aren't here; deploy/fetch_models.sh fetches them")
    sys.exit(77)
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("hands*"):
    old.unlink()
LOG = SessionLog(OUT / "hands.jsonl")
PRESSES = 4  # s of the script
TORN, BLACK, UNPLUGGED, SPAN = 8, 9, 10, 0.6  # s of the camera's time

session = f"hands{os.getpid()}"
# A hand that points down, whose index finger's tip goes 20 mm into the block; its palm is to the camera.
turn = [0.70710678, -0.70710678, 0, 0]
reach = [0.0315, 1.03 + 0.178, 0]  # of the wrist, when the tip is at the block's top (arm_client.toml)
rows = [[t, reach[0], reach[1] + up, reach[2], *turn, *bends]
        for t, up, bends in ((0, 0.06, [0.1] * 5), (PRESSES - 1.5, 0.06, [0.1] * 5), (PRESSES, -0.02, [0.1] * 5), (60, -0.02, [0.1] * 5))]
(OUT / "hands_press.csv").write_text("time,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n")
camera = [0.03, 1.16, 0.5]
faults = "".join(f'[[fault]]\nkind = "{kind}"\nfrom = {at}\nto = {at + SPAN}\n' for kind, at in (("torn", TORN), ("black", BLACK), ("unplugged", UNPLUGGED)))
(OUT / "hands_scene.toml").write_text(
    f'ambient = 0.6\n[[camera]]\nrate = 15\nrays = 2\ndistortion = [-0.18, 0, 0, 0, 0]\nposition = {camera}\norientation = [1, 0, 0, 0]\n'
    f'[[hand]]\nmotion = "hands_press.csv"\nstation = 1\n{faults}')
programs = []
try:
    programs.append(Program(BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache"))
    programs[0].wait("is open")
    address = f"hands:synthetic:{OUT / 'hands_scene.toml'}"
    (OUT / "hands.toml").write_text(f'[tracker]\naddress = "{address}"\n[tracker.room]\nposition = {camera}\norientation = [1, 0, 0, 0]\n')
    started = time.monotonic()
    user = Program(BIN / "prosector-client", "join", "--name", "Feeler", "--display", "none", "--config", OUT / "hands.toml", "--session-log",
                   LOG.file, "--session", session)
    programs.append(user)
    user.wait("everything is here")

    def told(state):
        return [line for line in user.lines if line.startswith(f"tracker {address}: {state}")]

    check("it isn't away while it is being opened", not told("absent"))

    check("the camera streams", LOG.wait(lambda: told("streaming"), 5))
    check("the bare hand presses the tissue", LOG.wait(lambda: any(force > 0.3 for force in LOG.pushes("Feeler, right")), PRESSES + 4))
    print(f"the hand pushes with {LOG.pushes('Feeler, right')[-1]:.2f} N" if LOG.pushes("Feeler, right") else "nothing is touched")
    check("an unplugged camera is told of", LOG.wait(lambda: told("absent"), max(started + UNPLUGGED + 4 - time.monotonic(), 1)))
    check(f"in words: {told('absent')[-1:]}", told("absent") and "unplugged" in told("absent")[-1])
    # A synthetic camera begins anew when it is opened, and so does its hand.
    check("it is opened again", LOG.wait(lambda: len(told("streaming")) == 2, 5))
    check("the hand comes back and lets go", LOG.wait(lambda: "Feeler, right" not in list(LOG.lines())[-1]["touches"], 5))
    seen = len(LOG.pushes("Feeler, right"))
    check("and presses again", LOG.wait(lambda: any(force > 0.3 for force in LOG.pushes("Feeler, right")[seen:]), PRESSES + 4))
    user.end(signal.SIGINT)
    check("the client ends well", user.process.returncode == 0)
    print("\n".join(line for line in user.lines if line.startswith("tracker ")))
finally:
    for program in programs:
        program.end(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
