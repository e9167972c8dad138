"""The set-up window of one person, acted on by a mouse: real windows, real events. Run under deploy/with_display.sh."""

import json
import os
import shutil
import signal
import subprocess
import time

from PIL import ImageGrab

from desk_person import act, corner, wait_until, window_of

DOMAIN = 93


class SetupWindow:
    """`words`: more options of the set-up window."""

    def __init__(self, processes, programs, name, *words):
        self.out, self.layout = processes.out, processes.out / f"{name}.json"
        self.process = processes.start(f"{name}.log", programs / "prosector-client", "setup", "--domain", DOMAIN, "--name", name,
                                       "--layout-log", self.layout, *words)
        self.window = window_of(self.process, "^Prosector$", "the set-up window")

    def read(self):
        try:
            return json.loads(self.layout.read_text())
        except (OSError, json.JSONDecodeError):
            return {"controls": {}, "words": ""}

    def words(self):
        return self.read()["words"]

    def click(self, control):
        """Clicks the middle of a control, once the layout has not moved it while the pointer went there."""
        area = None
        while (seen := self.sees(control)) != area:
            area = seen
            left, top, right, bottom = area
            x, y = corner(self.window)
            act("mousemove", x + (left + right) / 2, y + (top + bottom) / 2)
            time.sleep(0.1)
        act("click", 1)
        time.sleep(0.3)

    def leave(self):
        """Ends the client that it started."""
        clients = subprocess.run(["pgrep", "-P", str(self.process.pid), "-f", "--", "--session anatomy --name"], capture_output=True, text=True)
        os.kill(int(clients.stdout.split()[0]), signal.SIGINT)

    def type(self, text):
        act("key", "ctrl+a")
        act("type", "--delay", 20, text)
        act("key", "Return")
        time.sleep(0.3)

    def picture(self, name):
        """A picture of the window, without the pointer's hover."""
        x, y = corner(self.window)
        act("mousemove", x + 1, y + 700)
        time.sleep(0.5)
        ImageGrab.grab(xdisplay="").crop((x, y, x + 1280, y + 720)).save(self.out / name)

    def end(self):
        self.process.terminate()
        self.process.wait(20)

    def sees(self, control, seconds=30):
        return wait_until(control, lambda: self.read()["controls"].get(control), seconds, self.process)


def some_scenes(folder, scenes, *names):
    """A folder with some of the scenes."""
    folder.mkdir()
    for name in names:
        shutil.copy(scenes / name, folder)
    return folder
