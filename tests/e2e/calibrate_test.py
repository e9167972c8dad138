#!/usr/bin/python3
"""calibrate_test.py BIN OUT: a person calibrates simulated devices in the terminal: an instrument's tip, the room, a phantom, a glove, noise,
latency and a bent field. What is written is compared with what the twins were told, which the client never sees."""
import math
import pathlib
import re
import sys
import threading
import time
import tomllib

from checks import check, finish
from program import Program

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
for old in OUT.iterdir():
    old.unlink()

# The FASTRAK's noise, an axis: 0.8 mm and 0.15 degrees RMS of all three.
NOISE = ["--noise-cm", "0.046", "--noise-deg", "0.0866", "--seed", "22"]
ROOM = (0.3, 0.8, 0.5, math.cos(0.1), 0.0, math.sin(0.1), 0.0)
TIP = (0.01, -0.02, -0.118)
POINTS = [(-0.2, 0.8, 0.0), (0.2, 0.8, 0.0), (0.2, 0.8, -0.3), (-0.2, 0.8, -0.3), (-0.2, 1.1, -0.3), (0.2, 1.1, 0.0)]


def about(x, y, z, angle):
    length = math.sqrt(x * x + y * y + z * z) or 1
    s = math.sin(angle / 2) / length
    return (math.cos(angle / 2), s * x, s * y, s * z)


PHANTOM = (0.05, 0.85, -0.12, *about(0.3, 1, 0.2, 0.7))
LANDMARKS = [(-0.1, 0.0, 0.1), (0.1, 0.0, 0.1), (0.1, 0.0, -0.1), (-0.1, 0.0, -0.1), (0.0, 0.15, 0.0)]  # m, of its shape
TARGET = (0.0, 0.05, 0.02)


def moved(pose, point):
    """A point of the frame that has that pose: x, y, z, then a quaternion."""
    w, u = pose[3], pose[4:]
    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    t = [2 * x for x in cross(u, point)]
    return [p + x + w * y + z for p, x, y, z in zip(pose[:3], point, t, cross(u, t))]


def script(name, columns, rows):
    file = OUT / f"{name}.csv"
    file.write_text(columns + "\n" + "".join(",".join(f"{v:.6f}" for v in row) + "\n" for row in rows))
    return file


def poses(name, keys):
    return script(name, "time,x,y,z,qw,qx,qy,qz", keys)


def twin(kind, name, file, *options):
    """A twin that moves when its client streams, and its address."""
    program = Program(BIN / f"prosector-{kind}-twin", "--script", file, "--wait-client", "--link", OUT / name, "--log", OUT / f"{name}.log.csv",
                      *options)
    program.wait("/dev/pts/")
    return program


def config(name, text):
    file = OUT / f"{name}.toml"
    file.write_text(text)
    return file


def calibrate(what, file, *options):
    return Program(BIN / "prosector-client", "calibrate", what, "--config", file, "--timeout", "60", *options)


def lead(program, guide, count, first=1):
    """Lets the twin go on whenever the client asks for the next of `count` steps: however slow the machine is, it is waited for."""
    def run():
        for n in range(first, count):
            while not any(line.startswith(f"{n + 1}/{count} ") for line in list(guide.lines)):
                if guide.process.poll() is not None:
                    return
                time.sleep(0.01)
            program.say("")
    threading.Thread(target=run, daemon=True).start()


def holds(times):
    return ["--hold", ",".join(f"{t:.6f}" for t in times)]


def ended(program):
    code = program.ended(70)
    print("\n".join("    " + line for line in program.lines))
    return code == 0


def distance(a, b):
    return math.dist(a, b)


def turn_between(a, b):
    return 2 * math.acos(min(1, abs(sum(x * y for x, y in zip(a, b)))))


def words(program, pattern):
    return [float(x) for x in re.search(pattern, "\n".join(program.lines)).groups()]


