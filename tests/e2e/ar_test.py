#!/usr/bin/python3
"""ar_test.py BIN OUT: an observer and a dissector look through synthetic cameras that move around a table's board. What is virtual stays where
it belongs among real things, hides behind a real hand and a phantom, and comes back after the board was lost."""
import math
import os
import pathlib
import shutil
import signal
import sys
import time

import numpy
from PIL import Image

from checks import check, finish
from program import Program

HERE = pathlib.Path(__file__).parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
TABLE = 0.9  # m
FLAT = "orientation = [0.70710678, -0.70710678, 0, 0]"
DOTS = [(-0.22, 0.15), (0.26, 0.15), (0.24, -0.12), (-0.22, -0.12)]  # x, z of green plates on the table, m
MARK, MARK_SIDE = (0.2, 0.1), 0.04  # the red mark of ar.toml
CUBE = HERE.parent.parent / "deploy/cameras/phantom.toml"  # a board: tags on a cube of 60 mm
WRIST = (0.0, 0.97, 0.25)
BLACK = [(5.0 * k + 3.5, 5.0 * k + 5) for k in range(20)]  # s, the observer's camera
PICTURES = 8

shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)


def turned(eye, target):
    """The pose of who looks from there to there: as a line of TOML or CSV."""
    back = numpy.subtract(eye, target)
    back /= numpy.linalg.norm(back)
    right = numpy.cross((0, 1, 0), back)
    right /= numpy.linalg.norm(right)
    m = numpy.stack((right, numpy.cross(back, right), back), 1)
    w = math.sqrt(1 + m[0, 0] + m[1, 1] + m[2, 2]) / 2
    return (*eye, w, (m[2, 1] - m[1, 2]) / 4 / w, (m[0, 2] - m[2, 0]) / 4 / w, (m[1, 0] - m[0, 1]) / 4 / w)


def plate(size, place, colour, pose=FLAT):
    return f"[[plate]]\nwidth = {size[0]}\nheight = {size[1]}\nposition = {list(place)}\n{pose}\ncolour = {list(colour)}\n"


