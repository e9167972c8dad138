#!/usr/bin/env python3
"""arm_test.py BIN OUT: a simulated haptic arm presses tissue in a real session, held by a modelled hand. What the arm pushes back
with is what the server says of the contact; when the server is killed in mid-press the arm goes limp, and it comes back with it."""
import csv
import json
import os
import pathlib
import signal
import statistics
import sys
import tempfile
import time

from program import Program

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("arm*"):
    old.unlink()
HERE = pathlib.Path(__file__).parent
SOCKET = pathlib.Path(tempfile.mkdtemp()) / "omni"  # a short path: sockets' are bounded
TOP = 1.03  # m: of the tissue
ARM = "0,1.07,-0.03,1,0,0,0"
SETTLES, MEASURED = 3, 2  # s

failures = []


def check(what, holds):
    print(("ok    " if holds else "FAILED"), what)
    if not holds:
        failures.append(what)


def arm_log(since=0.0):
    """Rows of the twin's log, as numbers, from that monotonic time (s) on."""
    with open(OUT / "arm.csv") as file:
        rows = []
        for row in csv.DictReader(file):
            try:
                rows.append({key: float(value) for key, value in row.items()})
            except (TypeError, ValueError):
                break  # the line that is being written
    return [row for row in rows if row["time_ns"] >= 1e9 * since]


def told_force():
    """The force of the user's hand as the server told it last; a line is written when something changes. N, on the tissue."""
    told = 0
    for line in open(OUT / "arm.jsonl"):
        try:
            touch = json.loads(line)["touches"].get("Feeler, right")
        except json.JSONDecodeError:
            break
        told = -touch["force"][1] if touch else 0
    return told


(OUT / "arm_client.toml").write_text((HERE / "arm_client.toml").read_text().replace("/tmp/omni", str(SOCKET)))
session = f"arm{os.getpid()}"
SERVE = [BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache", "--journal",
         OUT / "arm.sqlite"]
programs = []


def start(*words):
    programs.append(Program(*words))
    return programs[-1]


try:
    server = start(*SERVE)
    server.wait("is open")
    twin = start(BIN / "prosector-omni-twin", SOCKET, "--script", HERE / "arm_press.csv", "--room-arm", ARM,
                 "--wait-client", "--log", OUT / "arm.csv")
    twin.wait("ready")
    user = start(BIN / "prosector-client", "join", "--session", session, "--name", "Feeler", "--display", "none", "--config",
                 OUT / "arm_client.toml", "--session-log", OUT / "arm.jsonl", "--patience", "20")
    user.wait("ready")
    time.sleep(1 + SETTLES)
    begin = time.monotonic()
    time.sleep(MEASURED)

    rows = arm_log(begin)
    force = statistics.mean(row["fy"] for row in rows)
    depth = TOP - statistics.mean(row["y"] for row in rows)
    swing = max(row["y"] for row in rows) - min(row["y"] for row in rows)
    energy = min(row["energy"] for row in arm_log())
    print(f"the arm pushes with {force:.3f} N at {1e3 * depth:.2f} mm; it moves by {1e3 * swing:.3f} mm; it gave at most "
          f"{-1e3 * energy:.3f} mJ more than it got")
    told = told_force()
    print(f"the server tells {told:.3f} N")
    check("the arm is pushed back", force > 0.3)
    check("by what the server says, within 5 %", abs(force - told) <= 0.05 * told)
    check("it is still", swing < 3e-4)
    check("it gave no energy that nobody put in", energy > -2e-4)

    killed = time.monotonic()
    server.end(signal.SIGKILL)
    time.sleep(0.6)
    rows = arm_log(killed)
    limp = next((1e-9 * row["time_ns"] - killed for row in rows if abs(row["fy"]) < 0.02), None)
    steps = [abs(b["fy"] - a["fy"]) for a, b in zip(rows, rows[1:])]
    print(f"limp {1e3 * limp if limp else -1:.0f} ms after the kill, by steps of at most {max(steps):.3f} N")
    check("the arm goes limp after the server is killed", limp is not None and limp < 0.1)
    check("smoothly", max(steps) < 0.2 * force)

    server = start(SERVE[0], "--resume", OUT / "arm.sqlite", *SERVE[2:6])
    server.wait("is open")
    end = time.monotonic() + 20
    while time.monotonic() < end and not any(row["fy"] > 0.8 * force for row in arm_log(time.monotonic() - 0.5)):
        time.sleep(0.2)
    check("and comes back with it", any(row["fy"] > 0.8 * force for row in arm_log(time.monotonic() - 0.5)))
    user.end(signal.SIGINT)
    print(next((line for line in user.lines if line.startswith("arm: ")), "no line about the servo"))
    check("the client tells how punctual its servo was", any(line.startswith("arm: ") for line in user.lines))
finally:
    for program in programs:
        program.end(signal.SIGKILL)
    SOCKET.unlink(missing_ok=True)
    SOCKET.parent.rmdir()
sys.exit("\n".join(failures) if failures else 0)
