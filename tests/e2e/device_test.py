#!/usr/bin/python3
"""device_test.py BIN OUT DRIVER [liver]: a simulated device that is reached by a network or a socket moves a hand, which presses a block of
tissue, or the CT's liver, in a real session. Then it is unplugged, silent, spoils its bytes, floods and is of another version: each is told
in words, and it comes back by itself. Skipped (77) where the liver isn't here."""
import os
import pathlib
import signal
import sys
import time

from anatomy import ON_LIVER, anatomy
from checks import check, failures
from program import Program
from session_log import SessionLog

HERE = pathlib.Path(__file__).parent
BIN, OUT, DRIVER = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
LIVER = sys.argv[4:] == ["liver"]
if LIVER and not anatomy("liver.inr.gz").exists():
    print("skipped: the CT's liver isn't here; deploy/fetch_anatomy.sh fetches it")
    sys.exit(77)
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("device*"):
    old.unlink()
LOG = SessionLog(OUT / "device.jsonl")
if LIVER:
    SCENE, BODY, PLACE, DEEP, LATER = HERE.parents[1] / "deploy/scenes/cut.toml", "liver", ON_LIVER, 0.02, 3
else:
    SCENE, BODY, PLACE, DEEP, LATER = HERE / "arm.toml", "block", [0, 1.03, 0], 0.012, 0  # m: the block's top
PRESSED_BY = 1.5 + LATER  # s of the script; a liver takes a while to be here
# What goes wrong in seconds since the twin's start, and the state that is told of it.
SILENCE, BABBLE, UNPLUG, WRONG = ([at + LATER for at in span] for span in ((3.5, 5), (5.8, 6.6), (8.2, 8.8), (8.5, 10.5)))
# A SpaceMouse has other faults: nobody pushes it while it is silent, so that shows in a silence while it is pushed. Its records have no
# version.
PUSHED_SILENCE = 12 + LATER, 13.8 + LATER
BY_PUSHES = DRIVER == "spacemouse"
# At the end the hand rises, and those of other devices press again: a hand that comes back inside of tissue does not press it.
RISE = (11 + LATER, 14 + LATER) if BY_PUSHES else (WRONG[1] + 3, WRONG[1] + 4)

# How silence, what is spoilt, and another version show. A WebSocket that is silent or spoilt is connected anew.
SILENT, SPOILT, WRONGLY = ("absent", "absent", "babbling") if DRIVER == "leap" else ("silent", "babbling", "babbling")


def pushes():
    return LOG.pushes("Feeler, right", BODY)


session = f"device{os.getpid()}"
# A hand that points down, whose index finger's tip goes into the tissue; it waits over it first.
turn = [0.70710678, -0.70710678, 0, 0]
reach = [PLACE[0] + 0.0315, PLACE[1] + 0.178, PLACE[2]]  # of the wrist, when the tip is at the place (arm_client.toml)
script = OUT / "device_press.csv"
rows = [[t, reach[0], reach[1] + up, reach[2], *turn, 0, 0, 0, 0, 0] for t, up in
        ((0, 0.06), (PRESSED_BY, -DEEP), (RISE[0], -DEEP), (RISE[1], 0.06), (RISE[1] + 1, 0.06),
         (RISE[1] + 2.5, 0.06 if BY_PUSHES else -DEEP))]
script.write_text("time,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n")
stand = [0, 0, 0, 1, 0, 0, 0] if BY_PUSHES else [0.1, 0.9, 0.2, 0.70710678, 0, 0.70710678, 0]
programs = []
try:
    programs.append(Program(BIN / "prosector-server", SCENE, "--session", session, "--cache", OUT / "cache"))
    programs[0].wait("is open", seconds=120)
    at = f"/tmp/prosector-{os.getpid()}" if BY_PUSHES else 0
    started = time.monotonic()
    twin = Program(BIN / "prosector-device-twin", DRIVER, at, "--script", script, "--wait-client", "--room-device", ",".join(map(str, stand)),
                   "--silence", "{},{}".format(*(PUSHED_SILENCE if BY_PUSHES else SILENCE)), "--babble", "{},{}".format(*BABBLE),
                   "--unplug", f"{UNPLUG[0]},{UNPLUG[1] - UNPLUG[0]}", *([] if BY_PUSHES else ["--wrong-version", "{},{}".format(*WRONG)]))
    programs.append(twin)
    address = twin.wait(f"{DRIVER}:")
    room, mount = (rows[0][1:4], f"[tracker.stations.right]\nstation = 1\nmount.orientation = {turn}\n") if BY_PUSHES else (stand[:3], "")
    (OUT / "device.toml").write_text(f'[tracker]\naddress = "{address}"\n[tracker.room]\nposition = {room}\norientation = {stand[3:]}\n{mount}')
    user = Program(BIN / "prosector-client", "join", "--name", "Feeler", "--display", "none", "--config", OUT / "device.toml", "--session-log",
                   LOG.file, "--session", session)
    programs.append(user)
    user.wait("everything is here")
    check(f"the hand presses the {BODY}", LOG.wait(lambda: any(force > 0.15 for force in pushes()), 5 + LATER))
    print(f"the hand pushes with {pushes()[-1]:.2f} N" if pushes() else "nothing is touched")

    def told(state):
        return [line for line in user.lines if line.startswith(f"tracker {address}: {state}")]

    def is_now(state):
        return [line for line in user.lines if line.startswith(f"tracker {address}: ")][-1] in told(state)

    def touches_now():
        return "Feeler, right" in list(LOG.lines())[-1]["touches"]

    def height():
        return list(LOG.lines())[-1]["people"]["Feeler"]["right"]["at"][1]

    def sleep_until(at):
        time.sleep(max(0, started + at - time.monotonic()))

    states = [("streaming", BABBLE[0]), (SPOILT, BABBLE[1] + 0.5), ("streaming", UNPLUG[0]), ("absent", UNPLUG[0] + 0.7)]
    states = [*states, ("streaming", UNPLUG[1] + 2)] if BY_PUSHES else [(SILENT, SILENCE[1]), *states, (WRONGLY, WRONG[1]), ("streaming", WRONG[1] + 3)]
    for state, until in states:
        check(f"it is {state} by {until} s", LOG.wait(lambda: is_now(state), max(started + until - time.monotonic(), 0.1)))
    for state in {state for state, _ in states} - {"streaming"}:
        check(f"words say what is {state}: {told(state)[-1:]}", told(state) and len(told(state)[-1]) > len(address) + 50)
    if not BY_PUSHES:
        sleep_until(RISE[0])
        check("the hand rises", touches_now() and LOG.wait(lambda: not touches_now(), 4))
    check("and the hand presses again", LOG.wait(lambda: touches_now() and pushes()[-1] > 0.15, 5))
    if BY_PUSHES:
        sleep_until(RISE[0])
        low = height()
        sleep_until(PUSHED_SILENCE[0] + 0.8)
        there = height()
        sleep_until(PUSHED_SILENCE[1] - 0.1)
        print(f"pushed upwards, silent: {1e3 * (there - low):.1f} mm up, later {1e3 * (height() - low):.1f} mm")
        check("a hand that was pushed stands still once the device is silent", there > low + 0.01 and abs(height() - there) < 1e-3)
        check("which is none of its states", is_now("streaming"))
    user.end(signal.SIGINT)
    check("the client ends well", user.process.returncode == 0)
    print("\n".join(line for line in user.lines if line.startswith("tracker ")))
finally:
    for program in programs:
        program.end(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
