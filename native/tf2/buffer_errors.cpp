// The texts of a buffer's errors. They equal tf2's to the letter, because programs and users search for them.
#include "tf2/buffer.hpp"
#include "tf2/text.hpp"

namespace tfloom::tf2 {
namespace {

std::string reason_text(const Failure& failure, const Frame& frame) {
  using Found = Bracket::Found;
  const std::string requested = time_text(failure.stamp);
  switch (failure.reason) {
    case Found::only_one:
      return join("Lookup would require extrapolation at time ", requested, ", but only time ",
                  time_text(frame.newest_stamp()), " is in the buffer");
    case Found::after_newest:
      return join("Lookup would require extrapolation into the future.  Requested time ", requested,
                  " but the latest data is at time ", time_text(frame.newest_stamp()));
    case Found::before_oldest:
      return join("Lookup would require extrapolation into the past.  Requested time ", requested,
                  " but the earliest data is at time ", time_text(frame.oldest_stamp()));
    case Found::yes:
    case Found::empty:
      break;
  }
  return "";  // a history emptied by `clear`: Jazzy has no text for it
}

Code code_of(Bracket::Found reason) {
  if (reason == Bracket::Found::after_newest) return Code::forward;
  return reason == Bracket::Found::before_oldest ? Code::backward : Code::no_data;
}

}  // namespace

Error Buffer::error_of(const Failure& failure, FrameId target, FrameId source) const {
  using Kind = Failure::Kind;
  const std::string &target_name = frames_[target].name, &source_name = frames_[source].name;
  if (failure.kind == Kind::cycle) {
    return {.code = Code::lookup,
            .text = join("The tf tree is invalid because it contains a loop.\n", frames_as_string(), "\n")};
  }
  if (failure.kind == Kind::unconnected) {
    return {.code = Code::connectivity,
            .text = join("Could not find a connection between '", target_name, "' and '", source_name,
                         "' because they are not part of the same tree.Tf has two or more unconnected trees.")};
  }
  const Frame& frame = frames_[failure.frame];
  return {.code = code_of(failure.reason),
          .text = join(reason_text(failure, frame), ", when looking up transform from frame [", source_name,
                       "] to frame [", target_name, "]"),
          .frame = frame.name,
          .requested = failure.stamp,
          .oldest = frame.oldest_stamp(),
          .newest = frame.newest_stamp()};
}

Error Buffer::name_error_of(std::string_view name, std::string_view where, Phrase phrase) const {
  const bool is_lookup = phrase == Phrase::lookup;
  const std::string_view fault = name.empty()             ? "in tf2 frame_ids cannot be empty"
                                 : name.starts_with('/')  ? "in tf2 frame_ids cannot start with a '/'"
                                                          : "";
  if (!fault.empty()) {
    return {.code = Code::invalid_argument,
            .text = join(is_lookup ? "Invalid argument \"" : "Invalid frame ID \"", name, "\" passed to ", where,
                         " - ", fault)};
  }
  if (find_frame(name)) return {.code = Code::ok};
  return {.code = Code::lookup,
          .text = is_lookup ? join("\"", name, "\" passed to ", where, " does not exist. ")
                            : join("Invalid frame ID \"", name, "\" passed to ", where, " - frame does not exist"),
          .frame = std::string(name)};
}

Error Buffer::name_error(const Query& query, Phrase phrase) const {
  const std::string_view function = phrase == Phrase::lookup ? "lookupTransform" : "canTransform";
  Error error = name_error_of(query.target, join(function, " argument target_frame"), phrase);
  if (error.code == Code::ok) error = name_error_of(query.source, join(function, " argument source_frame"), phrase);
  if (error.code == Code::ok && query.fixed) {
    error = name_error_of(*query.fixed, join(function, " argument fixed_frame"), phrase);
  }
  return error;
}

}  // namespace tfloom::tf2
