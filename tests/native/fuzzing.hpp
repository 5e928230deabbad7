// A fuzzer without a compiler's help: it mutates a corpus, and ends with an error or a sanitizer's report.
//
//   NAME SECONDS [CORPUS_FOLDER [SEED]]      for so long
//   NAME COUNTn [CORPUS_FOLDER [SEED]]       for so many inputs: `1000000n`
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fuzzing {

using Bytes = std::vector<std::uint8_t>;

[[noreturn]] inline void fail(const char* name, const char* what) {
  std::fprintf(stderr, "%s: %s\n", name, what);
  std::abort();
}

class Mutator {
 public:
  Mutator(std::vector<Bytes> corpus, std::uint32_t seed) : corpus_(std::move(corpus)), random_(seed) {}

  Bytes next() {
    Bytes bytes = pick();
    for (std::size_t changes = below(4) + 1; changes > 0; --changes) change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % limit; }
  const Bytes& pick() { return corpus_[below(corpus_.size())]; }

  void change(Bytes& bytes) {
    static constexpr std::uint8_t notable[] = {0, 1, 2, 4, 8, 0x7f, 0x80, 0xd8, 0xdc, 0xff};
    if (bytes.empty()) bytes.push_back(0);
    const std::size_t at = below(bytes.size());
    const auto place = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    switch (below(6)) {
      case 0: bytes[at] ^= static_cast<std::uint8_t>(1U << below(8)); break;
      case 1: bytes[at] = notable[below(std::size(notable))]; break;
      case 2: bytes[at] = static_cast<std::uint8_t>(random_()); break;
      case 3: bytes.resize(at); break;
      case 4: bytes.insert(place, below(9), notable[below(std::size(notable))]); break;
      default: {
        const Bytes& other = pick();
        bytes.erase(place, bytes.end());
        if (other.size() > at) bytes.insert(bytes.end(), other.begin() + static_cast<std::ptrdiff_t>(at), other.end());
      }
    }
  }

  std::vector<Bytes> corpus_;
  std::mt19937 random_;
};

// Add the files of a folder, in order of their names, so that a seed gives the same inputs on each machine.
inline void load(const char* folder, std::vector<Bytes>& corpus) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path());
  std::ranges::sort(paths);
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
}

// Run the corpus and then mutations of it. `run` returns whether an input was accepted.
template <class Run>
int fuzz(const char* name, const Run& run, std::vector<Bytes> corpus, int argument_count, char** arguments) {
  if (argument_count < 2) {
    std::fprintf(stderr, "usage: %s SECONDS|COUNTn [CORPUS_FOLDER [SEED]]\n", name);
    return 2;
  }
  if (argument_count > 2) load(arguments[2], corpus);
  std::size_t sound = 0;
  for (const Bytes& bytes : corpus) sound += run(bytes) ? 1 : 0;
  const std::size_t seeds = corpus.size();
  const auto seed =
      argument_count > 3 ? static_cast<std::uint32_t>(std::atoll(arguments[3])) : std::random_device{}();
  std::printf("seed %u: the same seed and corpus give the same inputs\n", seed);
  std::fflush(stdout);
  Mutator mutator(std::move(corpus), seed);
  const bool is_count = std::string(arguments[1]).ends_with('n');
  const auto most = is_count ? static_cast<std::size_t>(std::atoll(arguments[1])) : SIZE_MAX;
  const std::chrono::duration<double> duration(is_count ? 1e8 : std::atof(arguments[1]));
  const auto start = std::chrono::steady_clock::now();
  std::size_t runs = 0;
  std::size_t accepted = 0;
  for (; runs < most && std::chrono::steady_clock::now() - start < duration; ++runs) {
    accepted += run(mutator.next()) ? 1 : 0;
  }
  std::printf("%zu of %zu seeds read; %zu inputs, %zu read, %zu refused\n", sound, seeds, runs, accepted, runs - accepted);
  return 0;
}

}  // namespace fuzzing
