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
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        for line in self.process.stdout:
            self.lines.append(line.rstrip("\n"))

    def say(self, line):
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def wait(self, words, times=1, seconds=40):
        end = time.monotonic() + seconds
        over = False
        while sum(words in line for line in list(self.lines)) < times:
            if over or time.monotonic() > end:
                sys.exit(f"FAILED: no {times} x \"{words}\" in:\n" + "\n".join(self.lines))
            time.sleep(0.02)
            if self.process.poll() is not None:
                self.reader.join(10)  # what it said last counts
                over = True
        return [line for line in self.lines if words in line][-1]

    def ended(self, seconds):
        """Its exit code, once all that it said has been read."""
        code = self.process.wait(seconds)
        self.reader.join(10)
        return code

    def end(self, how=signal.SIGTERM):
        if self.process.poll() is None:
            self.process.send_signal(how)
        self.ended(30)
