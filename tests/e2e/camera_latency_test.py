#!/usr/bin/python3
"""camera_latency_test.py BIN OUT [SECONDS]: how late what a camera saw is: in the server's tick, at an observer, and in the picture that one sees.
A synthetic camera paints the time into its pictures, and the clock is read again in what the client drew; so what the client says of its pictures is
borne out by them. Somebody else wants few pictures, and gets no more. Leaves OUT/latency.json and prints its table."""
import csv
import json
import math
import os
import pathlib
import shutil
import signal
import statistics
import sys
import time

from checks import check, finish
from film import pictures
from program import Program

HERE = pathlib.Path(__file__).parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SECONDS = float(sys.argv[3]) if len(sys.argv) > 3 else 5
FLAT = "orientation = [0.70710678, -0.70710678, 0, 0]"
BOARD = f"position = [0.23, 0.98, 0]\n{FLAT}"
RATE, EXPOSURE, DELAY = 15, 0.008, 0.02  # of the camera, a second and s
SIDE, CELLS, BITS = 16, 20, 16  # of the painted clock in 640 pixels: twins/camera/painted_clock.h
AROUND = 1 << BITS  # ms, after which it shows the same again
SLOW = 3  # pictures a second that somebody wants
NS = 1e-6  # ms
SETTLED = 1  # s after the first picture that don't count

shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)


