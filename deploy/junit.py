"""Reads the JUnit files that ctest writes."""
import pathlib
import re
import xml.etree.ElementTree as tree

not_xml = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f]|&#x(?:0*[0-8bcef]|0*1[0-9a-f]);", re.I)


def cases_of(path):
    """Gives the test cases of a file; what tests printed may hold characters that XML may not, which go."""
    text = pathlib.Path(path).read_text(errors="replace")
    return list(tree.fromstring(not_xml.sub("?", re.sub(r"^<\?xml[^>]*>", "", text))).iter("testcase"))


def name(case):
    return case.get("name")


def failed(case):
    return case.get("status") == "fail"


def seconds(case):
    return float(case.get("time"))


skipped_line = re.compile(r"^\[  SKIPPED \] ([^\s(]+) \(", re.M)
reason_line = re.compile(r"^[^\n]*: Skipped\n(.*)$|^SKIP(?:PED)?:? *(.*)$", re.M | re.I)


def skipped(case):
    """Gives (name, reason) of each test that was skipped: a process of many tests tells them in its output."""
    text, mark = case.findtext("system-out") or "", case.find("skipped")
    found = reason_line.search(text)
    reason = (found.group(1) or found.group(2) or "").strip() if found else ""
    inner = skipped_line.findall(text)
    if inner:
        prefix = name(case).split(".")[0]
        return [(f"{prefix}.{test}", reason) for test in inner]
    return [] if mark is None else [(name(case), reason or mark.get("message", ""))]
