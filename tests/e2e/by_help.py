"""A mouse and a keyboard worked by the words of the help, in which controls are looked up by what they do."""

import contextlib
import re
import time

from desk_person import act, corner

KEYS = {"Esc": "Escape", "Ctrl": "ctrl", "Shift": "shift", "Alt": "alt", "Space": "space", "comma": "comma",
        "full stop": "period", "+": "plus", "-": "minus"}
BUTTONS = {"left": 1, "middle": 2, "right": 3, "click": 1, "hold": 1, "drag": 1}


def key_of(word):
    return KEYS.get(word, word.lower() if len(word) == 1 else word)


def button_of(words):
    """Of a mouse, if the words name one."""
    return next((number for name, number in BUTTONS.items() if name in words), None)


class Help:
    """The lines that the client shows on H: a control, and what it does."""

    def __init__(self, text):
        self.rows = [row.groups() for row in re.finditer(r"^  (\S.*?) {2,}(\S.*)$", text, re.MULTILINE)]
        assert self.rows, f"there is no help in:\n{text}"

    def find(self, does, by=""):
        """The first way to what these words describe, with `by` in it; None: the help has none."""
        for control, done in self.rows:
            for way in control.split(", "):
                if re.search(does, done) and by in way:
                    return way
        return None

    def control(self, does, by=""):
        found = self.find(does, by)
        assert found, f"no line of the help says \"{does}\", by \"{by}\""
        return found


class Hands:
    """On mouse and keyboard. Places are pixels of the window, from its upper left."""

    STEP = 0.05  # s between two places of a moving pointer

    def __init__(self, window, size, pace):
        self.left, self.top = corner(window)
        self.size = size
        self.pace = pace  # s that the pointer takes across half the window
        self.pressed = None
        self.at = size[0] // 2, size[1] // 2
        self.put()

    def put(self):
        act("mousemove", self.left + self.at[0], self.top + self.at[1])

    def move(self, to, seconds=None):
        """Moves the pointer as an arm does, without a jump."""
        begun, start = self.at, time.monotonic()
        way = max(abs(a - b) for a, b in zip(begun, to))
        seconds = seconds or self.pace * max(0.2, way / (self.size[0] / 2))
        while (part := (time.monotonic() - start) / seconds) < 1:
            self.at = tuple(round(a + part * (b - a)) for a, b in zip(begun, to))
            self.put()
            time.sleep(self.STEP)
        self.at = tuple(to)
        self.put()

    def press(self, control):
        """Presses a key, or clicks."""
        *modifiers, last = control.split(" + ")
        with self.held(modifiers):
            for _ in range(2 if last.startswith("double") else 1):
                act("click", button_of(last)) if button_of(last) else act("key", key_of(last))

    def drag(self, control, by):
        """Moves the pointer that far while the control's keys and button are held, and back without them."""
        *modifiers, last = control.split(" + ")
        begun = self.at
        with self.held(modifiers):
            act("mousedown", button_of(last))
            self.move((begun[0] + by[0], begun[1] + by[1]))
            act("mouseup", button_of(last))
        self.move(begun)

    def turn_wheel(self, control, notches):
        """Turns it away from the person if notches > 0."""
        *modifiers, last = control.split(" + ")
        assert last.startswith("wheel"), f"{control} is not the wheel"
        with self.held(modifiers):
            for _ in range(abs(notches)):
                act("click", 4 if notches > 0 else 5)
                time.sleep(0.06)

    def hold(self, control):
        self.pressed = button_of(control)
        act("mousedown", self.pressed)

    def let_go(self):
        if self.pressed:
            act("mouseup", self.pressed)
        self.pressed = None

    @staticmethod
    @contextlib.contextmanager
    def held(keys):
        for key in keys:
            act("keydown", key_of(key))
        yield
        for key in reversed(keys):
            act("keyup", key_of(key))
