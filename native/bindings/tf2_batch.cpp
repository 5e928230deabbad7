// Arrays in and out of a buffer. Python code converts and checks the arrays; these functions accept one kind only.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "bindings/gil.hpp"
#include "bindings/tf2_arguments.hpp"
#include "bindings/tf2_buffer.hpp"
#include "core/vector_width.hpp"
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
using Rotations = Array<const double, nb::shape<-1, 4>>;
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

[[noreturn]] void raise_at_index(const tf2::FailedStamp& failed) {
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
  if (failed) raise_at_index(*failed);
}

std::size_t set_many(BufferHandle& self, const NameArgument& frame_id, const NameArgument& child_frame_id,
                     const Stamps& stamps, const Points<double>& positions, const Rotations& rotations,
                     const NameArgument& authority) {
  require_equal(stamps.size(), positions.shape(0), rotations.shape(0));
  const ReleasedGil release;
  return self.buffer->set_many(
      {frame_id.text, child_frame_id.text, {stamps.data(), stamps.size()}, positions.data(), rotations.data()},
      authority.text);
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
void move_cloud(const Array<const double, nb::shape<7>>& transform, const Array<std::uint8_t, nb::ndim<1>>& bytes,
                std::array<std::size_t, 2> shape, std::array<std::size_t, 2> steps,
                std::array<std::size_t, 3> offsets) {
  const tf2::CloudLayout layout{shape[0], shape[1], steps[0], steps[1], offsets};
  if (!layout.fits(bytes.size(), sizeof(T))) throw nb::value_error("the points must lie within the bytes");
  const Transform value = transform_at(transform.data());
  const ReleasedGil release;
  tf2::move_cloud<T>(value, layout, reinterpret_cast<std::byte*>(bytes.data()));
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
  if (failed) raise_at_index(*failed);
}

template <class T>
void bind_points(nb::module_& m, nb::class_<BufferHandle>& buffer, const std::string& type) {
  m.def(("move_points_" + type).c_str(), &move_points<T>, "transform"_a, "points"_a, "out"_a,
        "Apply `transform` (7,) to `points` (N, 3) and write them into `out`, which may be `points`.");
  m.def(("move_cloud_" + type).c_str(), &move_cloud<T>, "transform"_a, "bytes"_a, "shape"_a, "steps"_a, "offsets"_a,
        "Apply `transform` (7,) to the points of a cloud, in place. Point (row, column) of `shape` begins at row * "
        "steps[0] + column * steps[1], and has x, y and z at `offsets` from there, in this machine's byte order.\n\n"
        "Raises ValueError if they are not all within `bytes` (N,).");
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
      .def_ro("sample_count", &tf2::Edge::sample_count, "Number of samples.")
      .def("_repr_html_",
           [](const nb::handle self) { return nb::module_::import_("tfloom.tf2.html").attr("edge_html")(self); },
           nb::sig("def _repr_html_(self) -> str"), "Return what a notebook shows.");
  type.def("fill_many", &lookup_many, "target_frame"_a, "source_frame"_a, "stamps_ns"_a, "out"_a, "known"_a,
           "strict"_a, "workers"_a,
           "Fill `out` (N, 7) with the transforms at `stamps_ns` (N,), `known` (N,) with whether there is one.\n\n"
           "With `strict`, raises as `lookup` does for the first stamp that fails, with its `index`.")
      .def("store_many", &set_many, "frame_id"_a, "child_frame_id"_a, "stamps_ns"_a, "positions"_a,
           "rotations_xyzw"_a, "authority"_a,
           "Store `positions` (N, 3) and `rotations_xyzw` (N, 4) at `stamps_ns` (N,). Return how many were stored.")
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
                   "Memory of all histories [bytes].");
  bind_points<float>(m, type, "float32");
  bind_points<double>(m, type, "float64");
  m.def("use_wide_vectors", &use_wide_vectors, "are_wide"_a,
        "Compute lookups at many stamps, and clouds, in vectors of four numbers, if this processor has them, or in those that every "
        "processor has. Return whether they are the wide ones. For tests: the wide ones are the default.");
  m.def("matrices", &matrices, "rows"_a, "out"_a, "Write the matrices of `rows` (N, 7) into `out` (N, 4, 4).");
}

}  // namespace tfloom::bindings
