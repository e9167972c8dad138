#!/usr/bin/env python3
"""check_comments.py [FOLDER]...: what a reader of our C++ comments would stumble over,
in the folders held to it, or in FOLDERs.

In headers: a function's /// comment begins with a verb in the third person (Returns, Makes, Tells whether); no sentence is
longer than 30 words. In headers and .cpp files: no comment begins with "Of", "From" or "To", says "likewise" or "part of it",
or is "the same" alone. A FOLDER may be a file.
"""

import pathlib
import re
import subprocess
import sys

MOST_WORDS = 30

# Held to the rules. A folder holds those below it; FOLDER/* holds its own files only.
HELD = ("client", "common", "drivers", "idl", "server/calibration", "server/physics/*", "server/physics/contact",
        "server/physics/hands", "server/physics/panel", "server/physics/parts", "server/physics/rigid", "server/session")
# Not yet: empty when all are held. Tests aren't meant to be.
NOT_YET = ("server/physics/collision", "server/physics/coupled", "server/physics/cutting", "server/physics/organs",
           "server/physics/soft")

# Capitalised words on s that begin sentences and are no verbs of functions.
NO_VERBS = {
    "Always", "As", "Axes", "Bits", "Bounds", "Bytes", "Contacts", "Corners", "Edges", "Faces", "Figures", "Forces",
    "Hands", "Headers", "Indices", "Islands", "Its", "Lines", "Metres", "Milliseconds", "Nanoseconds",
    "Newtons", "Nodes", "Numbers", "Pairs", "Parts", "Points", "Seconds", "Segments", "Sides", "Slots",
    "This", "Times", "Triangles", "Tubes", "Us", "Values", "Velocities", "Vertices", "Voxels", "Weights", "Words",
    "Zeros",
}
ANYWHERE = (
    (re.compile(r"\b[Ll]ikewise\b"), "says likewise: name it"),
    (re.compile(r"\bpart of it\b"), "says part of it: name the whole"),
    (re.compile(r"^(Of|From|To) "), "begins with Of, From or To"),
    (re.compile(r"^[Tt]he same[.;]?$"), "is the same alone: name it"),
)
NO_FUNCTION = re.compile(r"^(struct|class|enum|union|using|namespace|friend|concept|#|public:|private:|protected:)")


def blocks(lines):
    """(first line number, kind, text, what follows) of each comment: /// or // lines in a row, or one after code."""
    number = 0
    while number < len(lines):
        stripped = lines[number].strip()
        found = re.match(r"(///?)(?!/)", stripped)
        if not found:
            trailing = code_and_comment(lines[number])[1]
            if trailing:
                yield number + 1, "trailing", trailing, ""
            number += 1
            continue
        kind, first, texts = found[1], number, []
        while number < len(lines) and re.match(re.escape(kind) + r"(?!/)", lines[number].strip()):
            texts.append(lines[number].strip()[len(kind):])
            number += 1
        yield first + 1, kind, "\n".join(texts), declaration(lines, number)


def code_and_comment(line):
    """A line without and with only its trailing // comment; strings are left alone."""
    quote, k = "", 0
    while k < len(line):
        c = line[k]
        if quote:
            if c == "\\":
                k += 1
            elif c == quote:
                quote = ""
        elif c == '"' or (c == "'" and not (k and line[k - 1].isdigit())):
            quote = c
        elif line.startswith("//", k):
            return line[:k], line[k:].lstrip("/<").strip()
        k += 1
    return line, ""


def declaration(lines, number):
    """What a comment that ends before lines[number] stands over, up to its ; or {."""
    text = ""
    while number < len(lines) and lines[number].strip() and len(text) < 600:
        text += " " + code_and_comment(lines[number])[0].strip()
        if re.search(r"[;{]", text):
            break
        number += 1
    return text.strip()


def without_templates(text):
    text = re.sub(r"\boperator\s*(\(\)|[^\s\w(]+)", "operator_", text)
    while True:
        shorter = re.sub(r"<[^<>]*>", "", text)
        if shorter == text:
            return re.sub(r"^(template\s*|requires\s+[^(]*?(\|\|[^(]*)*\s)+", "", text.strip())
        text = shorter


def is_function(text):
    text = re.sub(r"\[\[\w+\]\]\s*", "", without_templates(text))
    return not NO_FUNCTION.match(text) and bool(re.match(r"[^={;]*\w\s*\(", text))


def sentences(text):
    """The sentences of a comment's text. A line that is set in is an item of its own; an empty line ends a paragraph."""
    paragraphs = re.split(r"\n\s*\n|\n(?= {2,}| ?- )|\n(?= ?\d+\. )", text)
    for paragraph in paragraphs:
        paragraph = re.sub(r"`[^`]*`", "Code", " ".join(paragraph.split()))
        yield from re.split(r"(?<=[.!?])[)\"”]?\s+(?=[^a-z\s])", paragraph)


def words_of(sentence):
    return [word for word in sentence.split() if re.search(r"\w", word)]


def faults(file):
    """(line number, rule) of each fault of a file."""
    for number, kind, text, below in blocks(file.read_text().splitlines()):
        flat = " ".join(text.split()).lstrip("-< ")
        for rule, why in ANYWHERE:
            if rule.search(flat):
                yield number, f"{why}: {flat[:70]}"
        if file.suffix != ".h":
            continue
        first = re.match(r"[\w`']*", flat)[0]
        if kind == "///" and is_function(below) and (not re.fullmatch(r"[A-Z][a-z]+s", first) or first in NO_VERBS):
            yield number, f"a function's comment begins with a verb (Returns, Makes, Tells whether): {flat[:70]}"
        for sentence in sentences(text):
            if len(words_of(sentence)) > MOST_WORDS:
                yield number, f"{len(words_of(sentence))} words: {sentence[:70]}…"


def holds(folder, name):
    """Whether the file `name` is FOLDER, lies below it, or, where it ends in /*, lies in it."""
    if folder.endswith("/*"):
        return str(pathlib.PurePosixPath(name).parent) == folder[:-2]
    return name == folder or name.startswith(folder.rstrip("/") + "/")


def files_of(root, folders):
    """The C++ files of the tree that `folders` hold."""
    names = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.h", "*.cpp"], cwd=root,
                           check=True, capture_output=True, text=True).stdout.splitlines()
    return [root / name for name in names if any(holds(folder, name) for folder in folders) and (root / name).exists()]


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    files = files_of(root, sys.argv[1:] or HELD)
    found = 0
    for file in files:
        for number, why in faults(file):
            print(f"{file.relative_to(root)}:{number}: {why}", file=sys.stderr)
            found += 1
    waiting = "" if not NOT_YET or sys.argv[1:] else f"; not held yet: {', '.join(NOT_YET)}"
    print(f"comments: {found} faults" if found else f"comments: {len(files)} files good{waiting}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
