// Fuzzes the codec's walk: an input holds a plan and bytes; what can be read must survive writing and reading.
//
//   fuzz_cdr SECONDS [CORPUS_FOLDER [SEED]]      mutates the corpus by itself, on any compiler
//
// With clang, `-DTFLOOM_LIBFUZZER -fsanitize=fuzzer,address,undefined` makes it a libFuzzer program instead.
//
// An input: the number of plans, then for each the number of its fields, then for each of these kind, shape, count,
// string bound and, for a message, which of the plans before; the last plan is the message's. CDR follows.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "value_tree.hpp"

namespace {

using namespace tfloom::cdr;
using Bytes = std::vector<std::uint8_t>;
using Plans = std::vector<std::unique_ptr<Plan>>;

class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t next() { return at_ < bytes_.size() ? bytes_[at_++] : 0; }
  // A copy that ends with its allocation, so that the sanitizer sees one byte too many.
  [[nodiscard]] std::vector<std::byte> rest() const {
    std::vector<std::byte> copy(bytes_.size() - at_);
    if (!copy.empty()) std::memcpy(copy.data(), bytes_.data() + at_, copy.size());
    return copy;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

Field read_field(Input& input, const Plans& before) {
  Field field;
  field.name = "f";
  field.kind = static_cast<Kind>(input.next() % 15);
  field.shape = static_cast<Shape>(input.next() % 4);
  field.count = std::max<std::uint32_t>(input.next(), 1);  // no definition has arrays of length 0
  field.string_bound = input.next();
  if (field.kind == Kind::message) {
    const std::uint8_t which = input.next();
    if (before.empty()) field.kind = Kind::string;
    else field.message = before[which % before.size()].get();
  }
  return field;
}

Plans read_plans(Input& input) {
  Plans plans;
  for (int left = input.next() % 32; left >= 0; --left) {
    auto plan = std::make_unique<Plan>();
    plan->name = "fuzz/msg/Plan";
    for (int fields = input.next() % 32; fields > 0; --fields) plan->fields.push_back(read_field(input, plans));
    plan->update_least_size();
    plans.push_back(std::move(plan));
  }
  return plans;
}

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "fuzz_cdr: %s\n", what);
  std::abort();
}

std::vector<std::byte> encode(const Tree& tree, const Plan& plan) {
  TreeStorage storage;
  Writer out(storage, 0);
  TreeSource source;
  Emitter(source, out).message(&tree, plan);
  storage.bytes.resize(out.size());
  return storage.bytes;
}

Tree decode(std::span<const std::byte> bytes, const Plan& plan) {
  Cursor in(bytes);
  TreeSink sink;
  return Reader(in, sink).message(plan);
}

// Returns whether the bytes were read.
bool run(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const Plans plans = read_plans(input);
  const Plan& plan = *plans.back();
  const auto data = input.rest();
  Tree tree;
  try {
    tree = decode(data, plan);
  } catch (const DecodeError& error) {
    if (error.offset > data.size()) fail("an error lies beyond the end");
    return false;
  }
  const auto once = encode(tree, plan);
  if (once != encode(decode(once, plan), plan)) fail("what was written is read as something else");
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  run({data, size});
  return 0;
}

#ifndef TFLOOM_LIBFUZZER
namespace {

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

std::vector<Bytes> load(const char* folder) {
  std::vector<Bytes> corpus{Bytes{0, 1, 11, 0, 0, 0, 0, 1, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8}};
  if (folder == nullptr) return corpus;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return corpus;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("usage: fuzz_cdr SECONDS [CORPUS_FOLDER [SEED]]\n", stderr);
    return 2;
  }
  auto corpus = load(count > 2 ? arguments[2] : nullptr);
  std::size_t sound = 0;
  for (const Bytes& bytes : corpus) sound += run(bytes) ? 1 : 0;
  const std::size_t seeds = corpus.size();
  const auto seed = count > 3 ? static_cast<std::uint32_t>(std::atoll(arguments[3])) : std::random_device{}();
  std::printf("seed %u: the same seed and corpus give the same inputs\n", seed);
  std::fflush(stdout);
  Mutator mutator(std::move(corpus), seed);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(std::atof(arguments[1]));
  std::size_t runs = 0;
  std::size_t accepted = 0;
  for (; std::chrono::steady_clock::now() < end; ++runs) {
    accepted += run(mutator.next()) ? 1 : 0;
  }
  std::printf("%zu of %zu seeds read; %zu inputs, %zu read, %zu refused\n", sound, seeds, runs, accepted, runs - accepted);
  return 0;
}
#endif
