#!/usr/bin/python3
"""check_folders.py [--arrows FOLDER]: checks that no folders include each other in a cycle, and the namespaces of mechanics.

A folder is the directory of a file, without those below it. Each #include of one of the project's own files is an arrow from
the including file's folder to the included file's. Tests are not checked. --arrows lists the arrows among the folders below
FOLDER, each with one example.

Files below server/physics/mechanics/NAME define their names in namespace prosector::NAME. They may open other namespaces of
the project only to declare a type that is defined elsewhere.
"""

import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOPS = ("common", "idl", "drivers", "twins", "server", "client")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
MECHANICS = "server/physics/mechanics/"
NAMESPACE = re.compile(r"^namespace (prosector[\w:]*) \{\n(.*?)^\}", re.M | re.S)
DECLARATION = re.compile(r"(class|struct|enum class) \w+;")


def sources():
    """The project's C++ files, without tests."""
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.h", "*.cpp"], cwd=ROOT,
                            capture_output=True, text=True, check=True).stdout.split()
    return [name for name in listed if name.split("/")[0] in TOPS and (ROOT / name).exists()]


def arrows(files):
    """{(from, to): (including file, included file)} of two different folders, with the first example of each."""
    known, found = set(files), {}
    for name in files:
        for included in INCLUDE.findall((ROOT / name).read_text()):
            pair = tuple(str(pathlib.PurePosixPath(file).parent) for file in (name, included))
            if included in known and pair[0] != pair[1]:
                found.setdefault(pair, (name, included))
    return found


def misplaced_names(files):
    """Files of mechanics with a namespace other than their folder's, as (file, namespace); and the number of files checked."""
    found, checked = [], 0
    for name in files:
        if not name.startswith(MECHANICS):
            continue
        checked += 1
        own = "prosector::" + name.removeprefix(MECHANICS).split("/")[0]
        for namespace, body in NAMESPACE.findall((ROOT / name).read_text()):
            only_declares = all(DECLARATION.fullmatch(line) for line in body.splitlines() if line)
            if namespace not in (own, own + "::HWY_NAMESPACE") and not only_declares:
                found.append((name, namespace))
    return found, checked


def components(graph):
    """The strongly connected components of {node: successors} with more than one node (Tarjan 1972)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for successor in graph.get(node, ()):
            if successor not in index:
                visit(successor)
                low[node] = min(low[node], low[successor])
            elif successor in stack:
                low[node] = min(low[node], index[successor])
        if low[node] == index[node]:
            component = []
            while not component or component[-1] != node:
                component.append(stack.pop())
            if len(component) > 1:
                found.append(sorted(component))

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return found


def main():
    files = sources()
    found = arrows(files)
    if sys.argv[1:2] == ["--arrows"]:
        for (source, target), (name, included) in sorted(found.items()):
            if source.startswith(sys.argv[2]) and target.startswith(sys.argv[2]):
                print(f"{source} -> {target}: {name} includes {included}")
        return 0
    graph = collections.defaultdict(set)
    for source, target in found:
        graph[source].add(target)
    cycles = components(graph)
    for cycle in cycles:
        print("folders include each other in a cycle: " + ", ".join(cycle), file=sys.stderr)
        for (source, target), (name, included) in sorted(found.items()):
            if source in cycle and target in cycle:
                print(f"  {name} includes {included}", file=sys.stderr)
    misplaced, checked = misplaced_names(files)
    for name, namespace in misplaced:
        print(f"{name}: defines names in namespace {namespace}, not in that of its folder", file=sys.stderr)
    folders = {folder for pair in found for folder in pair}
    print(f"folders: {len(folders)}, arrows: {len(found)}, cycles: {len(cycles)} (bound 0)")
    print(f"files of mechanics: {checked}, in another namespace than their folder's: {len(misplaced)} (bound 0)")
    return 1 if cycles or misplaced else 0


if __name__ == "__main__":
    sys.exit(main())
