#!/usr/bin/python3
"""check_comments.py [--root ROOT] [FOLDER]...: what a reader of our C++ comments would stumble over,
in the folders held to it, or in FOLDERs (or files).

A function's /// comment begins with a verb in the third person (Returns, Computes, Reports whether). No sentence is longer than
30 words. No comment begins with "Of", "From" or "To", says "likewise" or "part of it", or is "the same" alone. Each C++
file but those of tests is held, or waits in NOT_YET.

A comment with a word of UNPLAIN, or that begins with "What" or "Who", is a fault. A run without FOLDERs prints their number and its
bound, 0. --unplain lists them.
"""

import pathlib
import re
import sys

MOST_WORDS = 30

# Held to the rules. A folder holds those below it; FOLDER/* holds its own files only.
HELD = ("client", "common", "deploy", "drivers", "idl", "server", "twins")
# Not yet held.
NOT_YET = ()

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
# Words for which docs/understand/glossary.md or common technical English has a plainer one.
UNPLAIN = re.compile(
    r"\b(anew|mends?|mended|tells?|told|dear|who|whoever|whom|beside|at once|by itself|by themselves|of its own|of their own|"
    r"lets? go|takes? hold|to be had|so much|happenings?)\b|^(What|Who)\b", re.I)
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
        first = re.match(r"[\w`']*", flat)[0]
        if kind == "///" and is_function(below) and (not re.fullmatch(r"[A-Z][a-z]+s", first) or first in NO_VERBS):
            yield number, f"a function's comment begins with a verb (Returns, Computes, Reports whether): {flat[:70]}"
        for sentence in sentences(text):
            if len(words_of(sentence)) > MOST_WORDS:
                yield number, f"{len(words_of(sentence))} words: {sentence[:70]}…"


def unplain(file):
    """(line number, word, text) of each comment that is counted as unplain."""
    for number, _, text, _ in blocks(file.read_text().splitlines()):
        flat = re.sub(r"`[^`]*`", "", " ".join(text.split()).lstrip("-< "))
        found = UNPLAIN.search(flat)
        if found:
            yield number, found[0], flat


def holds(folder, name):
    """Whether the file `name` is FOLDER, lies below it, or, where it ends in /*, lies in it."""
    if folder.endswith("/*"):
        return str(pathlib.PurePosixPath(name).parent) == folder[:-2]
    return name == folder or name.startswith(folder.rstrip("/") + "/")


def sources(root):
    """The names of the tree's C++ files, from its root; without those of builds and of git."""
    tops = [top for top in sorted(root.iterdir()) if top.is_dir() and top.name != "build" and top.name[0] != "."]
    return [str(file.relative_to(root)) for top in tops for file in sorted(top.rglob("*")) if file.suffix in (".h", ".cpp")]


def main():
    own = pathlib.Path(__file__).resolve().parent.parent
    words, root = sys.argv[1:], own
    if words[:1] == ["--root"]:
        root, words = pathlib.Path(words[1]).resolve(), words[2:]
    names = sources(root)
    if words[:1] == ["--unplain"]:
        for name in names:
            if any(holds(folder, name) for folder in words[1:]):
                for number, word, text in unplain(root / name):
                    print(f"{name}:{number}: {word}: {text[:120]}")
        return 0
    held = [name for name in names if any(holds(folder, name) for folder in words or HELD)]
    found = [(name, number, why) for name in held for number, why in faults(root / name)]
    if not words:
        found += [(name, 1, "is neither held nor waiting: name its folder in deploy/check_comments.py") for name in names
                  if not any(holds(folder, name) for folder in (*HELD, *NOT_YET, "tests"))]
    plain = [(name, number, f"unplain word {word}: {text[:70]}") for name in held for number, word, text in unplain(root / name)]
    print(f"comments with unplain words: {len(plain)} (bound 0)")
    found += plain
    for name, number, why in found:
        print(f"{name}:{number}: {why}", file=sys.stderr)
    waiting = f"; not held yet: {', '.join(NOT_YET)}" if NOT_YET and not words else ""
    print(f"comments: {len(found)} faults" if found else f"comments: {len(held)} files good{waiting}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
