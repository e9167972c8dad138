#!/usr/bin/python3
"""check_playback.py DIR [--stops]: what playback_test.sh left in DIR. --stops prints the two times, s, at which the session stood."""

import pathlib
import re
import struct
import sys
import zlib

from checks import check, figures, finish, journal_rows

folder = pathlib.Path(sys.argv[1])
TICK_RATE = 60
PEOPLE = 0.015  # share of the picture: a journal doesn't keep where heads look, and forearms go with them


def pixels(file):
    """A picture of 8-bit RGB, row by row, without its filters."""
    data = file.read_bytes()
    at, packed, width, height = 8, b"", 0, 0
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height = struct.unpack(">II", body[:8])
        if kind == b"IDAT":
            packed += body
        at += size + 12
    raw, stride, above, out = zlib.decompress(packed), 3 * width, bytearray(3 * width), []
    for y in range(height):
        how, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - 3] if i >= 3 else 0), above[i], (above[i - 3] if i >= 3 else 0)
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda c: abs(guess - c))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth)[how]) & 255
        out.append(row)
        above = row
    return out


def differing(a, b):
    """The share of pixels that differ by more than a shade."""
    rows = list(zip(pixels(folder / a), pixels(folder / b)))
    off = sum(max(abs(p[i + k] - q[i + k]) for k in range(3)) > 12 for p, q in rows for i in range(0, len(p), 3))
    return off / (len(rows) * len(rows[0][0]) / 3)


stops = [row["tick"] / TICK_RATE for row in journal_rows(folder, "event") if row["what"] == "pace" and "stopped" in row["detail"]]
if "--stops" in sys.argv:
    print(*(f"{s:.6f}" for s in stops[:2]))
    sys.exit()

for live, played in (("before", "before_played"), ("after", "after_played"), ("after", "after_again")):
    share = differing(f"{live}.png", f"{played}.png")
    print(f"      {played}: {100 * share:.3f} % of the pixels differ")
    check(f"{played} is as it was", share < PEOPLE)
check("before the cut is not after it", differing("before.png", "after.png") > 2 * PEOPLE)
log = (folder / "play.log").read_text()
check("every state hash is the recorded one", "DIFFERENT" not in log)
check("the viewer saw no contradiction", figures(folder / "viewer.json")["contradictions"] == 0)
check("it ran faster than real time", any(float(x) > 1.2 for x in re.findall(r"x([\d.]+) real time", log)))
check("nothing can be changed", "it cannot be changed" in (folder / "viewer.log").read_text())
check("the journal was not touched", (folder / "journal.was").read_text() == (folder / "journal.is").read_text())
check("nothing lies beside it", not (folder / "journal.sqlite-wal").exists())
finish()
