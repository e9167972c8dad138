"""A person at a desk, acted: real processes, a real window, and xdotool for the mouse and the keys. Run under deploy/with_display.sh.
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
    skip("no display: run under deploy/with_display.sh")
if not shutil.which("xdotool"):
    skip("xdotool is not installed")


def wait_until(what, test, seconds=30, process=None):
    """Returns the result of `test` as soon as it is true. Fails at once if `process`, on which it depends, has exited."""
    deadline = time.monotonic() + seconds
    while time.monotonic() < deadline:
        exited = process is not None and process.poll() is not None
        if (found := test()):
            return found
        if exited:
            raise AssertionError(f"{what}: the program ended with exit status {process.returncode}")
        time.sleep(0.1)
    raise AssertionError(f"{what}: not within {seconds} s")


def act(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True)


def windows(title):
    return subprocess.run(["xdotool", "search", "--onlyvisible", "--name", title], capture_output=True, text=True).stdout.split()


def window_of(process, title, what="the window", seconds=30):
    """Waits for a visible window with this title, and returns its id. Fails at once if `process`, which opens it, has exited."""
    return wait_until(what, lambda: windows(title), seconds, process)[0]


def geometry(window):
    """Of a window's picture on the screen: its upper left, its width and height, pixels."""
    lines = subprocess.run(["xdotool", "getwindowgeometry", "--shell", window], capture_output=True, text=True, check=True).stdout
    place = dict(line.split("=") for line in lines.split())
    return tuple(int(place[what]) for what in ("X", "Y", "WIDTH", "HEIGHT"))


def corner(window):
    return geometry(window)[:2]


