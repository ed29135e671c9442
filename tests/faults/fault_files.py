"""Faults as files: what they say, and putting them into a copy of the source.

A fault is NAME.fault beside this file:

    # One sentence: what is wrong now.
    rooms render sense
    file game/render/bsdf.cpp
    find
    the text as it is, which has to be there exactly once
    put
    the text as it is with the fault in it

`file`, `find` and `put` may come several times. A text ends where the next of these words stands alone on its line.
"""
import dataclasses
import pathlib


class Stale(Exception):
    """The fault no longer fits the source: somebody has to look at it."""


@dataclasses.dataclass
class Edit:
    file: str
    find: str
    put: str


@dataclasses.dataclass
class Fault:
    name: str
    sentence: str
    rooms: list
    edits: list


def read_fault(path):
    sentence, rooms, edits, file, part, text = "", [], [], None, None, {"find": [], "put": []}

    def close_edit():
        if part is None:
            return
        edits.append(Edit(file, "\n".join(text["find"]), "\n".join(text["put"])))
        text["find"], text["put"] = [], []

    for line in path.read_text().splitlines():
        if line == "find":
            close_edit()
            part = "find"
        elif line == "put":
            part = "put"
        elif line.startswith("file "):
            close_edit()
            file, part = line[5:].strip(), None
        elif part is not None:
            text[part].append(line)
        elif line.startswith("# "):
            sentence = (sentence + " " + line[2:]).strip()
        elif line.startswith("rooms "):
            rooms = line[6:].split()
    close_edit()
    if not sentence or not rooms or not edits:
        raise Stale(f"{path.name}: a fault needs a sentence, rooms, and what to change")
    return Fault(path.stem, sentence, rooms, edits)


def read_faults(folder):
    return [read_fault(path) for path in sorted(pathlib.Path(folder).glob("*.fault"))]


def with_fault(fault, source):
    """{path: text} of the files the fault changes."""
    changed = {}
    for edit in fault.edits:
        path = source / edit.file
        if not path.is_file():
            raise Stale(f"{fault.name}: there is no {edit.file}")
        text = changed.get(path, path.read_text())
        count = text.count(edit.find)
        if count != 1 or edit.find == edit.put:
            raise Stale(f"{fault.name}: this is {count} times in {edit.file}, once is right:\n{edit.find}")
        changed[path] = text.replace(edit.find, edit.put)
    return changed
