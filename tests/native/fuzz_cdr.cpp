// Fuzzes the codec's walk: an input holds a plan and bytes; what can be read must survive writing and reading.
//
// For the arguments, see fuzzing.hpp. With clang, `-DTFLOOM_LIBFUZZER -fsanitize=fuzzer,address,undefined` makes it a
// libFuzzer program instead.
//
// An input: the number of plans, then for each the number of its fields, then for each of these kind, shape, count,
// string bound and, for a message, which of the plans before; the last plan is the message's. CDR follows.
#include <memory>
#include <string>
#include <vector>

#include "fuzzing.hpp"
#include "value_tree.hpp"

namespace {

using namespace tfloom::cdr;
using fuzzing::fail;
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
    plan->update_min_size();
    plans.push_back(std::move(plan));
  }
  return plans;
}

std::vector<std::byte> encode(const Tree& tree, const Plan& plan) {
  TreeStorage storage;
  Writer out(storage, 0);
  TreeReader reader;
  Encoder(reader, out).message(&tree, plan);
  storage.bytes.resize(out.size());
  return storage.bytes;
}

Tree decode(std::span<const std::byte> bytes, const Plan& plan) {
  Cursor in(bytes);
  TreeBuilder builder;
  return Decoder(in, builder).message(plan);
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
    if (error.offset > data.size()) fail("fuzz_cdr", "an error lies beyond the end");
    return false;
  }
  const auto once = encode(tree, plan);
  if (once != encode(decode(once, plan), plan)) fail("fuzz_cdr", "what was written is read as something else");
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  run({data, size});
  return 0;
}

#ifndef TFLOOM_LIBFUZZER
int main(int count, char** arguments) {
  return fuzzing::fuzz("fuzz_cdr", run, {{0, 1, 11, 0, 0, 0, 0, 1, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8}}, count, arguments);
}
#endif
