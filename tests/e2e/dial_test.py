#!/usr/bin/python3
"""dial_test.py BIN OUT: a host has a body modelled anew while the session runs, at the price that the server found for it. Both
people stay, and both journals replay."""
import os
import pathlib
import re
import subprocess
import sys
import time

from program import ENV, Program

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.glob("dial*.sqlite*"):
    old.unlink()
SCENE = """name = "dial"
[[light]]
kind = "directional"
[[soft]]
name = "ball"
shape = "ball"
size = [0.06, 0.06, 0.06]
cell = 0.02
surface_cell = 0.01
youngs_modulus = 20000
poisson_ratio = 0.3
position = [0, 1, 0]
accuracy_of = ["shape"]
  [[soft.attach]]
  center = [0, 0.97, 0]
  radius = 0.02
  stiffness = 1e8
"""
FIRST_TIME = 400  # s: rungs are measured on this machine

(OUT / "dial.toml").write_text(SCENE)
session = f"dial{os.getpid()}"
journal = OUT / "dial.sqlite"
server = Program(BIN / "prosector-server", OUT / "dial.toml", "--session", session, "--cache", OUT / "cache", "--journal", journal)
people = []
try:
    server.wait("is open")
    host = Program(BIN / "prosector-client", "join", "--session", session, "--name", "Host", "--host", "--display", "none",
                   "--timeout", "20")
    people.append(host)
    server.wait("Host joins")
    people.append(Program(BIN / "prosector-client", "observe", "--session", session, "--name", "Watcher", "--display", "none",
                          "--timeout", "20"))
    server.wait("Watcher joins")

    host.say("accuracy ball")
    told = server.wait("ball: available accuracies: ", seconds=FIRST_TIME)
    prices = [float(p) for p in re.findall(r"([0-9.]+) % for", told)]
    assert prices == sorted(prices, reverse=True) and len(prices) >= 1, told
    host.wait("ball: available accuracies: ")

    host.say("accuracy ball 0.1 %")
    server.wait("no configuration reaches 0.1 %", seconds=FIRST_TIME)
    host.say(f"accuracy ball {1.01 * prices[-1]:.4g} %")
    server.wait("the journal continues in", seconds=FIRST_TIME)
    for name in ("Host", "Watcher"):
        server.wait(f"{name} joins", times=2)
    host.wait("ball is remodelled: expected ")
    time.sleep(1)
    for person in people:
        assert person.process.poll() is None, "somebody didn't stay:\n" + "\n".join(person.lines)
finally:
    for program in (*people, server):
        program.process.terminate()
        program.ended(20)

for file in (journal, OUT / "dial-2.sqlite"):
    replay = subprocess.run([BIN / "prosector-server", "--replay", file, "--cache", OUT / "cache"], capture_output=True, text=True,
                            env=ENV, timeout=120)
    assert replay.returncode == 0 and "equal: " in replay.stdout, f"{file}:\n{replay.stdout}{replay.stderr}"
print(f"dial: ball can have {prices} %, was modelled anew, two people stayed, both journals replay")
