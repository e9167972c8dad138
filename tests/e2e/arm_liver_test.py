#!/usr/bin/python3
"""arm_liver_test.py BIN OUT near|far: a simulated haptic arm presses the CT's liver in a real session. near: on loopback, while
somebody cuts its right lobe; then the server is killed and comes back. far: from another network namespace, behind a bridge with
25 ms each way, 5 ms jitter and 1 % loss; skipped (77) where namespaces can't be made."""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

from anatomy import ON_LIVER, anatomy
from arm_press import HERE, ArmPress
from checks import check, failures

ROOT = HERE.parent.parent
BIN, OUT, KIND = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
NETWORK = sys.argv[4:]  # the client's, inside a namespace
OUT.mkdir(parents=True, exist_ok=True)
DEEP = 0.02  # m: goal of the hand below where it meets the liver
SERVER = [BIN / "prosector-server", ROOT / "deploy/scenes/cut.toml", "--cache", OUT / "cache"]
if not anatomy("liver.inr.gz").exists():
    print("skipped: the CT's liver isn't here; deploy/fetch_anatomy.sh fetches it")
    sys.exit(77)
arm = ArmPress(BIN, OUT, f"liver_{KIND}", ON_LIVER, from_behind=False)


def show(when, felt, told):
    print(f"{when}: {felt['force']:.3f} N felt, {told:.3f} N told, {1e3 * felt['depth']:.2f} mm deep, {1e3 * felt['swing']:.3f} mm "
          f"of swing")


def told_right(felt, told):
    """Within 5 %, and what the log's hundredths of a newton hide."""
    return abs(felt - told) <= 0.05 * told + 0.005


def press(*network):
    """Presses and rests; checks that what is felt is what the server tells. Returns the client."""
    user = arm.join(arm.write_script(0.05, DEEP), *network)
    user.wait("everything is here")
    if not arm.feels(0.2, 30):
        sys.exit("FAILED: the liver isn't felt")
    time.sleep(4)
    felt = arm.measure(2)
    told = arm.told_force()
    show("at rest", felt, told)
    check("the liver pushes back by what the server says, within 5 %", told_right(felt["force"], told))
    check("the arm is still", felt["swing"] < 3e-4)
    check("it gave no energy that nobody put in", felt["energy"] > -2e-4)
    return user


def revision():
    """Of the liver's topology, as the arm's user knows it."""
    seen = 0
    for line in open(OUT / f"{arm.name}.jsonl"):
        try:
            seen = json.loads(line)["parts"]["liver"]["revision"]
        except (json.JSONDecodeError, KeyError):
            continue
    return seen


def cutter(session):
    """Starts a user with a simulated tracker and glove who takes the scalpel and opens the liver from above."""
    script = OUT / "cutter.csv"  # as the first of the demo's two, but it ends before it meets the hand that presses
    script.write_text((ROOT / "deploy/demo/cut_first.csv").read_text().replace("9,1,-0.1,1.2751,", "9,1,0,1.2751,")
                      .replace("10,1,-0.14,", "10,1,0.06,").replace("11,1,-0.3,", "11,1,0.3,"))
    for device, words in (("fastrak", ["--room-device", "0,1,1,1,0,0,0", "--noise-cm", "0.02", "--seed", "1"]), ("5dt", ["--seed", "2"])):
        arm.start(BIN / f"prosector-{device}-twin", "--script", script, "--wait-client", "--link", OUT / f"cutter.{device}", *words)
        for _ in range(50):
            if (OUT / f"cutter.{device}").exists():
                break
            time.sleep(0.1)
    user = arm.start(BIN / "prosector-client", "join", "--session", session, "--name", "Cutter", "--config",
                     ROOT / "deploy/demo/headset.toml", "--tracker", f"fastrak:{OUT}/cutter.fastrak", "--glove", f"5dt:{OUT}/cutter.5dt",
                     "--display", "none")
    user.wait("tracker fastrak")


def energy_books(user):
    """What hand and server counted that the hand gave, J."""
    user.end(signal.SIGINT)
    line = next(line for line in user.lines if line.startswith("arm: energy from the hand"))
    print(line)
    gave, got, counted, back = map(float, re.findall(r"[-\d.]+", line))
    return 1e-3 * (gave - got), 1e-3 * (counted - back)


def near():
    session = f"liver{os.getpid()}"
    journal = OUT / "liver.sqlite"
    journal.unlink(missing_ok=True)
    words = ["--session", session, "--journal", journal]
    server = arm.start(*SERVER, *words)
    server.wait("is open", seconds=120)
    user = press("--session", session)

    begin = time.monotonic()
    cutter(session)
    while revision() == 0 and time.monotonic() < begin + 30:
        time.sleep(0.2)
    time.sleep(6)
    rows = arm.rows(begin)
    force = [row["fy"] for row in rows]
    steps = max(abs(b - a) for a, b in zip(force, force[1:]))
    print(f"while it is cut: {min(force):.3f} to {max(force):.3f} N, by steps of at most {steps:.3f} N")
    check("somebody cut the liver", revision() > 0)
    check("the arm was pushed back meanwhile", max(force) > 0.1)
    check("without a jolt", steps < 0.5)
    felt, told = arm.measure(2), arm.told_force()
    show("beside the cut", felt, told)
    check("the cut liver pushes back by what the server says, within 5 %", told_right(felt["force"], told))

    killed = time.monotonic()
    server.end(signal.SIGKILL)
    time.sleep(0.6)
    limp, step = arm.limp(killed)
    print(f"limp {1e3 * limp if limp else -1:.0f} ms after the kill, by steps of at most {step:.3f} N")
    check("the arm goes limp after the server is killed", limp is not None and limp < 0.1)
    server = arm.start(SERVER[0], "--resume", journal, *SERVER[2:], *words[:2])
    server.wait("is open", seconds=120)
    check("and comes back with it", arm.feels(0.8 * felt["force"], 30))
    user.end(signal.SIGINT)


def inside():
    user = press("--session", "liver", *NETWORK)
    hand, server = energy_books(user)
    # While it goes in, what the arm renders lags behind what the server has by the way of a round trip.
    check("both ends count the same energy within 30 %", abs(hand - server) < 0.3 * hand)


def far():
    network = [HERE.parent / "idl/namespaces", "wan", BIN / "wan_bridge",
               " ".join(map(str, [*SERVER, "--session", "liver", "--profile", "wan", "--lan", "--seconds", 90])),
               " ".join(map(str, [sys.executable, __file__, BIN, OUT, "inside", "--profile", "wan", "--lan=%I", "--peer", "%S"]))]
    sys.exit(subprocess.run(network, env={**os.environ, "PROSECTOR_WAN_DELAY_MS": "25"}).returncode)


try:
    {"near": near, "far": far, "inside": inside}[KIND]()
finally:
    arm.close(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
