#!/usr/bin/python3
"""newcomer.py BIN OUT [--brisk], run under deploy/with_display.sh: a person who has never seen Prosector touches the liver, takes the scalpel and cuts.

They host and join by the words of README.md. They read the first messages and the help, look about with the pointer until what they
look for is named beside it, and do what the help says: no key is written here (by_help.py). What the picture says in words they
read at the client's terminal. Leaves a picture of each step and times.json. --brisk: the pace of somebody in a hurry.
"""

import json
import os
import pathlib
import re
import sys
import time

from by_help import Hands, Help
from desk_person import Processes, act, corner, wait_until, window_of
from PIL import ImageChops, ImageGrab, ImageStat

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = 800, 600  # of the client's window, if nobody says otherwise
TOUCHED_WITHIN, CUT_WITHIN = 120, 300  # s after the scene is in the window
LEISURELY, BRISK = 0.8, 0.3  # s that the pointer takes across half the window
LEFT_OUT = "pinch", "F11", "L", "Esc"  # needs a touchpad; takes the screen; takes the keyboard; leaves
DONE_BEFORE = "mouse", "hold", "left", "click", "with wheel"  # while they touched and cut
DRAWS = "cuts .*along the pointer"  # where a blade stays in the hand without a button
SEEN = 20_000  # of a picture's sum of levels, that a person sees to have changed
PICTURES = "first", "help", "touched", "above", "holds", "cut"  # of the steps that docs/learn/desk.md shows


