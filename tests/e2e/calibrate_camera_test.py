#!/usr/bin/python3
"""calibrate_camera_test.py BIN OUT: before a synthetic camera whose tracker is bare hands, a person swings an instrument with a printed board
about its tip, and then touches points of a phantom that has a board of its own. What is written is compared with what the scenes have."""
import math
import pathlib
import re
import shutil
import sys
import tomllib

from checks import check, finish
from program import Program

HERE = pathlib.Path(__file__).parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)

TIP = (0.01, -0.15, 0.02)  # m, in the frame of the instrument's board
MOUNT = (0.01, -0.02, -0.03)  # the same, from the tip that such a board has by itself, 12 cm below it
CAMERA = "[camera]\nrate = 15\nrays = 2\nfocal = 800\n"  # at the origin, looks along -z
LANDMARKS = [(-0.09, 0.0, 0.07), (0.09, 0.0, 0.07), (0.09, 0.0, -0.07), (-0.09, 0.0, -0.07), (0.0, 0.1, 0.05)]  # m, of the phantom's shape
TARGET = (0.0, 0.04, 0.01)


def product(a, b):
    return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])


def about(axis, angle):
    return (math.cos(angle / 2), *(math.sin(angle / 2) * x / math.hypot(*axis) for x in axis))


def turned(q, v):
    return product(product(q, (0, *v)), (q[0], -q[1], -q[2], -q[3]))[1:]


def moved(pose, v):
    return tuple(p + x for p, x in zip(pose[0], turned(pose[1], v)))


def with_tip_at(place, q):
    """The pose of the instrument's board."""
    return (*(p - x for p, x in zip(place, turned(q, TIP))), *q)


def scene(name, keys, more=""):
    rows = "".join(",".join(f"{v:.6f}" for v in key) + "\n" for key in keys)
    (OUT / f"{name}.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + rows)
    file = OUT / f"{name}.toml"
    file.write_text(CAMERA + f'[[board]]\nknown = "instrument"\nmotion = "{name}.csv"\n' + more)
    return f"hands:synthetic:{file}"


def calibrate(what, *words):
    program = Program(BIN / "prosector-client", "calibrate", what, "--config", config, "--write", "--timeout", "100", *words)
    code = program.ended(130)
    print("\n".join("    " + line for line in program.lines))
    check(f"{what} ends well", code == 0)
    return "\n".join(program.lines)


pivot, keys = (0, -0.12, -0.5), [(0, *with_tip_at((0.1, 0, -0.5), about((1, 0, 0), 0))), (1, *with_tip_at((0, -0.12, -0.5), about((1, 0, 0), 0)))]
for k in range(1200):  # it rests, then swings
    t = 0.05 * k
    lean = min(1, t / 2) * (0.45 + 0.1 * math.sin(0.7 * t))
    keys.append((4 + t, *with_tip_at(pivot, about((math.cos(0.9 * t), 0, math.sin(0.9 * t)), lean))))
tip_scene = scene("tip", keys)

shutil.copy(HERE.parents[1] / "deploy/cameras/phantom.toml", OUT / "cube.toml")
cube = ((0, -0.12, -0.75), product(about((1, 0, 0), 0.55), about((0, 1, 0), 0.6)))
shape = ((0.015, 0.02, -0.01), about((0.2, 1, 0.1), -0.5))  # in the cube's frame
keys, t = [(0, *with_tip_at((0.2, 0.05, -0.6), about((1, 0, 0), 0)))], 1
for n, landmark in enumerate(LANDMARKS):
    leaned = product(about((1, 0, 0), -0.5), about((math.cos(n), 0, math.sin(n)), 0.2))  # a tag that is seen aslant tells best how
    at = with_tip_at(moved(cube, moved(shape, landmark)), leaned)
    keys += [(t + 1, *at), (t + 3.5, *at)]
    t += 3.5
keys.append((t + 1, *with_tip_at((0.2, 0.05, -0.6), about((1, 0, 0), 0))))
place = f"position = [{', '.join(map(str, cube[0]))}]\norientation = [{', '.join(map(str, cube[1]))}]\n"
touch_scene = scene("touch", keys, f'[[board]]\nfile = "cube.toml"\n{place}')

config = OUT / "client.toml"
text = f"""[tracker]
address = "{tip_scene}"

[tracker.stations]
right.station = 1
instrument.station = 2  # beside bare hands it is another one
"""
config.write_text(text)
words = calibrate("tip")
tool = tomllib.loads(config.read_text())["tracker"]["stations"]["instrument"]
told = float(re.search(r"expected error of the tip (\S+) mm", words).group(1))
off = 1e3 * math.dist(tool["mount"]["position"], MOUNT)
print(f"the tip is off by {off:.2f} mm; {told} mm were told")
check("the tip of an instrument beside bare hands is found within 2 mm", off < 2)
check("its station stays", tool["station"] == 2 and "# beside bare hands it is another one" in config.read_text())

config.write_text(config.read_text().replace(tip_scene, touch_scene) + '\n[phantom]\nbody = "skull"\nboard = "cube.toml"\n')
words = calibrate("phantom", "--target=" + ",".join(map(str, TARGET)), *(f"--point={x},{y},{z}" for x, y, z in LANDMARKS))
found = tomllib.loads(config.read_text())["phantom"]
told = float(re.search(r"expected error at \S+ \S+ \S+ m: (\S+) mm RMS", words).group(1))
off = 1e3 * math.dist(moved((found["position"], found["orientation"]), TARGET), moved(shape, TARGET))
print(f"the phantom's target is off by {off:.2f} mm; {told} mm were told")
check("a phantom is found by its board, within 2 mm", off < 2)
finish()
