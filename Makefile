# varmass: nothing has to be built to use the headers. What a target needs beyond a C compiler is installed by apt-get as
# root, and for others where INSTALL=1 is set, by sudo. Else the command that would is printed, and what needs it is left out.
#
#   make headers  write the four headers from src/                make part PARTS="mechanics/jumps"   build/parts/jumps.h
#   make parts-table   lines and flash of each chapter taken alone, docs/parts.md
#   make run      build and run the examples, draw their figures        make bench   time everything (minutes)
#   make bench-quick   the same, roughly       make bench-count   count instructions       make cost   write docs/cost.md
#   make docs     write all documents whose numbers take minutes, and the marked numbers of the README and the manuals
#   make check-docs   fail where a document was written from other headers      make campaigns   the long checks, part by part
#   make test     the tests, three minutes       make test-all   the rest       make lint    strict warnings, gcc and clang
#   make scan     millions of random arguments (minutes)                make points SEED=n   20 000 fresh table points
#   make routes    random oscillators by all routes against exact motions, docs/routes.md (minutes)
#   make exhaustive   every float of a period (half an hour)            make data    write the reference tables anew
#   make figures  draw docs/figures                                     make measurements    write docs/measurements.md
#   make first-steps   short programs, docs/first-steps.md
#   make wasm      pages for the browser: build/wasm/play.html, what accuracy costs
#   make sweep     a Monte-Carlo of break-ups over all cores          make firmware-table   flash, stack, instructions
#   make firmware   a controller on an emulated Cortex-M4F           make scene-sizes    flash of scenes
#   make test-cross   the same bits and the tests on every target (hours)
#   make test-fuzz SECONDS=n   all functions fuzzed      make evaluations COUNT=n   n of each special function
#   make test-events RUNS=n   n random runs whose events coincide (a minute for 300000)
#   make test-refusals ROUNDS=n   each function n times with numbers of any size (three minutes for 100000)
#   make test-threads   everything from many threads, under ThreadSanitizer
#   make coverage   lines and branches that the tests execute       make test-mutate SEED=n MUTANTS=n   wrong headers
#   make test-sanitize   sanitizers, valgrind, static analysers      make proof   abstract interpretation by Frama-C
#   make proof-kernels KERNELS=full   error bounds by Gappa and Sollya, docs/proof.md (quick: a minute; full: twenty)
#   make install PREFIX=/usr/local   headers, pkg-config and CMake files     make amalgamation   build/amalgamation/varmass.h
#   make site     the reference in HTML, build/site/index.html
#   make packages   an Arduino and PlatformIO library, a release with its checksum, build/packages
#   make law       docs/law.md, the law of order five, with its figures
#   make toronto   the Toronto test set of initial value problems, docs/toronto.md
#   make validation   published numbers of other programs and papers beside ours, docs/validation.md
#   make tables   Tables 1 to 4 of the dissertation, row by row, docs/tables.md
#   make clean    remove build/

CC = cc
CFLAGS = -O2
SEED = 1
STRICT = -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wfloat-conversion -Wshadow -Wundef
COMPILE = $(CC) -std=c99 $(CFLAGS)
IN_BUILD = mkdir -p $(@D) && echo '*' >build/.gitignore

HEADERS = jacobi.h ateb.h integrators.h varmass.h
TESTS = jacobi elliptic_integrals ateb rk4 pairs adaptive dense events saved_runs faults coincidences attitude bodies jumps jumps2 relative inverse axle \
    jump_equations torque_free streams flow flow1 flow2 supply orbit drum drum_shaft lambert broken_rotor broken_rotor_stability \
    lagrange lagrange_jump pendulum constant_mass laws loads averaging slow_motion closed_law collocation routes ladder \
    duffing duffing_laws odd_force van_der_pol van_der_pol_law jeffcott jeffcott_motion pair forced periodic grounded_pair \
    diagnostics forces \
    scene_bodies scene_effects scene_mass scene_streams scene_links scene_joints scene_events scene_runs scenes \
    dissertation tables validation hard refusals_numerics refusals_bodies refusals_streams refusals_oscillators \
    refusals_slow \
    refusals_scenes null_pointers
# Scripts of make test (tests/test_NAME.sh), and those of make test-all; some are in both, called with "quick" by make test and
# with "rest" by make test-all, for what the quick part leaves out
SCRIPTS = headers readme documents promises errors parts golden errata install gsl hard_cases
LONG_SCRIPTS = readme headers projects golden snippets parts sanitize fuzz options first_steps scene_cost package plans languages \
    avr sweep guides site page resumed
