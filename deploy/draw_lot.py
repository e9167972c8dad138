#!/usr/bin/python3
"""draw_lot.py SEED [--comments N] [--messages N] [--sentences N]: texts to be judged by a reader who has not seen the code.

Draws comments of public declarations (/// in headers of the product), messages (string literals of the product with at least
five words) and sentences of docs (without decisions), each uniformly by a random generator with this seed. The reader
explains each text from the text alone; a text that the reader cannot explain, or explains otherwise than the code does, is
rewritten. A reader needs no more than the printed text.
"""

import argparse
import importlib.util
import pathlib
import random
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent


def load(name):
    spec = importlib.util.spec_from_file_location(name, ROOT / "deploy" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def tracked(pattern):
    listed = subprocess.run(["git", "ls-files", *pattern], cwd=ROOT, capture_output=True, text=True, check=True)
    return [name for name in listed.stdout.split() if not name.startswith("tests/")]


def comments(checker):
    """(place, comment, declaration) of each /// comment of a header."""
    for name in tracked(["*.h"]):
        for number, kind, text, below in checker.blocks((ROOT / name).read_text().splitlines()):
            if kind == "///":
                yield f"{name}:{number}", " ".join(text.split()), below


def messages():
    """(place, text, "") of each string literal of at least five words, adjacent literals joined; without SQL statements."""
    sql = re.compile(r"\s*(?:CREATE|SELECT|INSERT|UPDATE|DELETE|REPLACE|ALTER|PRAGMA|BEGIN) ")
    literal = re.compile(r'"((?:\\.|[^"\\\n])*)"')
    for name in tracked(["*.cpp"]):
        text = re.sub(r"^\s*(//|#).*$", "", (ROOT / name).read_text(), flags=re.M)
        for found in re.finditer(r'(?:"(?:\\.|[^"\\\n])*"\s*)+', text):
            joined = "".join(part[1] for part in literal.finditer(found[0]))
            if len(re.findall(r"[A-Za-z]{2,}", joined)) >= 5 and not sql.match(joined):
                yield f"{name}:{text[: found.start()].count(chr(10)) + 1}", joined, ""


def sentences():
    for name in tracked(["docs/*.md", "README.md"]):
        if "docs/decisions/" in name or "docs/changes/" in name:
            continue
        prose = re.sub(r"```.*?```|<!--.*?-->", "", (ROOT / name).read_text(), flags=re.S)
        for paragraph in re.split(r"\n\s*\n", prose):
            if paragraph.lstrip().startswith(("|", "#", "```")):
                continue
            for sentence in re.split(r"(?<=[.!?])\s+(?=[A-Z`*])|\n- ", paragraph):
                sentence = " ".join(sentence.split()).removeprefix("- ")
                if len(sentence.split()) >= 5:
                    yield name, sentence, ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int)
    parser.add_argument("--comments", type=int, default=100)
    parser.add_argument("--messages", type=int, default=60)
    parser.add_argument("--sentences", type=int, default=40)
    options = parser.parse_args()
    checker = load("check_comments")
    for kind, texts, count in (("comment", comments(checker), options.comments), ("message", messages(), options.messages),
                               ("sentence", sentences(), options.sentences)):
        drawn = random.Random(f"{options.seed} {kind}").sample(sorted(texts), count)
        for number, (place, text, below) in enumerate(drawn, 1):
            print(f"{kind} {number} [{place}]\n  {text}" + (f"\n  of: {below}" if below else "") + "\n")


if __name__ == "__main__":
    main()
