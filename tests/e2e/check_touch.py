#!/usr/bin/python3
"""Checks what the observer of deploy/demo_touch.sh knew: DIR/log.jsonl, written from its replica, and DIR's pictures."""

import json
import pathlib
import sys

FIRST, SECOND = "first user, right", "second user, right"
folder = pathlib.Path(sys.argv[1])
lines = [json.loads(line) for line in (folder / "log.jsonl").read_text().splitlines()]
failures = []


def check(what, holds):
    print(("ok    " if holds else "FAILED"), what)
    if not holds:
        failures.append(what)


def holders(line):
    return set(line["parts"]["liver"].get("holders", []))


def upward(line):
    """N, of each hand that touches the liver."""
    return {hand: t["force"][1] for hand, t in line["touches"].items() if t["body"] == "liver"}


def held_by(*hands):
    """The last lines in which exactly these hold the liver, and no other hand touches it: lifted, and at rest."""
    those = [l for l in lines if holders(l) == set(hands) and set(upward(l)) == set(hands)]
    calm = [l for l in those if sum(upward(l).values()) > 0]
    return calm[-6:]


def mean(values):
    values = list(values)
    return sum(values) / len(values) if values else float("nan")


def rise(some):
    """mm, of the liver's surface, mean."""
    return 1e3 * mean(l["parts"]["liver"]["shift"][1] for l in some)


# ---- Holding together
seen = [h for h, before in zip(map(holders, lines), [None, *map(holders, lines)]) if h != before]
check(f"nobody, the first, both, the second, nobody held the liver: {[sorted(h) for h in seen]}",
      seen == [set(), {FIRST}, {FIRST, SECOND}, {SECOND}, set()])
alone, together, handed_over = held_by(FIRST), held_by(FIRST, SECOND), held_by(SECOND)
check("each of these lasted", min(len(alone), len(together), len(handed_over)) >= 2)
lift = {hand: mean(upward(l)[hand] for l in some) for hand, some in ((FIRST, alone), (SECOND, handed_over))}
shares = {hand: mean(upward(l)[hand] for l in together) for hand in lift}
for hand in lift:
    check(f"{hand}: alone lifts with {lift[hand]:.1f} N, in company with {shares[hand]:.1f}", min(lift[hand], shares[hand]) > 1)
# Of an elastic body that is tied down, each hand's share of the rise is what it would lift by itself with that force.
expected = rise(alone) * shares[FIRST] / lift[FIRST] + rise(handed_over) * shares[SECOND] / lift[SECOND]
check(f"their forces add: the liver rises by {rise(together):.1f} mm, {expected:.1f} mm by superposition",
      0.7 * expected < rise(together) < 1.3 * expected)
check(f"by one hand it rises by {rise(alone):.1f} and {rise(handed_over):.1f} mm",
      rise(together) > 1.2 * max(rise(alone), rise(handed_over)) > 0)
check(f"it is back in the end, within 0.5 mm: {lines[-1]['parts']['liver']['shift']}",
      max(map(abs, lines[-1]["parts"]["liver"]["shift"])) < 5e-4)

# ---- The panel
def panels(part):
    return [(l, p["controls"]) for l in lines for user, p in l["panels"].items()
            if user == "first user" and p["part"] == part]


kidney = panels("kidney")
check("touching the kidney brought up its panel", bool(kidney))
check("its button said that it was attached", bool(kidney) and kidney[0][1]["attach"]["on"])
check("a finger pressed the button home, and it was green",
      any(c["attach"]["touched"] and c["attach"]["position"] > 0.85 for _, c in kidney))
check("the button came back", bool(kidney) and kidney[-1][1]["attach"]["position"] < 0.05)
end = lines[-1]["parts"]["kidney"]
check("the kidney is detached", end.get("attached") is False and bool(kidney) and not kidney[-1][1]["attach"]["on"])
check("a finger moved the slider, and it was green", any(c["stiffness"]["touched"] for _, c in kidney))
slider = kidney[-1][1]["stiffness"] if kidney else {"position": 0, "touched": True}
check(f"the slider stayed where it was left: {slider['position']}", slider["position"] > 0.6 and not slider["touched"])
check(f"the kidney is stiffer: {end.get('stiffness')}",
      abs(end.get("stiffness", 1) - 0.25 * 16 ** slider["position"]) < 0.01 * end.get("stiffness", 1))
check("the liver stays attached", lines[-1]["parts"]["liver"]["attached"])

# ---- Pictures
moments = ["alone", "together", "handed-over", "touch", "button", "slider", "end"]
pictures = [(folder / f"{eyes}{moment}.png").read_bytes() for eyes in ("", "eyes-") for moment in moments]
check("all pictures are there", all(data[:8] == b"\x89PNG\r\n\x1a\n" and len(data) > 8_000 for data in pictures))
check("they differ", len(set(pictures)) == len(pictures))
server = json.loads((folder / "server.json").read_text())
check("two took part, two watched", server["participants"] == 2 and server["observers"] == 2)
check("nothing that arrived was invalid", server["invalid_dropped"] == 0)
sys.exit(1 if failures else 0)