EXAMPLES = table5 example1 example2 drum scenes dzhanibekov tumbling rocket dust slow resonance rotor pendulum solvable
TEST_PROGRAMS = $(TESTS:%=build/tests/double/%) $(TESTS:%=build/tests/float/%)
LOGS = $(SCRIPTS:%=build/tests/%.log) $(TESTS:%=build/tests/%.log)
LONG_LOGS = $(LONG_SCRIPTS:%=build/tests/all/%.log) $(TESTS:%=build/tests/all/%.log) build/tests/all/exhaustive_jacobi.log
JOBS = $(shell nproc 2>/dev/null || echo 2)
# A make of its own for the logs named, as many jobs at a time as there are processors unless `make -j N` says otherwise,
# then their sum. What does not compile leaves no log, which is a failure.
RUN_TESTS = @rm -f $(1); $(MAKE) -s -k $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS)) $(1) || :; sh tests/run.sh sum $(1)
TEST_FILES = build/command $(HEADERS) $(wildcard tests/*.h tests/data/*.h tests/hard/* examples/*.h examples/scenes/*.h)
GSL_CHECK = echo '\#include <gsl/gsl_sf.h>' | $(CC) -E -

.PHONY: headers part parts-table law duffing van-der-pol toronto tables validation test-events test-refusals test-readme scaling wasm first-steps sweep firmware firmware-table test-cross install uninstall amalgamation run test test-all scan routes points exhaustive lint bench measurements figures data clean bench-quick bench-count cost scene-sizes test-fuzz evaluations test-threads coverage test-mutate test-sanitize proof proof-kernels packages site docs check-docs campaigns counts hard-cases promises numbers peers test-gpu

headers:
	@mkdir -p build && echo '*' >build/.gitignore
	@for header in $(HEADERS); do awk -f src/headers.awk src/$$header >build/$$header || exit 1; \
	cmp -s build/$$header $$header && rm build/$$header || mv build/$$header $$header; done

# chapters and all that they need in one header, named after the first of them
PARTS = mechanics/jumps
part:
	@mkdir -p build && echo '*' >build/.gitignore
	sh src/part.sh build/parts/$(notdir $(firstword $(PARTS))).h $(PARTS)

# docs/parts.md: lines and flash of each chapter taken alone
parts-table:
	@sh tests/install.sh "command -v arm-none-eabi-gcc" gcc-arm-none-eabi libnewlib-arm-none-eabi
	sh src/parts_table.sh build >build/parts.md && mv build/parts.md docs/parts.md
	@$(STAMP) parts

# A document that a program writes ends with a stamp of the headers; bench/documents.txt lists these documents.
STAMP = sh bench/stamp.sh write
# Documents in the order in which they are written: the table of numbers is made from the others, and the numbers of the
# README and the manuals from it. Times need an idle machine and are not among them (make cost, make peers).
DOCUMENTS = counts hard-cases validation toronto law duffing van-der-pol first-steps figures parts-table firmware-table \
    scene-sizes measurements promises numbers
docs: headers
	+@for document in $(DOCUMENTS); do echo "docs: $$document"; $(MAKE) -s $$document >build/docs.log 2>&1 || \
	    { cat build/docs.log; echo "FAILED: make $$document"; exit 1; }; done
	@sh bench/stamp.sh refresh
	@sh tests/check_docs.sh . today

check-docs:
	@sh tests/check_docs.sh . today && echo "the documents are sound, and those of make docs are from today's headers"

# the long checks one after the other; those that passed with these headers are not run again
CAMPAIGNS = # names, none: all
campaigns:
	sh bench/campaigns.sh $(CAMPAIGNS)

counts: bench-count
	cp build/bench/count/counts.md docs/counts.md
	@$(STAMP) counts

hard-cases:
	CC="$(CC)" sh tests/test_hard_cases.sh build write
	@$(STAMP) hard-cases

promises: build/tests/promises.log
	sh bench/promises.sh build <bench/promises.md >build/promises.md && mv build/promises.md docs/promises.md
	@$(STAMP) promises

numbers:
	CC="$(CC)" sh bench/numbers.sh table >build/numbers.md && mv build/numbers.md docs/numbers.md
	@$(STAMP) numbers
	sh bench/numbers.sh write README.md docs/accuracy.md docs/cost.md docs/extending.md src/*.h src/*/*.h
	@$(MAKE) -s headers

peers:
	CC="$(CC)" sh bench/no_peer_wins.sh build
	@$(STAMP) peers

run: $(EXAMPLES:%=build/examples/%)
	@mkdir -p build/figures
	@for example in $(EXAMPLES); do echo; case $$example in rotor|pendulum|slow|resonance) end= ;; *) end=.csv ;; esac; \
	./build/examples/$$example build/figures/$$example$$end || exit 1; done
	@sh examples/figures.sh build/figures
	@sh examples/scenes.sh build/figures

