#!/usr/bin/python3
"""hands_test.py BIN OUT: a bare hand before a synthetic camera presses tissue in a real session, again and again. Boards
before the same camera say where it stands and where the head is. Then the camera gives torn and black pictures, and is unplugged: each is told in
words or passed over, and the hand comes back by itself."""
import math
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
FIRST, PERIOD, LAST = 2, 3, 180  # s: the first press begins, each takes, and the script ends
PATIENCE = 40  # s: a busy machine shows few pictures a second
TORN, BLACK, UNPLUGGED = (8, 8.6), (9, 9.6), (10, 11.5)  # s of the camera's time

session = f"hands{os.getpid()}"
# A hand that points down, whose index finger's tip goes 20 mm into the block and out again; its palm is to the camera. It doesn't stay in the
# block: a hand that isn't seen for a while and comes into sight there has no way in, and is held by whatever side is next.
turn = [0.70710678, -0.70710678, 0, 0]
reach = [0.0315, 1.03 + 0.178, 0]  # of the wrist, when the tip is at the block's top (arm_client.toml)
ups = [(0, 0.06)] + [(t + dt, up) for t in range(FIRST, LAST, PERIOD) for dt, up in ((0, 0.06), (1.2, -0.02), (1.8, -0.02))]
rows = [[t, reach[0], reach[1] + up, reach[2], *turn, *[0.1] * 5] for t, up in ups]
(OUT / "hands_press.csv").write_text("time,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n")
camera = [0.03, 1.16, 0.5]
TABLE = "position = [0.18, 1.28, 0]\norientation = [1, 0, 0, 0]\n"
HEAD = "position = [-0.12, 1.05, 0]\norientation = [1, 0, 0, 0]\n"
EYES = [-0.12, 0.99, -0.02]  # 6 cm below that board, and 2 cm behind
faults = "".join(f'[[fault]]\nkind = "{kind}"\nfrom = {begin}\nto = {end}\n' for kind, (begin, end) in (("torn", TORN), ("black", BLACK), ("unplugged", UNPLUGGED)))
(OUT / "hands_scene.toml").write_text(
    f'ambient = 0.6\n[[camera]]\nrate = 15\nrays = 2\ndistortion = [-0.18, 0, 0, 0, 0]\nposition = {camera}\norientation = [1, 0, 0, 0]\n'
    f'[[hand]]\nmotion = "hands_press.csv"\nstation = 1\n[[board]]\nknown = "tablet"\n{TABLE}[[board]]\nknown = "head"\n{HEAD}{faults}')
programs = []
try:
    programs.append(Program(BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache"))
    programs[0].wait("is open")
    address = f"hands:synthetic:{OUT / 'hands_scene.toml'}"
    # What [tracker.room] says by default isn't true: only the table's board tells where the camera is.
    (OUT / "hands.toml").write_text(f'[tracker]\naddress = "{address}"\n[tracker.table]\nboard = "tablet"\n{TABLE}'
                                    "[tracker.stations.head]\nstation = 3\n")
    started = time.monotonic()
    user = Program(BIN / "prosector-client", "join", "--name", "Feeler", "--display", "none", "--config", OUT / "hands.toml", "--session-log",
                   LOG.file, "--session", session)
    programs.append(user)
    user.wait("everything is here")

    def told(state):
        return [line for line in user.lines if line.startswith(f"tracker {address}: {state}")]

    check("it isn't away while it is being opened", not told("absent"))

    def forces():
        """On the hand, N: whichever way, as a hand that comes into sight inside tissue is pushed out sideways."""
        return [math.hypot(*line["touches"]["Feeler, right"]["force"]) for line in LOG.lines() if "Feeler, right" in line["touches"]]

    def presses(since):
        return LOG.wait(lambda: any(force > 0.3 for force in forces()[since:]), PATIENCE)

    check("the camera streams", LOG.wait(lambda: told("streaming"), PATIENCE))
    check("the bare hand presses the tissue", presses(0))
    print(f"the hand pushes with {max(forces(), default=0):.2f} N")
    eyes = [line["people"]["Feeler"]["eyes"]["at"] for line in LOG.lines() if "eyes" in line["people"].get("Feeler", {})]
    check(f"the head is where its board says: {eyes[-1:]}", eyes and math.dist(eyes[-1], EYES) < 0.005)
    check("an unplugged camera is told of", LOG.wait(lambda: told("absent"), max(started + UNPLUGGED[1] + PATIENCE - time.monotonic(), 1)))
    check(f"in words: {told('absent')[-1:]}", told("absent") and "unplugged" in told("absent")[-1])
    check("it is opened again", LOG.wait(lambda: "streaming" in [line for line in user.lines if line.startswith(f"tracker {address}: ")][-1], PATIENCE))
    check("and the hand presses again", presses(len(forces())))
    user.end(signal.SIGINT)
    check("the client ends well", user.process.returncode == 0)
    print("\n".join(line for line in user.lines if line.startswith("tracker ")))
finally:
    for program in programs:
        program.end(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
