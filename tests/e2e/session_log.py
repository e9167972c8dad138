"""What a client's --session-log tells while it runs."""
import json
import time


class SessionLog:
    def __init__(self, file):
        self.file = file

    def lines(self):
        if not self.file.exists():
            return
        for line in open(self.file):
            try:
                yield json.loads(line)
            except json.JSONDecodeError:
                return

    def pushes(self, who):
        """Of a hand ("NAME, right"), down on the tissue, N, as each line has it."""
        return [-touch["force"][1] for line in self.lines() for user, touch in line["touches"].items() if user == who]

    @staticmethod
    def wait(holds, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if holds():
                return True
            time.sleep(0.1)
        return False
