#!/usr/bin/env python3
"""Wrong headers that the tests are to notice: one token of a header changed at a time.

A mutant flips a sign, swaps * and /, turns a comparison round, swaps && and ||, doubles a constant, adds one to an
index or a count, or swaps the alternatives of a conditional. Lines are drawn from those that some test executes, by
the map that coverage.py leaves (lines that have moved since are found by their text), each of a header with the
same chance. The programs that execute the line are built and run one by one, those in double first, then those in
float, the header's own and the quickest first, and last those that take SLOW seconds, until one fails, ends with a
signal or needs four times its time. Of more than MANY in a precision, those are run that execute most lines next to
this one. tcc, where it is there, makes this a matter of seconds; since some lines are compiled by gcc only, what
passes is then tried by gcc, and the header's own programs by gcc as make test-all compiles the headers, which are
then vectorised. Where all pass, the mutant has survived and is printed, to be judged: a test is missing, or it is
equivalent (the results are as good) and goes with its reason to tests/mutants.txt, whose mutants count neither as
caught nor as missed.

A file of src/ that is copied into several headers belongs to the first of them (rooms.py); the mutant is in all copies.

Before, for each header, two controls: the header as it is must survive, and with |x| = -x it must be caught.

usage: mutate.py BUILD SEED COUNT [HEADER...] from the top of the project, after coverage.py; COUNT of each header.
The mutants of a header depend on SEED and on this header, but not on the other headers that are named.
"""
import difflib
import glob
import json
import os
import random
import re
import resource
import shutil
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from queue import Queue

sys.dont_write_bytecode = True  # no folder beside the sources
from rooms import HEADERS, code_of, owners

MANY = 10
NEXT = 100 # lines before and after the one that is changed
SLOW = 6 # seconds
TCC, GCC = ['tcc', '-DFLT_EVAL_METHOD=0'], ['gcc', '-O1'] # the one compiles in no time, the other takes everything
FAST = ['gcc', '-O3', '-march=native', '-ffp-contract=fast']
LEAST = 90.0
WORKERS = int(os.environ.get('JOBS', os.cpu_count()))
DECLARED = re.compile(r'\s*(?:const |VM_TABLE )*(?!return\b|else\b|case\b)\w+ [^=({]*\[') # a longer array is as good
NUMBER = r'\d+\.\d+(?:e[+-]?\d+)?|\d+e[+-]?\d+'
CHANGES = (
    ('sign', r' \+ ', ' - '), ('sign', r' - ', ' + '), ('sign', r' \+= ', ' -= '), ('sign', r' -= ', ' += '),
    ('sign', r'(?<=[=(,?:] )-(?=[\w(])|(?<=\()-(?=[\w(])|(?<=return )-(?=[\w(])', ''),
    ('sign', r'(?<=VM_C\()(?=\d)', '-'), ('sign', r'(?<=VM_C\()-', ''),
    ('factor', r' \* ', ' / '), ('factor', r' / ', ' * '), ('factor', r' \*= ', ' /= '),
    ('comparison', r' < ', ' >= '), ('comparison', r' > ', ' <= '), ('comparison', r' <= ', ' > '),
    ('comparison', r' >= ', ' < '), ('comparison', r' == ', ' != '), ('comparison', r' != ', ' == '),
    ('logic', r' && ', ' || '), ('logic', r' \|\| ', ' && '), ('logic', r'(?<=[( ])!(?=[\w(])', ''),
    ('constant', rf'(?<=VM_C\()-?(?:{NUMBER})', lambda m: repr(2 * float(m[0])) if float(m[0]) else '1.0'),
    ('integer', r'(?<![\w.])[0-9](?![\w.])', lambda m: str(int(m[0]) + 1)),
    ('choice', r'\? ([^?:,;]+) : ([^?:,;]+)(?=;)', lambda m: f'? {m[2]} : {m[1]}'),
)


def draw(rng, codes, places):
    """One mutant: (header, line, kind, column, end, new text); a kind of change first, so that rare ones come too."""
    while True:
        header, line = rng.choice(places)
        kind, pattern, new = rng.choice(CHANGES)
        code = codes[header][line - 1]
        found = [at for at in re.finditer(pattern, code) if not DECLARED.fullmatch(code[:at.start()])]
        if found and re.search(r'[;{},]|\\$|&&|\|\|', code):
            at = rng.choice(found)
            return header, line, kind, at.start(), at.end(), new(at) if callable(new) else new


