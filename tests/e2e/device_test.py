#!/usr/bin/python3
"""device_test.py BIN OUT DRIVER: a simulated device that is reached by a network or a socket moves a hand, which presses tissue in a real
session. Then it is unplugged, silent, spoils its bytes, floods and is of another version: each is told in words, and it comes back by itself."""
import os
import pathlib
import signal
import sys
import time

from checks import check, failures
from program import Program
from session_log import SessionLog

HERE = pathlib.Path(__file__).parent
BIN, OUT, DRIVER = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("device*"):
    old.unlink()
LOG = SessionLog(OUT / "device.jsonl")
PRESSED_BY = 1.5  # s of the script
# What goes wrong in seconds since the twin's start, and the state that is told of it.
SILENCE, BABBLE, UNPLUG, WRONG = (3.5, 5), (5.8, 6.6), (8.2, 0.6), (8.5, 10.5)

# How silence, what is spoilt, and another version show. A WebSocket that is silent or spoilt is connected anew; a SpaceMouse that nobody
# pushes is silent anyway, and its records have no version.
SILENT, SPOILT, WRONGLY = {"leap": ("absent", "absent", "babbling"), "spacemouse": ("streaming", "babbling", "streaming")}.get(
    DRIVER, ("silent", "babbling", "babbling"))


def pushes():
    return LOG.pushes("Feeler, right")


session = f"device{os.getpid()}"
# A hand that points down, whose index finger's tip goes 12 mm into the block; it waits over it first.
turn = [0.70710678, -0.70710678, 0, 0]
reach = [0.0315, 1.03 + 0.178, 0]  # of the wrist, when the tip is at the block's top (arm_client.toml)
script = OUT / "device_press.csv"
rows = [[t, reach[0], reach[1] + up, reach[2], *turn, 0, 0, 0, 0, 0] for t, up in ((0, 0.06), (PRESSED_BY, -0.012), (60, -0.012))]
script.write_text("time,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n")
stand = [0, 0, 0, 1, 0, 0, 0] if DRIVER == "spacemouse" else [0.1, 0.9, 0.2, 0.70710678, 0, 0.70710678, 0]
programs = []
try:
    programs.append(Program(BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache"))
    programs[0].wait("is open")
    at = f"/tmp/prosector-{os.getpid()}" if DRIVER == "spacemouse" else 0
    started = time.monotonic()
    twin = Program(BIN / "prosector-device-twin", DRIVER, at, "--script", script, "--wait-client", "--room-device", ",".join(map(str, stand)),
                   "--silence", "{},{}".format(*SILENCE), "--babble", "{},{}".format(*BABBLE), "--unplug", "{},{}".format(*UNPLUG),
                   "--wrong-version", "{},{}".format(*WRONG))
    programs.append(twin)
    address = twin.wait(f"{DRIVER}:")
    room, mount = (rows[0][1:4], f"[tracker.stations.right]\nstation = 1\nmount.orientation = {turn}\n") if DRIVER == "spacemouse" else (stand[:3], "")
    (OUT / "device.toml").write_text(f'[tracker]\naddress = "{address}"\n[tracker.room]\nposition = {room}\norientation = {stand[3:]}\n{mount}')
    user = Program(BIN / "prosector-client", "join", "--name", "Feeler", "--display", "none", "--config", OUT / "device.toml", "--session-log",
                   LOG.file, "--session", session)
    programs.append(user)
    user.wait("everything is here")
    check("the hand presses the tissue", LOG.wait(lambda: any(force > 0.3 for force in pushes()), 5))
    print(f"the hand pushes with {pushes()[-1]:.2f} N" if pushes() else "nothing is touched")

    def told(state):
        return [line for line in user.lines if line.startswith(f"tracker {address}: {state}")]

    def is_now(state):
        return [line for line in user.lines if line.startswith(f"tracker {address}: ")][-1] in told(state)

    for state, until in ((SILENT, SILENCE[1]), ("streaming", BABBLE[0]), (SPOILT, BABBLE[1] + 0.5), ("streaming", UNPLUG[0]),
                         ("absent", UNPLUG[0] + 0.7), (WRONGLY, WRONG[1]), ("streaming", WRONG[1] + 3)):
        check(f"it is {state} by {until} s", LOG.wait(lambda: is_now(state), max(started + until - time.monotonic(), 0.1)))
    for state in {SILENT, "absent", SPOILT, WRONGLY} - {"streaming"}:
        check(f"words say what is {state}: {told(state)[-1:]}", told(state) and len(told(state)[-1]) > len(address) + 50)
    check("and the hand presses again", LOG.wait(lambda: "Feeler, right" in list(LOG.lines())[-1]["touches"] and pushes()[-1] > 0.1, 4))
    user.end(signal.SIGINT)
    check("the client ends well", user.process.returncode == 0)
    print("\n".join(line for line in user.lines if line.startswith("tracker ")))
finally:
    for program in programs:
        program.end(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
