#!/usr/bin/python3
"""check_types.py [ROOT] [--list]: no type of the product is large, no function long, and no file long.

A class or struct may have 30 member functions (constructors, private and static ones among them) and 20 data members (static
ones not). A function may have 60 lines, from the line of its opening brace to that of its closing one. Types that a type
encloses count separately. A source file, also of tests and scripts, may have 500 lines; tables (*_table.cpp) may have more. --list prints the largest types and the longest functions and checks nothing.
The C++ is read by its braces, not compiled: macros that hide braces would mislead this.
"""

import pathlib
import re
import sys

MOST_FUNCTIONS, MOST_FIELDS, MOST_LINES, MOST_IN_FILE = 30, 20, 60, 500
FOLDERS = "client", "common", "drivers", "idl", "server", "twins"
IDLE = re.compile(r"//[^\n]*|/\*.*?\*/|R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'", re.S)
PREPROCESSOR = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)
TYPE = re.compile(r"^(?:class|struct|union)\s+(?:(?:alignas\s*\([^)]*\)|\[\[.*?\]\])\s*)*([\w:]*)")


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def code_of(text):
    """The text with comments, literals and preprocessor lines blank, so that places stay."""
    return PREPROCESSOR.sub(blank, IDLE.sub(blank, text))


def closing(code, at):
    """The place of the bracket that closes the one at `at`."""
    depth = 0
    for place in range(at, len(code)):
        depth += code[place] in "({["
        depth -= code[place] in ")}]"
        if depth == 0:
            return place
    raise ValueError("a bracket does not close")


def without_angles(head):
    """The head without what stands in <...>: template parameters and arguments."""
    head = re.sub(r"operator\s*(<=>|<<|>>|<=|>=|<|>|==|!=|=|->|\(\s*\))", "operator_", head)
    before = None
    while before != head:
        before = head
        head = re.sub(r"<[^<>]*>", " ", head)
    return head


def is_function(head):
    plain = re.sub(r"alignas\s*\([^)]*\)|\[\[.*?\]\]|decltype\s*\([^)]*\)", " ", without_angles(head))
    before_value = re.split(r"=(?!=)|\{", plain)[0]
    return "(" in before_value and not re.match(r"[^(]*\(\s*\*", before_value)


def statements(code, begin, end):
    """(head, place of the body's opening brace or None, place) of each declaration in code[begin:end]."""
    start = place = begin
    while place < end:
        char = code[place]
        if char in "([":
            place = closing(code, place)
        elif char == ";":
            yield code[start:place], None, start
            start = place + 1
        elif char == ":" and re.fullmatch(r"\s*(public|private|protected)\s*", code[start:place]):
            start = place + 1
        elif char == "{":
            head = code[start:place]
            shut = closing(code, place)
            listed = re.search(r"\)[^:]*(?<!:):(?!:)", head)
            if is_function(head) and listed and re.search(r"[\w>]\s*$", head):
                place = shut  # a member's initialiser
            elif is_function(head) or re.match(r"\s*(inline\s+)?namespace\b|\s*extern\b", head):
                yield head, place, start
                place, start = shut, shut + 1
            elif re.match(r"(class|struct|union|enum)\b", without_angles(re.sub(r"^\s*template", "", head)).strip()):
                yield head, place, start
                place = shut
                start = code.index(";", shut) + 1
                names = code[shut + 1:start - 1].strip()
                if names:
                    yield "nested " + names, None, shut
                place = start - 1
            else:
                place = shut  # a value
        place += 1


def fields_of(head):
    """How many data members a declaration makes."""
    plain = re.split(r"\n", without_angles(head).strip())
    plain = " ".join(plain).strip()
    if not plain or re.match(r"(using|typedef|friend|static_assert|static|enum|class|struct|union|template|public|private|protected)\b",
                             plain) and not re.match(r"(struct|class|enum)\s+\w+\s+\w+", plain):
        return 0
    plain = re.sub(r"\([^()]*\)|\{[^{}]*\}|\[[^\]]*\]", "", plain)
    depth = count = 0
    for char in plain:
        depth += char in "({["
        depth -= char in ")}]"
        count += char == "," and depth == 0
    return count + 1