def scene():
    """A camera over the table that sees its board and a right hand's, which presses the block again and again."""
    down = math.radians(65)
    turn = [math.cos(down / 2), -math.sin(down / 2), 0, 0]
    rows = [[t, 0, y, 0.15, 1, 0, 0, 0] for t, y in ((0, 1.09), (0.5, 1.03), (1, 1.09))]
    (OUT / "press.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + "\n".join(",".join(map(str, row)) for row in rows) + "\n")
    (OUT / "scene.toml").write_text(
        f"[[camera]]\nclock = true\nrate = {RATE}\nexposure = {EXPOSURE}\ndelay = {DELAY}\nrays = 1\nposition = [0.1, 1.62, 0.27]\norientation = {turn}\n"
        f'[[board]]\nknown = "table"\n{BOARD}\n'
        f'[[board]]\nknown = "wrist-right"\nworn = true\nmotion = "press.csv"\nloop = true\n')
    (OUT / "client.toml").write_text(f'[tracker]\naddress = "tags:synthetic:{OUT}/scene.toml"\n[tracker.table]\nboard = "table"\n{BOARD}\n')


def rows_of(name):
    with open(OUT / name, newline="") as stream:
        return list(csv.DictReader(stream))


def clock(picture):
    """What the clock in a picture says, ms; None: it isn't whole."""
    left = (picture.width - SIDE * CELLS) // 2
    cells = [picture.getpixel((left + SIDE * k + SIDE // 2, SIDE // 2))[1] > 127 for k in range(CELLS)]
    ms = sum(1 << bit for bit in range(BITS) if cells[2 + bit])
    parity = bin(ms).count("1") % 2 == 1
    return ms if cells[0] and not cells[1] and cells[BITS + 2] == parity and cells[BITS + 3] != parity else None


def stage(latencies):
    ordered = sorted(latencies)
    return {"median_ms": statistics.median(ordered), "p95_ms": ordered[int(0.95 * (len(ordered) - 1))], "samples": len(ordered)}


def machine():
    model = [line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
    return f"{model[0]}, {len(model)} cores; load average {os.getloadavg()[0]:.1f}"


scene()
session = f"latency{os.getpid()}"
programs = []
try:
    programs.append(Program(BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache"))
    programs[0].wait("is open")
    observer = Program(BIN / "prosector-client", "observe", "--name", "observer", "--session", session, "--display", "none", "--latency-log", OUT / "arrived.csv",
                       "--summary", OUT / "observer.json")
    programs.append(observer)
    user = Program(BIN / "prosector-client", "join", "--name", "user", "--session", session, "--config", OUT / "client.toml", "--display", "ar:offscreen",
                   "--size", "640x480", "--no-overlay", "--quality", "low", "--fps", RATE, "--screenshot", f"{OUT}/first.png@0", "--record", OUT / "seen.avi",
                   "--latency-log", OUT / "sent.csv", "--frame-log", OUT / "drawn.csv", "--summary", OUT / "user.json")
    programs.append(user)
    for program in (observer, user):
        program.wait("everything is here")
    user.wait("streaming")
    patience = time.monotonic() + 60
    while not (OUT / "first.png").exists() and time.monotonic() < patience:  # the first picture has shaders to compile
        time.sleep(0.1)
    time.sleep(SETTLED + SECONDS)
    user.end(signal.SIGINT)
    slow = Program(BIN / "prosector-client", "observe", "--name", "slow", "--session", session, "--camera", f"synthetic:{OUT}/scene.toml", "--display",
                   "ar:offscreen", "--size", "320x240", "--quality", "low", "--fps", SLOW, "--record", OUT / "slow.avi", "--frame-log", OUT / "slow.csv",
                   "--seconds", "4")
    programs.append(slow)
    check("who wants few pictures ends well", slow.ended(60) == 0)
    observer.end(signal.SIGINT)
    for program in (user, observer):
        check("a client ends well", program.process.returncode == 0)
finally:
    for program in programs:
        program.end(signal.SIGKILL)

drawn = [{key: float(value) for key, value in row.items()} for row in rows_of("drawn.csv")]
sent = {int(row["sequence"]): row for row in rows_of("sent.csv")}
# Which input each tick had, by what the observer was told: the first tick that had consumed it, and when that was heard of.
arrived = [row for row in rows_of("arrived.csv") if int(row["sequence"]) in sent]
seen_ns = {sequence: int(row["seen_ns"]) for sequence, row in sent.items()}

few = [int(row["drawn_ns"]) for row in rows_of("slow.csv")]
lasted = 1e-9 * (few[-1] - few[0])
check(f"few are drawn: {len(few) - 1} in {lasted:.1f} s after the first", 1 <= len(few) - 1 <= SLOW * lasted + 2)

clocks = [clock(picture) for picture in pictures(OUT / "seen.avi")]
told = {int(row["camera_ns"]) // 1_000_000 % AROUND for row in drawn}
read = set(clocks) - {None}
print(f"{len(drawn)} pictures drawn, {len(clocks)} filmed, {len(read)} camera's pictures in them")
check("the clock is read in all but the first pictures", len(read) >= SECONDS and sum(ms is None for ms in clocks) <= 3)
check("each clock is that of a picture that the client says it drew", read <= told)
shown = [ms for ms in clocks if ms is not None]
check("pictures are shown in their order", all((after - before) % AROUND < AROUND // 2 for before, after in zip(shown, shown[1:])))

ticks = sorted((int(row["tick"]), seen_ns[int(row["sequence"])]) for row in arrived)


def hand_of(tick):
    """When the hand was seen that a tick had; None: it had none yet."""
    before = [seen for at, seen in ticks if at <= tick]
    return max(before) if before else None


new = {}  # by camera's picture: the first input that has its hand
for sequence, row in sorted(sent.items()):
    new.setdefault(int(row["seen_ns"]), (sequence, int(row["sent_ns"])))
first = {sequence for sequence, _ in new.values()}
drawn = [row for row in drawn if row["drawn_ns"] > drawn[0]["drawn_ns"] + 1e9 * SETTLED]
tissue = [(row["drawn_ns"] - hand_of(row["tick"])) * NS for row in drawn if hand_of(row["tick"])]
stages = {
    "hand sent to the server": stage([(at - seen) * NS for seen, (_, at) in new.items()]),
    "tick with it told to an observer": stage([(int(row["arrived_ns"]) - seen_ns[int(row["sequence"])]) * NS for row in arrived if int(row["sequence"]) in first]),
    "picture drawn: what is real in it": stage([(row["drawn_ns"] - row["camera_ns"]) * NS for row in drawn]),
    "picture drawn: one's own hand in it": stage([(row["drawn_ns"] - row["hand_ns"]) * NS for row in drawn if row["hand_ns"]]),
    "picture drawn: the tissue in it": stage(tissue),
}
figures = {"machine": machine(), "camera": f"640 x 480, {RATE} a second, {EXPOSURE * 1e3:g} ms exposed, at hand {DELAY * 1e3:g} ms later",
           "seconds": SECONDS, "playout_delay_ms": json.loads((OUT / "user.json").read_text())["playout_delay_ms"],
           "renderer": json.loads((OUT / "user.json").read_text())["renderer"], "stages": stages}
(OUT / "latency.json").write_text(json.dumps(figures, indent=2) + "\n")
print(f"{figures['machine']}; camera {figures['camera']}; after mid-exposure:")
for name, row in stages.items():
    print(f"  {name:40} median {row['median_ms']:6.1f} ms, 95 % {row['p95_ms']:6.1f} ms, of {row['samples']}")
    check(f"{name}: enough of it", row["samples"] >= SECONDS)
least = 1e3 * (EXPOSURE / 2 + DELAY)
check("nothing is earlier than the camera gives it", all(row["median_ms"] > least for row in stages.values()))
check("what is told comes after it was sent", stages["tick with it told to an observer"]["median_ms"] > stages["hand sent to the server"]["median_ms"])
real, soft = (stages[f"picture drawn: {what} in it"]["median_ms"] for what in ("what is real", "the tissue"))
check("tissue is seen later than what is real beside it", soft > real)
if "-v" in sys.argv:
    print("\n".join(user.lines))
finish()
