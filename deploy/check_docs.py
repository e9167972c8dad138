#!/usr/bin/python3
"""check_docs.py [--sentences] [ROOT]: what a reader of README.md, CHANGELOG.md and docs/ would stumble over.

Seven rules: no sentence is longer than 30 words; each relative link leads to a file and an anchor that exist; each page of
docs/ is linked from docs/README.md or from the README.md of its own folder; each table has a heading row and a separator
row; each page that a source names, and each source that a page names in `backticks` by a path from the root or from
server/physics, is there; each file of docs/pictures is shown
by a page, and deploy/renew_pictures.py names its producer. Tables, code and headings are free of the first rule, docs/decisions of the first and the last.
NAME in a path stands for any name.
Lengths are bounded, too: README.md, the pages of docs/understand, and all of docs/ together. Each bound is printed with its figure.
--sentences prints how many long sentences each page has, and the words of the longest, and checks nothing.
"""

import pathlib
import re
import sys

import renew_pictures

MOST_WORDS = 30
MOST_OF_README, MOST_OF_UNDERSTAND, MOST_OF_ALL = 950, 2400, 81000  # words; a bar of a table is none
SOURCES = ("client", "common", "deploy", "drivers", "idl", "server", "shaders", "tests", "twins")
PATH = re.compile(r"`((?:[\w.-]+/)+[\w-]+\.(?:h|cpp|idl|glsl|frag|vert|py|sh|toml|txt|xml|csv))`")
LINK = re.compile(r"!?\[([^\]]*)\]\(([^)\s]+)\)")


def without_fences(text):
    """The lines, those of fenced code and of comments empty, so that line numbers stay."""
    lines, fenced, comment = [], False, False
    for line in text.splitlines():
        if line.lstrip().startswith("```"):
            fenced = not fenced
            lines.append("")
        elif fenced:
            lines.append("")
        else:
            comment = comment or line.lstrip().startswith("<!--")
            lines.append("" if comment else line)
            comment = comment and "-->" not in line
    return lines


def paragraphs(text):
    """(line number, text) of each paragraph and list item, without headings and tables."""
    found, start, words = [], 0, []

    def end():
        if words:
            found.append((start, " ".join(words)))
        words.clear()

    for number, line in enumerate(without_fences(text), 1):
        stripped = line.strip()
        item = re.match(r"([-*+]|\d+\.) ", stripped)
        if not stripped or stripped[0] in "#|" or item:
            end()
        if not stripped or stripped[0] in "#|":
            continue
        if not words:
            start = number
        words.append(stripped[item.end():] if item else stripped)
    end()
    return found


def sentences(paragraph):
    text = LINK.sub(lambda link: "" if link[0].startswith("!") else link[1], paragraph)
    text = re.sub(r"`[^`]*`", "Code", text)
    text = re.sub(r"\*+|(?<!\w)_|_(?!\w)", "", text)
    return re.split(r"(?<=[.!?])[)\"”]?\s+(?=[^a-z\s])", text)


def words_of(sentence):
    return [word for word in sentence.split() if re.search(r"\w", word)]


def long_sentences(page):
    for line, paragraph in paragraphs(page.read_text()):
        for sentence in sentences(paragraph):
            if len(words_of(sentence)) > MOST_WORDS:
                yield line, len(words_of(sentence)), sentence


def anchors(page):
    """As GitHub makes them: lower case, spaces to hyphens, most punctuation gone, doubles numbered."""
    found = {}
    for line in without_fences(page.read_text()):
        heading = re.match(r"#{1,6}\s+(.*)", line)
        if heading:
            text = re.sub(r"[`*]", "", LINK.sub(r"\1", heading[1])).strip().lower()
            anchor = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
            found[anchor] = found.get(anchor, -1) + 1
    return {name if not n else f"{name}-{n}" for name, most in found.items() for n in range(most + 1)}


def links(page):
    """(line number, file, anchor) of each link that leads to a file of the tree."""
    for number, line in enumerate(without_fences(page.read_text()), 1):
        for link in LINK.finditer(re.sub(r"`[^`]*`", "", line)):
            if not re.match(r"[a-z]+:", link[2]):
                path, _, anchor = link[2].partition("#")
                yield number, (page.parent / path).resolve() if path else page, anchor


def dead_links(page):
    for line, target, anchor in links(page):
        if not target.exists():
            yield line, f"leads to {target}, which is not there"
        elif anchor and target.suffix == ".md" and anchor not in anchors(target):
            yield line, f"{target.name} has no heading for #{anchor}"


def lost_sources(page, root):
    for line, text in enumerate(without_fences(page.read_text()), 1):
        for path in PATH.findall(text):
            if "NAME" not in path and not any((root / base / path).exists() for base in (".", "server/physics")):
                yield line, f"names {path}, which is not there"


