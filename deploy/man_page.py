#!/usr/bin/python3
"""man_page.py PROGRAM FILE: writes its man page, made of what `PROGRAM --help` and the `--help` of each of its commands say."""
import os
import pathlib
import re
import subprocess
import sys

# Where CLI11 begins descriptions: after the term, or on the next line where the term is too long.
indent = 30 * " "


def told(program, *words):
    """Runs PROGRAM as a user with a home folder `~` would, so that defaults name no machine's folders."""
    name = pathlib.Path(program).name
    run = subprocess.run([name, *words], executable=program, env={"HOME": "~", "PATH": os.environ["PATH"]},
                         stdin=subprocess.DEVNULL, capture_output=True, text=True)
    return run.stdout or run.stderr


def escaped(text):
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return "\n".join(r"\&" + line if line[:1] in (".", "'") else line for line in text.split("\n"))


def parse(text):
    """Gives the introduction, the usage, and the sections: (title, [(term, description)])."""
    introduction, found, rest = text.partition("Usage: ")
    if not found:
        usage, _, introduction = text.partition(": ")
        return [introduction.strip()], usage.strip(), []
    usage, _, rest = rest.partition("\n")
    sections = []
    lines = [line for line in rest.split("\n") if line.strip()]
    for line, following in zip(lines, [*lines[1:], ""]):
        if line.startswith(indent):
            continue  # taken with its term
        if not line.startswith(" "):
            sections.append((line.strip().rstrip(":"), []))
        elif following.startswith(indent):
            sections[-1][1].append((line.strip(), following.strip()))
        else:
            sections[-1][1].append((line[:len(indent)].strip(), line[len(indent):].strip()))
    return introduction.rstrip().split("\n"), usage.strip(), sections


def term(text):
    """`--size FLOAT:FLOAT in [1 - 2]=1`: the names bold, what they take in italics, once."""
    names, _, takes = text.partition(" ")
    names = re.sub(r"\{.*?\}", "", names).replace(",", ", ")
    takes = re.sub(r"^(\w+):\1 in ", r"\1 in ", takes)
    return r"\fB" + escaped(names) + r"\fR" + (r" \fI" + escaped(takes) + r"\fR" if takes else "")


def paragraphs(lines):
    """Prose is filled, indented lines are examples."""
    out = []
    for line in lines:
        if not line.strip():
            out.append(".PP")
        elif line.startswith(" "):
            out += [".nf", escaped(line), ".fi"]
        else:
            out.append(escaped(line))
    return out


def options(sections, macro):
    out = []
    for title, rows in sections:
        out.append(f'.{macro} "{escaped(title.upper() if macro == "SH" else title)}"')
        for row, description in rows:
            out += [".TP", term(row), escaped(description)]
    return out


def page(program):
    name = pathlib.Path(program).name
    version = told(program, "--version").split(",")[0].split()
    introduction, usage, sections = parse(told(program, "--help"))
    introduction[0] = introduction[0].removeprefix(name + ": ")
    introduction[0] = introduction[0][0].upper() + introduction[0][1:]
    summary = introduction[0].split(". ")[0].rstrip(".")
    out = [f'.TH "{escaped(name.upper())}" "1" "" "{" ".join(version)}" "Prosector"',
           ".SH NAME", f"{escaped(name)} \\- {escaped(summary[0].lower() + summary[1:])}",
           ".SH SYNOPSIS", escaped(usage), ".SH DESCRIPTION", *paragraphs(introduction)]
    commands = [row[0] for title, rows in sections if title == "Subcommands" for row in rows]
    out += options(sections, "SH")
    for command in commands:
        introduction, usage, sections = parse(told(program, command, "--help"))
        out += [f'.SH "{escaped(name)} {escaped(command)}"', *paragraphs(introduction), ".PP", escaped(usage)]
        out += options(sections, "SS")
    out += [".SH \"SEE ALSO\"", "Pages on scenes, networks and devices, where prosector\\-server is installed:",
            "/usr/share/doc/prosector/docs."]
    return "\n".join(out) + "\n"


if len(sys.argv) != 3:
    sys.exit(__doc__)
file = pathlib.Path(sys.argv[2])
file.parent.mkdir(parents=True, exist_ok=True)
file.write_text(page(str(pathlib.Path(sys.argv[1]).resolve())))
