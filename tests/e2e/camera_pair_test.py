#!/usr/bin/python3
"""camera_pair_test.py BIN OUT CAMERAS: two synthetic cameras, 12 cm apart, are calibrated together by one board. The second is unplugged
for a while, which is told. What is written is compared with how the cameras stand."""
import csv
import math
import pathlib
import signal
import subprocess
import sys
import tomllib

from checks import check, finish
from program import Program

BIN, OUT, CAMERAS = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
OUT.mkdir(parents=True, exist_ok=True)
SWIFTNESS = 1.0  # of the shipped motion's times
APART, TURN = 0.08, 0.1  # m, rad about the vertical: the second one looks at what the first one sees

with open(CAMERAS / "shown_board.csv") as file:
    rows = list(csv.DictReader(file))
for row in rows:
    row["time"] = f"{SWIFTNESS * float(row['time']):.4f}"
    row["x"] = f"{float(row['x']) + APART / 2:.6f}"
with open(OUT / "shown.csv", "w", newline="") as file:
    writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
FOCALS = {"first": 612, "second": 560}
POSES = {"first": "", "second": f"position = [{APART}, 0, 0]\norientation = [{math.cos(TURN / 2)}, 0, {math.sin(TURN / 2)}, 0]\n"}
for name, focal in FOCALS.items():
    fault = '[[fault]]\nkind = "unplugged"\nfrom = 1\nto = 3\n' if name == "second" else ""
    (OUT / f"{name}.toml").write_text(f"[camera]\nrays = 2\nfocal = {focal}\n{POSES[name]}"
                                      f'[[board]]\nknown = "calibration"\nmotion = "shown.csv"\nloop = true\n{fault}')
config = OUT / "client.toml"
config.write_text("# mine\n")
early = subprocess.run([BIN / "prosector-client", "camera", "calibrate", f"synthetic:{OUT / 'first.toml'}", "--second", f"synthetic:{OUT / 'second.toml'}",
                        "--out", OUT / "lens.toml", "--out-config", config], capture_output=True, text=True, timeout=20)
check(f"a configuration without a tracker is refused before the calibration: {early.stderr}",
      early.returncode != 0 and "tracker.address" in early.stderr and "views of the board" not in early.stdout)
config.write_text('# mine\n[tracker]\naddress = "hands:0,2"\n')
program = Program(BIN / "prosector-client", "camera", "calibrate", f"synthetic:{OUT / 'first.toml'}", "--second", f"synthetic:{OUT / 'second.toml'}",
                  "--out", OUT / "lens.toml", "--out-config", config, "--timeout", "40")
try:
    told = program.wait("unplugged")
    check(f"the camera that is unplugged is named: {told}", "second.toml" in told)
    print(program.wait("expected error of positions where the board was held", seconds=150))
    program.wait("wrote ")
finally:
    program.end(signal.SIGTERM)
tracker = tomllib.loads(config.read_text())["tracker"]
check("both lenses are named", (tracker["lens"], tracker["second_lens"]) == ("lens.toml", "lens-second.toml"))
check("comments are kept", config.read_text().startswith("# mine\n"))
for name, file in (("first", tracker["lens"]), ("second", tracker["second_lens"])):
    focal = tomllib.loads((OUT / file).read_text())["focal"][0]
    check(f"the {name} focal length is {FOCALS[name]} px: {focal}", abs(focal - FOCALS[name]) < 0.01 * FOCALS[name])
place, turn = tracker["second"]["position"], tracker["second"]["orientation"]
off = math.dist(place, (APART, 0, 0))
check(f"the second camera is where it stands within 3 mm: {place}", off < 3e-3)
away = 2 * math.acos(min(1, abs(turn[0] * math.cos(TURN / 2) + turn[2] * math.sin(TURN / 2))))
check(f"and turned within 0.5°: {math.degrees(away):.3f}", math.degrees(away) < 0.5)
finish()
