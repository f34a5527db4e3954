"""Which lines of the four headers are code, and which are copies of each other.

A file of src/ that several headers need is copied into each of them, inside a guard of its own, such as
VARMASS_BASE_WORDS_H. A program that includes several headers compiles only the first copy. Therefore a tool that asks
which lines the tests execute must take the copies together: owners() names one of them for all.
"""
import re

HEADERS = ('jacobi', 'ateb', 'integrators', 'varmass')


def code_of(text):
    """The text with comments, strings and preprocessor lines blanked, every other character where it was."""
    def blank(found):
        return re.sub(r'[^\n]', ' ', found[0])
    return re.sub(r'(?m)^[ \t]*#.*', blank, re.sub(r'/\*.*?\*/|"[^"\n]*"', blank, text, flags=re.S))


def files_of(lines):
    """For each line, counted from 1: (guard of the innermost file of src/, lines since this guard)."""
    found, open_conditions = {}, []
    for number, line in enumerate(lines, 1):
        guard = re.match(r'#ifndef (VARMASS_\w+_H)$', line)
        if re.match(r'#\s*if', line):
            open_conditions.append((guard[1], number) if guard else None)
        inner = next((condition for condition in reversed(open_conditions) if condition), None)
        if inner:
            found[number] = inner[0], number - inner[1]
        if re.match(r'#\s*endif', line):
            open_conditions.pop()
    return found


def owners(sources):
    """For each (header, line), of sources {header: lines}: the (header, line) of the first copy, in the order of HEADERS."""
    first, owner = {}, {}
    for header in HEADERS:
        files = files_of(sources[header])
        for line in range(1, len(sources[header]) + 1):
            owner[header, line] = first.setdefault(files[line], (header, line)) if line in files else (header, line)
    return owner
