#include "tf2/requests.hpp"

#include <algorithm>

namespace tfloom::tf2 {

Requests::Handle Requests::add(Request request) {
  const std::lock_guard lock(mutex_);
  request.handle = ++last_;
  requests_.push_back(std::make_shared<const Request>(std::move(request)));
  count_.store(requests_.size());
  return last_;
}

bool Requests::cancel(Handle handle) {
  std::shared_ptr<const Request> cancelled;  // destroyed after the lock, because its callback may own anything
  const std::lock_guard lock(mutex_);
  const auto place = std::find_if(requests_.begin(), requests_.end(),
                                  [handle](const auto& request) { return request->handle == handle; });
  if (place == requests_.end()) return false;
  cancelled = std::move(*place);
  requests_.erase(place);
  count_.store(requests_.size());
  return true;
}

void Requests::clear() {
  std::vector<std::shared_ptr<const Request>> cancelled;  // destroyed after the lock, as in `cancel`
  const std::lock_guard lock(mutex_);
  cancelled.swap(requests_);
  count_.store(0);
}

}  // namespace tfloom::tf2
