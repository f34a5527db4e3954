#!/usr/bin/env python3
"""Lines and branches of the four headers that the tests execute, by clang's source-based coverage.

Every test program is built in double and float without optimisation and run, and as it is with fused multiply-adds:
some code is there with these and in optimised builds only. A line with nothing but a brace, a comment or a directive
is none. A branch is each of the two outcomes of a condition, && and || having one each side; conditions that the
compiler knows are none, nor are those of base/self_check.h: one side of each is taken only where a machine or an
option of the compiler is wrong, which tests/test_options.sh tries. What counts is the union over the programs, since
each of them has its own copies of the functions. A file of src/ that is copied into several headers counts for the
first of them (rooms.py).
BUILD/coverage/missed.txt lists what no program executes; BUILD/coverage/map.json, for mutate.py, which
programs execute a line, the most often first, how long they take, and the headers' text.

usage: coverage.py BUILD TEST... from the top of the project; ends with an error below LEAST percent
"""
import json
import os
import re
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

sys.dont_write_bytecode = True  # no folder beside the sources
from rooms import HEADERS, code_of, files_of, owners

LEAST = 98.0
MISCOMPILED = 'jacobi_ns(0, ' # the check that clang 14 miscompiles with counters at -O1 and fused multiply-adds
SELF_CHECK = 'VARMASS_BASE_SELF_CHECK_H'
EMPTY = re.compile(r'[\s{}]*')
CONSTANT = re.compile(r'[\s\d.+\-*/<>=!()]|VM_MANT_DIG|[DF]LT_\w+|VM_C|sizeof|vm_real|VM_EPSILON|1e')


def tool(name):
    """The tool of the clang that compiles, which may carry its version in its name."""
    version = re.search(r'version (\d+)', subprocess.check_output(['clang', '--version'], text=True))[1]
    return next(found for found in (f'{name}-{version}', name) if shutil.which(found))


def header_of(path):
    name = os.path.basename(path)
    return name[:-2] if name[:-2] in HEADERS and os.path.dirname(os.path.abspath(path)) == os.getcwd() else None


def measure(job):
    """One program: (name, seconds, {header: {line: count}}, {header: {span: [taken, not taken]}})."""
    folder, name, source, flags = job
    program, profile = f'{folder}/{name}', f'{folder}/{name}.profraw'
    subprocess.check_call(['clang', '-std=c99', '-w', '-fprofile-instr-generate', '-fcoverage-mapping', *flags,
                           source, '-o', program, '-lm'])
    start = time.monotonic()
    output = subprocess.run([program], env={**os.environ, 'LLVM_PROFILE_FILE': profile}, stdout=subprocess.PIPE,
                            text=True)
    seconds = time.monotonic() - start
    failures = [line for line in output.stdout.split('\n') if 'FAILED' in line]
    if output.returncode and not (name == 'jacobi_contracted' and len(failures) == 1 and MISCOMPILED in failures[0]):
        sys.exit(f'{name} fails: {output.stdout[-2000:]}')
    subprocess.check_call([tool('llvm-profdata'), 'merge', '-sparse', profile, '-o', program + '.profdata'])
    export = [tool('llvm-cov'), 'export', program, f'-instr-profile={program}.profdata']
    lines, branches, header = {}, {}, None
    for record in subprocess.check_output(export + ['-format=lcov'], text=True).split('\n'):
        if record.startswith('SF:'):
            header = header_of(record[3:])
        elif record.startswith('DA:') and header:
            line, count = record[3:].split(',')[:2]
            lines.setdefault(header, {})[int(line)] = int(count)
    for function in json.loads(subprocess.check_output(export))['data'][0]['functions']:
        for *span, taken, not_taken, file, _, _ in function['branches']:
            header = header_of(function['filenames'][file])
            if header:
                sides = branches.setdefault(header, {}).setdefault(tuple(span), [0, 0])
                sides[0] += taken
                sides[1] += not_taken
    for left in (program, profile, program + '.profdata'):
        os.remove(left)
    return name, seconds, lines, branches


