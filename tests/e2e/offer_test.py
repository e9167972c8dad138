#!/usr/bin/python3
"""offer_test.py BIN OUT: a watcher offers the hands of a session by VRPN and OpenIGTLink. Two more users, whose trackers these offers are,
follow the first one's hand."""
import json
import os
import pathlib
import signal
import sys
import time

from checks import check, failures
from program import Program

HERE = pathlib.Path(__file__).parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("offer*"):
    old.unlink()
HAND = [-0.2, 1.3, 0.1]  # where nothing is in its way
NAMES = ["Leader", "By VRPN", "By IGTL"]


def hands():
    """Where everybody's right wrist is, by name, as the watcher saw it last."""
    last = {}
    for line in open(OUT / "offer.jsonl"):
        try:
            last = json.loads(line)
        except json.JSONDecodeError:
            break
    return {name: person["right"]["at"] for name, person in last.get("people", {}).items() if "right" in person}


def together():
    at = hands()
    return all(name in at for name in NAMES) and all(abs(a - b) < 2e-3 for name in NAMES for a, b in zip(at[name], HAND))


session = f"offer{os.getpid()}"
script = OUT / "offer_hand.csv"
script.write_text("time,x,y,z\n" + f"0,{HAND[0] + 0.1},{HAND[1]},{HAND[2]}\n" + f"1,{HAND[0]},{HAND[1]},{HAND[2]}\n")
programs = []


def start(*words):
    programs.append(Program(*words))
    return programs[-1]


def join(name, address):
    return start(BIN / "prosector-client", "join", "--name", name, "--display", "none", "--session", session, "--tracker", address)


try:
    start(BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache").wait("is open")
    watcher = start(BIN / "prosector-client", "observe", "--name", "Watcher", "--display", "none", "--session", session, "--session-log",
                    OUT / "offer.jsonl", "--publish", "vrpn:127.0.0.1:0", "--publish", "igtl:127.0.0.1:0")
    ports = {protocol: watcher.wait(f"by {protocol} at 127.0.0.1 port").split()[-1] for protocol in ("vrpn", "igtl")}
    twin = start(BIN / "prosector-device-twin", "vrpn", 0, "--script", script, "--wait-client")
    join(NAMES[0], twin.wait("vrpn:"))
    join(NAMES[1], f"vrpn:Leader.right@localhost:{ports['vrpn']}")
    join(NAMES[2], f"igtl:localhost:{ports['igtl']}/Leader.right")
    end = time.monotonic() + 15
    while not together() and time.monotonic() < end:
        time.sleep(0.1)
    check(f"all three hands are at {HAND}, within 2 mm: {hands()}", together())
    watcher.end(signal.SIGINT)
    check("the watcher ends well", watcher.process.returncode == 0)
finally:
    for program in programs:
        program.end(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
