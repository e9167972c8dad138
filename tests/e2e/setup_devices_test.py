#!/usr/bin/python3
"""setup_devices_test.py PROGRAMS OUT: a person with a simulated tracker and glove names both in the set-up window, sees them live, finds the
receiver of the right hand by moving it, and saves the configuration, whose comments stay."""

import os
import pathlib
import sys
import time

from checks import check, finish
from desk_person import Processes, wait_until
from setup_window import SetupWindow

PROGRAMS, OUT = map(pathlib.Path, sys.argv[1:3])

# The second receiver goes back and forth, and the fingers open and close.
MOTION = """time,station,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little
0,1,-0.1,1.2,0.2,1,0,0,0,0,0,0,0,0
1,1,-0.1,1.2,0.2,1,0,0,0,0.2,0.5,0.7,0.8,0.9
2,1,-0.1,1.2,0.2,1,0,0,0,0,0,0,0,0
0,2,0.0,1.3,0.0,1,0,0,0,0,0,0,0,0
1,2,0.3,1.4,0.0,0.995004,0.099833,0,0,0,0,0,0,0
2,2,0.0,1.3,0.0,1,0,0,0,0,0,0,0,0
"""

with Processes(OUT) as processes:
    os.environ["XDG_CONFIG_HOME"] = str(OUT / "config")
    os.environ["XDG_CACHE_HOME"] = str(OUT / "cache")
    (OUT / "motion.csv").write_text(MOTION)
    config = OUT / "client.toml"
    config.write_text(f'''# The laboratory's devices
[tracker]
address = "fastrak:{OUT}/tracker"  # on the shelf
hemisphere = [0.0, 0.0, -1.0]  # below the ceiling

[tracker.room]
position = [0, 0.8, 0]
''')
    room = "0,0.8,0,1,0,0,0"
    processes.start("tracker.log", PROGRAMS / "prosector-fastrak-twin", "--script", OUT / "motion.csv", "--link", OUT / "tracker", "--loop",
                    "--room-device", room)
    processes.start("glove.log", PROGRAMS / "prosector-5dt-twin", "--script", OUT / "motion.csv", "--link", OUT / "glove", "--loop")
    wait_until("the devices", lambda: (OUT / "tracker").exists() and (OUT / "glove").exists())
    (OUT / "scenes").mkdir()
    user = SetupWindow(processes, PROGRAMS, "Ada", "--config", config, "--scenes", OUT / "scenes")
    user.click("Checks")
    user.sees("check Pictures", 90)
    user.picture("setup-checks.png")
    user.click("Devices")
    user.click("glove.right.address")
    user.type(f"5dt:{OUT}/glove")
    user.sees("right glove")
    check("a glove that was named is there", True)
    user.click("tracker")
    user.sees("move right")
    user.click("move right")
    wait_until("the receiver that moves", lambda: user.words() == "Receiver 2 is assigned to the right hand.", 20)
    check("the right hand's receiver is found by moving it", True)
    time.sleep(3)
    user.picture("setup-devices.png")
    before = config.read_text()
    check("nothing is written yet", "glove" not in before)
    user.click("save")
    wait_until("the file", lambda: config.read_text() != before)
    after = config.read_text()
    check("comments and order stay", all(line in after for line in before.splitlines() if "#" in line)
          and after.startswith("# The laboratory's devices"))
    check("the glove is in it", f'address = "5dt:{OUT}/glove"' in after)
    check("and the receiver", "station = 2" in after)
    user.click("Tracker")
    user.sees("receiver 2 accurate")
    user.picture("setup-tracker.png")
    user.click("Glove")
    for gesture in ("fist", "flat"):
        user.sees(f"{gesture} made")
    for finger in ("thumb", "little"):
        user.sees(f"span {finger} good")
    check("a hand follows the glove, and its gestures are known", "hand" in user.read()["controls"])
    user.picture("setup-glove.png")
    user.end()
    check("it ends cleanly", user.process.returncode == 0)
finish()