# A line a program; all that they print, the tables of worst errors too, is in build/tests/NAME.log
test:
	+$(call RUN_TESTS,$(LOGS))

# What make test leaves out, and its programs again: as headers are used, included and compiled with the caller's code; and
# linked with headers that were compiled with fused multiply-adds; logs in build/tests/all
test-all:
	+$(call RUN_TESTS,$(LONG_LOGS))

lint: build/command
	@sh tests/install.sh -w "for the warnings of C++" "command -v g++" g++; \
	sh tests/install.sh -w "for the warnings of clang" "command -v clang++" clang; \
	sh tests/install.sh -w "for the test that compares with it" "$(GSL_CHECK)" libgsl-dev; sh tests/lint.sh build $(STRICT)

# bench/bench_NAME.c each; those of functions in float too, and as arrays like to be compiled
BENCHES = $(patsubst bench/bench_%.c,%,$(sort $(wildcard bench/bench_*.c))) jacobi_float ateb_float jacobi_wide ateb_wide
BENCH_PROGRAMS = $(BENCHES:%=build/bench/%)
bench: $(BENCH_PROGRAMS)
	@CC="$(CC)" FLAGS="$(CFLAGS)" sh bench/run.sh build/bench build/figures "" $(BENCHES)
	@$(TODAY) >build/bench/headers

bench-quick: $(BENCH_PROGRAMS)
	@CC="$(CC)" FLAGS="$(CFLAGS)" sh bench/run.sh build/bench/quick build/bench/quick quick $(BENCHES)

# instructions of a call, the same in every run
bench-count: build/bench/count/double build/bench/count/float
	@sh tests/install.sh "command -v valgrind" valgrind && CC="$(CC)" FLAGS="$(CFLAGS)" sh bench/count.sh build/bench/count

# the tables and figures of docs/cost.md from the last `make bench`, which it runs where these headers were not measured
TODAY = sh bench/stamp.sh of $(basename $(HEADERS))
cost:
	@[ "$$($(TODAY))" = "$$(cat build/bench/headers 2>/dev/null)" ] || $(MAKE) bench
	@sh bench/cost.sh build/bench build/figures docs/cost.md docs/figures
	@$(STAMP) cost

# a campaign of minutes: random arguments against quadruple precision (gcc with libquadmath)
scan: build/tests/scan build/tests/scan_float
	@mkdir -p build/campaigns/tables
	./build/tests/scan 1000000 >build/campaigns/tables/scan.log
	./build/tests/scan_float 1000000 >>build/campaigns/tables/scan.log
	@cat build/campaigns/tables/scan.log
	@sh bench/measurements.sh function build/campaigns/tables/scan.log <bench/scan.md >docs/scan.md && $(STAMP) scan

# a campaign of minutes: random oscillators by all routes against exact motions in long double
RUNS_OF_ROUTES = 2000
routes: build/tests/random_routes
	@mkdir -p build/campaigns/tables
	./build/tests/random_routes $(RUNS_OF_ROUTES) >build/campaigns/tables/routes.md || \
	    { cat build/campaigns/tables/routes.md; exit 1; }
	@grep 'passed,' build/campaigns/tables/routes.md
	@{ cat bench/routes.md; grep -v 'passed,' build/campaigns/tables/routes.md; } >docs/routes.md && $(STAMP) routes

# a campaign of half an hour: the float functions at every float of a period
EXHAUSTIVE = build/tests/exhaustive_jacobi build/tests/exhaustive_ateb
exhaustive: $(EXHAUSTIVE)
	for program in $(EXHAUSTIVE); do ./$$program 1 >$$program.out & done; wait
	{ cat bench/exhaustive.md; printf '\n```\n'; cat $(EXHAUSTIVE:%=%.out); printf '```\n'; } >docs/exhaustive.md
	@grep 'passed,' docs/exhaustive.md; [ "$$(grep -c ' passed, 0 failed' docs/exhaustive.md)" = 2 ]
	@$(STAMP) exhaustive

