// Arrays in and out of a buffer. Python code converts and checks the arrays; these functions accept one kind only.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "bindings/gil.hpp"
#include "bindings/tf2_arguments.hpp"
#include "bindings/tf2_buffer.hpp"
#include "tf2/batch.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using tf2::Stamp;
using tf2::Transform;

template <class T, class... Shape>
using Array = nb::ndarray<T, nb::c_contig, nb::device::cpu, Shape...>;
using Stamps = Array<const std::int64_t, nb::ndim<1>>;
using Rows = Array<const double, nb::shape<-1, 7>>;
using OutRows = Array<double, nb::shape<-1, 7>>;
using Mask = Array<std::uint8_t, nb::ndim<1>>;
template <class T>
using Points = Array<const T, nb::shape<-1, 3>>;
template <class T>
using OutPoints = Array<T, nb::shape<-1, 3>>;

// A row is translation x, y, z and rotation x, y, z, w, the same layout as a Transform.
static_assert(sizeof(Transform) == 7 * sizeof(double));

Transform transform_at(const double* row) {
  return {{row[0], row[1], row[2]}, {row[3], row[4], row[5], row[6]}};
}

template <class... Sizes>
void require_equal(std::size_t size, Sizes... sizes) {
  if (((size != sizes) || ...)) throw nb::value_error("the arrays must be of one length");
}

[[noreturn]] void raise(const tf2::FailedStamp& failed) {
  const nb::object exception = exception_of(failed.error);
  exception.attr("index") = failed.index;
  PyErr_SetObject(exception.type().ptr(), exception.ptr());
  throw nb::python_error();
}

void lookup_many(const BufferHandle& self, const NameArgument& target, const NameArgument& source,
                 const Stamps& stamps, const OutRows& out, const Mask& known, bool is_strict, unsigned workers) {
  require_equal(stamps.size(), out.shape(0), known.size());
  std::optional<tf2::FailedStamp> failed;
  {
    const ReleasedGil release;
    failed = tf2::lookup_many(*self.buffer, target.text, source.text, {stamps.data(), stamps.size()},
                              {reinterpret_cast<Transform*>(out.data()), out.shape(0)},
                              {known.data(), known.size()}, is_strict, workers);
  }
  if (failed) raise(*failed);
}

std::size_t set_many(BufferHandle& self, const NameArgument& frame_id, const NameArgument& child_frame_id,
                     const Stamps& stamps, const Rows& rows, const NameArgument& authority) {
  require_equal(stamps.size(), rows.shape(0));
  const ReleasedGil release;
  constexpr std::size_t chunk_size = 1024;  // entries inserted under one lock
  std::vector<tf2::Entry> entries;
  std::size_t stored = 0;
  for (std::size_t start = 0; start < stamps.size(); start += chunk_size) {
    entries.clear();
    for (std::size_t i = start; i < std::min(start + chunk_size, stamps.size()); ++i) {
      entries.push_back({frame_id.text, child_frame_id.text, stamps.data()[i], transform_at(rows.data() + 7 * i)});
    }
    stored += self.buffer->set(entries, authority.text, false);
  }
  return stored;
}

nb::tuple samples(const BufferHandle& self, const NameArgument& frame_id, const NameArgument& child_frame_id) {
  std::vector<tf2::Sample> found;
  {
    const ReleasedGil release;
    found = self.buffer->samples(frame_id.text, child_frame_id.text);
  }
  nb::bytearray stamps, rows;
  stamps.resize(found.size() * sizeof(Stamp));
  rows.resize(found.size() * sizeof(Transform));
  auto* stamp = static_cast<char*>(stamps.data());
  auto* row = static_cast<char*>(rows.data());
  {
    const ReleasedGil release;  // no other thread has a reference to the two bytearrays yet
    for (const tf2::Sample& sample : found) {
      std::memcpy(stamp, &sample.stamp, sizeof(Stamp));
      std::memcpy(row, &sample.value, sizeof(Transform));
      stamp += sizeof(Stamp);
      row += sizeof(Transform);
    }
    std::vector<tf2::Sample>().swap(found);  // free the memory without the GIL, because that takes long too
  }
  return nb::make_tuple(stamps, rows);
}

template <class T>
void move_points(const Array<const double, nb::shape<7>>& transform, const Points<T>& points,
                 const OutPoints<T>& out) {
  require_equal(points.shape(0), out.shape(0));
  const Transform value = transform_at(transform.data());
  const ReleasedGil release;
  tf2::move_points(value, points.data(), out.data(), points.shape(0));
}

