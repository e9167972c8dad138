#!/usr/bin/python3
"""see_through_video.py BIN OUT [PICTURE]: a bare hand presses the liver that lies on a real table, as a user sees it through a camera that
goes to and fro. Films the synthetic camera of deploy/cameras/press.toml, lets it be the user's camera in a session, and makes an animated
picture of what the client recorded: PICTURE (default docs/pictures/see-through.webp). Needs the CT and the networks that find hands."""

import io
import pathlib
import signal
import subprocess
import sys
import time

from PIL import Image

from animated_picture import write_animation
from picture_files import jpegs_of

ROOT = pathlib.Path(__file__).resolve().parent.parent
BIN, OUT = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
PICTURE = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else ROOT / "docs/pictures/see-through.webp"
AROUND = 8  # s, after which the camera's way and the hand's begin anew
RATE, KEPT = 15, 10  # pictures a second: of the camera, and of what is made of it
SIZE = 480, 360  # pixels
CLIENT = f"""[tracker]
address = "hands:{OUT.resolve()}/film.avi"
lens = "film.toml"
[tracker.table]
board = "table"
position = [0, 0.9, 0.05]
orientation = [0.70710678, -0.70710678, 0, 0]
"""


def record():
    """Leaves what the user saw in OUT/seen.avi, two times around."""
    session = f"see-through-{time.time_ns()}"
    subprocess.run([BIN / "prosector-client", "camera", "record", f"synthetic:{ROOT}/deploy/cameras/press.toml", "--out", OUT / "film.avi",
                    "--seconds", str(AROUND)], check=True)
    (OUT / "client.toml").write_text(CLIENT)
    server = subprocess.Popen([BIN / "prosector-server", ROOT / "deploy/scenes/abdomen.toml", "--session", session])
    try:
        subprocess.run([BIN / "prosector-client", "join", "--name", "user", "--session", session, "--timeout", "180", "--config", OUT / "client.toml",
                        "--display", "ar:offscreen", "--size", "640x480", "--no-overlay", "--fps", str(RATE), "--record", OUT / "seen.avi",
                        "--seconds", str(2.5 * AROUND)], check=True)
    finally:
        server.send_signal(signal.SIGTERM)
        server.wait()


OUT.mkdir(parents=True, exist_ok=True)
record()
seen = [Image.open(io.BytesIO(jpeg)) for jpeg in jpegs_of(OUT / "seen.avi")]
write_animation([seen[len(seen) - AROUND * RATE + int(k * RATE / KEPT)] for k in range(AROUND * KEPT)], PICTURE, SIZE, KEPT)