# a campaign of minutes: 20 000 points of each table and more, drawn anew and computed by mpmath
points: build/command
	@sh tests/install.sh "python3 -c 'import mpmath'" python3-mpmath
	mkdir -p build/points && python3 tests/gen/jacobi_reference.py 20 build/points $(SEED)
	python3 tests/gen/elliptic_integrals_reference.py 10 build/points $(SEED)
	python3 tests/gen/ateb_reference.py 23 $(SEED) build/points/ateb_table.h
	for flags in "" -DVM_USE_FLOAT "-O3 -march=native -ffp-contract=fast"; do for test in jacobi elliptic_integrals ateb; do \
	    $(COMPILE) $$flags -DPOINTS tests/test_$$test.c -o build/points/test -lm && ./build/points/test || exit 1; \
	    done; done

# a campaign of hours: the same bits and the tests on every target that can be had, with emulators
test-cross:
	sh tests/cross.sh build docs/cross.md $(TESTS)
	@$(STAMP) cross

# the golden program on a graphics processor; nvcc takes ten minutes
test-gpu:
	sh tests/gpu.sh build

# a bounded time of fuzzing, all targets together; then errors that are planted must be found
SECONDS = 240
test-fuzz:
	@sh tests/install.sh "command -v clang" clang; sh tests/fuzz/fuzz.sh build $(SECONDS)
	sh tests/fuzz/planted.sh build

# a campaign of minutes to hours: COUNT random evaluations of each special function, in both precisions; docs/evaluations.md.
# What was broken off goes on where it was. LINES="first last" runs these rows of the table alone.
COUNT = 10000000
LINES =
evaluations:
	@sh bench/evaluations.sh build $(COUNT) $(SEED) $(LINES)

# a campaign of minutes: random runs whose events coincide, jump or vanish, each known beforehand
RUNS = 1000000
test-events: build/tests/double/coincidences build/tests/float/coincidences
	for precision in double float; do ./build/tests/$$precision/coincidences $(RUNS) || exit 1; done

# a campaign of minutes: ROUNDS calls of each function with numbers of any size, which it must refuse or compute with
ROUNDS = 100000
REFUSALS = $(filter-out refusals_scenes,$(filter refusals_%,$(TESTS)))
test-refusals: $(REFUSALS:%=build/tests/double/%) $(REFUSALS:%=build/tests/float/%)
	@sh tests/run.sh one build/refusals.log $(foreach program,$^,"./$(program) $(ROUNDS)")
	@sh tests/run.sh sum build/refusals.log >build/refusals.sum

# everything from many threads at once, under ThreadSanitizer
test-threads:
	@sh tests/install.sh "command -v clang" clang
	@mkdir -p build/tests
	for precision in "" -DVM_USE_FLOAT; do \
	    clang -std=c99 -O1 -g -fsanitize=thread $$precision tests/threads.c -o build/tests/threads -lm -lpthread && \
	    ./build/tests/threads 8 20 || exit 1; done

# campaigns of minutes: what the tests execute, whether they notice wrong headers, what tools find in the headers
MUTANTS = 25 # of each header
MUTATED = # headers' names, none: all four
coverage:
	@sh tests/install.sh "command -v clang && (command -v llvm-cov || command -v llvm-cov-14)" clang llvm
	@mkdir -p build && $(IN_BUILD) && python3 tests/coverage.py build $(TESTS)
build/coverage/map.json:
	-$(MAKE) coverage
test-mutate: build/coverage/map.json
	python3 tests/mutate.py build $(SEED) $(MUTANTS) $(MUTATED)
PART = all # or run, valgrind, static; or gcc, memory, clang, valgrind, analyser, tidy, misra: one of them
test-sanitize:
	@sh tests/install.sh "command -v clang" clang; mkdir -p build && echo '*' >build/.gitignore; sh tests/sanitize.sh build $(PART) $(TESTS)
proof:
	@mkdir -p build && echo '*' >build/.gitignore; sh tests/eva.sh build
KERNELS = quick # or full, which takes twenty minutes
proof-kernels:
	@sh tests/install.sh "command -v gappa && command -v sollya" gappa sollya
	@sh tests/install.sh "python3 -c 'import mpmath'" python3-mpmath
	@mkdir -p build/proof && echo '*' >build/.gitignore
	python3 tests/proof/prove.py $(KERNELS) >build/proof/results || { cat build/proof/results; exit 1; }
	@cat build/proof/results
	@sed -e '/@RESULTS@/{' -e 'r build/proof/results' -e 'd' -e '}' bench/proof.md >docs/proof.md && $(STAMP) proof

# a controller on an emulated Cortex-M4F
CORTEX_M4F = -mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16
CORTEX_M = -nostartfiles -T tests/cross/cortex_m.ld -Wl,--defsym=FLASH_SIZE=0x40000,--defsym=RAM_SIZE=0x10000,--gc-sections \
    -ffunction-sections -fdata-sections