def moved(before, lines):
    """Which line each line of the text before has become, from 1; without those that changed."""
    if before == lines:
        return {line: line for line in range(1, len(lines) + 1)}
    blocks = difflib.SequenceMatcher(None, before, lines, autojunk=False).get_matching_blocks()
    return {block.a + k + 1: block.b + k + 1 for block in blocks for k in range(block.size)}


def flags_of(name):
    return ['-DVM_USE_FLOAT'] if name.endswith('_float') else \
        ['-O1', '-march=native', '-ffp-contract=fast'] if name.endswith('_contracted') else []


def built(folder, name, compiler):
    test = re.sub(r'_(float|contracted)$', '', name)
    command = [*compiler, '-std=c99', '-w', *flags_of(name), f'tests/test_{test}.c', '-o', 'test', '-lm']
    return not subprocess.run(command, cwd=folder, stderr=subprocess.DEVNULL).returncode


def passes(folder, limit):
    """Does the program that was built last pass within so many seconds of processor time? It is stopped at the first
    failure that it prints."""
    command = ['sh', '-c', f'ulimit -t {limit}; exec stdbuf -oL ./test']
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as program:
        for line in program.stdout:
            if b'FAILED' in line:
                program.kill()
    return not program.returncode


def write(folder, headers):
    for header, lines in headers.items():
        with open(f'{folder}/{header}.h', 'w') as file:
            file.write('\n'.join(lines))


COMPILERS = {}


def compiler_of(folder, name, seconds, last):
    """The first one by which the program compiles and passes, with the headers as they are, of TCC, GCC, or only `last` if
    it is given; four times as long."""
    tcc = last is None and shutil.which(TCC[0]) and seconds < SLOW and not name.endswith('_contracted')
    for compiler in (TCC, GCC) if tcc else (last or GCC,):
        if built(folder, name, compiler):
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            if passes(folder, 600):
                return compiler, int(3 + 4 * (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before))
    sys.exit(f'{name} fails without a mutant')


def judge(folder, right, wrong, programs, own, seconds):
    """'caught', 'stillborn' (does not compile), or 'survived', of the headers wrong, {header: lines}; the headers right
    are put back afterwards. The programs `own` are tried once more by FAST."""
    tries = [(name, by) for by in (None, 'gcc') for name in programs] + [(name, 'fast') for name in own]
    for name, by in tries:
        if by == 'gcc' and COMPILERS[name, None][0] is GCC: # it has been tried
            continue
        if (name, by) not in COMPILERS:
            COMPILERS[name, by] = compiler_of(folder, name, seconds[name], {None: None, 'gcc': GCC, 'fast': FAST}[by])
        compiler, limit = COMPILERS[name, by]
        write(folder, wrong)
        is_built = built(folder, name, compiler)
        is_right = is_built and passes(folder, limit)
        write(folder, right)
        if not is_right:
            return 'caught' if is_built else 'stillborn'
    return 'survived'


def is_own(header, name):
    """Does the program's source include this header, itself or by a header of the tests?"""
    with open('tests/test_' + re.sub(r'_(float|contracted)$', '', name) + '.c') as file:
        text = file.read()
    for local in re.findall(r'#include "(\w+\.h)"', text):
        with open(f'tests/{local}') as file:
            text += file.read()
    return f'"../{header}.h"' in text


def in_order(header, line, executed, seconds):
    """The programs to try: in double, then in float, the header's own and the quickest first; last the slow ones, in
    float only those that have the header's name. `executed` has the programs that execute each line of the header."""
    names = executed[line]
    lines_next = Counter(name for k in range(line - NEXT, line + NEXT + 1) for name in executed.get(k, ()))
    quick = sorted((name for name in names if seconds[name] < SLOW), key=lambda name: -lines_next[name])
    slow = [name for name in names if seconds[name] >= SLOW and (not flags_of(name) or name.startswith(header))]
    kinds = [[name for name in quick if re.search(r'_float$|_contracted$|$', name)[0] == ending][:MANY]
             for ending in ('', '_float')]
    for kind in kinds:
        kind.sort(key=lambda name: (not is_own(header, name), seconds[name]))
    return kinds[0] + kinds[1] + slow or names[:MANY]


def prepared(build):
    """A copy of the project for each worker; copies, no links: ".." must lead from a source to the mutant."""
    folders = Queue()
    for k in range(WORKERS):
        folder = f'{build}/mutants/{os.getpid()}-{k}'
        for name in ('tests', 'examples'):
            shutil.copytree(name, f'{folder}/{name}')
        for source in glob.glob(f'{folder}/tests/*.[ch]'): # tcc takes no part of a literal for a constant
            with open(source) as file:
                text = file.read().replace("PRECISION[0] == 'f'", 'sizeof(vm_real) == 4')
            with open(source, 'w') as file:
                file.write(text)
        for name in HEADERS:
            shutil.copy(f'{name}.h', folder)
        folders.put(folder)
    return folders


