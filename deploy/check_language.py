#!/usr/bin/python3
"""Holds the client's translations to its sources.

Every text that the client's sources mark, by tr(...) or msg(...), must be in each client/language/*.po, in their
order, with a translation that has the same placeholders; nothing else may be. Texts of passing_texts.h must stand in
a source outside the client.

  deploy/check_language.py           says what differs
  deploy/check_language.py --update  brings the .po files in order; new texts wait there with an empty translation
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "client" / "language"
HEADER = """# The client's texts in another language. Made from the sources by deploy/check_language.py --update.
msgid ""
msgstr ""
"Language: {}\\n"
"MIME-Version: 1.0\\n"
"Content-Type: text/plain; charset=UTF-8\\n"
"Content-Transfer-Encoding: 8bit\\n"
"""


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t") + '"'


def unquoted(text):
    return re.sub(r"\\(.)", lambda m: {"n": "\n", "t": "\t"}.get(m[1], m[1]), text)


def entries_of(po):
    """Returns pairs of text and translation, without the header's."""
    out = []
    for block in re.findall(r'^msgid ((?:".*"\n)+)msgstr ((?:".*"(?:\n|$))+)', po, re.MULTILINE):
        out.append(tuple(unquoted("".join(re.findall(r'^"(.*)"$', part, re.MULTILINE))) for part in block))
    return [entry for entry in out if entry[0]]


def marked_texts():
    """Returns what the sources mark, each text once."""
    files = sorted(str(f.relative_to(ROOT)) for f in (ROOT / "client").rglob("*") if f.suffix in (".cpp", ".h"))
    made = subprocess.run(["xgettext", "--from-code=UTF-8", "--language=C++", "-k", "-ktr", "-kmsg", "--no-location",
                           "--no-wrap", "-f", "-", "-o", "-"], input="\n".join(files), capture_output=True, text=True,
                          cwd=ROOT, check=True)
    return [text for text, _ in entries_of(made.stdout)]


def placeholders(text):
    """Returns a text's placeholders of fmt, as pairs of argument and format."""
    out, plain = [], 0
    for found in re.finditer(r"\{\{|\}\}|\{(\d*)(:[^{}]*)?\}|[{}]", text):
        if found[0] in ("{{", "}}"):
            continue
        if found[1] is None:
            raise ValueError("a brace by itself")
        out.append((int(found[1]) if found[1] else plain, found[2] or ""))
        plain += 1
    if re.search(r"\{\d", text) and re.search(r"\{[:}]", text):
        raise ValueError("numbered and plain placeholders together")
    return sorted(set(out)) if re.search(r"\{\d", text) else sorted(out)


def troubles_of(texts, entries):
    """Returns what is wrong with a language's entries."""
    out = []
    if [text for text, _ in entries] != texts:
        known = [text for text, _ in entries]
        out += [f"lacks {quoted(t)}" for t in texts if t not in known]
        out += [f"has {quoted(t)}, which no source marks" for t in known if t not in texts]
        out = out or ["is not in the order of the sources"]
    for text, translation in entries:
        if not translation:
            out.append(f"{quoted(text)} is not translated")
            continue
        try:
            same = placeholders(text) == placeholders(translation)
        except ValueError as error:
            out.append(f"{quoted(translation)}: {error}")
            continue
        if not same:
            out.append(f"{quoted(translation)}: other placeholders than {quoted(text)}")
        if (text[0] == " ") != (translation[0] == " "):
            out.append(f"{quoted(translation)}: a blank begins only one of it and {quoted(text)}")
    return out


def passing_troubles():
    """Returns texts of passing_texts.h that no source outside the client has."""
    outside = "\n".join(f.read_text() for folder in ("common", "drivers", "server", "twins")
                        for f in sorted((ROOT / folder).rglob("*")) if f.suffix in (".cpp", ".h"))
    passing = re.findall(r'msg\("((?:[^"\\]|\\.)*)"\)', (FOLDER / "passing_texts.h").read_text())
    return [f'passing_texts.h: no library says "{text}"' for text in passing if f'"{text}"' not in outside]


def main():
    texts = marked_texts()
    bad = passing_troubles()
    for file in sorted(FOLDER.glob("*.po")):
        entries = entries_of(file.read_text())
        if "--update" in sys.argv[1:]:
            known = dict(entries)
            entries = [(text, known.get(text, "")) for text in texts]
            blocks = [f"\nmsgid {quoted(text)}\nmsgstr {quoted(translation)}\n" for text, translation in entries]
            file.write_text(HEADER.format(file.stem) + "".join(blocks))
        bad += [f"{file.name}: {trouble}" for trouble in troubles_of(texts, entries)]
    print("\n".join(bad) if bad else f"{len(texts)} texts in {len(list(FOLDER.glob('*.po')))} languages")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