firmware:
	@sh tests/install.sh "command -v arm-none-eabi-gcc" gcc-arm-none-eabi libnewlib-arm-none-eabi
	@sh tests/install.sh "command -v qemu-system-arm" qemu-system-arm
	@mkdir -p build/firmware
	arm-none-eabi-gcc $(CORTEX_M4F) -std=c99 $(STRICT) -Os -fno-math-errno $(CORTEX_M) tests/cross/cortex_m.c examples/firmware/sieve.c \
	    -o build/firmware/sieve.elf -lm
	arm-none-eabi-size build/firmware/sieve.elf
	qemu-system-arm -M mps2-an386 -icount shift=10 -nographic -monitor none -serial none \
	    -semihosting-config enable=on,target=native -kernel build/firmware/sieve.elf </dev/null

firmware-table:
	@sh tests/install.sh "command -v arm-none-eabi-gcc" gcc-arm-none-eabi libnewlib-arm-none-eabi
	@sh tests/install.sh "command -v riscv64-unknown-elf-gcc" gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf
	@sh tests/install.sh "command -v qemu-system-arm && command -v qemu-system-riscv32" qemu-system-arm qemu-system-misc
	@sh tests/install.sh "command -v gnuplot" gnuplot-nox
	sh examples/firmware/table.sh build >build/firmware.md && mv build/firmware.md docs/firmware.md
	gnuplot -e "csv='build/firmware/table.csv'; svg='docs/figures/firmware.svg'" examples/firmware/table.gp
	@$(STAMP) firmware

# an oscillator for the browser: serve build/wasm
WASM = clang --target=wasm32-wasi --sysroot=/usr -std=c99 -ffp-contract=off -Oz -mexec-model=reactor -Wl,-s
wasm:
	@sh tests/install.sh "command -v clang && test -e /usr/lib/wasm32-wasi/libc.a && command -v node" \
	    clang lld wasi-libc libclang-rt-14-dev-wasm32 nodejs
	mkdir -p build/wasm && cp examples/wasm/index.html build/wasm
	$(WASM) examples/wasm/leaking.c -o build/wasm/leaking.wasm -lm
	$(WASM) examples/wasm/play.c -o build/wasm/play.wasm -lm
	wc -c build/wasm/leaking.wasm build/wasm/play.wasm
	node examples/wasm/leaking.mjs build/wasm/leaking.wasm
	base64 -w0 build/wasm/play.wasm >build/wasm/play.base64
	awk 'NR == FNR {program = $$0; next} {at = index($$0, "@WASM@")} \
	    at {print substr($$0, 1, at - 1) program substr($$0, at + 6); next} {print}' \
	    build/wasm/play.base64 examples/wasm/play.html >build/wasm/play.html

scene-sizes:
	@sh tests/install.sh "command -v arm-none-eabi-gcc" gcc-arm-none-eabi libnewlib-arm-none-eabi
	sh examples/firmware/scene_sizes.sh build >build/scene-sizes.md && mv build/scene-sizes.md docs/scene-sizes.md
	@$(STAMP) scene-sizes

# a Monte-Carlo of break-ups over all cores, and by MPI where it is
sweep:
	@sh tests/install.sh "command -v mpicc && command -v mpirun" openmpi-bin libopenmpi-dev && \
	mkdir -p build && mpicc -std=c99 $(CFLAGS) -fopenmp -DWITH_MPI examples/sweep/breakups.c -o build/breakups -lm || \
	$(COMPILE) -fopenmp examples/sweep/breakups.c -o build/breakups -lm
	./build/breakups 4000000 1 build/breakups.blocks

# a campaign of an hour: every command of the README, as it stands
test-readme:
	CC="$(CC)" sh tests/test_readme.sh build all

# how the sweep scales over threads and ranks, docs/scaling.md
scaling:
	@sh tests/install.sh "command -v mpicc && command -v mpirun" openmpi-bin libopenmpi-dev
	sh examples/sweep/scaling.sh build >build/scaling.md && mv build/scaling.md docs/scaling.md
	@$(STAMP) scaling

measurements: $(TESTS:%=build/tests/%.log)
	sh bench/measurements.sh bound $^ <bench/measurements.md >build/measurements.md && mv build/measurements.md docs
	@$(STAMP) measurements

figures: run
	for figure in $$(grep -o 'figures/[a-z0-9_]*\.svg' docs/figures.md); do cp "build/$$figure" docs/figures || exit 1; done
	@$(STAMP) figures

