# Each target is a line or two that a person could type. `make setup` makes .venv; the others make it if it's missing.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
export PIP_DISABLE_PIP_VERSION_CHECK = 1

.PHONY: setup demo test check stub api bench matrix clean

setup: $(VENV)/.installed

$(VENV)/.installed: pyproject.toml CMakeLists.txt packages/tfloom-ros2/pyproject.toml src/tfloom/__init__.py $(shell find native -name '*.?pp')
	@echo "Setting up $(VENV): a compile and a handful of downloads, some minutes the first time"
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade "pip>=25.1"
	$(BIN)/python -m pip install --quiet --group build --group test --group check
	$(BIN)/python -m pip install --quiet --no-build-isolation -C cmake.define.TFLOOM_WARNINGS_AS_ERRORS=ON \
		--editable ".[all]" ./packages/tfloom-ros2
	touch $@

demo: setup
	$(BIN)/tfloom demo $(ARGS)

test: setup
	$(BIN)/python -m pytest $(ARGS)

check: setup
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

# The typed face of the extension, after a change in native/bindings.
stub: setup
	$(BIN)/python -m nanobind.stubgen -m tfloom._native -q -o src/tfloom/_native.pyi

# docs/rclpy_api.md, after a change in what is there of ROS's names.
api: setup
	$(BIN)/python docs/rclpy_api.py

# Who is measured beside us is installed for this alone; a peer that can't be is named, and left out.
bench: setup
	-$(BIN)/python -m pip install --quiet --group bench
	$(BIN)/python -m benchmarks $(ARGS)

# The core tests on each Python 3.10 to 3.14 that this machine has, free-threaded ones too.
matrix:
	.ci/matrix $(ARGS)

clean:
	rm -rf $(VENV) build dist
