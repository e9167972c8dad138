"""A person at a desk, acted: real processes, a real window, and xdotool for the mouse and the keys. Run under xvfb-run.
Importing this ends the test as skipped (77) where there is no display or no tool to act on it."""

import json
import math
import os
import shutil
import subprocess
import sys
import time

from PIL import ImageGrab


def skip(why):
    print("SKIPPED:", why)
    sys.exit(77)


if not os.environ.get("DISPLAY"):
    skip("no display: run under xvfb-run")
if not shutil.which("xdotool"):
    skip("xdotool is not installed")


def wait_until(what, test, seconds=30):
    """What `test` gives as soon as it is true."""
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        if (found := test()):
            return found
        time.sleep(0.1)
    raise AssertionError(f"{what}: not within {seconds} s")


def act(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True)


def windows(title):
    return subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], capture_output=True, text=True).stdout.split()


def corner(window):
    """Of a window's picture on the screen: its upper left, pixels."""
    lines = subprocess.run(["xdotool", "getwindowgeometry", "--shell", window], capture_output=True, text=True, check=True).stdout
    place = dict(line.split("=") for line in lines.split())
    return int(place["X"]), int(place["Y"])


class Processes:
    """What a test started, with a log each in the folder `out`; ended with it."""

    def __init__(self, out):
        self.out, self.running = out, []
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir(parents=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process in self.running:
            if process.poll() is None:
                process.terminate()
        for process in self.running:
            process.wait(20)

    def start(self, log, *command):
        with open(self.out / log, "w") as file:
            self.running.append(subprocess.Popen([str(c) for c in command], stdout=file, stderr=subprocess.STDOUT))
        return self.running[-1]

    def leave(self, client, server):
        """The person leaves and the server ends; what it counted of commands."""
        act("key", "Escape")
        assert client.wait(20) == 0, "the client did not leave when told to"
        server.terminate()
        assert server.wait(20) == 0
        commands = json.loads((self.out / "server.json").read_text())["commands"]
        print(json.dumps(commands))
        return commands

    def says(self, log, words):
        return words in (self.out / log).read_text()


# Vectors are tuples.
def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(k, a):
    return tuple(k * x for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


class View:
    """Where a desk user's eye is, as mouse and keyboard have moved it: client/app/desk.cpp."""

    FIRST_REACH = 0.7  # of the way to the target
    TURN_PER_PIXEL = 0.005
    REACH_PER_NOTCH, WRIST_PER_NOTCH = 0.02, 0.1

    def __init__(self, window, size, eye, target, fov):
        self.left, self.top = corner(window)
        self.width, self.height = size
        self.target, self.fov = target, fov
        back = minus(eye, target)
        self.distance = math.sqrt(dot(back, back))
        self.yaw, self.pitch = math.atan2(back[0], back[2]), math.asin(back[1] / self.distance)
        self.reach = self.FIRST_REACH * self.distance

    def back(self):
        return (math.sin(self.yaw) * math.cos(self.pitch), math.sin(self.pitch), math.cos(self.yaw) * math.cos(self.pitch))

    def eye(self):
        return plus(self.target, times(self.distance, self.back()))

    def turn_to_yaw(self, yaw):
        """With the right button."""
        x, y = self.left + self.width // 2, self.top + self.height // 2
        pixels = round((self.yaw - yaw) / self.TURN_PER_PIXEL)
        act("mousemove", x, y, "mousedown", 3, "mousemove", x + pixels, y)
        time.sleep(0.2)
        act("mouseup", 3)
        self.yaw -= pixels * self.TURN_PER_PIXEL

    def wheel(self, notches):
        for _ in range(abs(notches)):
            act("click", 4 if notches > 0 else 5)

    def roll(self, angle):
        act("keydown", "shift")
        self.wheel(round(angle / self.WRIST_PER_NOTCH))
        act("keyup", "shift")

    def pixel(self, place):
        """Of a place in the room, on the screen; and how far it is from the eye, m."""
        way = minus(place, self.eye())
        back = self.back()
        right = (math.cos(self.yaw), 0, -math.sin(self.yaw))
        up = cross(back, right)
        scale = self.height / 2 / math.tan(self.fov / 2) / -dot(way, back)
        return (round(self.left + self.width / 2 + scale * dot(way, right)), round(self.top + self.height / 2 - scale * dot(way, up)),
                math.sqrt(dot(way, way)))

    def reach_for(self, place):
        """Brings the fingertips there, to a notch of the wheel."""
        x, y, distance = self.pixel(place)
        act("mousemove", x, y)
        notches = round((distance - self.reach) / self.REACH_PER_NOTCH)
        self.wheel(notches)
        self.reach += notches * self.REACH_PER_NOTCH

    def draw(self, start, end, steps):
        """A tenth of a second a step."""
        for k in range(1, steps + 1):
            self.reach_for(plus(start, times(k / steps, minus(end, start))))
            time.sleep(0.1)

    def picture(self):
        box = (self.left, self.top, self.left + self.width, self.top + self.height)
        return ImageGrab.grab(xdisplay="").crop(box).convert("RGB")