first-steps: build/command
	CC="$(CC)" sh examples/first_steps/steps.sh build write
	@$(STAMP) first-steps

# docs/law.md: the law of order five; its text is bench/law.md
law: build/law build/examples/solvable build/examples/law_as_data
	@sh tests/install.sh "command -v gnuplot" gnuplot-nox
	sh bench/law.sh build
	@$(STAMP) law
build/law: bench/law.c build/command $(HEADERS)
	$(COMPILE) bench/law.c -o $@ -lm
build/examples/law_as_data: examples/first_steps/18_law_as_data.c build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) -ffp-contract=off $< -o $@ -lm

# docs/duffing.md: Duffing's oscillator and other odd forces; its text is bench/duffing.md
duffing: build/duffing
	@sh tests/install.sh "command -v gnuplot" gnuplot-nox
	sh bench/duffing.sh build
	@$(STAMP) duffing
build/duffing: bench/duffing.c build/command $(HEADERS)
	$(COMPILE) bench/duffing.c -o $@ -lm

# docs/van-der-pol.md: the law of order three for Van der Pol's oscillator
van-der-pol: build/van_der_pol
	@sh tests/install.sh "command -v gnuplot" gnuplot-nox
	sh bench/van_der_pol.sh build
	@$(STAMP) van-der-pol
build/van_der_pol: bench/van_der_pol.c build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm

# docs/toronto.md: the Toronto test set, beside version 0.1 and DOP853
toronto: build/toronto
	./build/toronto markdown bench/toronto_before.csv >build/toronto.md && mv build/toronto.md docs/toronto.md
	@$(STAMP) toronto
build/toronto: bench/toronto.c bench/dop853.h tests/detest.h tests/data/detest_table.h build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm

# docs/validation.md: numbers that others have published, beside ours
validation: build/tests/double/validation
	./build/tests/double/validation markdown >build/validation.md && mv build/validation.md docs/validation.md
	@$(STAMP) validation

# docs/tables.md: Tables 1 to 4 of the dissertation, as printed and as they are true
tables: build/tests/double/tables
	./build/tests/double/tables markdown >build/tables.md && mv build/tables.md docs/tables.md

data:
	@sh tests/install.sh "python3 -c 'import mpmath'" python3-mpmath
	python3 tests/gen/ateb_reference.py
	python3 tests/gen/jacobi_reference.py
	python3 tests/gen/elliptic_integrals_reference.py
	python3 tests/gen/beta_reference.py
	python3 tests/gen/lambert_reference.py
	python3 tests/gen/drum_reference.py
	python3 tests/gen/drum_shaft_reference.py
	python3 tests/gen/elementary.py table
	python3 tests/gen/table5.py
	python3 tests/gen/order_conditions.py
	python3 tests/gen/attitude.py
	python3 tests/gen/rotation_reference.py
	python3 tests/gen/rotor_reference.py
	python3 tests/gen/supply.py
	python3 tests/gen/streams.py
	python3 tests/gen/lagrange_inverse.py
	python3 tests/gen/slow.py
	python3 tests/gen/jeffcott_reference.py
	python3 tests/gen/loads_reference.py
	python3 tests/gen/oscillator_reference.py
	python3 tests/gen/slow_motion.py
	python3 tests/gen/hard_reference.py
	@mkdir -p build && echo '*' >build/.gitignore
	$(COMPILE) tests/gen/routes_reference.c -o build/routes_reference -lm
	./build/routes_reference >tests/data/routes_table.h
	$(COMPILE) tests/gen/slow_motion_reference.c -o build/slow_motion_reference -lm
	./build/slow_motion_reference >build/slow_motions.h && mv build/slow_motions.h tests/data
	mkdir -p build && $(CC) -std=gnu99 -O2 tests/gen/detest_reference.c -o build/detest_reference -lquadmath -lm
	./build/detest_reference >build/detest_table.h && mv build/detest_table.h tests/data

# one file instead of four: the headers in place of their #include lines, what they share only once
amalgamation: build/amalgamation/varmass.h
build/amalgamation/varmass.h: src/headers.awk $(wildcard src/*.h src/*/*.h)
	@$(IN_BUILD) && mkdir -p $(@D) && awk -v whole=1 -f src/headers.awk src/varmass.h >$@

# a reference in HTML, with search, figures and guides: build/site/index.html; fails where Doxygen warns
site:
	@sh tests/install.sh -w "to write the reference" "command -v doxygen" doxygen
	rm -rf build/site && mkdir -p build/site && doxygen docs/site/Doxyfile

