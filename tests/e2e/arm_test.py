#!/usr/bin/python3
"""arm_test.py BIN OUT [DRIVER]: a simulated haptic arm presses tissue in a real session, held by a modelled hand. What the arm pushes back
with is what the server says of the contact; when the server is killed in mid-press the arm goes limp, and it comes back with it."""
import os
import pathlib
import re
import signal
import sys
import time

from arm_press import HERE, ArmPress
from checks import check, failures

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("arm*"):
    old.unlink()
SETTLES, MEASURED = 4, 2  # s

session = f"arm{os.getpid()}"
SERVE = [BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache", "--journal",
         OUT / "arm.sqlite"]
arm = ArmPress(BIN, OUT, "arm", [0, 1.03, 0], driver=sys.argv[3] if len(sys.argv) > 3 else "omni-twin")
try:
    server = arm.start(*SERVE)
    server.wait("is open")
    user = arm.join(HERE / "arm_press.csv", "--session", session)
    time.sleep(SETTLES)

    felt = arm.measure(MEASURED)
    force = felt["force"]
    print(f"the arm pushes with {force:.3f} N at {1e3 * felt['depth']:.2f} mm; it moves by {1e3 * felt['swing']:.3f} mm; it gave at "
          f"most {-1e3 * felt['energy']:.3f} mJ more than it got")
    told = arm.told_force()
    print(f"the server tells {told:.3f} N")
    check("the arm is pushed back", force > 0.3)
    check("by what the server says, within 5 %", abs(force - told) <= 0.05 * told)
    check("it is still", felt["swing"] < 3e-4)
    check("it gave no energy that nobody put in", felt["energy"] > -2e-4)

    killed = time.monotonic()
    server.end(signal.SIGKILL)
    time.sleep(0.6)
    limp, step = arm.limp(killed)
    print(f"limp {1e3 * limp if limp else -1:.0f} ms after the kill, by steps of at most {step:.3f} N")
    check("the arm goes limp after the server is killed", limp is not None and limp < 0.1)
    check("smoothly", step < 0.2 * force)

    server = arm.start(SERVE[0], "--resume", OUT / "arm.sqlite", *SERVE[2:6])
    server.wait("is open")
    check("and comes back with it", arm.feels(0.8 * force, 20))
    user.end(signal.SIGINT)
    about = [line for line in user.lines if line.startswith("arm: ")]
    print("\n".join(about))
    check("the client tells how punctual its servo was", any("arm: " in line and "latency" in line for line in about))
    check("and what energy both ends counted", any(re.search("energy from the hand .* counted by the server", line) for line in about))
finally:
    arm.close(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
