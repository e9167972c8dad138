#!/usr/bin/python3
"""learn.py BIN OUT [LESSON]..., run by deploy/learn.sh: goes through the lessons of docs/learn by their own words, and makes their pictures."""

import json
import math
import os
import pathlib
import re
import shutil
import signal
import sys
import time

from PIL import Image, ImageDraw, ImageFont

import asked_part
import newcomer
from desk_person import act
from lesson import ROOT, Lesson

BESIDE, BELOW = (820, 0), (0, 640)  # places of further windows on the screen
ROUND, PRESSES = 24, 10             # s: of the scripts of deploy/demo, and from their begin until the hand is in the liver
FILM = 8  # s, of the hand that presses
COST, ERROR = "ms_per_frame", "error_continuum"


def chart(rows):
    """Error against cost, both in decades, a point each row."""
    points = [(math.log10(row[COST]), math.log10(row[ERROR]), f"{row['tets']} {row['element']}") for row in rows if row.get(ERROR)]
    assert len(points) > 3, "too little was measured for a picture"
    width, height, margin, font = 640, 400, 60, ImageFont.truetype("DejaVuSans.ttf", 13)
    low = [math.floor(min(point[k] for point in points)) for k in (0, 1)]
    high = [math.ceil(max(point[k] for point in points)) for k in (0, 1)]
    picture = Image.new("RGB", (width, height), "white")
    draw = ImageDraw.Draw(picture)

    def at(x, y):
        return (margin + (x - low[0]) / (high[0] - low[0]) * (width - 2 * margin),
                height - margin - (y - low[1]) / max(1, high[1] - low[1]) * (height - 2 * margin))

    for x in range(low[0], high[0] + 1):
        draw.line((*at(x, low[1]), *at(x, high[1])), "#cccccc")
        draw.text((at(x, 0)[0] - 12, height - margin + 8), f"{10.0 ** x:g}", "black", font)
    for y in range(low[1], high[1] + 1):
        draw.line((*at(low[0], y), *at(high[0], y)), "#cccccc")
        draw.text((8, at(0, y)[1] - 8), f"{100 * 10.0 ** y:g} %", "black", font)
    colours = dict(zip(sorted({kind for _, _, kind in points}), ("#1f5fa8", "#c8641e", "#3b8a3b", "#8a3b8a")))
    for x, y, kind in points:
        cx, cy = at(x, y)
        draw.ellipse((cx - 4, cy - 4, cx + 4, cy + 4), colours.get(kind, "black"))
    for k, (kind, colour) in enumerate(colours.items()):
        draw.text((width - 2 * margin - 40, 12 + 16 * k), kind, colour, font)
    draw.text((margin, 12), "error of the deflection", "black", font)
    draw.text((width // 2 - 60, height - 24), "ms of CPU a frame", "black", font)
    return picture


def desk(lesson):
    server = lesson.start("prosector-server", "server.log")
    server.waits_for("is open on this machine", 120)
    client = lesson.start("prosector-client", "client.log")
    window = lesson.window()
    client.waits_for("everything is here")
    person = newcomer.Newcomer(lesson.folder, client.shell, window.window, client.log, newcomer.LEISURELY)
    onlooker = lesson.watch("prosector")
    try:
        newcomer.reads_the_help(person)
        newcomer.touches_the_liver(person)
        asked_part.looks_around(person, onlooker, "Ann")
        asked_part.asks_the_liver(person, onlooker, "Ann")
        newcomer.cuts_the_liver(person, newcomer.takes_the_scalpel(person))
        newcomer.takes_it_back(person)
        newcomer.tries_every_line(person)
    finally:
        person.leaves_times()
        for picture in newcomer.PICTURES:
            if (file := lesson.folder / f"{picture}.png").exists():
                lesson.keep(Image.open(file), picture)
    newcomer.check(person.times)


def host(lesson):
    server = lesson.start("prosector-server", "server.log")
    server.waits_for("is open on this machine", 120)
    ann = lesson.start("--name Ann", "ann.log")
    ann_window = lesson.window()
    ann.waits_for("everything is here")
    time.sleep(1.5)
    lesson.keep(ann_window.picture(), "window")
    ben = lesson.start("--name Ben", "ben.log")
    ben_window = lesson.window(BESIDE)
    ben.waits_for("everything is here")
    ann.waits_for("Ben joined as a dissector")
    ben_window.point(0.5, 0.45)
    time.sleep(2)
    ann_window.press("Tab")
    time.sleep(2)
    lesson.keep(ann_window.picture(), "guest")
    ann_window.press("Tab")
    lesson.type(ann, "give Ben observer")
    ben.waits_for("you are now an observer")
    lesson.type(ann, "give Ben dissector")
    ben.waits_for("you are now a dissector")
    ann.type("help")
    ann.waits_for("give NAME ROLE")
    ann_window.press("space")
    ben.waits_for("the host stopped time")
    time.sleep(1)
    lesson.keep(ben_window.picture(), "stopped")
    lesson.type(ann, "step 10")
    ben.waits_for("slow motion")
    ben.waits_for("time resumed")
    lesson.type(ann, "reset all")
    for window, terminal in (ben_window, ben), (ann_window, ann):
        window.press("Escape")
        assert terminal.shell.wait(30) == 0, "somebody could not leave"
    os.killpg(server.shell.pid, signal.SIGINT)
    server.waits_for("ended after")
    said = lesson.run("--replay", "replay.log")
    assert "equal" in said, said


def headset(lesson):
    lesson.start("prosector-server", "server.log").waits_for("is open on this machine", 120)
    lesson.start("prosector-fastrak-twin", "twins.log")
    time.sleep(1)
    ann = lesson.start("--name Ann", "ann.log")
    window = lesson.window()
    ann.waits_for("tracker .*streaming")
    streaming = time.monotonic()
    ann.waits_for("everything is here")
    lesson.start("--name Ben", "ben.log").waits_for("everything is here")
    outside = lesson.window(BELOW)
    outside.turn_wheel(-4, "ctrl")
    time.sleep(max(0, PRESSES - (time.monotonic() - streaming)))
    lesson.keep(window.picture(), "stereo")
    lesson.keep(outside.picture(), "outside")
    lesson.run("mine.csv", "mine.log")


def observer(lesson):
    lesson.start("prosector-server", "first.log")
    ann_log = lesson.folder / "ann.log"
    newcomer.wait_until("Ann", lambda: ann_log.exists() and "streaming" in ann_log.read_text(), 120)
    streaming = time.monotonic()

    def presses():
        """Waits for the next moment at which her hand is in the liver."""
        now = (time.monotonic() - streaming) % ROUND
        time.sleep((PRESSES - now) % ROUND)

    ben = lesson.start("prosector-client observe --session lesson --name Ben\n", "ben.log")
    window = lesson.window()
    ben.waits_for("everything is here")
    for key in ("h", "h", "Home"):
        window.press(key)
        time.sleep(0.5)
    window.point(0.5, 0.45)
    act("mousedown", 3)
    window.point(0.6, 0.5)
    act("mouseup", 3)
    for key in ("g", "Home", "c", "c", "i", "i"):
        window.press(key)
        time.sleep(0.5)
    window.turn_wheel(-3, "ctrl")
    presses()
    outside = window.picture()
    window.press("Tab")
    time.sleep(0.7)
    lesson.keep(window.picture(), "eyes")
    lesson.keep(outside, "window")
    window.press("Tab")
    window.press("v")
    presses()
    lesson.keep(window.picture(), "strain")
    lesson.type(ben, "picture mine.png")
    newcomer.wait_until("mine.png", (lesson.folder / "mine.png").exists, 20)
    window.press("Escape")
    assert ben.shell.wait(30) == 0
    lesson.run("--record mine.avi", "video.log", 90)
    assert (lesson.folder / "mine.avi").stat().st_size > 10_000, "there is hardly a video"
    cem = lesson.start("--language tr", "cem.log")
    window = lesson.window()
    cem.waits_for("everything is here")
    window.picture()
    window.point(0.5, 0.45)
    time.sleep(1.5)
    lesson.keep(window.picture(), "names")


def researcher(lesson):
    lesson.block("deploy/build.sh")  # what it builds is what this runs
    said = lesson.run("prosector-bench", "bench.log", 120)
    assert "within 16 ms" in said, said
    lesson.keep(chart(json.loads((lesson.folder / "bend.json").read_text())["rows"]), "trade")
    said = lesson.run("--replay", "replay.log")
    assert "equal" in said, said
    said = lesson.run("prosector-play", "play.log", 120)
    print(said)


def programmer(lesson):
    lesson.block("deploy/build.sh")  # what it builds is what this installs
    release = lesson.folder / "build" / "release"
    built = (release / "bin").resolve().parent
    (release / "bin").unlink()
    release.rmdir()
    release.symlink_to(built)
    lesson.run("cmake --install", "install.log", 120)
    said = lesson.run("cp -r prosector", "example.log", 300)
    page = (ROOT / "docs" / "learn" / "programmer.md").read_text()
    said += lesson.run("sed -i", "stiffer.log", 300)
    lines = re.findall(r"(?:beam|ball|kidney): .*", said)
    assert len(lines) == 6 and lines[1:3] == lines[4:], said
    for line in lines:
        assert f"`{line}`" in page, f"programmer.md does not have: {line}"


def webcam(lesson):
    lesson.run("prosector-board", "boards.log", 120)
    said = lesson.run("camera record", "camera.log", 300)
    print(said)
    said = lesson.run("camera calibrate", "calibrate.log", 120)
    print(said)
    lesson.run("cat > webcam.toml", "config.log")
    lesson.start("prosector-server", "server.log").waits_for("is open on this machine", 120)
    ann = lesson.start("--name Ann", "ann.log")
    through = lesson.window()
    ann.waits_for("tracker .*streaming")
    ann.waits_for("everything is here")
    lesson.start("--name Ben", "ben.log").waits_for("everything is here")
    outside = lesson.window(BELOW)
    time.sleep(2 * FILM)
    lesson.keep(through.picture(), "through")
    lesson.keep(outside.picture(), "outside")
    said = lesson.run("selftest hands", "selftest.log")
    print(said)


LESSONS = {"host": host, "headset": headset, "desk": desk, "observer": observer, "researcher": researcher, "webcam": webcam, "programmer": programmer}


def main():
    bin_folder, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(out, ignore_errors=True)
    (out / "pictures").mkdir(parents=True)
    path = f"{bin_folder}:{os.environ['PATH']}"  # what a terminal has after a lesson's first block
    environment = {**os.environ, "LC_ALL": "C.UTF-8", "LP_NUM_THREADS": "2", "PATH": path}
    for name in sys.argv[3:] or LESSONS:
        with Lesson(name, out, bin_folder, out / "pictures", environment) as lesson:
            LESSONS[name](lesson)


if __name__ == "__main__":
    main()