def in_copy(folders, work, *arguments):
    folder = folders.get()
    try:
        return work(folder, *arguments)
    finally:
        folders.put(folder)


def controls(folders, chosen, sources, programs, seconds):
    """As they are, the headers must pass; with |x| = -x they must not. The program is one that executes most lines."""
    wrong = {header: [re.sub(r'(#define VM_FABS\(x\)) .*', r'\1 (-(x))', line) for line in sources[header]]
             for header in HEADERS}
    for header in chosen:
        lines_of = Counter(name for names in programs[header].values() for name in names
                           if seconds[name] < SLOW and not flags_of(name))
        program = lines_of.most_common(1)[0][0]
        verdicts = [in_copy(folders, judge, sources, headers, [program], [], seconds) for headers in (sources, wrong)]
        if verdicts != ['survived', 'caught']:
            sys.exit(f'{header}.h: the controls are not as they must be: {verdicts}')


def known_equivalent(sources, owner):
    """{(header, line, line of the mutant)}, of tests/mutants.txt, where each line must be one of its header's own."""
    with open('tests/mutants.txt') as file:
        known = {tuple(line.split('\t')[:3]) for line in file if not line.startswith('#')}
    own = {(owner[header, number][0], text.strip()) for header in HEADERS
           for number, text in enumerate(sources[header], 1)}
    for header, line, _ in known:
        if (header, line) not in own:
            sys.exit(f'tests/mutants.txt: {header}.h has no such line: {line}')
    return known


def main():
    build, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    with open(f'{build}/coverage/map.json') as file:
        known = json.load(file)
    chosen = sys.argv[4:] or HEADERS
    sources = {header: open(f'{header}.h').read().split('\n') for header in HEADERS}
    codes = {header: code_of('\n'.join(sources[header])).split('\n') for header in chosen}
    executed = {}
    for header in chosen:
        now = moved(known['sources'][header], sources[header])
        executed[header] = {now[int(line)]: names for line, names in known['programs'][header].items()
                            if int(line) in now}
    places = {header: [(header, line) for line in sorted(executed[header]) if codes[header][line - 1].strip()]
              for header in chosen}
    mutants = []
    for header in chosen:
        rng = random.Random(f'{seed} {header}')
        mutants += [draw(rng, codes, places[header]) for _ in range(count)]
    owner, copies = owners(sources), {}
    folders, equivalent = prepared(build), known_equivalent(sources, owner)
    for place, first in owner.items():
        copies.setdefault(first, []).append(place)
    with ThreadPoolExecutor(WORKERS) as pool:
        controls(folders, chosen, sources, executed, known['seconds'])

        def verdict_of(mutant):
            header, line, kind, start, end, new = mutant
            old = sources[header][line - 1]
            text = old[:start] + new + old[end:]
            if (header, old.strip(), text.strip()) in equivalent:
                return 'equivalent', mutant, text
            wrong = {header: list(lines) for header, lines in sources.items()}
            for copy, place in copies[header, line]:
                wrong[copy][place - 1] = text
            programs = in_order(header, line, executed[header], known['seconds'])
            own = [name for name in programs if is_own(header, name) and not flags_of(name)][:2]
            return in_copy(folders, judge, sources, wrong, programs, own, known['seconds']), mutant, text

        verdicts = {header: Counter() for header in chosen}
        for k, (verdict, (header, line, kind, *_), text) in enumerate(pool.map(verdict_of, mutants), 1):
            verdicts[header][verdict] += 1
            print(f'{k} of {len(mutants)}: {header}.h:{line} {verdict}', file=sys.stderr, flush=True)
            if verdict == 'survived':
                print(f'{header}.h:{line}: {kind}', sources[header][line - 1].strip(), text.strip(), sep='\n    ',
                      flush=True)
    while not folders.empty(): # others may be at work beside
        shutil.rmtree(folders.get())
    enough = True
    for header, counts in verdicts.items():
        alive = counts['caught'] + counts['survived']
        share = 100 * counts['caught'] / alive if alive else 100
        enough = enough and share >= LEAST
        print(f'{header + ".h":14} {counts["caught"]} of {alive} caught, {share:.1f} %; '
              f'{counts["equivalent"]} known as equivalent, {counts["stillborn"]} do not compile')
    sys.exit(not enough)


main()
