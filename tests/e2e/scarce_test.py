#!/usr/bin/python3
"""scarce_test.py BIN OUT: a session whose programs may open 64 files only, limits that are refused with a remedy, odd films as cameras of a
running session, and a journal that was resumed ten times and is replayed."""
import json
import pathlib
import resource
import shutil
import subprocess
import sys
import time

from checks import check, finish
from film import mjpeg_of_many_sizes

BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SCENE = pathlib.Path(__file__).parents[2] / "deploy/scenes/touch.toml"
DOMAIN = "86"
FILES = 64
RESUMED = 10

shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)


def limited(files=None, megabytes=None):
    def set_limits():
        if files:
            resource.setrlimit(resource.RLIMIT_NOFILE, (files, files))
        if megabytes:
            resource.setrlimit(resource.RLIMIT_AS, (megabytes * 10**6,) * 2)
    return set_limits


def start(log, program, *words, **limits):
    with open(OUT / log, "w") as file:
        return subprocess.Popen([BIN / program, *map(str, words), "--domain", DOMAIN], stdout=file, stderr=subprocess.STDOUT,
                                stdin=subprocess.DEVNULL, preexec_fn=limited(**limits))


def said(log):
    return (OUT / log).read_text()


def wait_for(log, words, seconds=30):
    end = time.monotonic() + seconds
    while words not in said(log):
        if time.monotonic() > end:
            sys.exit(f"FAILED: no \"{words}\" in {log}:\n{said(log)}")
        time.sleep(0.05)


def refused(what, words, **limits):
    for program, arguments in (("prosector-server", [SCENE]), ("prosector-client", ["observe", "--display", "none"])):
        log = f"refused-{program}.log"
        code = start(log, program, *arguments, **limits).wait(20)
        check(f"{program} refuses {what}: {said(log).strip()}", code == 2 and words in said(log))


refused("32 open files", "ulimit -n 64", files=32)
refused("700 MB of memory", "ulimit -v", megabytes=700)

# A session within 64 open files each.
server = start("server.log", "prosector-server", SCENE, "--session", "scarce", "--journal", OUT / "journal.sqlite", files=FILES)
wait_for("server.log", "is open on this machine")
people = {name: start(f"{name}.log", "prosector-client", role, "--name", name, "--session", "scarce", "--display", display, "--seconds", "3",
                      "--summary", OUT / f"{name}.json", files=FILES)
          for name, role, display in (("ada", "join", "offscreen"), ("eve", "observe", "none"), ("sam", "observe", "none"))}
for name, person in people.items():
    code = person.wait(60)
    check(f"{name} took part with {FILES} open files", code == 0 and "everything is here" in said(f"{name}.log"))

# Films that are not whole, and files that are no films, as cameras of that session.
scene = OUT / "camera.toml"
scene.write_text("[[camera]]\nwidth = 160\nheight = 120\nfocal = 150\nrate = 20\nrays = 1\n"
                 "[[plate]]\nname = \"wall\"\nwidth = 9\nheight = 9\nposition = [0, 1, -1]\norientation = [1, 0, 0, 0]\ncolour = [200, 20, 30]\n")
subprocess.run([BIN / "prosector-client", "camera", "record", f"synthetic:{scene}", "--out", OUT / "whole.avi", "--seconds", "1.5"], check=True,
               stdout=subprocess.DEVNULL)
whole = (OUT / "whole.avi").read_bytes()
(OUT / "half.avi").write_bytes(whole[:len(whole) // 2])
(OUT / "torn.avi").write_bytes(whole[:len(whole) // 3] + bytes(len(whole) // 4) + whole[len(whole) * 7 // 12:])
(OUT / "sizes.mjpeg").write_bytes(mjpeg_of_many_sizes())
(OUT / "text.avi").write_text("no film\n" * 500)
(OUT / "empty.avi").write_bytes(b"")
for film, is_film in (("whole.avi", True), ("half.avi", True), ("torn.avi", True), ("sizes.mjpeg", True), ("text.avi", False), ("empty.avi", False)):
    client = start(f"{film}.log", "prosector-client", "join", "--name", "filmed", "--session", "scarce", "--display", "none",
                   "--tracker", f"tags:{OUT / film}", "--seconds", "2")
    code = client.wait(40)
    words = said(f"{film}.log")
    check(f"with {film} as camera one stays in the session", code == 0 and "everything is here" in words)
    check(f"{film}: {'a camera' if is_film else 'no camera, and told why'}", is_film != (f"{film}: cannot be opened as a camera" in words))
    check("in our own words", "OpenCV" not in words)
check("the session goes on", server.poll() is None)
server.terminate()
check("the server ends when told to", server.wait(20) == 0)
entries = json.loads((OUT / "ada.json").read_text())
check("what ada received was whole", entries["contradictions"] == 0)

# A journal in eleven parts.
for k in range(RESUMED):
    code = start("resumed.log", "prosector-server", "--resume", OUT / "journal.sqlite", "--session", "scarce", "--seconds", "0.5").wait(60)
    if code != 0:
        check(f"resumed for the {k + 1}th time: {said('resumed.log')}", False)
        break
code = start("replayed.log", "prosector-server", "--replay", OUT / "journal.sqlite").wait(120)
check(f"replays after it was resumed {RESUMED} times: {said('replayed.log').strip().splitlines()[-1:]}", code == 0)
finish()
