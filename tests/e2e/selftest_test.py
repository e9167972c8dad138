#!/usr/bin/python3
"""selftest_test.py BIN OUT: `prosector-client selftest` by a configuration, whose devices are twins: a tracker that does as it should, one whose
line is spoilt, and a glove. The configuration says which device and receivers are meant, and how they stand."""

import pathlib
import signal
import shutil
import subprocess
import sys

from checks import check, finish
from program import Program

BIN, OUT = map(pathlib.Path, sys.argv[1:3])
shutil.rmtree(OUT, ignore_errors=True)
OUT.mkdir(parents=True)

# Two receivers go about, and the fingers open and close.
(OUT / "motion.csv").write_text("""time,station,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little
0,1,-0.3,1.2,0.2,1,0,0,0,0,0,0,0,0
0.8,1,0.3,1.4,-0.2,0.9,0.3,0.3,0.0995,1,1,1,1,1
1.6,1,-0.3,1.2,0.2,1,0,0,0,0,0,0,0,0
0,2,0.0,1.3,0.0,1,0,0,0,0,0,0,0,0
0.8,2,0.4,1.1,0.3,0.9,0.3,0.3,0.0995,0,0,0,0,0
1.6,2,0.0,1.3,0.0,1,0,0,0,0,0,0,0,0
""")
ROOM = "0.1,0.8,0.2,1,0,0,0"
programs = []


def twin(kind, name, *options):
    program = Program(BIN / f"prosector-{kind}-twin", "--script", OUT / "motion.csv", "--link", OUT / name, "--loop", *options)
    program.wait("/dev/pts/")
    programs.append(program)


def config(name, tracker):
    file = OUT / f"{name}.toml"
    file.write_text(f"""[tracker]
address = "fastrak:{OUT}/{tracker}"
hemisphere = [0, 0, -1]
room.position = [0.1, 0.8, 0.2]

[tracker.stations]
right.station = 2

[glove.right]
address = "5dt-usb:{OUT}/glove"
open = [800, 800, 800, 800, 800]
closed = [1300, 1300, 1300, 1300, 1300]
""")
    return file


def selftest(name, *words):
    program = Program(BIN / "prosector-client", "selftest", *words, "--seconds", "2.5", "--out", OUT / f"{name}.txt")
    programs.append(program)
    return program


def unfit(report):
    """What doesn't fit, but for what a busy machine does to twins and stamps."""
    return [line for line in report.splitlines() if line.startswith("DOES NOT FIT") and "are missing" not in line and "jumps" not in line]


def ended(program, name):
    """Its exit code, and its report."""
    code = program.ended(30)
    report = (OUT / f"{name}.txt").read_text()
    print(report)
    check("its exit code says whether all fits", code == (1 if "DOES NOT FIT" in report else 0))
    return unfit(report), report


try:
    twin("fastrak", "good", "--room-device", ROOM)
    twin("fastrak", "spoilt", "--room-device", ROOM, "--garbage", "0.3")
    twin("5dt", "glove", "--hid")
    good, spoilt = config("good", "good"), config("spoilt", "spoilt")
    runs = {"tracker": selftest("tracker", "--config", good), "noise": selftest("noise", "tracker", "--config", spoilt),
            "glove": selftest("glove", "glove.right", "--config", good)}
    faults, report = ended(runs["tracker"], "tracker")
    check("a tracker that does as it should fits", not faults)
    check("the first device that the configuration names is meant", f"fastrak:{OUT}/good" in report)
    rows = (OUT / "tracker.csv").read_text().splitlines()
    columns = rows[0].split(",")
    samples = [dict(zip(columns, row.split(","))) for row in rows[1:]]
    check("its one receiver alone is asked for", samples and {s["station"] for s in samples} == {"2"})
    heights = [float(s["y"]) for s in samples]
    check("and stands in the room as the configuration says", 1.09 < min(heights) < 1.15 and 1.25 < max(heights) < 1.31)
    faults, report = ended(runs["noise"], "noise")
    check("a spoilt line doesn't fit, and that is said", any("invalid data skipped" in line for line in faults))
    faults, report = ended(runs["glove"], "glove")
    check("a glove fits, by the table that names it", not faults and f"5dt-usb:{OUT}/glove" in report)
    rows = (OUT / "glove.csv").read_text().splitlines()
    thumb = rows[0].split(",").index("thumb")
    bends = [float(row.split(",")[thumb]) for row in rows[1:]]
    check("its bends are mapped by the configuration's counts", min(bends) < 0.1 and max(bends) > 0.9)
    for words, says in ((["glove.left", "--config", good], "configures no glove.left"), (["tracker"], "is not a device"),
                        (["--config", OUT / "nowhere.toml"], "nowhere.toml")):
        run = subprocess.run([BIN / "prosector-client", "selftest", *words], capture_output=True, text=True, timeout=20, cwd=OUT)
        check(f"{' '.join(map(str, words[:1]))}: refused in words", run.returncode != 0 and says in run.stderr + run.stdout)
finally:
    for program in programs:
        program.end(signal.SIGKILL)
finish()
