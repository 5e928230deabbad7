"""Run the benchmarks of foxglove_bridge."""

from benchmarks.foxglove_bridge.relay import main

if __name__ == "__main__":
    main()