programs = []
try:
    # A field bent by metal, mapped on a grid of 3 x 3 x 3 while all else goes on.
    low, high, keys, times = (-0.2, 0.8, -0.4), (0.2, 1.2, 0.0), [], []
    held = about(0, 1, 0, 0.2)
    grid = [[low[a] + (high[a] - low[a]) * i / 2 for i in range(3)] for a in range(3)]
    keys.append((0, -0.3, 0.7, 0.1, *held))
    row = 0
    for j in range(3):
        for k in (range(3) if j % 2 == 0 else reversed(range(3))):
            for i in (range(3) if row % 2 == 0 else reversed(range(3))):
                place = (grid[0][i], grid[1][j], grid[2][k])
                times.append(0.2 * len(times) + 0.2)
                keys.append((times[-1], *place, *held))
            row += 1
    bent = ["--room-device", ",".join(map(str, (0, 1, 0.5, 1, 0, 0, 0))), "--distortion", "0.5,0.1,-0.7,6,0.8"]
    programs.append(twin("fastrak", "field", poses("field", keys), *bent, *NOISE, *holds(times)))
    field_config = config("field", f"""[tracker]
address = 'fastrak:{OUT}/field'  # where it is plugged in
room.position = [0, 1, 0.5]
""")
    field = calibrate("field", field_config, "--low=-0.2,0.8,-0.4", "--high=0.2,1.2,0", "--grid", "3,3,3",
                      "--orientation=" + ",".join(map(str, held)), "--map", "map.toml", "--write")
    lead(programs[-1], field, 27)
    programs.append(field)

    # A glove: seven poses.
    bends = [[0] * 5, [1] * 5] + [[1 if i == f else 0 for i in range(5)] for f in range(5)]
    times = [0.3 * n + 0.3 for n in range(len(bends))]
    keys = [(t, *bend) for t, bend in zip(times, bends)]
    programs.append(twin("5dt", "glove", script("glove", "time,thumb,index,middle,ring,little", keys), "--hid", "--noise-counts", "3", *holds(times)))
    glove_config = config("glove", f"""# my glove
[glove.right]
address = '5dt-usb:{OUT}/glove'
pinch = true # I pinch
""")
    glove = calibrate("glove", glove_config, "--write")
    lead(programs[-1], glove, 7)
    programs.append(glove)

    # Rest, and an uneven motion against the twin's own log.
    pivot = (0.1, 0.8, -0.1)
    room = ",".join(map(str, ROOM))
    programs.append(twin("fastrak", "rest", poses("rest", [(0, *pivot, *about(1, 0, 0, 0.01))]), "--room-device", room, *NOISE))
    rest_config = config("rest", f"[tracker]\naddress = 'fastrak:{OUT}/rest'\n")
    noise = calibrate("noise", rest_config, "--seconds", "2")
    programs.append(noise)
    keys = [(0, *pivot, *about(1, 0, 0, 0.01))]
    for n, step in enumerate([0.31, 0.22, 0.4, 0.18, 0.27, 0.35, 0.2, 0.29, 0.24, 0.38, 0.21, 0.33, 0.26, 0.19, 0.36]):
        x = 0.22 if n % 2 else -0.02 * (n % 3)
        keys.append((keys[-1][0] + step, x, 0.8 + 0.02 * (n % 4), -0.1, *about(1, 0, 0, 0.01)))
    programs.append(twin("fastrak", "wave", poses("wave", keys), "--room-device", room, *NOISE))
    wave_config = config("wave", f"[tracker]\naddress = 'fastrak:{OUT}/wave'\n")
    latency = calibrate("latency", wave_config, "--reference", OUT / "wave.log.csv", "--seconds", "4")
    programs.append(latency)

    # The tip of an instrument: it rests, then swings about it.
    keys = [(0, *pivot, *about(1, 0, 0, 0.01)), (0.1, *pivot, *about(1, 0, 0, 0.01))]
    for n in range(24):
        angle = 2.4 * n
        keys.append((0.4 + 0.3 * n, *pivot, *about(math.cos(angle), 0.3 * math.sin(3 * angle), math.sin(angle), math.radians(35))))
    tip_text = f"""# The laboratory's tracker.
[tracker]
address = 'fastrak:{OUT}/tracker'

[tracker.stations]
instrument.station = 1 # the stylus
"""
    tracker_config = config("tracker", tip_text)
    stylus = twin("fastrak", "tracker", poses("tip", keys), "--room-device", room, "--tip", ",".join(map(str, TIP)), *NOISE, *holds([0.1]))
    programs.append(stylus)
    tip = calibrate("tip", tracker_config, "--write")
    lead(stylus, tip, 2)
    programs.append(tip)
    check("the tip is found", ended(tip))
    stylus.end()
    text = tracker_config.read_text()
    found = tomllib.loads(text)["tracker"]["stations"]["instrument"]["mount"]["position"]
    told, = words(tip, r"expected error of the tip (\S+) mm")
    print(f"the tip is off by {1e3 * distance(found, TIP):.2f} mm; {told} mm were told")
    check("within four times the error that is told, and that is below 0.2 mm", 1e3 * distance(found, TIP) < 4 * told and told < 0.2)
    check("what the person wrote stays", text.startswith(tip_text.rstrip("\n").rsplit("instrument", 1)[0]) and "# the stylus" in text)

    # The room, with that tip.
    keys, times = [(0, -0.1, 0.9, 0.1, *about(1, 0, 0, 0.2))], []
    for n, point in enumerate(POINTS):
        turn = about(math.cos(n), 0.5, math.sin(n), 0.5)
        times.append(0.4 * n + 0.4)
        keys.append((times[-1], *point, *turn))
    stylus = twin("fastrak", "tracker", poses("room", keys), "--room-device", room, "--tip", ",".join(map(str, TIP)), *NOISE, *holds(times))
    programs.append(stylus)
    align = calibrate("room", tracker_config, "--write", *(f"--point={x},{y},{z}" for x, y, z in POINTS))
    lead(stylus, align, len(POINTS))
    programs.append(align)
    check("the tracker's place is found", ended(align))
    stylus.end()
    found = tomllib.loads(tracker_config.read_text())["tracker"]["room"]
    off, turned = distance(found["position"], ROOM[:3]), turn_between(found["orientation"], ROOM[3:])
    print(f"the transmitter is off by {1e3 * off:.2f} mm and {math.degrees(turned):.2f} degrees")
    told, = words(align, r"expected position error: (\S+) mm RMS between")
    check("within 1 mm and 0.2 degrees", off < 1e-3 and turned < math.radians(0.2))
    check("a small error is told", told < 0.5)

    # A phantom that stands in that room, and a place inside it.
    tracker_config.write_text(tracker_config.read_text() + "\n[phantom]\nmesh = 'skull.stl' # printed\n")
    keys, times = [(0, 0.1, 1.1, 0.1, *about(1, 0, 0, 0.2))], []
    for n, point in enumerate(LANDMARKS):
        times.append(0.4 * n + 0.4)
        keys.append((times[-1], *moved(PHANTOM, point), *about(math.cos(n), 0.5, math.sin(n), 0.5)))
    stylus = twin("fastrak", "tracker", poses("phantom", keys), "--room-device", room, "--tip", ",".join(map(str, TIP)), *NOISE, *holds(times))
    programs.append(stylus)
    phantom = calibrate("phantom", tracker_config, "--write", "--target=" + ",".join(map(str, TARGET)),
                        *(f"--point={x},{y},{z}" for x, y, z in LANDMARKS))
    lead(stylus, phantom, len(LANDMARKS))
    programs.append(phantom)
    check("the phantom's place is found", ended(phantom))
    stylus.end()
    found = tomllib.loads(tracker_config.read_text())["phantom"]
    off = 1e3 * distance(moved((*found["position"], *found["orientation"]), TARGET), moved(PHANTOM, TARGET))
    told, = words(phantom, r"expected error at 0.000, 0.050, 0.020 m: (\S+) mm RMS")
    print(f"the target inside the phantom is off by {off:.2f} mm; {told} mm were told")
    check("the target is within 1 mm", off < 1)
    check("a small error is told there", told < 0.6)
    check("what the person wrote of the phantom stays", "mesh = 'skull.stl' # printed" in tracker_config.read_text())

    check("noise is measured", ended(noise))
    millimetres, degrees = words(noise, r"noise (\S+) mm, (\S+)° RMS")
    check("as the twin has it, within a fifth", abs(millimetres - 0.8) < 0.16 and abs(degrees - 0.15) < 0.03)
    check("latency is measured", ended(latency))
    ms, error = words(latency, r"device is (\S+) ± (\S+) ms later")
    check("through a pseudo-terminal it is small", -2 < ms < 50 and error < 5)  # a busy machine reads late

    check("the glove is calibrated", ended(glove))
    right = tomllib.loads(glove_config.read_text())["glove"]["right"]
    off = max(abs(c - e) for c, e in zip(right["open"] + right["closed"], [800] * 5 + [1300] * 5))
    print(f"counts are off by {off:.0f} at most, {90 * off / 500:.1f} degrees")
    check("joints are within 3 degrees", 90 * off / 500 < 3)
    check("the rest of the glove's file stays", "pinch = true # I pinch" in glove_config.read_text())

    check("the field is mapped", ended(field))
    before, after = words(field, r"before: (\S+) mm.*after: (\S+) mm")
    check("the field was bent", before > 5)
    field_text = field_config.read_text()
    check("and its map is named", tomllib.loads(field_text)["tracker"]["field_map"] == "map.toml")
    # Off the grid, through the driver: with the map and without.
    offs, place, recording = {}, (0.1, 1.1, -0.1), {}
    for name, text in (("without", field_text.replace("field_map", "# field_map")), ("with", field_text)):
        programs.append(twin("fastrak", name, poses(f"held_{name}", [(0, *place, *held)]), *bent, *NOISE))
        file = config(f"field_{name}", text.replace(f"{OUT}/field", f"{OUT}/{name}"))
        recording[name] = Program(BIN / "prosector-client", "record", f"fastrak:{OUT}/{name}", "--config", file, "--out", OUT / f"{name}.csv",
                                  "--seconds", "2.5")
        programs.append(recording[name])
    for name, program in recording.items():
        check(f"a device is recorded {name} a map", ended(program))
        rows = [line.split(",")[2:5] for line in (OUT / f"{name}.csv").read_text().splitlines()[1:]]
        mean = [sum(float(r[a]) for r in rows) / len(rows) for a in range(3)]
        offs[name] = 1e3 * distance(mean, place)
    print(f"beside the grid's points: {offs['without']:.1f} mm without the map, {offs['with']:.1f} mm with it")
    check("the driver puts poses right", offs["with"] < 0.5 * offs["without"] and offs["without"] > 3)
finally:
    for program in programs:
        program.end()
finish()
