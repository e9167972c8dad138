"""Programs that a test starts, speaks to and waits for."""

import os
import signal
import subprocess
import sys
import threading
import time

ENV = {**os.environ, "LC_ALL": "C"}


class Program:
    """A program that is spoken to, and whose lines can be waited for."""

    def __init__(self, *words, env=None):
        self.lines = []
        self.process = subprocess.Popen([str(w) for w in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                        stdin=subprocess.PIPE, env={**ENV, **(env or {})})
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        for line in self.process.stdout:
            self.lines.append(line.rstrip("\n"))

    def say(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def wait(self, words, times=1, seconds=40):
        end = time.monotonic() + seconds
        while sum(words in line for line in list(self.lines)) < times:
            if time.monotonic() > end or self.process.poll() is not None:
                sys.exit(f"FAILED: no {times} x \"{words}\" in:\n" + "\n".join(self.lines))
            time.sleep(0.02)
        return [line for line in self.lines if words in line][-1]

    def end(self, how=signal.SIGTERM):
        if self.process.poll() is None:
            self.process.send_signal(how)
        self.process.wait(30)
