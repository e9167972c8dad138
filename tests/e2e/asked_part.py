"""What docs/learn/desk.md has a reader do between touching and cutting, acted: looking around, and asking a part what it is.

What comes of it is read in the session log of an onlooker.
"""

import time

from desk_person import View, act, cross, plus, times, wait_until
from newcomer import SIZE, around

FOV = 0.8  # rad, of the lesson's scene
# Of the board, m to the right of and above its middle: common/panel.h.
ATTACHED, LIGHT, ROOM, SLIDER = (-0.071, 0.028), (0.071, -0.012), (-0.071, -0.052), (0, -0.096)
SLIDER_TRAVEL = 0.23


def anywhere():
    return around((SIZE[0] // 2, SIZE[1] // 2), 60, 6, 5)


class Asker:
    """A newcomer with a part's panel before them."""

    def __init__(self, person, log, name):
        self.person, self.name = person, name
        self.view = View(person.window, SIZE, FOV, log, name)

    def panel(self):
        return self.view.last_line().get("panels", {}).get(self.name)

    def part(self, name):
        return self.view.last_line()["parts"][name]

    def place(self, spot):
        """Where that place of the board is in the room."""
        panel = self.panel()
        along = cross((0, 1, 0), panel["faces"])
        right = times(1 / max(1e-9, sum(a * a for a in along)) ** 0.5, along)
        return plus(panel["at"], plus(times(spot[0], right), times(spot[1], cross(panel["faces"], right))))

    def click(self, spot):
        self.view.point_at(self.place(spot))
        time.sleep(0.3)
        act("click", 1)

    def drag(self, spot, by):
        start, end = self.place(spot), self.place((spot[0] + by, spot[1]))
        self.view.point_at(start)
        time.sleep(0.3)
        act("mousedown", 1)
        self.view.draw(start, end, 10)
        act("mouseup", 1)


def looks_around(person, log, name):
    """The table of the lesson: a part fills the window, and the first view comes back."""
    view = Asker(person, log, name).view
    home = person.help.control("first view")
    person.hands.press(home)
    view.settle()
    first = view.eyes()
    at = person.finds("kidney", anywhere())
    assert at, "nothing in the first picture is named kidney"
    view.after(lambda: person.hands.press(person.help.control("^fits what is under")))
    view.after(lambda: person.hands.press(home))
    assert max(abs(a - b) for a, b in zip(first[0], view.eyes()[0])) < 0.01, "Home leads elsewhere"
    person.has("looks around")


def asks_the_liver(person, log, name):
    """Its panel comes up; buttons and slider do what they say; away from it the same key shuts it."""
    asker = Asker(person, log, name)
    person.hands.press(person.help.control("first view"))
    asker.view.settle()
    assert person.finds("liver", anywhere()), "nothing in the first picture is named liver"
    person.turns_to()
    key = person.help.control("^the panel of the part")
    person.hands.press(key)
    wait_until("the liver's panel", lambda: (asker.panel() or {}).get("part") == "liver", 10)
    time.sleep(1)
    person.picture("panel")
    asker.click(ATTACHED)
    wait_until("the liver to be out of its place", lambda: not asker.part("liver")["attached"], 10)
    asker.click(ATTACHED)
    wait_until("the liver to be back in its place", lambda: asker.part("liver")["attached"], 10)
    asker.click(ROOM)
    wait_until("the room to be dim", lambda: asker.view.last_line()["room_lights"] < 1, 10)
    asker.click(LIGHT)
    wait_until("the light on the liver", lambda: asker.part("liver")["lit"], 10)
    before = asker.part("liver")["stiffness"]
    asker.drag(SLIDER, SLIDER_TRAVEL / 4)
    wait_until("the liver to be stiffer", lambda: asker.part("liver")["stiffness"] > 1.2 * before, 10)
    assert person.finds("table", anywhere()), "nothing in the first picture is named table"
    person.hands.press(key)
    wait_until("the panel to go", lambda: not asker.panel(), 10)
    said = person.terminal()[person.read_until:]
    assert "refused" not in said and "no panel" not in said, said
    person.has("asks the liver what it is")
