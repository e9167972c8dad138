#!/usr/bin/python3
"""contents_test.py PACKAGES BUILD: what is in the packages, from which no file is in two, and what they say of themselves."""
import gzip
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

packages, build = (pathlib.Path(word).resolve() for word in sys.argv[1:])
source = pathlib.Path(__file__).resolve().parents[2]
wanted = {
    "prosector-server": ["usr/bin/prosector-server", "usr/bin/prosector-import", "usr/share/prosector/scenes/abdomen.toml",
                         "usr/share/prosector/dds/loopback.xml", "usr/share/prosector/fetch_anatomy.sh",
                         "usr/lib/systemd/system/prosector-server.service", "etc/default/prosector-server"],
    "prosector-client": ["usr/bin/prosector-client", "usr/bin/prosector-fastrak-twin", "usr/bin/prosector-5dt-twin",
                         "usr/share/prosector/client.toml", "usr/share/prosector/fetch_models.sh",
                         "usr/share/applications/prosector-client.desktop"],
    "prosector-tools": ["usr/bin/prosector-scene", "usr/bin/prosector-bench", "usr/bin/prosector-play"],
    "libprosector-dev": ["usr/lib/libprosector_physics.a", "usr/include/prosector/server/physics/simulation.h",
                         "usr/lib/cmake/Prosector/ProsectorConfig.cmake",
                         "usr/share/doc/libprosector-dev/example/bend_and_press.cpp"],
}
failures = []


def check(good, what):
    if not good:
        failures.append(what)


def told(*words):
    return subprocess.run([str(word) for word in words], check=True, capture_output=True, text=True).stdout


def check_control(name, deb):
    field = lambda key: told("dpkg-deb", "--field", deb, key).strip()
    check(field("Package") == name, f"{deb.name} calls itself {field('Package')}")
    check(field("Maintainer") == "Prosector developers <prosector@localhost>", f"{name}: Maintainer: {field('Maintainer')}")
    check(field("Version") == re.search(r"VERSION ([\d.]+)", (source / "CMakeLists.txt").read_text().split("project(")[1])[1],
          f"{name}: Version: {field('Version')}")
    summary, *more = field("Description").split("\n")
    check(20 < len(summary) < 80 and more, f"{name}: Description: {summary}")
    if name != "libprosector-dev":
        check("libc6 (>=" in field("Depends"), f"{name}: no run-time dependency was found: {field('Depends')}")
        check("-dev" not in field("Depends"), f"{name}: needs a development package: {field('Depends')}")
    else:
        check("libeigen3-dev" in field("Depends"), f"{name}: Depends: {field('Depends')}")
    if name == "prosector-server":
        check(told("dpkg-deb", "--info", deb, "conffiles").split() == ["/etc/default/prosector-server"], f"{name}: conffiles")
        for script in ("postinst", "prerm", "postrm"):
            told("dpkg-deb", "--info", deb, script)


def check_tree(name, tree):
    files = {str(path.relative_to(tree)) for path in tree.rglob("*") if not path.is_dir()}
    for file in [*wanted[name], f"usr/share/doc/{name}/copyright", f"usr/share/doc/{name}/changelog.gz"]:
        check(file in files, f"{name}: no {file}")
    for file in files:
        check(file.startswith(("usr/", "etc/default/")), f"{name}: {file} stands elsewhere")
        text = (tree / file).read_bytes()
        for place in (source, build):
            check(str(place).encode() not in text, f"{name}: {file} names {place}")
    notices = (tree / f"usr/share/doc/{name}/copyright").read_text()
    for licence in ("common-licenses/Apache-2.0", "copyright file of libeigen3-dev", "copyright file of libcli11-dev"):
        check(licence in notices, f"{name}: copyright does not say: {licence}")
    return files


def check_programs(tree):
    for program in (tree / "usr/bin").glob("*"):
        sections = told("readelf", "--sections", "--wide", program)
        check(".debug_info" not in sections and ".symtab" not in sections, f"{program.name} is not stripped")
        page = gzip.decompress((tree / f"usr/share/man/man1/{program.name}.1.gz").read_bytes()).decode()
        check_page(program, page)


def options_of(program, *words):
    run = subprocess.run([program, *words, "--help"], capture_output=True, text=True)
    commands = re.search(r"^Subcommands:\n((?:  .*\n)+)", run.stdout, re.M)
    return set(re.findall(r"^ +(--[a-z0-9-]+)", run.stdout, re.M)), re.findall(r"^  (\S+)", commands[1], re.M) if commands else []


def check_page(program, page):
    """Every option that a program's help tells is on its page, under its command."""
    name = program.name
    options, commands = options_of(program)
    check(options or name == "prosector-import", f"{name} tells no options")
    parts = dict(re.findall(r'^\.SH "' + name.replace("-", r"\\-") + r' (\S+)"\n((?:(?!\.SH ).*\n)*)', page, re.M))
    for command, text in [("", page), *((command, parts.get(command.replace("-", r"\-"), "")) for command in commands)]:
        for option in options if not command else options_of(program, command)[0]:
            check("fB" + option.replace("-", r"\-") + r"\fR" in text, f"{name} {command}: its man page lacks {option}")
    check(r"\(>" not in page and "/root" not in page, f"{name}: its man page names a home folder")
    if shutil.which("man"):
        run = subprocess.run(["man", "--warnings", "--local-file", "-Tutf8", "-"], input=page, capture_output=True, text=True)
        check(run.returncode == 0 and not run.stderr, f"{name}: its man page: {run.stderr}")


def check_development(tree):
    for library in (tree / "usr/lib").glob("*.a"):
        check(".debug_" not in told("readelf", "--sections", "--wide", library), f"{library.name} is not stripped")
    include = tree / "usr/include/prosector"
    for header in include.rglob("*.h"):
        for included in re.findall(r'^#include "(.*)"', header.read_text(), re.M):
            check((include / included).is_file(), f"{header.relative_to(include)} includes {included}, which no package has")


def check_with(program, *words):
    """Asks a program of others, where this machine has it."""
    if not shutil.which(program):
        print(f"note: {program} is not installed")
        return
    run = subprocess.run([program, *map(str, words)], capture_output=True, text=True)
    check(run.returncode == 0, f"{program}: {run.stdout}{run.stderr}")


owners = {}
with tempfile.TemporaryDirectory() as folder:
    debs = sorted(packages.glob("*.deb"))
    check(sorted(deb.name.split("_")[0] for deb in debs) == sorted(wanted), f"packages made: {[deb.name for deb in debs]}")
    for deb in debs:
        name, tree = deb.name.split("_")[0], pathlib.Path(folder) / deb.stem
        told("dpkg-deb", "--extract", deb, tree)
        check_control(name, deb)
        for row in told("dpkg-deb", "--contents", deb).splitlines():
            check(re.match(r"[-d]rw[-x](r-[-x]){2} root/root ", row), f"{name}: owner or permissions: {row}")
        for file in check_tree(name, tree):
            check(file not in owners, f"{file} is in {owners.get(file)} and {name}")
            owners[file] = name
        check_programs(tree)
        if name == "libprosector-dev":
            check_development(tree)
        if name == "prosector-client":
            check_with("desktop-file-validate", tree / "usr/share/applications/prosector-client.desktop")
if failures:
    sys.exit("\n".join(failures))
print(f"ok: {len(owners)} files in {len(wanted)} packages, none in two")