def text_of(source, span):
    first, start, last, end = span
    if first == last:
        return source[first - 1][start - 1:end - 1]
    return ' '.join([source[first - 1][start - 1:], *source[first:last - 1], source[last - 1][:end - 1]])


def function_at(source, line):
    """The name of the function whose body holds this line: the last definition that starts in column one."""
    for text in reversed(source[:line]):
        found = re.match(r'(?:VM_API|VM_INLINE|static)\b.*?\b(\w+)\(', text) or re.match(r'#define (\w+)', text)
        if found:
            return found[1]
    return '?'


def report(folder, sources, lines, branches):
    missed, enough = open(f'{folder}/missed.txt', 'w'), True
    print(f'{"":14}{"lines":>7}{"missed":>8}{"":9}{"branches":>10}{"missed":>8}')
    for header in HEADERS:
        source = sources[header]
        code = code_of('\n'.join(source)).split('\n')
        for line in [line for line in lines[header] if EMPTY.fullmatch(code[line - 1])]:
            del lines[header][line]
        bare = [line for line, count in sorted(lines[header].items()) if not count]
        file_of = files_of(source)
        real = {span: sides for span, sides in branches[header].items()
                if CONSTANT.sub('', text_of(source, span)) and file_of.get(span[0], ('',))[0] != SELF_CHECK}
        half = [(span, side) for span, sides in sorted(real.items()) for side in (0, 1) if not sides[side]]
        share = [100 * (1 - len(bare) / len(lines[header])), 100 * (1 - len(half) / (2 * len(real)))]
        enough = enough and min(share) >= LEAST
        print(f'{header + ".h":14}{len(lines[header]):7}{len(bare):8}{share[0]:8.2f}%'
              f'{2 * len(real):10}{len(half):8}{share[1]:8.2f}%')
        for line in bare:
            print(f'{header}.h:{line}: {function_at(source, line)}: {source[line - 1].strip()}', file=missed)
        for span, side in half:
            print(f'{header}.h:{span[0]}:{span[1]}: {function_at(source, span[0])}: never {("true", "false")[side]}: '
                  f'{text_of(source, span)}', file=missed)
    return enough


def main():
    build, tests = sys.argv[1], sys.argv[2:]
    folder = f'{build}/coverage'
    os.makedirs(folder, exist_ok=True)
    jobs = [(folder, f'{test}{suffix}', f'tests/test_{test}.c', flags) for test in tests
            for suffix, flags in (('', ('-O0',)), ('_float', ('-O0', '-DVM_USE_FLOAT')),
                                  ('_contracted', ('-O1', '-march=native', '-ffp-contract=fast')))]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        measured = list(pool.map(measure, jobs))
    sources = {header: open(f'{header}.h').read().split('\n') for header in HEADERS}
    owner = owners(sources)
    lines, branches, programs = ({header: {} for header in HEADERS} for _ in range(3))
    for name, _, line_counts, sides in measured:
        for copy, counts in line_counts.items():
            for place, count in counts.items():
                header, line = owner[copy, place]
                lines[header][line] = lines[header].get(line, 0) + count
                if count:
                    programs[header].setdefault(line, []).append((count, name))
        for copy, spans in sides.items():
            for (start, column, end, end_column), (taken, not_taken) in spans.items():
                header, line = owner[copy, start]
                known = branches[header].setdefault((line, column, line + end - start, end_column), [0, 0])
                known[0] += taken
                known[1] += not_taken
    programs = {header: {line: [name for _, name in sorted(names, reverse=True)] for line, names in of_line.items()}
                for header, of_line in programs.items()}
    with open(f'{folder}/map.json', 'w') as file:
        json.dump({'seconds': {name: seconds for name, seconds, _, _ in measured}, 'programs': programs,
                   'sources': sources}, file)
    enough = report(folder, sources, lines, branches)
    print(f'{folder}/missed.txt names them')
    sys.exit(0 if enough else f'less than {LEAST} % of something')


main()