# a library for the Arduino IDE and PlatformIO, and a release with its checksum, under build/packages
packages: headers amalgamation
	@sh tests/install.sh -w "to compress a release" "command -v xz" xz-utils
	CC="$(CC)" sh examples/package/packages.sh build $(VERSION)

# headers under PREFIX/include/varmass, found by pkg-config and by CMake's find_package
PREFIX = /usr/local
INSTALLED = $(DESTDIR)$(PREFIX)
VERSION = $(shell awk '/define VARMASS_VERSION/ {gsub("\"", "", $$3); print $$3}' src/base/real.h)
install:
	mkdir -p $(INSTALLED)/include/varmass $(INSTALLED)/share/pkgconfig $(INSTALLED)/share/cmake/varmass
	cp $(HEADERS) $(INSTALLED)/include/varmass
	sed 's|@PREFIX@|$(PREFIX)|; s|@VERSION@|$(VERSION)|' examples/package/varmass.pc.in >$(INSTALLED)/share/pkgconfig/varmass.pc
	cp examples/package/varmassConfig.cmake $(INSTALLED)/share/cmake/varmass
	sed 's|@VERSION@|$(VERSION)|' examples/package/varmassConfigVersion.cmake.in \
	    >$(INSTALLED)/share/cmake/varmass/varmassConfigVersion.cmake
uninstall:
	rm -rf $(INSTALLED)/include/varmass $(INSTALLED)/share/cmake/varmass $(INSTALLED)/share/pkgconfig/varmass.pc

clean:
	rm -rf build

# changes when the compiler or its flags do, so that nothing is left from the ones before
build/command: FORCE
	@$(IN_BUILD) && echo '$(COMPILE)' | cmp -s - $@ || echo '$(COMPILE)' >$@
FORCE:

# The programs of make test. The headers are compiled once for all of them, with external functions; what is left of a
# program is small (tests/linked.h), and reads the headers without the functions' bodies (tests/declared.awk): those that it
# includes itself, or varmass.h where its own headers do. Warnings belong to make lint.
LINKED = -w -include tests/linked.h $$(sed -n 's|^\#include "\.\./\([a-z]*\.h\)".*|-include build/tests/declared/\1|p' $< | \
    grep . || echo "-include build/tests/declared/varmass.h")
DECLARED = tests/linked.h $(HEADERS:%=build/tests/declared/%)
build/tests/declared/%.h: %.h tests/declared.awk
	@$(IN_BUILD) && awk -f tests/declared.awk $< >$@

build/tests/double/headers.o: build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) -DVM_API= -x c -c varmass.h -o $@

build/tests/float/headers.o: build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) -DVM_USE_FLOAT -DVM_API= -x c -c varmass.h -o $@

build/tests/double/%: tests/test_%.c build/tests/double/headers.o $(DECLARED) $(TEST_FILES)
	@$(IN_BUILD) && $(COMPILE) -O1 -fno-inline $(LINKED) $< build/tests/double/headers.o -o $@ -lm

build/tests/float/%: tests/test_%.c build/tests/float/headers.o $(DECLARED) $(TEST_FILES)
	@$(IN_BUILD) && $(COMPILE) -O1 -fno-inline $(LINKED) -DVM_USE_FLOAT $< build/tests/float/headers.o -o $@ -lm

# The programs of make test-all: the headers included as users include them, in double; that such functions have the bits of
# those in one object, in both precisions, is checked by tests/test_golden.sh. make lint has compiled the objects already.
build/lint/double/%.o: tests/test_%.c $(TEST_FILES)
	@$(IN_BUILD) && gcc -std=c99 $(STRICT) -Wstrict-prototypes -Werror -I. -O2 -c $< -o $@

.PRECIOUS: build/lint/double/%.o
build/tests/all/double_%: build/lint/double/%.o
	@$(IN_BUILD) && gcc $< -o $@ -lm

# the promised bounds hold with fused multiply-adds wherever the compiler likes them: in the headers, compiled once, and in
# the programs that are linked with them (gcc fuses at -O1 only with -fexpensive-optimizations)
CONTRACTED = $(CC) -std=c99 -march=native -ffp-contract=fast
build/tests/contracted/headers.o: build/command $(HEADERS)
	@$(IN_BUILD) && $(CONTRACTED) -O3 -DVM_API= -x c -c varmass.h -o $@

build/tests/contracted/%: tests/test_%.c build/tests/contracted/headers.o $(DECLARED) $(TEST_FILES)
	@$(IN_BUILD) && $(CONTRACTED) -O1 -fexpensive-optimizations $(LINKED) $< build/tests/contracted/headers.o -o $@ -lm

