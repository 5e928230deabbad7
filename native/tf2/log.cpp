#include "tf2/log.hpp"

#include "tf2/text.hpp"

namespace tfloom::tf2 {

void Log::set_callback(LogCallback callback) {
  auto replaced = callback ? std::make_shared<const LogCallback>(std::move(callback)) : nullptr;
  const std::lock_guard lock(mutex_);
  callback_.swap(replaced);
}

void Log::report(Severity severity, std::string_view topic, std::string_view frame, std::string text) {
  // The callback is a user's, so it is called without the lock; the copy keeps it alive if it is replaced meanwhile.
  std::shared_ptr<const LogCallback> callback;
  {
    const std::lock_guard lock(mutex_);
    if (!callback_) return;
    const auto now = Clock::now();
    Recent& before = recent(topic, frame, now);
    if (now - before.last < period) {
      ++before.held_back;
      return;
    }
    if (before.held_back > 0) text += join("\n(", std::to_string(before.held_back), " more like this were held back)");
    before = {now, 0};
    callback = callback_;
  }
  (*callback)(severity, text);
}

Log::Recent& Log::recent(std::string_view topic, std::string_view frame, Clock::time_point now) {
  const Recent never{now - 2 * period, 0};
  if (recent_.size() >= max_remembered) {
    std::erase_if(recent_, [&](const auto& entry) { return now - entry.second.last >= period; });
  }
  // If there are too many names in one second, all further frames of a topic share one entry.
  const bool is_full = recent_.size() >= max_remembered;
  return recent_.try_emplace({std::string(topic), std::string(is_full ? "" : frame)}, never).first->second;
}

}  // namespace tfloom::tf2
