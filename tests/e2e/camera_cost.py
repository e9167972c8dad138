#!/usr/bin/python3
"""camera_cost.py BIN OUT [SECONDS [QUALITY]]: what two bare hands, a tablet and see-through cost a client, in CPU of its process and of each
thread, beside a session that runs on: with more and more of it. The camera is a film, as painting pictures costs more than all that is measured.
Leaves OUT/cost.json. Needs a display, the networks that find hands and the CT (deploy/fetch_models.sh, deploy/fetch_anatomy.sh)."""
import collections
import csv
import json
import os
import pathlib
import shutil
import signal
import sys
import time

import numpy

from anatomy import ON_LIVER
from program import Program
from tablet_scene import FLAT, OPEN, POINT, TABLE, TABLET, Scene, about, looking, wrist_for

HERE = pathlib.Path(__file__).parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SECONDS = float(sys.argv[3]) if len(sys.argv) > 3 else 15
QUALITY = sys.argv[4] if len(sys.argv) > 4 else "low"
FILM = 8  # s
SETTLED = 3  # s that don't count
ROOM = HERE.parent.parent / "deploy/scenes/touch.toml"
TICKS = os.sysconf("SC_CLK_TCK")


def film():
    """A user at the table, filmed: the right hand presses the liver, the left one goes to and fro beside it, the tablet trembles."""
    scene = Scene(OUT, rate=30)
    top, flat = numpy.add(ON_LIVER, (0.05, 0, 0)), about((1, 0, 0), -0.25)
    press = wrist_for(top, flat, 0.1)
    for at, up in ((0, 0.05), (2, -0.02), (4, 0.05), (6, -0.02)):
        scene.hold(at, press + (0, up, 0), flat, OPEN)
    config = scene.write(FILM)
    left = numpy.array([-0.22, 1.0, 0.14])
    rows = [[t, *(left + (x, 0, 0)), 1, 0, 0, 0, *bends] for t, x, bends in ((0, 0, OPEN), (2, 0.01, POINT), (4, 0, OPEN), (6, -0.01, POINT), (8, 0, OPEN))]
    (OUT / "left.csv").write_text("time,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little\n" + "\n".join(",".join(f"{x:.6g}" for x in row) for row in rows) + "\n")
    with open(OUT / "scene.toml", "a") as file:
        file.write('[[hand]]\nleft = true\nmotion = "left.csv"\nloop = true\n')
    clip = OUT / "film.avi"
    if not clip.exists():
        Program(BIN / "prosector-client", "camera", "record", f"synthetic:{OUT}/scene.toml", "--out", clip, "--seconds", FILM).ended(600)
    text = config.read_text().replace(scene.address, f"hands:{clip}").replace("[tracker]\n", '[tracker]\nlens = "film.toml"\n')
    text = text.split("[tracker.stations]")[0]
    tablet = "[tracker.stations]\ntablet.station = 3\n"
    (OUT / "hands.toml").write_text(text)
    (OUT / "tablet.toml").write_text(text + tablet)
    (OUT / "lite.toml").write_text(text.replace("[tracker]\n", '[tracker]\nhand_networks = "lite"\n') + tablet)


def threads(pid):
    """CPU seconds of each thread, by its number; and their names."""
    spent, names = {}, {}
    for task in pathlib.Path(f"/proc/{pid}/task").iterdir():
        try:
            name, rest = task.joinpath("stat").read_text().split(") ")
        except OSError:  # it has ended
            continue
        fields = rest.split()
        spent[task.name] = (int(fields[11]) + int(fields[12])) / TICKS
        names[task.name] = name.split("(", 1)[1]
    return spent, names


def measure(name, config, *display):
    session = f"cost{os.getpid()}"
    programs = []
    try:
        server = Program(BIN / "prosector-server", ROOM, "--session", session, "--cache", OUT / "cache", "--threads", "1", "--summary", OUT / "server.json")
        programs.append(server)
        server.wait("is open", seconds=120)
        client = Program(BIN / "prosector-client", "join", "--name", "user", "--session", session, "--config", OUT / f"{config}.toml", "--size", "640x480",
                         "--quality", QUALITY, "--no-overlay", "--latency-log", OUT / "sent.csv", "--summary", OUT / "user.json", *display)
        programs.append(client)
        client.wait("everything is here")
        client.wait("streaming")
        time.sleep(SETTLED)
        (before, _), begin = threads(client.process.pid), time.monotonic()
        others, _ = threads(server.process.pid)
        time.sleep(SECONDS)
        (after, names), lasted = threads(client.process.pid), time.monotonic() - begin
        now, _ = threads(server.process.pid)
        end = time.monotonic_ns()
        client.end(signal.SIGINT)
        server.end(signal.SIGINT)
    finally:
        for program in programs:
            program.end(signal.SIGKILL)
    by_name = collections.Counter()
    for task, spent in after.items():
        by_name[names[task]] += (spent - before.get(task, 0)) / lasted
    with open(OUT / "sent.csv", newline="") as stream:
        seen = {int(row["seen_ns"]) for row in csv.DictReader(stream) if end - int(row["sent_ns"]) < 1e9 * SECONDS}
    pictures = 0
    if "--frame-log" in display:
        with open(OUT / "drawn.csv", newline="") as stream:
            pictures = sum(end - int(row["drawn_ns"]) < 1e9 * SECONDS for row in csv.DictReader(stream)) / SECONDS
    row = {"what": name, "cores": sum(by_name.values()), "hands_a_second": len(seen) / SECONDS, "pictures_a_second": pictures,
           "server_cores": (sum(now.values()) - sum(others.values())) / lasted, "pace": json.loads((OUT / "server.json").read_text())["real_time_factor"],
           "threads": {key: value for key, value in by_name.most_common() if value > 0.005}}
    print(f"{name:28} {row['cores']:.2f} cores, {row['hands_a_second']:.1f} hands a second, {row['pictures_a_second']:.1f} pictures a second; server "
          f"{row['server_cores']:.2f} cores, x{row['pace']:.2f}; " + ", ".join(f"{key} {value:.2f}" for key, value in row["threads"].items()))
    return row


OUT.mkdir(parents=True, exist_ok=True)
film()
see = ("--display", "ar", "--frame-log", OUT / "drawn.csv")
plain = ("--fps", "10", "--effect", "shadows=off", "--effect", "edges=off")
rows = [measure("two bare hands", "hands", "--display", "none"), measure("and the tablet", "tablet", "--display", "none"), measure("and see-through", "tablet", *see),
        measure("10 pictures, no shadows", "tablet", *see, *plain), measure("and lite networks", "lite", *see, *plain)]
model = [line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
(OUT / "cost.json").write_text(json.dumps({"machine": f"{model[0]}, {len(model)} cores; load average {os.getloadavg()[0]:.1f}", "quality": QUALITY, "rows": rows}, indent=2) + "\n")