$(TESTS:%=build/tests/%.log): build/tests/%.log: build/tests/double/% build/tests/float/% FORCE
	@sh tests/run.sh one $@ ./build/tests/double/$* ./build/tests/float/$*

$(TESTS:%=build/tests/all/%.log): build/tests/all/%.log: build/tests/contracted/% build/tests/all/double_% FORCE
	@sh tests/run.sh one $@ ./build/tests/contracted/$* ./build/tests/all/double_$*

$(SCRIPTS:%=build/tests/%.log): build/tests/%.log: tests/test_%.sh FORCE
	@$(IN_BUILD) && CC="$(CC)" sh tests/run.sh one $@ "sh $< build quick"

$(LONG_SCRIPTS:%=build/tests/all/%.log): build/tests/all/%.log: tests/test_%.sh FORCE
	@$(IN_BUILD) && CC="$(CC)" sh tests/run.sh one $@ "sh $< build $(if $(filter $*,$(SCRIPTS)),rest)"

# what these read of the programs above
build/tests/headers.log: build/tests/double/headers.o build/tests/float/headers.o
build/tests/hard_cases.log: build/tests/double/hard build/tests/float/hard
build/tests/documents.log: build/tests/double/validation build/tests/double/tables
build/tests/promises.log: $(patsubst %,build/tests/%.log,$(shell sed -n '/^programs="/,/"$$/p' tests/test_promises.sh | sed 's/programs=//' | tr -d '"'))

build/tests/all/exhaustive_jacobi.log: build/tests/exhaustive_jacobi FORCE
	@$(IN_BUILD) && sh tests/run.sh one $@ "./$< 997"

build/tests/exhaustive_%: tests/exhaustive_%.c tests/exhaustive_double.c tests/exhaustive.h tests/every_float.h $(TEST_FILES)
	@$(IN_BUILD) && $(COMPILE) -c tests/exhaustive_double.c -o $@.o && $(COMPILE) $< $@.o -o $@ -lm

build/tests/random_routes: tests/random_routes.c $(wildcard tests/gen/*.h) $(TEST_FILES)
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm

build/tests/scan: tests/scan.c tests/quad.h $(TEST_FILES)
	@$(IN_BUILD) && $(CC) -std=gnu99 -ffp-contract=off $(CFLAGS) $< -o $@ -lquadmath -lm

build/tests/scan_float: tests/scan.c tests/quad.h $(TEST_FILES)
	@$(IN_BUILD) && $(CC) -std=gnu99 -ffp-contract=off $(CFLAGS) -DVM_USE_FLOAT $< -o $@ -lquadmath -lm

build/examples/%: examples/%.c build/command $(wildcard examples/*.h examples/scenes/*.h) $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm

# with GSL's functions beside ours where GSL is there, with errors where the compiler has quadruple precision
BENCH_FILES = build/bench/exact.o $(wildcard bench/*.h tests/data/*.h) build/command $(HEADERS)
COMPILE_BENCH = $(IN_BUILD) && if sh tests/install.sh "$(GSL_CHECK)" libgsl-dev; then gsl="-DWITH_GSL -lgsl -lgslcblas"; fi; \
    if $(QUAD_CHECK); then quad="-DWITH_QUAD -lquadmath"; fi; \
    $(CC) -std=c99 -DTOPIC='"$(@F)"' $< build/bench/exact.o -o $@ $$gsl $$quad -lm
QUAD_CHECK = echo '\#include <quadmath.h>' | $(CC) -E - >/dev/null 2>&1
build/bench/exact.o: bench/exact.c bench/exact.h tests/quad.h build/command
	@$(IN_BUILD) && if $(QUAD_CHECK); then quad=-DWITH_QUAD; fi; $(CC) -std=gnu99 -O2 -ffp-contract=off $$quad -c $< -o $@

build/bench/%: bench/bench_%.c $(BENCH_FILES)
	@$(COMPILE_BENCH) $(CFLAGS)

build/bench/%_float: bench/bench_%.c $(BENCH_FILES)
	@$(COMPILE_BENCH) $(CFLAGS) -DVM_USE_FLOAT

build/bench/%_wide: bench/bench_%.c $(BENCH_FILES)
	@$(COMPILE_BENCH) -O3 -march=native -fno-math-errno

build/bench/count/double: bench/count.c build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm

build/bench/count/float: bench/count.c build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) -DVM_USE_FLOAT $< -o $@ -lm
