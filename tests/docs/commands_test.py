#!/usr/bin/python3
"""commands_test.py BIN WORK: runs the commands of docs/do and docs/learn as a reader would.

Each page gets a folder of its own that looks like a clone: `deploy` and `build/release/bin` lead to the real ones. Its blocks
fenced as sh run in order, each by a shell of its own that ends at the first command that fails; what a block leaves in the
background is ended with it. A block after `<!-- not run: REASON -->` is not run: its syntax is checked, and that each program
that it names exists. Network stays at the product's default, this machine alone.
"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"(?:<!-- not run: (?P<why>[^\n]+?) -->\n)?```sh\n(?P<text>.*?)```", re.DOTALL)
BLOCK_SECONDS = 60


def blocks(page):
    """(line number, reason for not running or None, text) of each block."""
    text = page.read_text()
    return [(text.count("\n", 0, found.start("text")), found["why"], found["text"]) for found in BLOCK.finditer(text)]


def clone(folder, bin_folder):
    folder.mkdir(parents=True)
    (folder / "deploy").symlink_to(ROOT / "deploy")
    (folder / "build" / "release").mkdir(parents=True)
    (folder / "build" / "release" / "bin").symlink_to(bin_folder)


def end_group(shell):
    """Ends the shell, and what it left running in its process group, kindly first."""
    for kind, patience in ((signal.SIGTERM, 5), (signal.SIGKILL, 5)):
        until = time.monotonic() + patience
        while time.monotonic() < until:
            shell.poll()
            try:
                os.killpg(shell.pid, kind)
            except ProcessLookupError:
                return
            time.sleep(0.05)


def run(text, folder, environment, seconds):
    """What went wrong, or None."""
    log = folder / "log"
    with log.open("w") as out:
        shell = subprocess.Popen(["bash", "-euo", "pipefail", "-c", text], cwd=folder, env=environment, stdout=out,
                                 stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, start_new_session=True)
        try:
            status = shell.wait(seconds)
            fault = f"exit status {status}" if status else None
        except subprocess.TimeoutExpired:
            fault = f"not done after {seconds} s"
        end_group(shell)
    return fault and f"{fault}\n{log.read_text()[-2000:]}"


def check_unrun(text, bin_folder):
    """What is wrong with a block that is not run, or None."""
    syntax = subprocess.run(["bash", "-n", "-c", text], capture_output=True, text=True)
    if syntax.returncode:
        return syntax.stderr
    for word in re.findall(r"^(?:build/release/bin/)?(deploy/[\w./]+\.(?:sh|py)|prosector-[\w-]+)", text, re.MULTILINE):
        if not ((ROOT if word.startswith("deploy/") else bin_folder) / word).exists():
            return f"there is no {word}"
    return None


def check_page(page, folder, bin_folder, environment, seconds=BLOCK_SECONDS):
    """(faults, how many blocks ran, how many did not)."""
    faults, ran, unrun = [], 0, 0
    clone(folder, bin_folder)
    for line, why, text in blocks(page):
        if why:
            unrun += 1
            fault = check_unrun(text, bin_folder)
            print(f"not run  {page.name}:{line}: {why}")
        else:
            ran += 1
            begun = time.monotonic()
            fault = run(text, folder, environment, seconds)
            print(f"{'FAILED' if fault else 'ran'}  {page.name}:{line} in {time.monotonic() - begun:.1f} s", flush=True)
        if fault:
            faults.append(f"{page.name}:{line}: {fault}")
    return faults, ran, unrun


def check_the_check(work, bin_folder, environment):
    """Pages with a fault each, which has to be found."""
    for number, (text, ran, unrun) in enumerate([
            ("```sh\nfalse\ntrue\n```\n", 1, 0), ("```sh\nsleep 9\n```\n", 1, 0),
            ("<!-- not run: x -->\n```sh\nif\n```\n", 0, 1), ("<!-- not run: x -->\n```sh\ndeploy/nothing.sh\n```\n", 0, 1)]):
        page = work / f"bad{number}.md"
        page.write_text(text)
        if [len(part) if isinstance(part, list) else part for part in
                check_page(page, work / f"bad{number}", bin_folder, environment, seconds=0.3)] != [1, ran, unrun]:
            sys.exit(f"a fault was not found in:\n{text}")


def main():
    bin_folder, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    environment = {"HOME": str(work / "home"), "PATH": f"{bin_folder}:/usr/bin:/bin", "LP_NUM_THREADS": "1"}
    (work / "home").mkdir()
    check_the_check(work, bin_folder, environment)
    print("faults are found; now the pages")
    faults, ran, unrun = [], 0, 0
    for page in sorted(page for shelf in ("do", "learn") for page in (ROOT / "docs" / shelf).glob("*.md")):
        of_page = check_page(page, work / page.parent.name / page.stem, bin_folder, environment)
        faults, ran, unrun = faults + of_page[0], ran + of_page[1], unrun + of_page[2]
    for fault in faults:
        print(f"\nFAILED {fault}", file=sys.stderr)
    print(f"{ran} blocks run, {unrun} not run, {len(faults)} failed")
    if ran < 8:
        sys.exit(f"only {ran} blocks were found to run: does this still know how they are fenced?")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
