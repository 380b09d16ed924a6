# A thin front: what is built and how is in CMakePresets.json, what it needs in scripts/setup.sh.
# Variables: JOBS (default: all processors), PREFIX (install), CMAKE_ARGS (to configure, e.g. -DGRAZE_WERROR=ON),
# CTEST_ARGS (e.g. "-R narrow"), GRAZE_NO_SETUP=1 (install no packages), QUICK=1 (test, test-lab, bench) and
# POSES=file.csv (bench).
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
CMAKE_ARGS ?=
CTEST_ARGS ?=

.DEFAULT_GOAL := help
# One thing at a time even under `make -j`: the targets share build trees, and each runs in parallel by itself.
.NOTPARALLEL:

sources = $(shell find $(wildcard include src bindings apps tests fuzz bench examples) -name '*.hpp' -o -name '*.cpp')
configure = cmake --preset $(1) $(CMAKE_ARGS)
build = cmake --build --preset $(1) --parallel $(JOBS)
check = ctest --preset $(1) --parallel $(JOBS) $(CTEST_ARGS)

.PHONY: help
help: ## show this list
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 16

# In a tree of its own, which is built for this machine's processor alone and lightly optimised: a newcomer waits for it.
# The library that is installed and measured has all levels of the instruction set (`make install`).
.PHONY: demo
demo: ## build the program, collide an example scene, draw the contacts, and play it
	@scripts/setup.sh demo
	$(call configure,demo)
	$(call build,demo)
	build/demo/bin/graze collide examples/scenes/demo.gltf --out build/demo/contacts.glb --svg build/demo/contacts.svg
	build/demo/bin/graze simulate examples/scenes/demo.gltf --seconds 5 --out build/demo/moved.glb --svg build/demo/moved.svg
	@echo "The picture:           $(CURDIR)/build/demo/contacts.svg  (any web browser)"
	@echo "The scene in 3D:       $(CURDIR)/build/demo/contacts.glb  (any glTF viewer)"
	@echo "Before and after:      $(CURDIR)/build/demo/moved.svg"
	@echo "The scene in motion:   $(CURDIR)/build/demo/moved.glb"

.PHONY: test
test: ## build everything and run all tests (QUICK=1: without those of tests/long.txt)
	@scripts/setup.sh test
	$(call configure,release)
	$(call build,release)
	$(call check,release) $(if $(QUICK),-E "$$(grep -v -e '^#' -e '^$$' tests/long.txt | paste -s -d '|')")

.PHONY: asan
asan: ## the tests again, by clang, with address and undefined-behaviour sanitizers
	@scripts/setup.sh test fuzz
	$(call configure,asan)
	$(call build,asan)
	$(call check,asan)

.PHONY: tsan
tsan: ## the tests again, with the thread sanitizer
	@scripts/setup.sh test
	$(call configure,tsan)
	$(call build,tsan)
	$(call check,tsan)

# Without the scenes of EveryBroadPhase, which have one thread and would take three fifths of the time.
.PHONY: threads
threads: ## the tests that use threads, with the thread sanitizer
	@scripts/setup.sh test
	$(call configure,tsan)
	$(call build,tsan) --target test_broad test_world test_tbb
	$(call check,tsan) -L '^(broad|world|tbb)$$' -E EveryBroadPhase

.PHONY: clang
clang: ## the tests again, built by clang
	@scripts/setup.sh test fuzz
	$(call configure,clang)
	$(call build,clang)
	$(call check,clang)

# The same bits everywhere: a long run's are compared with those of this processor.
.PHONY: arm
arm: ## build for 64-bit ARM and compare its answers, in an emulator
	@scripts/setup.sh arm
	$(call configure,arm)
	$(call build,arm)
	$(call check,arm)

# Emscripten's own scripts look for Debian's modules, wherever this machine's Node comes from.
.PHONY: wasm
wasm: export NODE_PATH := /usr/share/nodejs
wasm: ## build for WebAssembly and compare its answers, in Node
	@scripts/setup.sh wasm
	$(call configure,wasm)
	$(call build,wasm)
	$(call check,wasm)

# A Windows of its own below build/windows/wine; no display is needed.
.PHONY: windows
windows: ## build for Windows with mingw-w64 and run the tests, under Wine
	@scripts/setup.sh windows
	$(call configure,windows)
	$(call build,windows)
	$(call check,windows)

