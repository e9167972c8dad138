#!/usr/bin/python3
"""check_folders.py [--arrows FOLDER]: reports the cycles among folders that include each other, and fails if there is one.

A folder is the directory of a file, without those below it. Each #include of one of the project's own files is an arrow from
the including file's folder to the included file's. Tests are not checked. --arrows lists the arrows among the folders below
FOLDER, each with one example.
"""

import collections
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TOPS = ("common", "idl", "drivers", "twins", "server", "client")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


def arrows():
    """{(from, to): (including file, included file)} of two different folders, with the first example of each."""
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.h", "*.cpp"], cwd=ROOT,
                            capture_output=True, text=True, check=True).stdout.split()
    files = [name for name in listed if name.split("/")[0] in TOPS and (ROOT / name).exists()]
    known, found = set(files), {}
    for name in files:
        for included in INCLUDE.findall((ROOT / name).read_text()):
            pair = tuple(str(pathlib.PurePosixPath(file).parent) for file in (name, included))
            if included in known and pair[0] != pair[1]:
                found.setdefault(pair, (name, included))
    return found


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
    found = arrows()
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
    folders = {folder for pair in found for folder in pair}
    print(f"folders: {len(folders)}, arrows: {len(found)}, cycles: {len(cycles)} (bound 0)")
    return 1 if cycles else 0


if __name__ == "__main__":
    sys.exit(main())
