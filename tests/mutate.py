#!/usr/bin/env python3
"""Wrong headers that the tests are to notice: one token of a header changed at a time.

A mutant flips a sign, swaps * and /, turns a comparison round, swaps && and ||, doubles a constant, adds one to an
index or a count, or swaps the alternatives of a conditional. Lines are drawn from those that some test executes, by
the map that coverage.py leaves; the programs that execute the line are built and run, those that do most often first,
until one fails, ends with a signal or takes ten times its time. Where MANY programs pass, the mutant counts as a
survivor and is printed, to be judged: it is equivalent (the results are as good), or a test is missing.

usage: mutate.py BUILD SEED COUNT [HEADER] from the top of the project, after coverage.py
"""
import json
import os
import random
import re
import shutil
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

HEADERS = ('jacobi', 'ateb', 'integrators', 'varmass')
MANY = 6
LEAST = 90.0
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


def code_of(line):
    """The line with comments blanked, nothing of a preprocessor line or a comment's inside."""
    if re.match(r'\s*(#|/\*(?!.*\*/)|\*|[^"]*\*/$)', line) or 'VM_TABLE' in line and '{' not in line:
        return ''
    return re.sub(r'/\*.*?(\*/|$)|"[^"]*"', lambda m: ' ' * len(m[0]), line)


def draw(rng, sources, programs):
    """One mutant: (header, line, kind, new text); a kind of change first, so that rare ones come too."""
    while True:
        header = rng.choice(list(programs))
        line = rng.choice(programs[header])
        kind, pattern, new = rng.choice(CHANGES)
        text = sources[header][line - 1]
        found = list(re.finditer(pattern, code_of(text)))
        if found and re.search(r'[;{},]|\\$|&&|\|\|', text):
            at = rng.choice(found)
            put = new(at) if callable(new) else new
            return header, line, kind, text[:at.start()] + put + text[at.end():]


def flags_of(name):
    return ['-DVM_USE_FLOAT'] if name.endswith('_float') else \
        ['-march=native', '-ffp-contract=fast'] if name.endswith('_contracted') else []


def judge(job):
    """'caught', 'stillborn' (does not compile), or 'survived'."""
    folder, mutant, source, programs, seconds = job
    header, line, _, text = mutant
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for name in HEADERS: # copies, no links: ".." leads from a source to the mutant
        shutil.copy(f'{name}.h', folder)
    for name in ('tests', 'examples'):
        shutil.copytree(name, f'{folder}/{name}')
    with open(f'{folder}/{header}.h', 'w') as file:
        file.write('\n'.join(source[:line - 1] + [text] + source[line:]))
    order = sorted(programs, key=lambda name: bool(flags_of(name)))[:MANY] # double first
    verdict = 'survived'
    for name in order:
        test = re.sub(r'_(float|contracted)$', '', name)
        compile_it = ['gcc', '-std=c99', '-O1', '-w', *flags_of(name), f'tests/test_{test}.c', '-o', 'test', '-lm']
        if subprocess.run(compile_it, cwd=folder, stderr=subprocess.DEVNULL).returncode:
            verdict = 'stillborn'
            break
        try:
            if subprocess.run(['./test'], cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=10 + 10 * seconds[name]).returncode:
                verdict = 'caught'
                break
        except subprocess.TimeoutExpired:
            verdict = 'caught'
            break
    shutil.rmtree(folder)
    return verdict, mutant


def main():
    build, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    with open(f'{build}/coverage/map.json') as file:
        known = json.load(file)
    chosen = sys.argv[4:] or HEADERS
    sources = {header: open(f'{header}.h').read().split('\n') for header in chosen}
    executed = {header: {int(line): names for line, names in known['programs'][header].items()
                         if code_of(sources[header][int(line) - 1])} for header in chosen}
    rng = random.Random(seed)
    lines = {header: sorted(of_line) for header, of_line in executed.items()}
    mutants = [draw(rng, sources, lines) for _ in range(count)]
    jobs = [(f'{build}/mutants/{seed}-{k}', mutant, sources[mutant[0]], executed[mutant[0]][mutant[1]],
             known['seconds']) for k, mutant in enumerate(mutants)]
    verdicts = {header: Counter() for header in chosen}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for verdict, (header, line, kind, text) in pool.map(judge, jobs):
            verdicts[header][verdict] += 1
            if verdict == 'survived':
                print(f'{header}.h:{line}: {kind}', sources[header][line - 1].strip(), text.strip(), sep='\n    ',
                      flush=True)
    enough = True
    for header, counts in verdicts.items():
        alive = counts['caught'] + counts['survived']
        share = 100 * counts['caught'] / alive if alive else 100
        enough = enough and share >= LEAST
        print(f'{header + ".h":14} {counts["caught"]} of {alive} caught, {share:.1f} %; '
              f'{counts["stillborn"]} did not compile')
    sys.exit(not enough)


main()