def synthetic(name, more):
    """A scene file for the camera, which swings around the board."""
    keys = [turned((0.35 * math.sin(a), 1.33 + 0.05 * math.cos(a), 0.5 * math.cos(a / 2)), (0.02, TABLE, 0.03)) for a in (-0.9, 0, 0.9, 0, -0.9)]
    rows = [f"{2 * k}," + ",".join(f"{x:.6f}" for x in key) for k, key in enumerate(keys)]
    (OUT / f"{name}.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + "\n".join(rows) + "\n")
    text = f'[[camera]]\nfocal = 600\ndistortion = [-0.18, 0.03, 0, 0, 0]\nrate = 10\nrays = 2\nmotion = "{name}.csv"\nloop = true\n'
    text += plate((0.75, 0.6), (0.02, TABLE - 0.0005, 0.02), (0, 0, 0)).replace("colour = [0, 0, 0]", "wood = true")
    text += "".join(plate((0.02, 0.02), (x, TABLE, z), (20, 200, 20)) for x, z in DOTS)
    text += f'[[board]]\nknown = "table"\nposition = [0, {TABLE}, 0]\n{FLAT}\n'
    (OUT / f"{name}.toml").write_text(text + more)
    return f"synthetic:{OUT / name}.toml"


def hand():
    """A real hand with its board."""
    x, y, z = WRIST
    (OUT / "hand_board.toml").write_text("[[grid]]\ncolumns = 2\nrows = 2\nsize = 0.034\ngap = 0.0085\nfirst = 100\n")
    return f'[[hand]]\nposition = {list(WRIST)}\n[[board]]\nfile = "hand_board.toml"\nposition = [{x}, {y + 0.02}, {z - 0.05}]\n{FLAT}\n'


def blob(picture, channel, least=100):
    """Middle and number of the pixels in which that channel is far above both others."""
    others = [c for c in range(3) if c != channel]
    above = picture[:, :, channel] - picture[:, :, others].max(2)
    rows, columns = numpy.nonzero(above > least)
    return (columns.mean(), rows.mean(), len(rows)) if len(rows) else (0, 0, 0)


def dots(picture):
    """Middles of the green plates, in the order of DOTS; None: not all are seen."""
    above = picture[:, :, 1] - picture[:, :, [0, 2]].max(2)
    rows, columns = numpy.nonzero(above > 40)
    weights = above[rows, columns]
    places, groups = numpy.stack((columns, rows), 1).astype(float), []
    while len(places):
        near = numpy.linalg.norm(places - places[0], axis=1) < 40
        if near.sum() > 40:
            groups.append(numpy.average(places[near], axis=0, weights=weights[near]))
        places, weights = places[~near], weights[~near]
    if len(groups) != 4:
        return None
    # In turn around their middle, beginning where the left one is not the farther one.
    middle = numpy.mean(groups, axis=0)
    groups.sort(key=lambda at: -math.atan2(at[1] - middle[1], at[0] - middle[0]))
    first = min(range(4), key=lambda k: groups[k][0] - groups[k][1])
    return numpy.array([groups[(first + k) % 4] for k in range(4)])


def homography(places, pixels):
    rows = []
    for (x, z), (u, v) in zip(places, pixels):
        rows += [[x, z, 1, 0, 0, 0, -u * x, -u * z, -u], [0, 0, 0, x, z, 1, -v * x, -v * z, -v]]
    return numpy.linalg.svd(numpy.array(rows))[2][-1].reshape(3, 3)


def middle_of_mark(h):
    """Where the mark's middle is seen, as its pixels' mean: by many places on it, as far as each is stretched."""
    total, sum_at = 0, numpy.zeros(2)
    steps = (numpy.arange(20) + 0.5) / 20 - 0.5
    for a in steps:
        for b in steps:
            p = h @ (MARK[0] + a * MARK_SIDE, MARK[1] + b * MARK_SIDE, 1)
            weight = abs(1 / p[2] ** 3)
            total += weight
            sum_at += weight * p[:2] / p[2]
    return sum_at / total


session = f"ar{os.getpid()}"
programs = []


def start(*words):
    programs.append(Program(*words))
    return programs[-1]


def look(who, name, more, *words):
    camera = synthetic(name, more)
    return start(BIN / "prosector-client", who, "--name", name, "--session", session, "--display", "ar:offscreen", "--camera", camera, "--size",
                 "640x480", "--no-overlay", *words)


def take(who, name):
    """The next picture."""
    file = OUT / f"{name}.png"
    who.say(f"picture {file}")
    end = time.monotonic() + 30
    while time.monotonic() < end:
        time.sleep(0.1)
        try:
            return numpy.asarray(Image.open(file).convert("RGB")).astype(float)
        except (OSError, SyntaxError):  # not yet whole
            continue
    sys.exit(f"FAILED: no picture {file}")


try:
    start(BIN / "prosector-server", HERE / "ar.toml", "--session", session, "--cache", OUT / "cache").wait("is open")
    lost = start(BIN / "prosector-client", "observe", "--name", "lost", "--session", session, "--display", "ar:offscreen", "--camera",
                 synthetic("lost", ""), "--phantom", "pole")
    check("a phantom that the scene doesn't have is refused", lost.ended(30) == 2)
    lost.wait('phantom "pole": the scene')
    faults = "".join(f'[[fault]]\nkind = "black"\nfrom = {begin}\nto = {end}\n' for begin, end in BLACK)
    watcher = look("observe", "watcher", faults)
    watcher.wait("everything is here")
    seen = {}
    while len(seen) < PICTURES and len(list(OUT.glob("watcher_*.png"))) < 5 * PICTURES:
        name = f"watcher_{len(list(OUT.glob('watcher_*.png')))}"
        picture = take(watcher, name)
        if dots(picture) is not None:
            seen[name] = picture
        time.sleep(0.3)
    watcher.wait("is not detected")
    watcher.wait("the camera has found the table")
    watcher.end(signal.SIGINT)
    config = OUT / "ar_client.toml"
    config.write_text(f'[tracker]\naddress = "tags:synthetic:{OUT}/worker.toml"\n[tracker.table]\nboard = "table"\n'
                      '[tracker.stations.right]\nstation = 1\nboard = "hand_board.toml"\nmount.position = [0, -0.05, -0.02]\n'
                      'mount.orientation = [0.70710678, 0.70710678, 0, 0]\n')
    worker = look("join", "worker", hand(), "--config", config)
    worker.wait("everything is here")
    worker.wait("streaming")
    time.sleep(1)
    worked = [take(worker, f"worker_{k}") for k in range(8)]
    worker.end(signal.SIGINT)
    # A cube of tags stands before the blue mark, and on a part of it; without [phantom] the mark shines through.
    cube = f'[[board]]\nfile = "{CUBE}"\nposition = [0, {TABLE + 0.03}, 0.165]\n'
    bare = look("observe", "bare", cube)
    bare.wait("everything is here")
    time.sleep(1)
    through = take(bare, "bare_0")
    bare.end(signal.SIGINT)
    (OUT / "cube.off").write_text("OFF\n8 6 0\n" + "".join(f"{x} {y} {z}\n" for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)) +
                                  "4 0 1 3 2\n4 4 6 7 5\n4 0 4 5 1\n4 2 3 7 6\n4 0 2 6 4\n4 1 5 7 3\n")
    config = OUT / "phantom_client.toml"
    config.write_text(f'[phantom]\nmesh = "cube.off"\nscale = 0.03\nboard = "{CUBE}"\n')
    holder = look("join", "holder", cube, "--config", config)
    holder.wait("everything is here")
    time.sleep(1)
    hidden = [take(holder, f"holder_{k}") for k in range(4)]
    holder.end(signal.SIGINT)
    for program in (watcher, worker, bare, holder):
        check("a client ends well", program.process.returncode == 0)
