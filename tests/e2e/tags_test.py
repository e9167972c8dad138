#!/usr/bin/python3
"""tags_test.py BIN OUT: a hand with a printed board on its back presses tissue in a real session, seen by a synthetic camera. Then its
pictures are torn, black, of another size, upside down, one a second, and the camera is unplugged: each is told in words, and it comes back."""
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
OUT.mkdir(parents=True, exist_ok=True)
LOG = SessionLog(OUT / "tags.jsonl")
LOG.file.unlink(missing_ok=True)
PRESSED_BY = 3  # s of the script
# Each in seconds of the camera's time, and a part of the words that are told of it.
FAULTS = {"torn": (5, 5.8, None), "black": (6, 7.8, "no board detected"), "resized": (8, 8.6, None), "upside_down": (8.8, 9.4, None),
          "slow": (9.6, 11.2, None), "unplugged": (11.4, 12.4, "unplugged")}
END = 13.2


def pushes():
    return LOG.pushes("Feeler, right")


session = f"tags{os.getpid()}"
# A hand that points down, whose index finger's tip goes 12 mm into the block; it waits over it first.
turn = [0.70710678, -0.70710678, 0, 0]
reach = [0.0315, 1.03 + 0.178, 0]  # of the wrist, when the tip is at the block's top (arm_client.toml)
rows = [[t, reach[0], reach[1] + up, reach[2], *turn] for t, up in ((0, 0.06), (1.5, 0.06), (PRESSED_BY, -0.012), (60, -0.012))]
(OUT / "press.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n")
(OUT / "camera.toml").write_text(
    "[camera]\nrays = 2\nposition = [0, 1.25, -0.5]\norientation = [0, 0, 1, 0]\ndistortion = [-0.18, 0.03, 0, 0, 0]\n"
    '[[board]]\nknown = "wrist-right"\nworn = true\nmotion = "press.csv"\n'
    + "".join(f'[[fault]]\nkind = "{kind}"\nfrom = {begin}\nto = {end}\n' for kind, (begin, end, _) in FAULTS.items()))
address = f"tags:synthetic:{OUT / 'camera.toml'}"
(OUT / "client.toml").write_text(f'[tracker]\naddress = "{address}"\n[tracker.room]\nposition = [0, 1.25, -0.5]\norientation = [0, 0, 1, 0]\n')
programs = []
try:
    programs.append(Program(BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache"))
    programs[0].wait("is open")
    user = Program(BIN / "prosector-client", "join", "--name", "Feeler", "--display", "none", "--config", OUT / "client.toml", "--session-log",
                   LOG.file, "--session", session)
    programs.append(user)
    user.wait(f"tracker {address}: streaming")
    started = time.monotonic()
    check("the hand presses the tissue", LOG.wait(lambda: any(force > 0.3 for force in pushes()), PRESSED_BY + 4))
    if pushes():
        print(f"the hand pushes with {max(pushes()):.2f} N")
    time.sleep(max(0, started + END - time.monotonic()))
    check("the hand presses again at the end", LOG.wait(lambda: "Feeler, right" in list(LOG.lines())[-1]["touches"], 20))
    for kind, (_, _, words) in FAULTS.items():
        if words:
            check(f"words say what is {kind}", any(words in line for line in user.lines))
    check("the client lives", user.process.poll() is None)
    user.end(signal.SIGINT)
    check("the client ends well", user.process.returncode == 0)
    print("\n".join(line for line in user.lines if line.startswith("tracker ")))
finally:
    for program in programs:
        program.end(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