def headless_tables(page):
    """(line number, why) of each block of table rows whose second row doesn't separate a heading from the rest."""
    lines = ["", *without_fences(page.read_text()), ""]
    for number in range(1, len(lines) - 1):
        begins = lines[number].startswith("|") and not lines[number - 1].startswith("|")
        if begins and not re.fullmatch(r"\|(?:\s*:?-+:?\s*\|)+", lines[number + 1].strip()):
            yield number, "a table without a heading and a row of |---|: was it torn by an empty line?"


def unlisted(pages, docs):
    """Each page that neither docs/README.md nor the README.md of its own folder links to."""
    indexes = [page for page in pages if page.name == "README.md"]
    listed = {index: {target for _, target, _ in links(index)} for index in indexes}
    for page in pages:
        index_of_folder = page.parent / "README.md"
        if page != docs / "README.md" and not any(page in listed.get(index, ()) for index in (docs / "README.md", index_of_folder)):
            yield page


def dead_mentions(root):
    """(file, line number, why) of each page that a comment or string of a source names and that is not there."""
    for file in (file for folder in SOURCES for file in sorted((root / folder).rglob("*"))):
        if file.is_file() and root / "tests" / "docs" not in file.parents and file.suffix not in (".png", ".bin"):
            for number, line in enumerate(file.read_text(errors="ignore").splitlines(), 1):
                for page in re.findall(r"\bdocs/[\w/-]+\.md\b", line):
                    if not (root / page).exists():
                        yield file, number, f"names {page}, which is not there"


def unproduced(docs, pages):
    """(picture, why) of each file of docs/pictures that no page shows, or that nothing renews."""
    shown = {target for page in pages for _, target, _ in links(page)}
    for picture in sorted(file for file in (docs / "pictures").rglob("*") if file.is_file()):
        if picture not in shown:
            yield picture, 1, "no page shows this picture"
        if str(picture.relative_to(docs / "pictures")) not in renew_pictures.listed():
            yield picture, 1, "deploy/renew_pictures.py names no producer of this picture"


def length(page):
    return len(words_of(page.read_text()))


def too_long(root, docs, pages):
    """(page, why) of each page above its bound; prints the figures and their bounds."""
    understand = max((page for page in pages if page.parent == docs / "understand"), key=length)
    total = sum(length(page) for page in pages)
    figures = [(root / "README.md", length(root / "README.md"), MOST_OF_README), (understand, length(understand), MOST_OF_UNDERSTAND),
               (docs / "README.md", total, MOST_OF_ALL)]
    print(f"words, and the bound: README.md {figures[0][1]} ({MOST_OF_README}), the longest page of docs/understand {figures[1][1]} "
          f"({MOST_OF_UNDERSTAND}), all of docs {total} ({MOST_OF_ALL})")
    for page, count, most in figures:
        if count > most:
            yield page, 1, f"{count} words, at most {most} are allowed" + (" in all of docs" if count == total else "")


def main():
    words = [word for word in sys.argv[1:] if word != "--sentences"]
    root = pathlib.Path(words[0] if words else pathlib.Path(__file__).parent.parent).resolve()
    docs = root / "docs"
    fragments = docs / "changes"  # entries of the changelog: deploy/changelog.py
    pages = sorted(page for page in docs.rglob("*.md") if page.parent != fragments or page.name == "README.md")
    tops = [root / "README.md", root / "CHANGELOG.md"]
    prose = [*tops, *(page for page in pages if "decisions" not in page.relative_to(docs).parts)]
    if "--sentences" in sys.argv[1:]:
        for page in prose:
            found = [length for _, length, _ in long_sentences(page)]
            print(f"{len(found):4} {max(found, default=0):4}  {page.relative_to(root)}")
        return 0
    faults = []
    for page in prose:
        faults += [(page, line, f"{n} words: {text[:90]}…") for line, n, text in long_sentences(page)]
        if page.name != "CHANGELOG.md":
            faults += [(page, line, why) for line, why in lost_sources(page, root)]
    for page in [*tops, *pages]:
        faults += [(page, line, why) for line, why in dead_links(page)]
        faults += [(page, line, why) for line, why in headless_tables(page)]
    faults += [(page, 1, "no index lists this page: name it in docs/README.md") for page in unlisted(pages, docs)]
    faults += dead_mentions(root)
    if not words:
        faults += too_long(root, docs, pages)
        faults += unproduced(docs, [*tops, *pages])
    for page, line, why in faults:
        print(f"{page.relative_to(root)}:{line}: {why}", file=sys.stderr)
    print(f"docs: {len(faults)} faults" if faults else f"docs: {len(pages)} pages good")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