finally:
    for program in programs:
        program.end(signal.SIGKILL)
worst, moved, last, free = 0, 0, None, 0
for name, picture in seen.items():
    pixels = dots(picture)
    x, y, count = blob(picture, 0)
    expected = middle_of_mark(homography(DOTS, pixels))
    miss = math.dist((x, y), expected)
    print(f"{name}: the red mark's {count} pixels are at ({x:.2f}, {y:.2f}), expected ({expected[0]:.2f}, {expected[1]:.2f}): {miss:.2f} off")
    worst = max(worst, miss if count > 100 else 99)
    moved = max(moved, math.dist(last, pixels[0])) if last is not None else 0
    last, free = pixels[0], blob(picture, 2)[2]
check(f"{len(seen)} pictures show all that is real", len(seen) == PICTURES)
check(f"the camera moves: {moved:.1f} pixels between two pictures", moved > 10)
check(f"the virtual mark stays where it belongs: within {worst:.2f} pixels", worst < 1)
left = [blob(picture, 2)[2] for picture in worked]
print(f"pixels of the blue mark that are seen: {left}; without a hand {free}")
# From some sides the hand's board isn't read, or its pose is too old to count where pictures come slowly.
check("what is beside the hand stays", min(blob(picture, 0)[2] for picture in worked) > 100)
blue, red = [blob(picture, 2)[2] for picture in hidden], [blob(picture, 0)[2] for picture in hidden]
print(f"behind the phantom {blue} pixels of the blue mark are seen")
check("what is beside the phantom stays", min(red) > 100)
check("the phantom hides what is behind it", free > 200 and max(blue) < 0.15 * free)
check("without a phantom the mark is drawn over the cube", blob(through, 2)[2] > 0.5 * free)
check("the hand hides what is below it", free > 200 and sum(pixels < 0.15 * free for pixels in left) >= len(left) // 4)
if "-v" in sys.argv:
    print("\n".join(watcher.lines + worker.lines))
finish()
