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

.PHONY: setup demo test test-slow test-ros test-all check stub generated ros-peer bench docs matrix platforms wheels dist licenses clean

setup:
	$(set_up) check

demo:
	$(set_up) demo
	@"$(BIN)/tfloom" demo $(ARGS)

# Test everything that the README promises, in some minutes.
test:
	$(set_up) test
	@"$(BIN)/python" tools/run_tests.py $(ARGS)

# Run the slow tests: sanitizers, wheels, type checks of users' programs, bare machines, soak.
test-slow:
	$(set_up) check
	@"$(BIN)/python" tools/run_tests.py --slow $(ARGS)

# Run the tests beside the real rclpy. Where it has no wheels they are skipped, with the reason.
test-ros:
	$(set_up) test
	@$(PYTHON) -m tools.ros_peer || test $$? = 3
	@"$(BIN)/python" tools/run_tests.py --ros $(ARGS)

test-all: test test-slow test-ros

# Each system has a cache of its own, because mypy checks all anew where a cache is of another one.
check:
	$(set_up) check
	"$(BIN)/ruff" check .
	"$(BIN)/ruff" format --check .
	"$(BIN)/mypy"
	"$(BIN)/mypy" --platform win32 --cache-dir .mypy_cache/win32
	"$(BIN)/mypy" --platform darwin --cache-dir .mypy_cache/darwin
	"$(BIN)/mypy" -p tools
	"$(BIN)/basedpyright" --pythonpath "$(BIN)/python"

# Generate the type stub of the extension, after a change in native/bindings.
stub:
	$(set_up) demo
	"$(BIN)/python" -m nanobind.stubgen -m tfloom._native -q \
		-p native/bindings/stub_patterns.txt -o src/tfloom/_native.pyi

# Generate what is not in git: the classes of messages, the façades, the manifests. Each target here does so, too.
generated:
	$(set_up) demo

# Install the real rclpy, on Fast DDS, in build/ros-peer: the peer of tests and benchmarks.
ros-peer:
	@$(PYTHON) -m tools.ros_peer

# Peers that cannot be installed are named, and not measured.
bench:
	$(set_up) test
	-$(set_up) bench
	-@$(PYTHON) -m tools.ros_peer
	"$(BIN)/python" -m benchmarks $(ARGS)

# Build the documentation as HTML pages, in build/docs; a warning is an error. It needs no network and no compiler.
docs:
	$(set_up) docs
	"$(BIN)/python" -m sphinx -q -W --keep-going -b html docs build/docs
	@echo "The pages begin at build/docs/index.html"

# Run the core tests on each Python 3.10 to 3.15 of this machine, including free-threaded ones.
matrix:
	.ci/matrix $(ARGS)

# Run tfloom on Debian testing, and on Debian 13 for arm64 by qemu, in chroots; needs root, and says what else.
platforms:
	$(set_up) demo
	@"$(BIN)/python" -m tools.platforms $(ARGS)

# Collect all downloads of set-up, tests and checks in the folder wheels/, for a machine without a network.
wheels:
	$(set_up) wheels

# Build the sdists and this system's wheels in dist/, and check them.
dist:
	@$(PYTHON) -m tools.release

# List the licences of what tfloom is built with, needs, and is developed with; fail on one that isn't accepted.
licenses:
	$(set_up) check
	@"$(BIN)/python" -m tools.licenses

clean:
	rm -rf "$(VENV)" build dist