class Processes:
    """The programs that a test started, each with a log in the folder `out`; they end with the test. If it fails, prints the exit
    status of each and the end of its log."""

    LAST_LINES = 40

    def __init__(self, out):
        self.out, self.started = out, []  # pairs of log name and process
        shutil.rmtree(out, ignore_errors=True)
        out.mkdir(parents=True)

    def __enter__(self):
        return self

    def __exit__(self, kind, error, _):
        if kind is not None and getattr(error, "code", 1) not in (None, 0, 77):  # 77: skipped
            self.report()
        for _, process in self.started:
            if process.poll() is None:
                process.terminate()
        for _, process in self.started:
            process.wait(20)

    def report(self):
        """Prints the exit status of each program and the last lines of its log."""
        for log, process in self.started:
            status = "running" if process.poll() is None else f"exit status {process.returncode}"
            lines = (self.out / log).read_text(errors="replace").splitlines()[-self.LAST_LINES:]
            print(f"--- {log}, {status}; its last {len(lines)} lines:", *lines, sep="\n", flush=True)

    def start(self, log, *command):
        with open(self.out / log, "w") as file:
            process = subprocess.Popen([str(c) for c in command], stdin=subprocess.PIPE, stdout=file, stderr=subprocess.STDOUT)
        self.started.append((log, process))
        return process

    def host_and_join(self, programs, scene, session, size, domain=92):
        """A server of that scene, a desk user in its window, which has the keys, and that window."""
        server = self.start("server.log", programs / "prosector-server", scene, "--session", session, "--domain", domain,
                            "--summary", self.out / "server.json", "--journal", self.out / "journal.sqlite")
        wait_until("the server", lambda: self.says("server.log", "is open on this machine"), 60, server)
        client = self.start("client.log", programs / "prosector-client", "join", "--name", "mouse", "--session", session,
                            "--domain", domain, "--size", "x".join(map(str, size)), "--quality", "low",
                            "--session-log", self.out / "log.jsonl")
        window = window_of(client, f"Prosector: {session}")
        act("windowfocus", window)
        wait_until("the scene", lambda: self.says("client.log", "everything is here"), process=client)
        return server, client, window

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
    """What a desk user's window shows, where their eyes are by the client's --session-log, and what their mouse does."""

    WRIST_PER_NOTCH = 0.1

    def __init__(self, window, size, fov, log, name="mouse"):
        self.left, self.top = corner(window)
        self.width, self.height = size
        self.fov, self.log, self.name = fov, log, name
        act("mousemove", self.left + self.width // 2, self.top + self.height // 2)  # the wheel is of the window below the pointer

    def last_line(self):
        """The last that the client knew."""
        try:
            lines = self.log.read_text().splitlines()
            return json.loads(lines[-1]) if lines else {}
        except (OSError, ValueError):
            return {}  # not there yet, or still being written

    def parts(self):
        """What the client knows of the scene's parts, by name."""
        return self.last_line().get("parts", {})

    def pieces(self):
        """The sizes of pieces that came off, by name, m. Pieces that were joined again are hidden, and not among them."""
        return {name: part["size"] for name, part in self.parts().items() if "piece" in name and not part.get("hidden")}

    def topology(self):
        """The hash of all meshes."""
        return self.last_line().get("topology")

    def eyes(self):
        """Where they are and where they look, once they are known."""
        eyes = wait_until("the eyes", lambda: self.last_line().get("people", {}).get(self.name, {}).get("eyes"))
        return tuple(eyes["at"]), tuple(eyes["look"])

    def pause_of_pictures(self):
        """The longest between the last pictures that showed something new, s. At rest the log says nothing, so no more than 3."""
        try:
            seconds = [json.loads(line)["seconds"] for line in self.log.read_text().splitlines()[-4:]]
        except (OSError, ValueError):
            return 1
        return min(3, max((b - a for a, b in zip(seconds, seconds[1:])), default=1))

    def stays(self, what, place, within, seconds=30):
        """Waits until a place is where it stays for longer than pictures take, however seldom they come."""
        last, since = place(), time.monotonic()

        def rests():
            nonlocal last, since
            now = place()
            if max(abs(a - b) for a, b in zip(now, last)) > within:
                last, since = now, time.monotonic()
            return time.monotonic() - since > max(0.6, 2.5 * self.pause_of_pictures())

        wait_until(f"{what} at rest", rests, seconds)

    def settle(self):
        """Waits until the eyes are where they stay."""
        self.stays("the eyes", lambda: (*self.eyes()[0], *self.eyes()[1]), 1e-9)

    def after(self, do):
        """Does what moves the eyes, and waits until they have moved and are where they stay."""
        before = self.eyes()
        do()
        wait_until("the eyes to move", lambda: self.eyes() != before)
        self.settle()

    def hand(self):
        """Where the right wrist is, as the physics has it."""
        return tuple(wait_until("the hand", lambda: self.last_line().get("people", {}).get(self.name, {}).get("right"))["at"])

    def hand_settles(self):
        """Waits until the hand is where it stays."""
        self.stays("the hand", self.hand, 2e-3)

    def wheel(self, notches, key=None):
        """Turns the wheel while a key is held: up, away from the person, if notches > 0."""
        if key:
            act("keydown", key)
        for _ in range(abs(notches)):
            act("click", 4 if notches > 0 else 5)
        if key:
            act("keyup", key)

    def roll(self, angle):
        self.wheel(round(angle / self.WRIST_PER_NOTCH), "shift")

    def pixel(self, place):
        """Of a place in the room, on the screen."""
        eye, look = self.eyes()
        way = minus(place, eye)
        level = math.hypot(look[0], look[2])
        right = (-look[2] / level, 0, look[0] / level)
        up = cross(right, look)
        scale = self.height / 2 / math.tan(self.fov / 2) / dot(way, look)
        return (round(self.left + self.width / 2 + scale * dot(way, right)),
                round(self.top + self.height / 2 - scale * dot(way, up)))

    def point_at(self, place):
        act("mousemove", *self.pixel(place))

    def draw(self, start, end, steps):
        """Moves the pointer from one place in the room to another, a tenth of a second a step, or slower where pictures come
        more slowly: the hand goes straight between the places that the pointer has at pictures."""
        for k in range(1, steps + 1):
            self.point_at(plus(start, times(k / steps, minus(end, start))))
            time.sleep(min(max(0.1, self.pause_of_pictures()), 0.5))

    def picture(self):
        box = (self.left, self.top, self.left + self.width, self.top + self.height)
        return ImageGrab.grab(xdisplay="").crop(box).convert("RGB")
