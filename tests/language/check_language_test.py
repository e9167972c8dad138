#!/usr/bin/python3
"""Holds deploy/check_language.py to finding each fault that a translation can have."""
import importlib.util
import sys

spec = importlib.util.spec_from_file_location("check_language", sys.argv[1])
check = importlib.util.module_from_spec(spec)
spec.loader.exec_module(check)

TEXTS = ["{} cut the {}", "Save"]
GOOD = [("{} cut the {}", "{} hat geschnitten: {}"), ("Save", "Speichern")]
assert check.troubles_of(TEXTS, GOOD) == []
assert check.troubles_of(TEXTS, [(TEXTS[0], "geschnitten: {1}, von {0}"), GOOD[1]]) == [], "another order"

FAULTY = {
    "a text is missing": GOOD[:1],
    "a text is in no source": GOOD + [("Load", "Laden")],
    "another order than the sources'": GOOD[::-1],
    "an empty translation": [GOOD[0], ("Save", "")],
    "a placeholder too few": [(TEXTS[0], "{} hat geschnitten"), GOOD[1]],
    "a placeholder too many": [GOOD[0], ("Save", "{} speichern")],
    "another format": [(TEXTS[0], "{} hat geschnitten: {:.1f}"), GOOD[1]],
    "a brace by itself": [(TEXTS[0], "{} hat geschnitten: {"), GOOD[1]],
    "both kinds of placeholders": [(TEXTS[0], "{} hat geschnitten: {1}"), GOOD[1]],
    "a blank before it": [GOOD[0], ("Save", " Speichern")],
}
for fault, entries in FAULTY.items():
    assert check.troubles_of(TEXTS, entries), fault

PO = 'msgid ""\nmsgstr ""\n"Language: de\\n"\n\nmsgid ""\n"one "\n"\\"two\\"\\n"\nmsgstr "eins\\tzwei"\n'
assert check.entries_of(PO) == [('one "two"\n', "eins\tzwei")], check.entries_of(PO)
print(f"finds {len(FAULTY)} faults")