# Debian's interpreter and NumPy, whatever stands first on the path. In the tree of `make test`: the library is built once.
.PHONY: python
python: ## build the Python package and run its tests
	@scripts/setup.sh python
	$(call configure,release) -DGRAZE_BUILD_PYTHON=ON
	$(call build,release) --target graze_python
	PYTHONPATH=build/release/python /usr/bin/python3 -m pytest -q -p no:cacheprovider tests/python

# The npm package answers for the lab: it is built where it is not there yet.
.PHONY: lab
lab: ## build the lab, a web application, into apps/lab/dist
	@scripts/setup.sh lab
	@test -e bindings/js/dist/double.js || $(MAKE) npm
	@cd apps/lab && { test node_modules/.package-lock.json -nt package-lock.json || npm ci --no-fund --no-audit; }
	cd apps/lab && npm run build

# The programs that the lessons show are linked with the library of `make test` and run in the module of `make python`,
# where these have been built; without them C++ is compiled only, and Python left out. The npm package is packed and
# installed here, since npm, Vite and a TypeScript of today are the lab's. QUICK=1 opens half of the pages.
.PHONY: test-lab
test-lab: lab ## the lab's tests: the lessons' programs, the pages in headless Chromium, and the npm package in a bundle
	node --test tests/js/package.test.js
	cd apps/lab && LIBGRAZE=$(abspath $(wildcard build/release/src/libgraze.a)) \
	  PYTHONPATH=$(abspath $(wildcard build/release/python)) QUICK=$(QUICK) npm test

# Judges nothing: times on a machine with other work say little, and the browser has no graphics card.
.PHONY: measure-lab
measure-lab: lab ## measure the lab in headless Chromium: first drawing, a drag, a thousand boxes
	cd apps/lab && node tests/measure.mjs

.PHONY: lab-pictures
lab-pictures: lab ## make the pictures of the lab below docs/ anew
	cd apps/lab && node tests/pictures.mjs

# LAB=folder takes a lab that was built elsewhere, LAB=none leaves it out. The pages of docs/, the API reference, the
# tables, the lessons and what searches them: static files for any host.
LAB ?= apps/lab/dist
.PHONY: site
site: $(if $(filter apps/lab/dist,$(LAB)),lab) ## write the site below build/site (LAB=none: without the lab)
	@scripts/setup.sh site
	/usr/bin/python3 docs/site/build.py --out build/site --lab $(LAB)

