#!/usr/bin/python3
"""window_test.py BIN OUT: the screen is a window into the room. First a recording tells exactly where the eyes are, then a face before a synthetic
camera moves, and is lost: what lies before the screen and behind it is seen where geometry says."""
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
DATA = pathlib.Path(os.environ.get("PROSECTOR_DATA") or pathlib.Path(os.environ.get("XDG_DATA_HOME") or pathlib.Path.home() / ".local/share") / "prosector")
WIDTH, HEIGHT = 640, 480
FOV, DISTANCE, TARGET = 0.8, 1.2, (0, 1.2, 0)  # of window.toml's camera
SCREEN = 0.3  # m, the picture's height, by default
MARKS = {"near": (0, (0.05, 1.12, 0.35)), "in the screen": (1, (0, 1.2, 0)), "far": (2, (-0.1, 1.3, -0.6))}  # channel, place
REST = (0, 0, SCREEN / 2 / math.tan(FOV / 2))
LEFT, RIGHT = (-0.12, 0.05, 0.65), (0.14, 0.06, 0.65)  # eyes, m from the middle; lower, the chin were out of the picture
MOVES, MOVED, LOST = 9, 10, 13  # s of the camera's time

shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)


def expected(eye, place):
    """Where the way from the eye to a place meets the screen, in pixels. All is reckoned in the room."""
    scale = 2 * DISTANCE * math.tan(FOV / 2) / SCREEN
    eye = numpy.add(TARGET, scale * numpy.array(eye))
    way = numpy.subtract(place, eye)
    at = eye + way * (TARGET[2] - eye[2]) / way[2] - TARGET
    pixel = HEIGHT / (scale * SCREEN)
    return WIDTH / 2 + pixel * at[0], HEIGHT / 2 - pixel * at[1]


def seen(picture):
    """Middles of the marks."""
    out = {}
    for name, (channel, _) in MARKS.items():
        others = [c for c in range(3) if c != channel]
        rows, columns = numpy.nonzero(picture[:, :, channel] - picture[:, :, others].max(2) > 30)
        out[name] = (columns.mean() + 0.5, rows.mean() + 0.5) if len(rows) > 50 else (-99, -99)
    return out


def take(who, name):
    """The next picture."""
    file = OUT / f"{name}.png"
    who.say(f"picture {file}")
    end = time.monotonic() + 30
    while time.monotonic() < end:
        time.sleep(0.05)
        try:
            return numpy.asarray(Image.open(file).convert("RGB")).astype(float)
        except (OSError, SyntaxError):  # not yet whole
            continue
    sys.exit(f"FAILED: no picture {file}")


def judge(name, picture, eye, most):
    """Checks where the marks are; a ball's middle is seen a little beside its place, aslant."""
    places = seen(picture)
    off = {mark: math.dist(places[mark], expected(eye, at)) for mark, (_, at) in MARKS.items()}
    words = ", ".join(f"{mark} {pixels:.1f}" for mark, pixels in off.items())
    check(f"{name}: pixels off: {words}", max(off.values()) < most)
    return places


session = f"window{os.getpid()}"
programs = []


def start(*words):
    programs.append(Program(*words))
    return programs[-1]


def look(name, *words):
    client = start(BIN / "prosector-client", "observe", "--name", name, "--session", session, "--display", "offscreen", "--size", f"{WIDTH}x{HEIGHT}",
                   "--no-overlay", "--quality", "low", *words)
    client.wait("everything is here")
    return client


def recorded(name, eye):
    file = OUT / f"{name}.csv"
    file.write_text("time,station,x,y,z,qw,qx,qy,qz\n" + "".join(f"{t},1,{eye[0]},{eye[1]},{eye[2]},1,0,0,0\n" for t in (0, 0.05)))
    return f"recorded-loop:{file}"


try:
    start(BIN / "prosector-server", HERE / "window.toml", "--session", session, "--cache", OUT / "cache").wait("is open")
    plain = look("plain")
    judge("without a window", take(plain, "plain"), REST, 1)
    plain.end(signal.SIGINT)
    exact = {}
    for name, eye in (("left", LEFT), ("right", RIGHT)):
        client = look(name, "--window", recorded(name, eye))
        time.sleep(1)
        exact[name] = judge(f"eyes to the {name}", take(client, name), eye, 1)
        client.end(signal.SIGINT)
    moved = {mark: exact["right"][mark][0] - exact["left"][mark][0] for mark in MARKS}
    print("from left to right they move by " + ", ".join(f"{mark} {pixels:.1f}" for mark, pixels in moved.items()) + " pixels")
    check("what is near moves against the eyes, what is far with them", moved["near"] < -30 and moved["far"] > 30)
    if not (DATA / "models/face_short_range.tflite").exists():
        print("the face is left out: the network that finds it isn't here; deploy/fetch_models.sh fetches it")
    else:
        rows = [(0, LEFT), (MOVES, LEFT), (MOVED, RIGHT)]
        (OUT / "head.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + "".join(f"{t},{x},{y},{z},1,0,0,0\n" for t, (x, y, z) in rows))
        (OUT / "head.toml").write_text("[[camera]]\nrate = 12\nrays = 1\nposition = [0, 0.17, 0]\norientation = [0, 0, 1, 0]\n"
                                       f'[[face]]\nmotion = "head.csv"\n[[fault]]\nkind = "black"\nfrom = {LOST}\nto = 999\n')
        client = start(BIN / "prosector-client", "observe", "--name", "head", "--session", session, "--display", "offscreen", "--size",
                       f"{WIDTH}x{HEIGHT}", "--no-overlay", "--quality", "low", "--window", f"face:synthetic:{OUT / 'head.toml'}")
        client.wait("observing session")
        began = time.monotonic()

        def at(seconds):
            time.sleep(max(0, began + seconds - time.monotonic()))

        client.wait("everything is here")
        client.wait("streaming")
        at(MOVES - 0.7)
        first = take(client, "head_left")
        check("the first picture came in time", time.monotonic() < began + MOVES)
        before = judge("the head to the left", first, LEFT, 12)
        at(LOST - 1)
        after = judge("the head to the right", take(client, "head_right"), RIGHT, 12)
        for mark in ("near", "far"):
            share = (after[mark][0] - before[mark][0]) / moved[mark]
            check(f"what is {mark} moves {share:.2f} times as far as it should", 0.85 < share < 1.15)
        client.wait("no face detected")
        at(LOST + 3)
        judge("the face is lost", take(client, "head_lost"), REST, 1)
        client.end(signal.SIGINT)
        check("the client ends well", client.process.returncode == 0)
finally:
    for program in programs:
        program.end(signal.SIGKILL)
finish()
