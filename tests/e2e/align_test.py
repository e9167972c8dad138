#!/usr/bin/python3
"""align_test.py BIN OUT: a board on a simulated tracker's receiver is held before a synthetic camera; both are moved by the same script. The
client writes where the camera stands, which is compared with the camera's true place."""
import math
import pathlib
import random
import sys
import tomllib

from checks import check, finish
from program import Program

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
OUT.mkdir(parents=True, exist_ok=True)
POSES, HELD, MOVED = 8, 1.0, 0.3
CAMERA = ((0.1, 1.2, 0.3), (math.cos(0.1), 0.0, math.sin(0.1), 0.0))
BOARD = ((0.02, -0.01, 0.03), (math.cos(0.4), math.sin(0.4), 0.0, 0.0))  # in the receiver's frame


def times(a, b):
    w, x, y, z = a
    v, i, j, k = b
    return (w * v - x * i - y * j - z * k, w * i + x * v + y * k - z * j, w * j - x * k + y * v + z * i, w * k + x * j - y * i + z * v)


def inverse(q):
    return (q[0], -q[1], -q[2], -q[3])


def turned(q, v):
    return times(times(q, (0, *v)), inverse(q))[1:]


def chained(a, b):
    return (tuple(p + t for p, t in zip(a[0], turned(a[1], b[0]))), times(a[1], b[1]))


def about(axis, degrees):
    s = math.sin(math.radians(degrees) / 2)
    return (math.cos(math.radians(degrees) / 2), *(s * v for v in axis))


def script(name, poses):
    rows = []
    for n, (place, turn) in enumerate(poses):
        begin = n * (HELD + MOVED)
        rows += [(begin, *place, *turn), (begin + HELD, *place, *turn)]
    (OUT / name).write_text("time,x,y,z,qw,qx,qy,qz\n" + "".join(",".join(f"{v:.7f}" for v in row) + "\n" for row in rows))


draw = random.Random(5)
back = ((0, 0, 0), inverse(BOARD[1]))
back = (tuple(-v for v in turned(back[1], BOARD[0])), back[1])
seen = [((draw.uniform(-0.1, 0.1), draw.uniform(-0.06, 0.06), -draw.uniform(0.45, 0.6)),
         times(times(about((1, 0, 0), (-1) ** n * draw.uniform(15, 40)), about((0, 1, 0), (-1) ** (n // 2) * draw.uniform(15, 40))),
               about((0, 0, 1), draw.uniform(-90, 90)))) for n in range(POSES)]
boards = [chained(CAMERA, pose) for pose in seen]
script("board.csv", boards)
script("receiver.csv", [chained(board, back) for board in boards])
(OUT / "camera.toml").write_text(f"[camera]\nrays = 2\nposition = {list(CAMERA[0])}\norientation = {list(CAMERA[1])}\n"
                                 '[[board]]\nknown = "tablet"\nmotion = "board.csv"\n')
text = '# my camera\n[tracker]\naddress = "tags:0"  # it stands on the shelf\n'
(OUT / "client.toml").write_text(text)
programs = []
try:
    twin = Program(BIN / "prosector-fastrak-twin", "--script", OUT / "receiver.csv", "--wait-client", "--link", OUT / "tracker", "--noise-cm", "0.046",
                   "--noise-deg", "0.0866")
    programs.append(twin)
    twin.wait("/dev/pts/")
    client = Program(BIN / "prosector-client", "camera", "align", f"synthetic:{OUT / 'camera.toml'}", "--tracker", f"fastrak:{OUT / 'tracker'}",
                     "--board", "tablet", "--poses", POSES - 1, "--timeout", "30", "--out-config", OUT / "client.toml")
    programs.append(client)
    check("the camera's place is found", client.ended(40) == 0)
    print("\n".join("    " + line for line in client.lines))
    written = (OUT / "client.toml").read_text()
    room = tomllib.loads(written)["tracker"].get("room", {"position": [9, 9, 9], "orientation": [1, 0, 0, 0]})
    off = 1e3 * math.dist(room["position"], CAMERA[0])
    turn = math.degrees(2 * math.acos(min(1, abs(sum(a * b for a, b in zip(room["orientation"], CAMERA[1]))))))
    print(f"the camera is off by {off:.2f} mm, {turn:.3f} degrees")
    check("within 2 mm and 0.2 degrees", off < 2 and turn < 0.2)
    check("what the person wrote stays", written.startswith(text))
finally:
    for program in programs:
        program.end()
finish()