# The back end stands in bindings/python/graze_build.py; pip fetches nothing.
.PHONY: wheel
wheel: ## build a wheel of the Python package below build/wheel, and try it in an environment of its own
	@scripts/setup.sh python
	$(call configure,release) -DGRAZE_BUILD_PYTHON=ON
	JOBS=$(JOBS) /usr/bin/python3 -m pip wheel . --no-build-isolation --no-deps --no-index --wheel-dir build/wheel
	/usr/bin/python3 -m venv --clear --system-site-packages build/wheel/tried
	build/wheel/tried/bin/pip install --quiet --no-index --no-deps --force-reinstall build/wheel/*.whl
	cd build/wheel && tried/bin/python -m pytest -q -p no:cacheprovider ../../tests/python

# In the tree of `make test`. Ranks share the processors, however few there are.
.PHONY: test-mpi
test-mpi: ## install MPI, build what runs on many machines, and run its tests
	@scripts/setup.sh mpi
	$(call configure,release)
	$(call build,release) --target graze_mpi_tests
	$(call check,release) -L '^mpi$$'

# The directory bindings/js/dist is the package, for others to depend on by its path.
.PHONY: npm
npm: export NODE_PATH := /usr/share/nodejs
npm: ## build the npm package, test it in Node and headless Chromium, and pack it
	@scripts/setup.sh npm
	$(call configure,npm)
	$(call build,npm)
	rm -rf bindings/js/dist && cp -r build/npm/package bindings/js/dist
	node --expose-gc --test tests/js/node.test.js tests/js/browser.test.js
	tar -czf build/npm/graze.tgz -C build/npm package
	@bindings/js/sizes.sh bindings/js/dist

.PHONY: fuzz
fuzz: ## run each fuzzer for a short while
	@scripts/setup.sh test fuzz
	$(call configure,asan)
	$(call build,fuzz)
	$(call check,fuzz)

# In the tree of the release, whose library is measured as it is. QUICK=1: two minutes instead of a quarter of an hour,
# written below build/. POSES=file.csv: a pile of one's own.
.PHONY: bench
bench: ## measure, beside Bullet, ODE, FCL and Embree, and write bench/RESULTS.md
	@scripts/setup.sh test bench
	$(call configure,bench)
	$(call build,bench)
	@bench/results.sh $(if $(QUICK),--quick) $(if $(POSES),--poses $(POSES))

.PHONY: bench-resolution
bench-resolution: ## run the solver's table beside Bullet and ODE, and write bench/RESOLUTION.md (QUICK=1: without piles)
	@scripts/setup.sh bench
	$(call configure,bench)
	cmake --build --preset bench --parallel $(JOBS) --target bench_resolution bench_plane
	@build/release/bin/bench_resolution $(if $(QUICK),--quick) > build/RESOLUTION.md
	@build/release/bin/bench_plane --scene . $(if $(QUICK),--scale 0.2 --steps 100) >> build/RESOLUTION.md
	@mv build/RESOLUTION.md bench/RESOLUTION.md

.PHONY: bench-python
bench-python: ## measure batches of boxes from Python beside C++, and questions about one pair
	@scripts/setup.sh bench python
	$(call configure,bench) -DGRAZE_BUILD_PYTHON=ON
	cmake --build --preset bench --parallel $(JOBS) --target bench_boxes graze_python
	@PYTHONPATH=build/release/python /usr/bin/python3 bench/python.py --boxes build/release/bin/bench_boxes

.PHONY: accuracy
accuracy: ## measure the largest errors, beside Bullet, ODE and FCL, and write bench/ACCURACY.md
	@scripts/setup.sh bench
	$(call configure,bench)
	cmake --build --preset bench --parallel $(JOBS) --target bench_accuracy
	@build/release/bin/bench_accuracy > build/ACCURACY.md
	@mv build/ACCURACY.md bench/ACCURACY.md

# Two milliseconds a pair and thread, nearly all of them for the truth: minutes for 2,000 of each two kinds.
PAIRS ?= 2000
.PHONY: extremes
extremes: ## measure the errors of hard pairs (PAIRS=2000 of each two kinds), and write bench/EXTREMES.md
	@scripts/setup.sh bench
	$(call configure,bench)
	cmake --build --preset bench --parallel $(JOBS) --target bench_extremes
	@build/release/bin/bench_extremes --pairs $(PAIRS) > build/EXTREMES.md
	@mv build/EXTREMES.md bench/EXTREMES.md

.PHONY: format
format: ## format all sources in place
	@scripts/setup.sh lint
	clang-format -i $(sources)

# clang-tidy reads the flags from the tree of the clang preset, since it does not know all of g++'s.
.PHONY: lint
lint: ## check the format, and the library and programs with clang-tidy
	@scripts/setup.sh lint
	clang-format --dry-run -Werror $(sources)
	@! LC_ALL=C.UTF-8 grep -HnE '^.{121,}$$' $(sources) | grep -E '^[^:]*:[0-9]*: *//' || { echo 'comments of over 120 columns'; exit 1; }
	$(call configure,clang)
	run-clang-tidy -quiet -p build/clang -j $(JOBS) '$(CURDIR)/(src|apps)/'

# A tree that exists stays as configured; a new one is made without tests, whose packages an install does not need.
# `make test` puts them in.
.PHONY: install
install: ## install library, headers and program below PREFIX (default /usr/local)
	@scripts/setup.sh demo
	@test -f build/release/build.ninja || \
	  cmake --preset release -DGRAZE_BUILD_TESTS=OFF -DGRAZE_BUILD_EXAMPLES=OFF $(CMAKE_ARGS)
	$(call build,release) --target graze_installed
	cmake --install build/release --prefix $(PREFIX)

.PHONY: abi
abi: ## compare the binary interface of graze.h with the one recorded in bindings/c/abi.xml
	@scripts/setup.sh abi
	bindings/c/abi.sh

# Taken apart below build/package/root and run from there, as on a machine that has nothing of this tree.
.PHONY: package
package: ## write Debian packages (library, -dev, program, Python) below build/package, and try them
	@scripts/setup.sh package
	$(call configure,package)
	$(call build,package)
	cd build/package && cpack -G DEB
	tests/package/run.sh build/package

.PHONY: clean
clean: ## remove everything that was built
	rm -rf build
