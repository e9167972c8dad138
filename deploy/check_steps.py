#!/usr/bin/python3
"""check_steps.py BUILD: how many commands deploy/demo.sh runs to compile and link before its first picture.

BUILD is a build folder of Ninja. Prints the count and its bound, and fails above the bound.
"""

import pathlib
import re
import subprocess
import sys

MOST_STEPS = 150

demo = (pathlib.Path(__file__).resolve().parent / "demo.sh").read_text()
targets = re.search(r'build\.sh" release (.*)', demo)[1].split()
commands = subprocess.run(["ninja", "-C", sys.argv[1], "-t", "commands", *targets], capture_output=True, text=True, check=True).stdout
count = len(commands.splitlines())
print(f"build commands before the first picture: {count}, at most {MOST_STEPS}")
sys.exit(count > MOST_STEPS)
