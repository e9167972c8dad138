"""A lesson of docs/learn, gone through: its own blocks are run, in a folder that looks like a clone, and what comes of them is looked at.

Run under deploy/with_display.sh. A block fenced as sh is a command of a terminal; one fenced as text is typed at a program's terminal, line by line.
A lesson of which a block was left out fails.
"""

import pathlib
import re
import subprocess
import sys
import time

from PIL import Image, ImageGrab

from desk_person import act, corner, wait_until, windows

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "docs"))
from commands_test import clone, end_group  # noqa: E402

TITLE = "Prosector: "  # begins each window's
FENCED = re.compile(r"```(?:sh|text)\n(.*?)```", re.DOTALL)
WIDTHS, MOST_BYTES = (800, 640, 560), 150_000  # of a picture of the documentation, the best first


def keep(image, file):
    """Saves a picture as large and as faithful as the documentation's bytes allow."""
    for width in (min(width, image.width) for width in WIDTHS):
        small = image.resize((width, round(image.height * width / image.width)), Image.LANCZOS)
        small.save(file, optimize=True)
        if file.stat().st_size <= MOST_BYTES:
            return
    small.quantize(palette=small.quantize(256), dither=Image.Dither.FLOYDSTEINBERG).save(file, optimize=True)
    assert file.stat().st_size <= MOST_BYTES, f"{file} has {file.stat().st_size} bytes"


class Window:
    """One that opens beside those that are known, at a place of the screen where nothing hides it."""

    def __init__(self, known, at):
        self.window = wait_until("a window", lambda: [window for window in windows(TITLE) if window not in known], 60)[0]
        act("windowmove", self.window, *at)
        time.sleep(0.5)

    def press(self, key):
        act("windowfocus", self.window)
        time.sleep(0.2)
        act("key", key)

    def point(self, part_x, part_y):
        """Moves the pointer to a place of the window, as parts of its width and height."""
        left, top, width, height = self.box()
        act("mousemove", left + round(part_x * width), top + round(part_y * height))

    def turn_wheel(self, notches, key):
        act("windowfocus", self.window, "keydown", key)
        for _ in range(abs(notches)):
            act("click", 4 if notches > 0 else 5)
        act("keyup", key)

    def box(self):
        lines = subprocess.run(["xdotool", "getwindowgeometry", "--shell", self.window], capture_output=True, text=True, check=True).stdout
        size = dict(line.split("=") for line in lines.split())
        return *corner(self.window), int(size["WIDTH"]), int(size["HEIGHT"])

    def picture(self):
        """What the window shows, once it shows anything."""
        def shown():
            left, top, width, height = self.box()
            image = ImageGrab.grab(xdisplay="").crop((left, top, left + width, top + height)).convert("RGB")
            return image if image.getbbox() else None  # None: all of it is black
        return wait_until("a picture in the window", shown, 60)


class Terminal:
    """What a block runs in: its program reads what is typed, and what it says is in a log."""

    def __init__(self, text, folder, log, environment):
        self.log = log
        with log.open("w") as out:
            self.shell = subprocess.Popen(["bash", "-euo", "pipefail", "-c", text], cwd=folder, env=environment, stdin=subprocess.PIPE,
                                          stdout=out, stderr=subprocess.STDOUT, start_new_session=True)

    def type(self, line):
        self.shell.stdin.write(f"{line}\n".encode())
        self.shell.stdin.flush()

    def waits_for(self, words, seconds=60):
        wait_until(f"{self.log.name}: {words}", lambda: re.search(words, self.log.read_text()), seconds)

    def end(self):
        end_group(self.shell)


class Lesson:
    """A page of docs/learn. Its pictures are learn-PAGE-… in `pictures`."""

    def __init__(self, name, work, bin_folder, pictures, environment):
        self.name, self.pictures, self.environment = name, pictures, environment
        self.folder = work / name
        clone(self.folder, bin_folder)
        self.blocks = FENCED.findall((ROOT / "docs" / "learn" / f"{name}.md").read_text())
        self.left, self.terminals = list(self.blocks), []

    def __enter__(self):
        print(f"== {self.name}", flush=True)
        self.begun = time.monotonic()
        return self

    def __exit__(self, kind, *_):
        for terminal in reversed(self.terminals):
            terminal.end()
        if kind is None:
            assert not self.left, f"{self.name}.md has blocks that nobody ran:\n{''.join(self.left)}"
            print(f"   {len(self.blocks)} blocks in {time.monotonic() - self.begun:.0f} s", flush=True)

    def block(self, words):
        found = next((block for block in self.left if words in block), None)
        assert found, f"{self.name}.md has no block with \"{words}\" left"
        self.left.remove(found)
        return found

    def start(self, words, log):
        """Begins a block that goes on until it is ended."""
        self.known = windows(TITLE)
        self.terminals.append(Terminal(self.block(words), self.folder, self.folder / log, self.environment))
        return self.terminals[-1]

    def watch(self, session):
        """The session log of an onlooker without a window, who is no part of the lesson."""
        log = self.folder / "onlooker.jsonl"
        command = f"prosector-client observe --session {session} --name onlooker --display none --session-log {log}"
        self.terminals.append(Terminal(command, self.folder, self.folder / "onlooker.log", self.environment))
        self.terminals[-1].waits_for("everything is here")
        return log

    def run(self, words, log, seconds=60):
        """Runs a block to its end; what it said."""
        terminal = self.start(words, log)
        status = terminal.shell.wait(seconds)
        said = terminal.log.read_text()
        assert status == 0, f"{words}: status {status}\n{said[-2000:]}"
        return said

    def type(self, terminal, words, pause=1.5):
        """Types a block's lines at a program's terminal, as fast as somebody would."""
        for line in self.block(words).splitlines():
            terminal.type(line)
            time.sleep(pause)

    def window(self, at=(0, 0)):
        """The one that the block started last opens."""
        return Window(self.known, at)

    def keep(self, image, name):
        file = self.pictures / f"learn-{self.name}-{name}.png"
        keep(image, file)
        print(f"   {file.name}: {file.stat().st_size} bytes", flush=True)