def readme_command(who):
    """What README.md tells them to run."""
    for line in (ROOT / "README.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) > 2 and cells[1] == who:
            return cells[2].strip("`").split()
    raise AssertionError(f"README.md has no line \"{who}\"")


def around(middle, step, across, down):
    """Places of a grid in the window, the nearest to its middle first."""
    places = [(middle[0] + step * x, middle[1] + step * y) for x in range(-across, across + 1) for y in range(-down, down + 1)]
    seen = [place for place in places if 20 <= place[0] < SIZE[0] - 20 and 50 <= place[1] < SIZE[1] - 70]
    return sorted(seen, key=lambda place: sum((a - b) ** 2 for a, b in zip(place, middle)))


class Newcomer:
    """Reads, looks about, and does. `log` is the client's terminal, `pace` that of Hands."""

    def __init__(self, out, client, window, log, pace):
        act("windowfocus", window)
        self.out, self.client, self.window, self.log = out, client, window, log
        self.begun, self.times, self.stumbles = time.monotonic(), {}, []
        self.hands = Hands(window, SIZE, pace)
        self.help = None

    def terminal(self):
        return self.log.read_text()

    def reads(self, message, seconds):
        """Whether such a message comes within that time."""
        end, begun = time.monotonic() + seconds, self.read_until
        while time.monotonic() < end:
            if re.search(message, self.terminal()[begun:], re.MULTILINE):
                return True
            time.sleep(0.1)
        return False

    def turns_to(self):
        """From here on messages are news."""
        self.read_until = len(self.terminal())

    def last_held(self):
        """What the last message on it says, since the person turned to what they do now."""
        return (["nothing", *re.findall("^you hold (the .*)$", self.terminal()[self.read_until:], re.MULTILINE)])[-1]

    def has(self, done, picture=None):
        self.times[done] = round(time.monotonic() - self.begun, 1)
        print(f"{self.times[done]:6.1f} s  {done}", flush=True)
        if picture:
            self.picture(picture)

    def stumbles_over(self, what):
        self.stumbles.append({"seconds": round(time.monotonic() - self.begun, 1), "over": what})
        print(f"{self.stumbles[-1]['seconds']:6.1f} s  stumbles: {what}", flush=True)

    def sees(self):
        """The window's picture."""
        left, top = corner(self.window)
        return ImageGrab.grab(xdisplay="").crop((left, top, left + SIZE[0], top + SIZE[1])).convert("RGB")

    def picture(self, name):
        self.sees().save(self.out / f"{name}.png")

    def leaves_times(self):
        self.picture("last")
        (self.out / "times.json").write_text(json.dumps({"seconds": self.times, "stumbles": self.stumbles}, indent=2) + "\n")

    def asks(self, question, answer):
        begun = len(self.terminal())
        self.client.stdin.write(f"{question}\n".encode())
        self.client.stdin.flush()
        return wait_until(f"the answer to \"{question}\"", lambda: re.search(answer, self.terminal()[begun:], re.MULTILINE))[1]

    def named(self):
        """What is named beside the pointer, once the picture is of where it is."""
        before = None
        for _ in range(10):
            time.sleep(0.1)
            said = self.asks("what", r"^at the pointer: (.*)$")
            if said == before:
                break
            before = said
        return said

    def finds(self, name, places):
        """The first of these places at which that is named."""
        for place in places:
            self.hands.move(place)
            if self.named().split(", held by")[0] == name:
                return place
        return None

    def finds_along(self, name, start, steps, until):
        """The first place on a way in small steps at which `name` is named, before `until` is."""
        for step in steps:
            self.hands.move((start[0] + step, start[1]), 0.1)
            named = self.named()
            if named.startswith(until):
                return None
            if named.split(", held by")[0] == name:
                return self.hands.at
        return None


def reads_the_help(person):
    """The key is the first thing that is told."""
    first = wait_until("a word on help", lambda: re.search(r"^(\S+): lists all mouse and keyboard controls", person.terminal(), re.MULTILINE))
    wait_until("the first picture", lambda: any(low < high - 50 for low, high in person.sees().getextrema()))
    time.sleep(0.5)
    person.picture("first")
    person.hands.press(first[1])
    time.sleep(1)
    person.help = Help(person.terminal())
    person.has("reads the help", "help")
    time.sleep(10 * person.hands.pace)
    person.hands.press(first[1])


def touches_the_liver(person):
    """Where its name stands beside the pointer; elsewhere on it, where something else comes into the hand."""
    places = around((SIZE[0] // 2, SIZE[1] // 2), 60, 5, 4)
    for _ in range(4):
        at = person.finds("liver", places)
        assert at, "nothing more in the first picture is named liver"
        if "finds the liver" not in person.times:
            person.has("finds the liver", "found")
        person.turns_to()
        person.hands.hold(person.help.control("grasps", by="button"))
        held = person.reads("you hold the liver", 4)
        person.hands.move((at[0] + 30, at[1] - 30), 2 * person.hands.pace)
        person.picture("touched")
        person.hands.let_go()
        if held:
            person.has("touches the liver")
            return
        person.stumbles_over("the hand went to the liver, and holds " + person.last_held())
        time.sleep(1)
        places = [place for place in places if place[1] < at[1] - 20]
    raise AssertionError("the hand never held the liver")


def looks_from_above(person):
    """And from farther away, as whoever looks for something."""
    views = next(does for _, does in person.help.rows if re.search("views: .*above", does))
    number = re.split("[,;:] ", views).index("above")
    person.hands.press(str(number))
    person.hands.turn_wheel(person.help.control("^zooms", by="wheel"), -5)
    time.sleep(1 + person.hands.pace)
    person.picture("above")


def finds_room_for_a_cut(person):
    """Where a line on the liver may begin, and where it may end with liver still beyond."""
    for start in around((SIZE[0] // 2, SIZE[1] // 2), 40, 5, 4):
        for x, y in ((-30, 0), (0, -30), (-25, -25), (25, -25)):
            line = [(start[0] + k * x, start[1] + k * y) for k in (0, 1, 2, 3)]
            if all(person.finds("liver", [place]) for place in line):
                return line[0], line[2]
    raise AssertionError("seen from above there is no room on the liver for a cut")


def finds_the_scalpel(person, tray, rows):
    """Goes across the tray, from border to border, in rows so far below that place."""
    for down in rows:
        for way in range(0, 300, 7), range(0, -300, -7):
            if person.finds_along("scalpel", (tray[0], tray[1] + down), way, "table"):
                return
    raise AssertionError("no scalpel is named on the tray")


def takes_the_scalpel(person):
    """Returns from where to where on the liver there is room for a cut, in the window as it is by then."""
    looks_from_above(person)
    line = finds_room_for_a_cut(person)
    tray = person.finds("tray", around((SIZE[0] // 2, SIZE[1] // 2), 80, 4, 2))
    assert tray, "seen from above there is no tray"
    person.has("finds the tray", "tray")
    for rows in (0, 40, -40, 80, -80), (30, -30, 60, -60, 90), (-20, 20, -50, 50, 70):
        finds_the_scalpel(person, tray, rows)
        if "finds the scalpel" not in person.times:
            person.has("finds the scalpel", "scalpel")
        person.turns_to()
        person.hands.hold(person.help.find("^takes it up") or person.help.control("grasps", by="button"))
        if person.reads("you hold the scalpel", 4):
            person.has("holds the scalpel")
            time.sleep(1 + person.hands.pace)
            person.picture("holds")
            if person.help.find(DRAWS):
                person.hands.let_go()
            return line
        person.stumbles_over("the pointer is at the scalpel, and the hand holds " + person.last_held())
        person.hands.move((tray[0] - 90, tray[1] + 200), 2 * person.hands.pace)  # put aside, on the table
        person.hands.let_go()
        time.sleep(1)
    raise AssertionError("the scalpel never came into the hand")


def strokes(person, start):
    """Whether a stroke along the liver, there and back, cuts."""
    for x, y in ((0, 45), (0, -45), (0, 0)):
        person.hands.move((start[0] + x, start[1] + y), 2 * person.hands.pace)
    return person.reads("you cut the liver", 1)


def cuts_as_the_help_says(person, line, draw):
    """A line along the pointer; again if that failed."""
    for _ in range(3):
        person.hands.move(line[0], person.hands.pace)
        time.sleep(1)
        person.hands.hold(draw)
        time.sleep(1)
        person.hands.move(line[1], 4)
        cut = person.reads("you cut the liver", 2)
        person.picture("cutting")
        person.hands.let_go()
        if cut:
            return True
        person.stumbles_over("drawing along the liver as the help says cuts nothing")
    return False


def cuts_by_trying(person, liver):
    """By lowering the blade and turning the wrist, where the help says no more than that."""
    for quarter in range(4):
        for _ in range(3):
            person.hands.turn_wheel(person.help.control("how deep"), 4)
            if strokes(person, liver):
                return True
        person.stumbles_over(f"no cut, {quarter} quarters of a turn of the wrist from how the scalpel lay")
        person.hands.turn_wheel(person.help.control("how deep"), -12)
        person.hands.turn_wheel(person.help.control("rolls the wrist"), 16)
    return False


def cuts_the_liver(person, line):
    person.hands.move(line[0], 4 * person.hands.pace)
    time.sleep(1)
    person.picture("over")
    person.turns_to()
    draw = person.help.find(DRAWS)
    assert cuts_as_the_help_says(person, line, draw) if draw else cuts_by_trying(person, line[0]), "nothing was cut"
    person.has("cuts the liver", "cut")


def takes_it_back(person):
    person.hands.let_go()
    person.turns_to()
    person.hands.press(person.help.control("undoes your last cut"))
    assert person.reads("you undid a cut of the liver", 10), "no message says that the cut was undone"
    person.has("takes the cut back", "back")


def tries(person, way):
    """Whether the help's words for a control could be followed, somewhere on the liver; what comes of it is seen in the picture."""
    hands, *_, last = person.hands, *way.split(" + ")
    keys = re.fullmatch(r"(?:\S )+\S|\S", last)
    if last in LEFT_OUT or way.startswith(DONE_BEFORE):
        return False
    if " to " in last:
        hands.press(way.replace(last, last.split(" to ")[1]))
        hands.press(way.replace(last, last.split(" to ")[0]))
    elif last.startswith("wheel"):  # also on the list that a line before opened
        hands.turn_wheel(way, 3)
    elif last.endswith(" drag"):
        hands.drag(way, (60, 30))
    elif keys:
        for key in last.split():
            hands.press(way.replace(last, key))
    else:
        hands.press(way)
    return True


def tries_every_line(person):
    """Each way of each line, from the first view on; those after which nothing in the window changes are told of."""
    home = person.help.control("first view")
    person.hands.press(home)
    at = person.finds("liver", around((SIZE[0] // 2, SIZE[1] // 2), 60, 5, 4))
    for control, does in person.help.rows:
        for way in control.split(", "):
            if way != home:
                person.hands.press(home)
            person.hands.move(at)
            time.sleep(0.5)
            before = person.sees()
            if not tries(person, way):
                continue
            time.sleep(0.7)
            change = ImageStat.Stat(ImageChops.difference(before, person.sees())).sum
            if sum(change) < SEEN:
                person.stumbles_over(f"{way}, which {does}: nothing changes")
    person.has("has tried every line")


def touches_and_cuts(person):
    reads_the_help(person)
    touches_the_liver(person)
    cuts_the_liver(person, takes_the_scalpel(person))


def check(times):
    assert times["touches the liver"] < TOUCHED_WITHIN and times["cuts the liver"] < CUT_WITHIN, times


def main():
    bin_folder, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    session = f"newcomer-{os.getpid()}"
    with Processes(out) as processes:
        host, scene = readme_command("host")
        server = processes.start("server.log", bin_folder / host, ROOT / scene, "--session", session, "--domain", 78, "--summary",
                                 out / "server.json")
        wait_until("the server", lambda: processes.says("server.log", "is open on this machine"), 120, server)
        join, *options = readme_command("join at a desk")
        client = processes.start("client.log", bin_folder / join, *options, "--session", session, "--domain", 78)
        window = window_of(client, f"Prosector: {session}")
        wait_until("the scene", lambda: processes.says("client.log", "everything is here"), 60, client)
        person = Newcomer(out, client, window, out / "client.log", BRISK if "--brisk" in sys.argv else LEISURELY)
        try:
            touches_and_cuts(person)
            takes_it_back(person)
        finally:
            person.leaves_times()
        processes.leave(client, server)
    check(person.times)


if __name__ == "__main__":
    main()
