#!/usr/bin/python3
"""camera_film_test.py BIN OUT: a synthetic camera's pictures are kept as a film, with the lens and the truth beside it; the film is a camera, whose
pictures are kept again. What can't be written, or isn't there, is told in words."""
import csv
import math
import pathlib
import shutil
import subprocess
import sys

from checks import check, finish
from film import pictures

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
RATE, SECONDS, SIZE = 10, 1.5, (64, 48)
FROM, TO = (0, 1.0, 0.4), (0.3, 1.2, 0.5)  # of the camera's way, which takes SECONDS
RED = (200, 20, 30)

shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)
(OUT / "way.csv").write_text("time,x,y,z,qw,qx,qy,qz\n" + "".join(f"{t},{x},{y},{z},1,0,0,0\n" for t, (x, y, z) in ((0, FROM), (SECONDS, TO))))
(OUT / "scene.toml").write_text(
    f"[[camera]]\nwidth = {SIZE[0]}\nheight = {SIZE[1]}\nfocal = 60\nrate = {RATE}\nrays = 1\ndistortion = [-0.1, 0.02, 0, 0, 0]\nmotion = \"way.csv\"\n"
    f"[[plate]]\nname = \"wall\"\nwidth = 9\nheight = 9\nposition = [0, 1, -1]\norientation = [1, 0, 0, 0]\ncolour = {list(RED)}\n")


def record(camera, film, *words):
    return subprocess.run([BIN / "prosector-client", "camera", "record", str(camera), "--out", str(film), "--seconds", str(SECONDS), *words],
                          capture_output=True, text=True)


def eased(t):
    """A share of the way, as motion scripts go."""
    return ((6 * t - 15) * t + 10) * t ** 3


told = record(f"synthetic:{OUT}/scene.toml", OUT / "film.avi")
check(f"a scene is filmed: {told.stdout.strip()}", told.returncode == 0)
seen = pictures(OUT / "film.avi")
check(f"{len(seen)} pictures, none left out", len(seen) == SECONDS * RATE)
check("as large as the camera's", {picture.size for picture in seen} == {SIZE})
middles = [picture.getpixel((SIZE[0] // 2, SIZE[1] // 2)) for picture in seen]
check(f"they show the wall: {middles[0]}", all(red > 2 * max(green, blue) for red, green, blue in middles))
with open(OUT / "film.csv", newline="") as stream:
    truth = list(csv.DictReader(stream))
cameras = [row for row in truth if row["thing"] == "camera"]
check("each picture has its truth", len(cameras) == len(seen) and len(truth) == 2 * len(seen))
off = [math.dist([float(row[axis]) for axis in "xyz"], [a + eased((k + 0.5) / RATE / SECONDS) * (b - a) for a, b in zip(FROM, TO)])
       for k, row in enumerate(cameras)]
check(f"the camera went its way, off by {1e3 * max(off):.4f} mm", max(off) < 1e-5)
check("the wall stood still", {(row["thing"], row["z"]) for row in truth} - {("camera", row["z"]) for row in cameras} == {("wall", "-1.000000")})
lens = (OUT / "film.toml").read_text()
check("the lens is the scene's", "-0.1000000, 0.0200000" in lens and f"width = {SIZE[0]}" in lens)
test = subprocess.run([BIN / "prosector-client", "camera", "selftest", OUT / "film.avi", "--lens", OUT / "film.toml", "--seconds", "1"], capture_output=True, text=True)
check("the film is a camera, and the lens fits it", f"{SIZE[0]} × {SIZE[1]}" in test.stdout or f"{SIZE[0]} x {SIZE[1]}" in test.stdout)

again = record(OUT / "film.avi", OUT / "again.avi")
check("a film is filmed", again.returncode == 0)
kept = pictures(OUT / "again.avi")
check(f"for as long: {len(kept) / 30:.2f} s", abs(len(kept) / 30 - SECONDS) < 0.5)
check("and shows the same", all(red > 2 * max(green, blue) for red, green, blue in (picture.getpixel((SIZE[0] // 2, SIZE[1] // 2)) for picture in kept)))
check("without a lens, which nobody knows", not (OUT / "again.toml").exists())

for what, camera, film, words in (("no scene", f"synthetic:{OUT}/none.toml", "x.avi", "none.toml"), ("no camera", OUT / "none.avi", "x.avi", "none.avi"),
                                  ("another ending", f"synthetic:{OUT}/scene.toml", "x.png", ".avi"),
                                  ("no folder", f"synthetic:{OUT}/scene.toml", "none/x.avi", "none")):
    refused = record(camera, OUT / film)
    check(f"{what}: {refused.stderr.strip().splitlines()[-1:]}", refused.returncode != 0 and words in refused.stderr)
if "-v" in sys.argv:
    print(test.stdout)
finish()