template <class T>
void deskew(const BufferHandle& self, const NameArgument& fixed, const NameArgument& source,
            const Array<const double, nb::shape<7>>& first, const Stamps& stamps, const Points<T>& points,
            const OutPoints<T>& out, unsigned workers) {
  require_equal(stamps.size(), points.shape(0), out.shape(0));
  const Transform target_from_fixed = transform_at(first.data());
  std::optional<tf2::FailedStamp> failed;
  {
    const ReleasedGil release;
    failed = tf2::deskew(*self.buffer, fixed.text, source.text, target_from_fixed, {stamps.data(), stamps.size()},
                         points.data(), out.data(), workers);
  }
  if (failed) raise(*failed);
}

template <class T>
void bind_points(nb::module_& m, nb::class_<BufferHandle>& buffer, const std::string& type) {
  m.def(("move_points_" + type).c_str(), &move_points<T>, "transform"_a, "points"_a, "out"_a,
        "Apply `transform` (7,) to `points` (N, 3) and write them into `out`, which may be `points`.");
  buffer.def(("deskew_" + type).c_str(), &deskew<T>, "fixed_frame"_a, "source_frame"_a, "target_from_fixed"_a,
             "stamps_ns"_a, "points"_a, "out"_a, "workers"_a,
             "Transform `points` (N, 3) from `source_frame` at `stamps_ns` (N,) into `fixed_frame`, then by "
             "`target_from_fixed` (7,), and write them into `out`.\n\n"
             "Raises as `lookup` does for the first stamp that fails, with its `index`.");
}

void matrices(const Rows& rows, const Array<double, nb::shape<-1, 4, 4>>& out) {
  require_equal(rows.shape(0), out.shape(0));
  const ReleasedGil release;
  const auto* transform = reinterpret_cast<const Transform*>(rows.data());
  double* m = out.data();
  for (std::size_t i = 0; i < rows.shape(0); ++i, ++transform, m += 16) {
    const auto r = tf2::rotation_matrix(transform->rotation);
    const auto& p = transform->translation;
    const double values[16] = {r[0], r[1], r[2], p.x, r[3], r[4], r[5], p.y, r[6], r[7], r[8], p.z, 0, 0, 0, 1};
    std::memcpy(m, values, sizeof values);
  }
}

}  // namespace

void bind_tf2_batch(nb::module_& m, nb::class_<BufferHandle>& type) {
  nb::class_<tf2::Edge>(m, "Edge", "A frame, its newest parent, and the range of its history.")
      .def_ro("child_frame_id", &tf2::Edge::child_frame_id, "The frame.")
      .def_ro("frame_id", &tf2::Edge::frame_id, "Its parent, by the newest sample.")
      .def_ro("authority", &tf2::Edge::authority, "Authority of the last insert.")
      .def_ro("is_static", &tf2::Edge::is_static, "Whether it is valid at all times.")
      .def_ro("oldest_ns", &tf2::Edge::oldest, "Stamp of the oldest sample [ns since epoch]; 0 if static.")
      .def_ro("newest_ns", &tf2::Edge::newest, "Stamp of the newest sample [ns since epoch]; 0 if static.")
      .def_ro("sample_count", &tf2::Edge::sample_count, "Number of samples.");
  type.def("fill_many", &lookup_many, "target_frame"_a, "source_frame"_a, "stamps_ns"_a, "out"_a, "known"_a,
           "strict"_a, "workers"_a,
           "Fill `out` (N, 7) with the transforms at `stamps_ns` (N,), `known` (N,) with whether there is one.\n\n"
           "With `strict`, raises as `lookup` does for the first stamp that fails, with its `index`.")
      .def("store_many", &set_many, "frame_id"_a, "child_frame_id"_a, "stamps_ns"_a, "rows"_a, "authority"_a,
           "Store `rows` (N, 7) at `stamps_ns` (N,). Return how many were stored.")
      .def("samples", &samples, "frame_id"_a, "child_frame_id"_a,
           nb::sig("def samples(self, frame_id: str, child_frame_id: str) -> tuple[bytearray, bytearray]"),
           "Return the stamps (int64) and rows (7 float64 each) stored for an edge, as bytes.")
      .def("edges", [](const BufferHandle& self) { return self.buffer->edges(); }, nb::call_guard<ReleasedGil>(),
           "Return each frame that has a parent, in order of first mention.")
      .def("remove_frame",
           [](BufferHandle& self, const NameArgument& name) {
             const ReleasedGil release;
             return self.buffer->remove_frame(name.text);
           },
           "frame_id"_a,
           "Remove a frame: its name, its transforms and those of its children to it.\n\n"
           "Returns False if it is unknown.")
      .def_prop_ro("memory", [](const BufferHandle& self) { return self.buffer->memory(); },
                   nb::call_guard<ReleasedGil>(),
                   "Memory of all histories [octets].");
  bind_points<float>(m, type, "float32");
  bind_points<double>(m, type, "float64");
  m.def("matrices", &matrices, "rows"_a, "out"_a, "Write the matrices of `rows` (N, 7) into `out` (N, 4, 4).");
}

}  // namespace tfloom::bindings
