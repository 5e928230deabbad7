"""The native code without each of its optimisations, as edits of its files.

An edit replaces a text that occurs once in the file; a whole file is replaced by one in `plain/`. So the shipped code
has no switches, and `tests/native/test_plain.py` fails if an edit no longer fits it.
"""

from __future__ import annotations

from pathlib import Path

HERE = Path(__file__).parent
NATIVE = HERE.parent.parent / "native"

Edits = list[tuple[str, str]]
EDITS: dict[str, dict[str, Edits | str]] = {
    "name index": {"tf2/name_index.hpp": "name_index.hpp"},
    "prefetch": {"tf2/buffer.cpp": [("      prefetch_frames(group);\n", "")]},
    "chain product": {"tf2/chain.hpp": "chain.hpp", "tf2/chain.cpp": []},
    "newest links": {
        "tf2/frames.hpp": [
            (
                "const Newest& newest(FrameId id) const { return newest_[id]; }",
                (
                    "Newest newest(FrameId id) const {\n"
                    "    const Frame& frame = *frames_[id];\n"
                    "    return {frame.newest_stamp(), frame.newest_parent(), frame.kind == Frame::Kind::moving};\n"
                    "  }"
                ),
            ),
            ("return newest_values_[id];", "return *frames_[id]->newest_value();"),
            (
                (
                    "    const Frame& frame = *frames_[id];\n"
                    "    newest_[id] = {frame.newest_stamp(), frame.newest_parent(), "
                    "frame.kind == Frame::Kind::moving};\n"
                    "    if (const Transform* value = frame.newest_value()) newest_values_[id] = *value;\n"
                ),
                "    static_cast<void>(id);\n",
            ),
        ],
        "tf2/walk.cpp": [
            ("is_uniform_ &= newest.stamp == first;", "is_uniform_ = false;"),
            ("is_uniform_ = true;", "is_uniform_ = false;"),
        ],
    },
    "slerp series": {
        "tf2/transform.hpp": [
            (
                (
                    "  if (one_minus_cos < 1e-4) return slerp_by_series<4>(r, one_minus_cos);  // θ < 0.8°\n"
                    "  if (one_minus_cos < slerp_series_farthest) "
                    "return slerp_by_series<8>(r, one_minus_cos);\n"
                ),
                "  if (one_minus_cos < 1e-12) return {1.0 - r, r};\n",
            )
        ]
    },
    "near slerp": {
        "tf2/transform.hpp": [
            ("bool is_near() const { return is_near_; }", "static constexpr bool is_near() { return false; }")
        ]
    },
    "columns": {
        "tf2/columns.cpp": [
            (
                '#define TFLOOM_INDEPENDENT _Pragma("GCC ivdep")',
                '#define TFLOOM_INDEPENDENT\n#pragma GCC optimize("no-tree-vectorize")',
            ),
            ("#ifdef __GNUC__\ntypedef double Lanes", "#if 0\ntypedef double Lanes"),
        ],
        "core/vector_width.hpp": [("#if defined(__GNUC__) && defined(__x86_64__)", "#if 0")],
    },
    "wide vectors": {"core/vector_width.hpp": [("#if defined(__GNUC__) && defined(__x86_64__)", "#if 0")]},
    "search hint": {
        "tf2/branch.cpp": [
            ("if (block.stamps.empty()) return i;", "if (block.stamps.size() != SIZE_MAX) return i;")
        ]
    },
    "radix order": {"tf2/stamp_order.cpp": [("fewest = 512", "fewest = SIZE_MAX")]},
    "any order": {"tf2/batch.cpp": [("is_sorted = std::ranges::is_sorted(part)", "is_sorted = true")]},
    "four at once": {"core/four.hpp": [("#ifdef __GNUC__", "#if 0")]},
    "canonical": {"tf2/transform.hpp": [("if (std::abs(n - 1.0) < 5e-9) {", "if (n == -1.0) {")]},
    "append": {"tf2/buffer.cpp": [("if (names.child == no_parent || ", "if (true || ")]},
    "names before": {
        "tf2/buffer.cpp": [
            (
                "  if (entry.child_frame_id != last.child_frame_id || entry.frame_id != last.frame_id) {",
                "  {",
            )
        ]
    },
    "message pool": {
        "bindings/message_memory.cpp": [
            ("#if !defined(Py_GIL_DISABLED) && !defined(PYPY_VERSION)", "#if defined(PYPY_VERSION)")
        ]
    },
    "shared 0 and 1": {
        "bindings/objects.hpp": [
            (
                (
                    "    if (bits == 0) return Py_NewRef(zero);\n"
                    "    if (bits == std::bit_cast<std::uint64_t>(1.0)) return Py_NewRef(one);\n"
                ),
                "    static_cast<void>(bits), static_cast<void>(zero), static_cast<void>(one);\n",
            )
        ]
    },
    "ASCII text": {
        "bindings/objects.cpp": [
            ("  if (is_ascii(text)) {", "  if (text.data() == nullptr && is_ascii(text)) {")
        ]
    },
    "size hint": {"bindings/cdr.cpp": [("out(storage, plan.last_size)", "out(storage, 64)")]},
    "wake-up if waiting": {
        "core/ready_queue.cpp": [
            (
                '"wake-up if waiting".\n    if (!std::exchange(is_waiting_, false)) return;\n',
                '"wake-up if waiting".\n',
            )
        ]
    },
    "busy wait": {
        "core/ready_queue.cpp": [
            ("busy_wait_.wait(has_tokens_, deadline.left()) && take(tokens, quiet)", "false")
        ]
    },
    "short slice": {
        "dds/reader.cpp": [("if (is_of_library()) use_short_slice();", "static_cast<void>(is_of_library);")]
    },
    "kept memory": {
        "core/kept_memory.hpp": [
            ("if (message_size < min_kept_memory) return;", "if (message_size != SIZE_MAX) return;")
        ]
    },
    "decoded in place": {
        "bindings/dds.cpp": [("if (data.size() < min_kept_memory) return", "if (data.size() > 0) return")]
    },
    "fair mutex": {"tf2/fair_mutex.hpp": [("#ifdef __GLIBC__\n\nclass", "#ifdef _WIN32\n\nclass")]},
}
"""For each optimisation, its files, each with its edits or with the name of the file in `plain/` that replaces it."""


def write_plain(name: str, folder: Path) -> set[str]:
    """Write the files that `name` changes into `folder`, laid out as `native/`, and return their paths in it."""
    for path, change in EDITS[name].items():
        text = (NATIVE / path).read_text("utf-8")
        if isinstance(change, str):
            text = (HERE / "plain" / change).read_text("utf-8")
        elif not change:  # the plain form needs only the header
            text = f'#include "{path.replace(".cpp", ".hpp")}"\n'
        else:
            for old, new in change:
                if text.count(old) != 1:
                    raise ValueError(
                        f"'{name}': native/{path} has this {text.count(old)} times, not once: {old}"
                    )
                text = text.replace(old, new)
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text("utf-8") != text:
            target.write_text(text, "utf-8")
    return set(EDITS[name])
