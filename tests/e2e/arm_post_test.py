#!/usr/bin/python3
"""arm_post_test.py BIN OUT: a simulated haptic arm presses on a post of wood in a real session, held by a modelled hand. It is felt as the
hard surface that docs/understand/haptics.md tells of, and the arm rests on it."""
import os
import pathlib
import signal
import sys
import time

from arm_press import HERE, ArmPress
from checks import check, failures

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("post*"):
    old.unlink()
TOP = 1.03  # m
STIFFNESS = 2000  # N/m, of what is rigid
ENCODER = 55e-6  # m: a step
PAD = 0.007  # m: from the fingertip's middle, where the stylus ends, to its skin

arm = ArmPress(BIN, OUT, "post", [0, TOP, 0])
try:
    session = f"armpost{os.getpid()}"
    server = arm.start(BIN / "prosector-server", HERE / "arm_post.toml", "--session", session,
                       "--journal", OUT / "post.sqlite")
    server.wait("is open")
    user = arm.join(arm.write_script(0.06, 0.003 - PAD), "--session", session)
    time.sleep(3.5)
    felt = arm.measure(1)
    depth = felt["depth"] + PAD
    print(f"the arm pushes with {felt['force']:.3f} N at {1e3 * depth:.3f} mm; it moves by {1e3 * felt['swing']:.3f} mm; it gave at "
          f"most {-1e3 * felt['energy']:.3f} mJ more than it got")
    check("the arm is pushed back", felt["force"] > 0.4)
    check("the post is as hard as is said of it, within an encoder's step",
          abs(felt["force"] - STIFFNESS * depth) <= STIFFNESS * ENCODER)
    check("it is still", felt["swing"] < 2 * ENCODER)
    check("it gave no energy that nobody put in", felt["energy"] > -2e-4)
finally:
    arm.close(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
