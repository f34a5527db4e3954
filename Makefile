# varmass: nothing has to be built to use the headers. Every target that needs more than a C compiler sets it up through
# the system's package manager where it may, and says so where it may not.
#
#   make run      build and run the examples, draw their figures        make bench   time everything
#   make test     all tests                                             make lint    strict warnings, gcc and clang
#   make scan     millions of random arguments (minutes)                make points SEED=n   20 000 fresh table points
#   make exhaustive   every float of a period (minutes)                 make data    write the reference tables anew
#   make figures  draw docs/figures                                     make measurements    write docs/measurements.md
#   make clean    remove build/

CC = cc
CFLAGS = -O2
SEED = 1
STRICT = -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wdouble-promotion -Wfloat-conversion -Wshadow -Wundef
COMPILE = $(CC) -std=c99 $(CFLAGS)
IN_BUILD = mkdir -p $(@D) && echo '*' >build/.gitignore

HEADERS = jacobi.h ateb.h integrators.h varmass.h
TESTS = jacobi ateb integrators events varmass dissertation oscillator routes
EXAMPLES = table5 example1 example2
TEST_PROGRAMS = $(TESTS:%=build/tests/double/%) $(TESTS:%=build/tests/float/%) \
    build/tests/contracted/jacobi build/tests/contracted/ateb build/tests/contracted/integrators build/tests/contracted/events
