// What a program of this folder finds wrong, in any of its threads: printed, and counted for its exit code.
#pragma once

#include <atomic>
#include <cstdio>
#include <string>

inline std::atomic<int> faults{0};

inline void check(bool holds, const char* what) {
  if (holds) return;
  ++faults;
  std::fprintf(stderr, "fault: %s\n", what);
}

inline void check(bool holds, const std::string& what) { check(holds, what.c_str()); }
