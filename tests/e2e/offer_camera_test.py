#!/usr/bin/python3
"""offer_camera_test.py BIN OUT CAMERAS: a watcher offers a synthetic camera's pictures by OpenIGTLink. Another program looks at them as at a
camera of its own, and finds the board in them; both say what is wrong when it is."""
import os
import pathlib
import signal
import subprocess
import sys

from checks import check, failures
from program import ENV, Program

HERE = pathlib.Path(__file__).parent
BIN, OUT, CAMERAS = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
OUT.mkdir(parents=True, exist_ok=True)
CLIENT = BIN / "prosector-client"


def run(*words):
    return subprocess.run([CLIENT, *words], capture_output=True, text=True, timeout=60, env=ENV)


session = f"offercamera{os.getpid()}"
programs = []
try:
    programs.append(Program(BIN / "prosector-server", HERE / "arm.toml", "--session", session, "--cache", OUT / "cache"))
    programs[0].wait("is open")
    programs.append(Program(CLIENT, "observe", "--name", "Watcher", "--display", "none", "--session", session, "--publish", "igtl:127.0.0.1:0",
                            "--publish-camera", "--camera", f"synthetic:{CAMERAS / 'table.toml'}"))
    port = programs[1].wait("and camera images, by igtl at 127.0.0.1 port").split()[-1]
    seen = run("camera", "selftest", f"igtl://127.0.0.1:{port}/Camera", "--seconds", "3")
    check(f"the other program sees the camera's pictures:\n{seen.stdout}{seen.stderr}", "images of 640 × 480" in seen.stdout)
    check("and the board in them", "board table: detected in" in seen.stdout)
    bad = run("camera", "selftest", "igtl://127.0.0.1:1/Camera", "--seconds", "3")
    check(f"where nobody listens it says so: {bad.stderr}", bad.returncode != 0 and "127.0.0.1" in bad.stderr)
    bad = run("observe", "--display", "none", "--session", session, "--publish", "igtl:127.0.0.1:0", "--publish-camera")
    check(f"without a camera it says which option names one: {bad.stderr}", bad.returncode != 0 and "--publish-camera" in bad.stderr)
finally:
    for program in reversed(programs):
        program.end(signal.SIGKILL)
sys.exit("\n".join(failures) if failures else 0)
