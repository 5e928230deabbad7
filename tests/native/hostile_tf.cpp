// Truncated, spoilt and random bytes into a TF sink. Ends with 0; the sanitizer watches the memory.
#include <random>
#include <string>
#include <vector>

#include "cdr/tf_message.hpp"
#include "tf_bytes.hpp"

using tfloom::cdr::TfSink;

namespace {

// A copy that ends with its allocation, so that the sanitizer sees one byte too many.
void push(TfSink& sink, const std::byte* data, std::size_t size) {
  const std::vector<std::byte> exact(data, data + size);
  sink.push(exact, {});
}

}  // namespace

int main() {
  const auto buffer = std::make_shared<tfloom::tf2::Buffer>();
  TfSink sink(buffer, "me", false, [](const auto&...) {});
  const Bytes sound = tf_bytes(5, 3);
  for (std::size_t size = 0; size <= sound.size(); ++size) push(sink, sound.data(), size);
  if (sink.dropped_count() != sound.size()) return 1;

  std::mt19937 random(1);
  for (int n = 0; n < 20'000; ++n) {
    Bytes spoilt = sound;
    for (int k = 0; k < 3; ++k) spoilt[random() % spoilt.size()] = static_cast<std::byte>(random());
    push(sink, spoilt.data(), random() % (spoilt.size() + 1));
  }
  // Spoilt names may have moved any frame; that each can be asked for is what counts.
  const auto names = buffer->frame_names();
  for (const std::string& name : names) static_cast<void>(buffer->lookup(tfloom::tf2::Query::at("frame0", name, 0)));
  static_cast<void>(buffer->all_frames_as_yaml(0.0));
  return names.size() >= 4 && sink.dropped_count() < sink.message_count() ? 0 : 1;
}
