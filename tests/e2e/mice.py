#!/usr/bin/python3
"""mice.py BIN OUT SCENE [--seconds N] [--seed N]: two people in real windows, each on a screen of their own, play in a scene with mouse and
keys as people do: they look around, hover, press, drag, take up instruments, cut, take cuts back, and ask for panels. The server keeps a
journal. Fails where a program ends by itself, where a body is put back to rest, or where simulated time is slower than half of real
time for longer than 5 s. Leaves logs and mice.json in OUT. The whole play repeats from its seed only as far as the machine's pace does."""

import argparse
import contextlib
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time
import tomllib

parser = argparse.ArgumentParser()
parser.add_argument("bin", type=pathlib.Path)
parser.add_argument("out", type=pathlib.Path)
parser.add_argument("scene", type=pathlib.Path)
parser.add_argument("--seconds", type=float, default=60)
parser.add_argument("--seed", type=int, default=random.randrange(10**6))
options = parser.parse_args()
os.environ.setdefault("DISPLAY", ":0")  # desk_person wants one; each person has their own
from desk_person import Processes, View, minus, plus, times, wait_until  # noqa: E402

SIZE = 800, 600
SLOW, SLOW_SECONDS = 0.5, 5
LINE = re.compile(r"^ +[0-9.]+ s +x([0-9.]+) real time")
desc = tomllib.loads(options.scene.read_text())
FOV = desc.get("camera", {}).get("fov", 0.8)
TOOLS = [body["position"] for body in desc.get("rigid", []) if "tool" in body]


@contextlib.contextmanager
def screen():
    """An X server of its own; its display's name."""
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-noreset", "-screen", "0", f"{SIZE[0]}x{SIZE[1]}x24", "-nolisten", "tcp"],
                              pass_fds=(write,), stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        with os.fdopen(read) as numbers:
            yield ":" + numbers.readline().strip()
    finally:
        server.terminate()
        server.wait(20)


class Player:
    """One of the two: a client in a window, and hands that do this and that."""

    def __init__(self, name, display, processes, seed):
        self.name, self.random, self.out = name, random.Random(seed), processes.out
        self.environment = {**os.environ, "DISPLAY": display}
        self.process = processes.start(f"{name}.log", "env", f"DISPLAY={display}", options.bin / "prosector-client", "join", "--name", name,
                                       "--session", "mice", "--domain", 93, "--size", "x".join(map(str, SIZE)), "--quality", "low",
                                       "--session-log", processes.out / f"{name}.jsonl")
        self.acts = {}
        self.next = 0

    def ready(self):
        wait_until("the scene", lambda: "everything is here" in (self.out / f"{self.name}.log").read_text(), 120, self.process)
        self.view = MouseView(self)
        self.view.eyes()

    def act(self, *words):
        subprocess.run(["xdotool", *map(str, words)], check=True, env=self.environment, stdout=subprocess.DEVNULL)

    def somewhere(self):
        """A place of the window: mostly where tissue is seen."""
        organs = [part for part in self.view.parts().values() if "size" in part and not part.get("hidden")]
        if organs and self.random.random() < 0.8:
            organ = self.random.choice(organs)
            spot = plus(organ["at"], [self.random.uniform(-0.4, 0.4) * size for size in organ["size"]])
            return self.view.pixel(spot)
        return self.random.randrange(SIZE[0]), self.random.randrange(60, SIZE[1])

    def glide(self, seconds, target=None):
        """Moves the pointer to a place in this time."""
        x, y = self.at
        to_x, to_y = target or self.somewhere()
        for k in range(1, max(2, round(seconds / 0.05)) + 1):
            share = k / max(2, round(seconds / 0.05))
            self.point(x + share * (to_x - x), y + share * (to_y - y))
            time.sleep(0.05)

    at = (SIZE[0] / 2, SIZE[1] / 2)

    def point(self, x, y):
        self.at = min(max(x, 1), SIZE[0] - 2), min(max(y, 1), SIZE[1] - 2)
        self.act("mousemove", round(self.at[0]), round(self.at[1]))

    # What a person does. Each takes some seconds.
    def hover(self):
        self.glide(self.random.uniform(0.5, 2))

    def press(self):
        self.glide(0.5)
        self.act("mousedown", 1)
        for _ in range(self.random.randint(1, 4)):
            self.glide(self.random.uniform(0.3, 1.5))
        self.act("mouseup", 1)

    def look_around(self):
        self.act("mousedown", 3)
        self.glide(0.7, (self.at[0] + self.random.uniform(-200, 200), self.at[1] + self.random.uniform(-80, 80)))
        self.act("mouseup", 3)
        self.act("click", self.random.choice((4, 5)))

    def change_view(self):
        self.act("key", self.random.choice(("Home", "1", "2", "3", "4")))
        time.sleep(1)

    def take_tool(self):
        if not TOOLS:
            return self.hover()
        self.act("key", "Home")
        time.sleep(1)
        self.glide(1, self.view.pixel(self.random.choice(TOOLS)))
        time.sleep(0.5)
        self.act("click", 1)

    def put_down(self):
        self.act("click", 1)

    def take_back(self):
        self.act("key", "z")
        time.sleep(0.5)

    def ask_for_panel(self):
        self.glide(0.5)
        self.act("key", "p")
        time.sleep(1)
        self.press()

    def toggle(self):
        self.act("key", self.random.choice(("v", "n", "i", "g", "x")))

    def play(self):
        what, = self.random.choices((self.hover, self.press, self.look_around, self.change_view, self.take_tool, self.put_down,
                                     self.take_back, self.ask_for_panel, self.toggle), (4, 10, 2, 1, 3, 1, 2, 1, 1))
        what()
        self.acts[what.__name__] = self.acts.get(what.__name__, 0) + 1

    def play_until(self, end):
        while time.monotonic() < end and self.process.poll() is None:
            self.play()