class Reader:
    def __init__(self, file, code):
        self.file, self.code, self.types, self.functions = file, code, [], []

    def line(self, place):
        return self.code.count("\n", 0, place) + 1

    def read(self, begin, end, owner=None):
        for head, body, place in statements(self.code, begin, end):
            template = re.match(r"\s*template\s*<", head)
            plain = without_angles(re.sub(r"^\s*template", "", head)).strip() if template else without_angles(head).strip()
            kind = TYPE.match(plain)
            if body is None:
                if re.match(r"(using|typedef|friend|static_assert)\b", plain):
                    continue
                if owner is not None and is_function(head):
                    owner["functions"] += 1
                elif owner is not None:
                    owner["fields"] += fields_of(head)
            elif re.match(r"(inline\s+)?namespace\b|extern\b", plain):
                self.read(body + 1, closing(self.code, body))
            elif kind and not is_function(head):
                name = kind.group(1) or "(unnamed)"
                mine = {"name": name if owner is None else owner["name"] + "::" + name, "functions": 0, "fields": 0,
                        "where": f"{self.file}:{self.line(body)}"}
                self.types.append(mine)
                self.read(body + 1, closing(self.code, body), mine)
            elif re.match(r"enum\b", plain):
                continue
            else:
                if owner is not None and not re.match(r"friend\b", plain):
                    owner["functions"] += 1
                lines = self.line(closing(self.code, body)) - self.line(body) + 1
                name = re.search(r"([\w:~]+)\s*\(|operator_", without_angles(head))
                self.functions.append({"name": name.group(1) or "operator" if name else "?", "lines": lines,
                                       "where": f"{self.file}:{self.line(body)}"})


def read_all(root):
    types, functions = [], []
    for path in sorted(path for folder in FOLDERS for path in (root / folder).rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        code = code_of(path.read_text(encoding="utf-8"))
        reader = Reader(path.relative_to(root), code)
        reader.read(0, len(code))
        types += reader.types
        functions += reader.functions
    return types, functions


def file_lengths(root):
    """Lines of each source file but tables, by its path."""
    paths = [path for folder in (*FOLDERS, "tests", "deploy") for path in (root / folder).rglob("*")
             if path.suffix in (".h", ".cpp", ".py", ".sh") and not path.stem.endswith("_table")]
    return {path.relative_to(root): path.read_text(encoding="utf-8").count("\n") for path in paths}


def faults(types, functions, lengths):
    found = [f'{t["where"]}: {t["name"]} has {t["functions"]} member functions and {t["fields"]} data members' for t in types
             if t["functions"] > MOST_FUNCTIONS or t["fields"] > MOST_FIELDS]
    found += [f'{f["where"]}: {f["name"]} has {f["lines"]} lines' for f in functions if f["lines"] > MOST_LINES]
    return found + [f"{path}: the file has {lines} lines" for path, lines in sorted(lengths.items()) if lines > MOST_IN_FILE]


def main():
    words = [word for word in sys.argv[1:] if word != "--list"]
    root = pathlib.Path(words[0]) if words else pathlib.Path(__file__).resolve().parent.parent
    types, functions = read_all(root)
    if "--list" in sys.argv:
        for t in sorted(types, key=lambda t: -max(t["functions"] / MOST_FUNCTIONS, t["fields"] / MOST_FIELDS))[:20]:
            print(f'{t["functions"]:4} functions {t["fields"]:4} fields  {t["name"]}  {t["where"]}')
        for f in sorted(functions, key=lambda f: -f["lines"])[:20]:
            print(f'{f["lines"]:4} lines  {f["name"]}  {f["where"]}')
        return
    if not types or not functions:
        sys.exit(f"types: nothing found below {root}")
    lengths = file_lengths(root)
    found = faults(types, functions, lengths)
    for fault in found:
        print(fault)
    if found:
        sys.exit(f"types: at most {MOST_FUNCTIONS} member functions, {MOST_FIELDS} data members, {MOST_LINES} lines "
                 f"per function, {MOST_IN_FILE} per file; split what is larger")
    print(f"types: good, {len(types)} types and {len(functions)} functions; longest file but tables: {max(lengths.values())} lines "
          f"({MOST_IN_FILE} allowed)")


if __name__ == "__main__":
    main()