TEST_FILES = build/command $(HEADERS) tests/check.h examples/envelope.h examples/table5_data.h $(wildcard tests/data/*.h)
GSL_CHECK = echo '\#include <gsl/gsl_sf.h>' | $(CC) -E -

.PHONY: run test scan points exhaustive lint bench measurements figures data clean

run: $(EXAMPLES:%=build/examples/%)
	@mkdir -p build/figures
	@./build/examples/table5
	@echo; ./build/examples/example1 build/figures/example1.csv
	@echo; ./build/examples/example2 build/figures/example2.csv
	@sh examples/figures.sh build/figures

test: $(TEST_PROGRAMS) build/tests/exhaustive_jacobi
	@if sh tests/install.sh "$(GSL_CHECK)" libgsl-dev; then \
	    $(COMPILE) tests/test_gsl.c -o build/tests/gsl -lgsl -lgslcblas -lm && gsl=./build/tests/gsl; \
	else gsl="echo 'GSL: 0 passed, 0 failed, 9 skipped'"; fi; \
	CC="$(CC)" sh tests/run.sh build/tests/log "sh tests/test_headers.sh build" "sh tests/test_plans.sh build" \
	    $(TEST_PROGRAMS) "./build/tests/exhaustive_jacobi 997" "$$gsl"

lint:
	@sh tests/install.sh "command -v g++" g++; sh tests/install.sh "command -v clang++" clang; \
	sh tests/install.sh "$(GSL_CHECK)" libgsl-dev; $(MAKE) -s build/command; sh tests/lint.sh build $(STRICT)

BENCHES = double float jacobi ateb ateb_float ateb_wide integrators pairs
bench: $(BENCHES:%=build/bench/%)
	@for bench in $(BENCHES); do ./build/bench/$$bench build/bench/$$bench.csv || exit 1; echo; done
	@sh bench/plot_integrators.sh build/bench

# a campaign of minutes: random arguments against quadruple precision (gcc with libquadmath)
scan: build/tests/scan build/tests/scan_float
	./build/tests/scan 1000000
	./build/tests/scan_float 1000000

# a campaign of minutes: the float functions at every float of a period
EXHAUSTIVE = build/tests/exhaustive_jacobi build/tests/exhaustive_ateb
exhaustive: $(EXHAUSTIVE)
	{ printf '# Every float of a period\n\nWritten by `make exhaustive`.\n\n```\n'; ./build/tests/exhaustive_jacobi 1; \
	for alpha in 0 0.5 1.5 3 33.3; do ./build/tests/exhaustive_ateb $$alpha; done; printf '```\n'; } >docs/exhaustive.md
	! grep -E 'FAILED|[1-9][0-9]* failed' docs/exhaustive.md

# a campaign of minutes: 20 000 points of each table and more, drawn anew and computed by mpmath
points: build/command
	@sh tests/install.sh "python3 -c 'import mpmath'" python3-mpmath
	mkdir -p build/points && python3 tests/gen/jacobi_reference.py 20 build/points $(SEED)
	python3 tests/gen/ateb_reference.py 23 $(SEED) build/points/ateb_table.h
	for flags in "" -DVM_USE_FLOAT "-O3 -march=native -ffp-contract=fast"; do for test in jacobi ateb; do \
	    $(COMPILE) $$flags -DPOINTS tests/test_$$test.c -o build/points/test -lm && ./build/points/test || exit 1; \
	    done; done

measurements: $(TEST_PROGRAMS) build/tests/scan build/tests/scan_float $(BENCHES:%=build/bench/%)
	sh bench/measurements.sh build

figures: run
	cp build/figures/example1_trigonometric.svg docs/figures/

data:
	@sh tests/install.sh "python3 -c 'import mpmath'" python3-mpmath
	python3 tests/gen/ateb_reference.py
	python3 tests/gen/jacobi_reference.py
	python3 tests/gen/beta_reference.py
	python3 tests/gen/elementary.py table
	python3 tests/gen/table5.py
	python3 tests/gen/order_conditions.py

clean:
	rm -rf build

# changes when the compiler or its flags do, so that nothing is left from the ones before
build/command: FORCE
	@$(IN_BUILD) && echo '$(COMPILE)' | cmp -s - $@ || echo '$(COMPILE)' >$@
FORCE:

build/tests/double/%: tests/test_%.c $(TEST_FILES)
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm

# the promised bounds hold with fused multiply-adds wherever the compiler likes them
build/tests/contracted/%: tests/test_%.c $(TEST_FILES)
	@$(IN_BUILD) && $(CC) -std=c99 -O3 -march=native -ffp-contract=fast $< -o $@ -lm

build/tests/float/%: tests/test_%.c $(TEST_FILES)
	@$(IN_BUILD) && $(COMPILE) -DVM_USE_FLOAT $< -o $@ -lm

build/tests/exhaustive_%: tests/exhaustive_%.c tests/exhaustive_double.c tests/exhaustive.h $(TEST_FILES)
	@$(IN_BUILD) && $(COMPILE) -c tests/exhaustive_double.c -o $@.o && $(COMPILE) $< $@.o -o $@ -lm

build/tests/scan: tests/scan.c $(TEST_FILES)
	@$(IN_BUILD) && $(CC) -std=gnu99 -ffp-contract=off $(CFLAGS) $< -o $@ -lquadmath -lm

build/tests/scan_float: tests/scan.c $(TEST_FILES)
	@$(IN_BUILD) && $(CC) -std=gnu99 -ffp-contract=off $(CFLAGS) -DVM_USE_FLOAT $< -o $@ -lquadmath -lm

build/examples/%: examples/%.c build/command examples/envelope.h examples/table5_data.h $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm

# with GSL's functions beside ours where GSL is there
build/bench/jacobi build/bench/ateb build/bench/integrators: build/bench/%: bench/bench_%.c $(wildcard bench/*.h) \
    build/command $(HEADERS)
	@$(IN_BUILD) && if sh tests/install.sh "$(GSL_CHECK)" libgsl-dev; then gsl="-DWITH_GSL -lgsl -lgslcblas"; fi; \
	$(COMPILE) $< -o $@ $$gsl -lm

build/bench/double: bench/bench.c bench/timing.h build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm

build/bench/float: bench/bench.c bench/timing.h build/command $(HEADERS)
	@$(IN_BUILD) && $(COMPILE) -DVM_USE_FLOAT $< -o $@ -lm

build/bench/ateb_float: bench/bench_ateb.c build/command ateb.h
	@$(IN_BUILD) && $(COMPILE) -DVM_USE_FLOAT $< -o $@ -lm

build/bench/ateb_wide: bench/bench_ateb.c build/command ateb.h
	@$(IN_BUILD) && $(CC) -std=c99 -O3 -march=native -fno-math-errno $< -o $@ -lm

build/bench/pairs: bench/pairs.c build/command
	@$(IN_BUILD) && $(COMPILE) $< -o $@ -lm
