#!/usr/bin/python3
"""desk_person_test.py OUT: a test that fails prints what its programs printed, and does not wait for a program that has exited."""
import contextlib
import io
import pathlib
import sys
import time

from checks import check, finish
from desk_person import Processes, wait_until, window_of

OUT = pathlib.Path(sys.argv[1])
printed = io.StringIO()
why, begun = "", time.monotonic()
with contextlib.redirect_stdout(printed):
    try:
        with Processes(OUT) as processes:
            processes.start("server.log", "sleep", 100)
            client = processes.start("client.log", "sh", "-c", "seq -f 'line %g' 60; exit 3")
            window_of(client, "Prosector: no such session", seconds=20)
    except AssertionError as error:
        why = str(error)
lines = printed.getvalue().splitlines()
check("a wait for the window of a program that has exited fails at once", time.monotonic() - begun < 10)
check(f"it says why: {why}", why == "the window: the program ended with exit status 3")
check("the end of the program's log is printed with its exit status",
      lines[-41:] == ["--- client.log, exit status 3; its last 40 lines:", *(f"line {n}" for n in range(21, 61))])
check("other programs are listed, too", lines[0] == "--- server.log, running; its last 0 lines:")

with contextlib.redirect_stdout(io.StringIO()) as printed, Processes(OUT) as processes:
    ended = processes.start("client.log", "sh", "-c", "echo done")
    ended.wait(20)
    found = wait_until("a line of a program that has exited", lambda: processes.says("client.log", "done"), process=ended)
check("what a program wrote before it exited counts", found)
check("a test that passes prints no logs", printed.getvalue() == "")
finish()
