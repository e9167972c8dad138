#!/usr/bin/python3
"""config_test.py BIN OUT: what is written into a client's configuration while it takes part holds at once: a tracker that comes, one that is
named otherwise, and a mistake, which changes nothing."""

import os
import pathlib
import signal
import sys
import time

from checks import check, finish
from program import Program

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("config*"):
    old.unlink()
SCENE = pathlib.Path(__file__).parent / "arm_post.toml"
session = f"config{os.getpid()}"
hand = OUT / "config_hand.csv"
hand.write_text("time,x,y,z\n0,0,1.3,0\n1,0.1,1.3,0\n2,0,1.3,0\n")
config = OUT / "config.toml"
config.write_text("# nothing yet\n")
programs = []


def start(*words):
    programs.append(Program(*words))
    return programs[-1]


def write(*changes):
    change = start(BIN / "prosector-client", "config", config, "--write", *(word for c in changes for word in ("--set", c)))
    check(f"written: {', '.join(changes)}", change.ended(20) == 0)


try:
    server = start(BIN / "prosector-server", SCENE, "--session", session, "--journal", OUT / "config.sqlite")
    server.wait("is open")
    for name in ("config_first", "config_second"):
        start(BIN / "prosector-fastrak-twin", "--script", hand, "--loop", "--link", OUT / name).wait("/dev/pts/")
    user = start(BIN / "prosector-client", "join", "--name", "Ada", "--session", session, "--display", "none", "--config", config)
    user.wait("everything is here")
    for name in ("config_first", "config_second"):
        write(f"tracker.address=fastrak:{OUT}/{name}")
        user.wait(f"tracker fastrak:{OUT}/{name}: streaming")
    check("each tracker that was named streams, without a new start", True)
    text = config.read_text()
    config.write_text(text + "\n[tracker.wings]\n")
    user.wait("devices are unchanged")
    check("a mistake is told with its line", any(f"{config}:" in line and "are unchanged" in line for line in user.lines))
    time.sleep(1)
    check("and nobody leaves for it", user.process.poll() is None)
    user.end(signal.SIGINT)
    check("it ends cleanly", user.process.returncode == 0)
finally:
    for program in programs:
        program.end(signal.SIGKILL)
finish()
