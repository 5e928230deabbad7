# Each target is a line or two that can be typed by hand. tools/set_up.py creates .venv and updates it: each target
# installs only the packages that it needs.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
export PIP_DISABLE_PIP_VERSION_CHECK = 1

# Without PYTHON=… on the command line, an existing environment keeps its Python.
KEEP := $(if $(filter file,$(origin PYTHON)),--keep-python)
set_up = @$(PYTHON) -c 'import sys; v = sys.version_info; \
	sys.exit(v < (3, 10) and "set-up: tfloom needs Python 3.10 or newer, and $(PYTHON) is %d.%d: make PYTHON=python3.12 …" % v[:2])' \
	&& $(PYTHON) tools/set_up.py --venv "$(VENV)" $(KEEP) $(SET_UP)

.DEFAULT_GOAL := setup
.PHONY: help setup demo test test-slow test-ros test-all check stub generated ros-peer bench docs matrix platforms wheels dist licenses clean

# The targets, by the text after ## in the first line of each, and commands without a target, which begin with #>.
help: ## print this
	@sed -n 's/^\([a-z-]*\):.*## /\1|/p' $(firstword $(MAKEFILE_LIST)) | awk -F'|' '{ printf "make %-11s %s\n", $$1, $$2 }'
	@sed -n 's/^#> //p' $(firstword $(MAKEFILE_LIST))

#>
#> In the environment (.venv/bin/python):
#> tools/generated.py                   generate what is not in git, as make generated does
#> docs/tf_doctor.py                    refresh docs/tf_doctor.md after a change in the catalogue of tf doctor
#> -m benchmarks.bag.reading            measure the reading of recordings beside rosbags and mcap-ros2-support
#> -m benchmarks.rmw.discovery          measure discovery as nodes grow, on both wires; tools/discovery_plot.py draws it
#> -m benchmarks.node.budget            measure the parts of a round trip's time
#> -m benchmarks.node.before PYTHON     measure nodes beside those of another commit, in its environment
#> -m benchmarks.node.soak              start and end processes for minutes, and account for messages and memory
#> -m benchmarks.node.soak_vendors      the same on tfloom and Fast DDS, with processes that are killed
#> -m tests.ros_peer.compare KIND       compare with the real rclpy on random cases; --count 2000 --seed 0
#> -m tests.planted_mistakes --seed 1   plant mistakes, and print which ones no test finds
#> -m tests.fuzz.test_fuzz all 10000    fuzz what is read from outside; -m tests.native.test_fuzz fuzz_tf 60
#> tools/moving_picture.py GIF          record README's moving picture, in Debian's Chromium
#> tools/plots.py TEXT SVG              draw the picture of docs/fast.md from what `-m benchmarks tf2` prints
#>
#> .ci/run                              run the CI
#> .ci/bare FOLDER 'make demo'          run a command as on a machine that has never built tfloom
#> .ci/newest_dds                       try the newest DDS library, then add it to `tried_versions` in native/dds/library.cpp
#> .ci/newest_pages                     try the newest viser and foxglove-sdk that pyproject.toml admits

setup: ## create or update .venv for all of these, and compile a change in native/
	$(set_up) check

demo: ## see it work; ARGS="--seconds 20", or ARGS=robot for a robot that maps its room
	$(set_up) demo
	@"$(BIN)/tfloom" demo $(ARGS)

test: ## run the tests of everything that the README promises; ARGS="tests/tf2 -k static"
	$(set_up) test
	@"$(BIN)/python" tools/run_tests.py $(ARGS)

test-slow: ## run the slow tests: sanitizers, wheels, type checks of users' programs, soak
	$(set_up) check
	@"$(BIN)/python" tools/run_tests.py --slow $(ARGS)

# Run the tests beside the real rclpy, of Jazzy and Kilted. Where one has no wheels its tests are skipped, with the reason.
test-ros: ## run the tests beside the real rclpy on Fast DDS, of Jazzy and of Kilted, where it has wheels
	$(set_up) test
	@ROS_DISTRO=jazzy $(PYTHON) -m tools.ros_peer || test $$? = 3
	@ROS_DISTRO=kilted $(PYTHON) -m tools.ros_peer || test $$? = 3
	@"$(BIN)/python" tools/run_tests.py --ros $(ARGS)

test-all: test test-slow test-ros ## run all three

# Type checkers use one core each. One cache for each system, because mypy checks all anew where a cache is of another one.
check: ## lint, check the format, and check types as on Linux, Windows and macOS
	$(set_up) check
	"$(BIN)/ruff" check .
	"$(BIN)/ruff" format --check .
	@$(MAKE) --no-print-directory -j2 -k types-here types-win32 types-darwin types-tools types-of-users

.PHONY: types-here types-win32 types-darwin types-tools types-of-users
types-here:
	"$(BIN)/mypy"

types-win32 types-darwin: types-%:
	"$(BIN)/mypy" --platform $* --cache-dir .mypy_cache/$*

types-tools: types-here # whose cache it shares
	"$(BIN)/mypy" -p tools

types-of-users:
	"$(BIN)/basedpyright" --pythonpath "$(BIN)/python"

stub: ## refresh _native.pyi after a change in native/bindings/
	$(set_up) demo
	"$(BIN)/python" -m nanobind.stubgen -m tfloom._native -q \
		-p native/bindings/stub_patterns.txt -o src/tfloom/_native.pyi

generated: ## generate what is not in git: classes of messages, façades, manifests; other targets do so, too
	$(set_up) demo

ros-peer: ## install the real rclpy in build/ros-peer, as a peer of benchmarks and tests; ROS_DISTRO=kilted, that of Kilted
	@$(PYTHON) -m tools.ros_peer

# Peers that cannot be installed are named, and not measured.
bench: ## measure, beside peers; ARGS="drop_in", "zenoh", "view", "launch", "native", …
	$(set_up) test
	-$(set_up) bench
	-@$(PYTHON) -m tools.ros_peer
	"$(BIN)/python" -m benchmarks $(ARGS)

# Build the documentation as HTML pages, in build/docs; a warning is an error. It needs no network and no compiler.
docs: ## build the documentation in build/docs, without a compiler
	$(set_up) docs
	"$(BIN)/python" -m sphinx -q -W --keep-going -b html docs build/docs
	@echo "The pages begin at build/docs/index.html"

matrix: ## run the core tests on each Python of the machine; ARGS="3.10 3.13"
	.ci/matrix $(ARGS)

# Run tfloom on Debian testing, and on Debian 13 for arm64 by qemu, in chroots; needs root, and says what else.
platforms: ## run on other Debians, arm64 and musl in chroots (root); ARGS="--short arm64"
	$(set_up) demo
	@"$(BIN)/python" -m tools.platforms $(ARGS)

wheels: ## collect all downloads in wheels/, for a machine without a network
	$(set_up) wheels

dist: ## build the sdists and this system's wheels in dist/, and check them
	@$(PYTHON) -m tools.release

licenses: ## list the licences of dependencies; fail on one that is not accepted
	$(set_up) check
	@"$(BIN)/python" -m tools.licenses

clean: ## remove .venv, build and dist
	rm -rf "$(VENV)" build dist