class MouseView(View):
    """The view of a player's own screen, which the window fills."""

    def __init__(self, player):
        self.left = self.top = 0
        self.width, self.height = SIZE
        self.fov, self.log, self.name = FOV, player.out / f"{player.name}.jsonl", player.name


def slowest(lines):
    """The longest time that simulated time was slower than SLOW in a row, s of real time: the server writes a line a second."""
    worst = slow = 0
    for found in filter(None, map(LINE.match, lines)):
        slow = slow + 1 if float(found[1]) < SLOW else 0
        worst = max(worst, slow)
    return worst


def play():
    import threading
    print(f"{options.scene.stem}: {options.seconds:g} s, seed {options.seed}", flush=True)
    with screen() as first, screen() as second, Processes(options.out) as processes:
        server = processes.start("server.log", options.bin / "prosector-server", options.scene, "--session", "mice", "--domain", 93,
                                 "--summary", options.out / "server.json", "--journal", options.out / "journal.sqlite")
        wait_until("the server", lambda: processes.says("server.log", "is open on this machine"), 300, server)
        players = [Player(name, display, processes, options.seed + k)
                   for k, (name, display) in enumerate((("ada", first), ("eve", second)))]
        for player in players:
            player.ready()
        end = time.monotonic() + options.seconds
        threads = [threading.Thread(target=player.play_until, args=(end,)) for player in players]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        faults = [f"{who} ended by itself, {process.returncode}"
                  for who, process in (("the server", server), *((player.name, player.process) for player in players))
                  if process.poll() is not None]
        for player in players:
            player.process.terminate()
            player.process.wait(30)
        server.terminate()
        if server.wait(60) != 0:
            faults.append(f"the server's exit status is {server.returncode}")
    lines = (options.out / "server.log").read_text().splitlines()
    resets = [line for line in lines if re.search(r"\breset", line)]
    slow = slowest(lines)
    faults += [f"put back to rest: {line.strip()}" for line in resets]
    if slow > SLOW_SECONDS:
        faults.append(f"slower than {SLOW} of real time for {slow:.0f} s")
    figures = {"scene": options.scene.stem, "seed": options.seed, "seconds": options.seconds, "slow_seconds": slow,
               "acts": {player.name: player.acts for player in players}, "faults": faults}
    (options.out / "mice.json").write_text(json.dumps(figures, indent=1) + "\n")
    print(json.dumps(figures["acts"]), f"slow for {slow:.0f} s", flush=True)
    for fault in faults:
        print("FAILED", fault)
    return 1 if faults else 0


for tool in "Xvfb", "xdotool":
    if not shutil.which(tool):
        print(f"SKIPPED: {tool} is not installed")
        sys.exit(77)
sys.exit(play())
