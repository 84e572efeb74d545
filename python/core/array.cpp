// SPDX-License-Identifier: MIT
#include "python/core/array.h"

#include "python/core/dlpack.h"

#include <cstdint>
#include <functional>
#include <numeric>

#include <pybind11/stl.h>

namespace bulletnav::python {
namespace {

namespace py = pybind11;

struct TypeFacts {
  const char* name;
  const char* format;  // struct's letter
  py::ssize_t bytes;
  DlDataType dl;
};

TypeFacts FactsOf(Dtype type) {
  switch (type) {
    case Dtype::kBool:
      return {"bool", "?", 1, {kDlBool, 8, 1}};
    case Dtype::kUint8:
      return {"uint8", "B", 1, {kDlUint, 8, 1}};
    case Dtype::kInt32:
      return {"int32", "i", 4, {kDlInt, 32, 1}};
    case Dtype::kFloat32:
      return {"float32", "f", 4, {kDlFloat, 32, 1}};
    case Dtype::kFloat64:
      return {"float64", "d", 8, {kDlFloat, 64, 1}};
  }
  return {"uint8", "B", 1, {kDlUint, 8, 1}};
}

/// Bytes from one place to the next, for each dimension.
std::vector<py::ssize_t> StridesOf(const Array& array) {
  std::vector<py::ssize_t> strides(array.shape.size());
  py::ssize_t step = FactsOf(array.type).bytes;
  for (std::size_t i = array.shape.size(); i-- > 0;) {
    strides[i] = step;
    step *= array.shape[i];
  }
  return strides;
}

py::ssize_t BytesOf(const Array& array) {
  return std::accumulate(array.shape.begin(), array.shape.end(), FactsOf(array.type).bytes,
                         std::multiplies<>());
}

py::buffer_info Buffer(Array& array) {
  const TypeFacts facts = FactsOf(array.type);
  return {array.data,  facts.bytes,     facts.format, static_cast<py::ssize_t>(array.shape.size()),
          array.shape, StridesOf(array)};
}

/// What a consumer of DLPack holds until it calls `deleter`, in any thread and without the lock.
struct DlHolder {
  std::shared_ptr<const void> owner;
  std::vector<std::int64_t> shape;
  DlManagedTensor tensor = {};
};

void DropUnused(PyObject* capsule) {
  // A consumer renames what it has taken.
  if (PyCapsule_IsValid(capsule, kDlCapsule) == 0) return;
  auto* tensor = static_cast<DlManagedTensor*>(PyCapsule_GetPointer(capsule, kDlCapsule));
  tensor->deleter(tensor);
}

/// The same numbers in memory of their own.
Array CopyOf(const Array& array) {
  const auto bytes = static_cast<std::size_t>(BytesOf(array));
  auto memory = std::make_shared<std::vector<std::byte>>(array.data, array.data + bytes);
  Array copy = array;
  copy.data = memory->data();
  copy.owner = std::move(memory);
  return copy;
}

/// What the array API standard asks of a producer since 2023: memory of its own where `copy` is
/// true, the device that is asked for. A capsule of version 0 is what every consumer takes,
/// whatever `max_version`; a CPU has no `stream`.
py::capsule ToDlpack(const Array& whole, const py::object& /*stream*/,
                     const py::object& /*max_version*/, const py::object& dl_device,
                     const py::object& copy) {
  if (!dl_device.is_none() && !dl_device.equal(py::make_tuple(static_cast<int>(kDlCpu), 0))) {
    throw py::buffer_error("the memory of a bulletnav.Array is the CPU's, (1, 0)");
  }
  const Array array = py::bool_(copy) ? CopyOf(whole) : whole;
  auto holder = std::make_unique<DlHolder>();
  holder->owner = array.owner;
  holder->shape.assign(array.shape.begin(), array.shape.end());
  DlManagedTensor& managed = holder->tensor;
  managed.tensor = {array.data,
                    {kDlCpu, 0},
                    static_cast<std::int32_t>(holder->shape.size()),
                    FactsOf(array.type).dl,
                    holder->shape.data(),
                    nullptr,
                    0};
  managed.context = holder.get();
  managed.deleter = [](DlManagedTensor* self) {
    delete static_cast<DlHolder*>(self->context);  // NOLINT: the C interface owns it
  };
  py::capsule capsule(&managed, kDlCapsule, &DropUnused);
  holder.release();  // NOLINT(bugprone-unused-return-value): the capsule has it
  return capsule;
}

/// Rows first to last of the first dimension.
Array Rows(const Array& array, py::ssize_t first, py::ssize_t last) {
  Array part = array;
  part.data += first * StridesOf(array)[0];
  part.shape[0] = last - first;
  return part;
}

py::object Item(py::object self, const py::object& key) {
  const auto& array = self.cast<const Array&>();
  if (array.shape.empty()) throw py::index_error("the array " + array.name + " has no dimensions");
  if (py::isinstance<py::slice>(key)) {
    py::ssize_t first = 0;
    py::ssize_t last = 0;
    py::ssize_t step = 1;
    py::ssize_t count = 0;
    const auto slice = key.cast<py::slice>();
    if (!slice.compute(array.shape[0], &first, &last, &step, &count)) throw py::error_already_set();
    if (step != 1) throw py::index_error("slices of an Array go by 1");
    return py::cast(Rows(array, first, first + count));
  }
  if (!PyIndex_Check(key.ptr()) || array.shape.size() == 1) {
    return py::reinterpret_steal<py::object>(PyMemoryView_FromObject(self.ptr()))[key];
  }
  py::ssize_t row = key.cast<py::ssize_t>();
  if (row < 0) row += array.shape[0];
  if (row < 0 || row >= array.shape[0]) throw py::index_error("no such row in " + array.name);
  Array one = Rows(array, row, row + 1);
  one.shape.erase(one.shape.begin());
  return py::cast(std::move(one));
}

py::tuple ShapeOf(const Array& array) {
  return py::cast(array.shape).cast<py::tuple>();
}

std::string Repr(const Array& array) {
  const auto shape = py::str(ShapeOf(array)).cast<std::string>();
  return "<bulletnav.Array " + array.name + " " + FactsOf(array.type).name + " " + shape +
         (array.units.empty() ? "" : " in " + array.units) + ">";
}

}  // namespace

Dtype DtypeOf(sim::Element element) {
  switch (element) {
    case sim::Element::kUint8:
      return Dtype::kUint8;
    case sim::Element::kInt32:
      return Dtype::kInt32;
    case sim::Element::kFloat32:
      return Dtype::kFloat32;
    case sim::Element::kFloat64:
      return Dtype::kFloat64;
  }
  return Dtype::kUint8;
}

Array MakeArray(const sim::ArraySpec& spec) {
  auto memory = std::make_shared<std::vector<std::byte>>(spec.bytes());
  Array array;
  array.data = memory->data();
  array.owner = std::move(memory);
  array.shape.assign(spec.shape.begin(), spec.shape.end());
  array.type = DtypeOf(spec.element);
  array.name = spec.name;
  array.units = spec.units;
  return array;
}

void BindArray(py::module_* module) {
  py::class_<Array>(*module, "Array", py::buffer_protocol(), py::module_local(),
                    "Numbers in BulletNav's memory, seen without a copy: numpy.asarray(a),\n"
                    "memoryview(a) and torch.from_dlpack(a) all look at the same bytes.")
      .def_buffer(&Buffer)
      .def_readonly("name", &Array::name, "What it holds, as 'panorama.color'.")
      .def_readonly("units", &Array::units, "Of its values, as 'm'; empty where there are none.")
      .def_property_readonly("shape", &ShapeOf)
      .def_property_readonly("ndim",
                             [](const Array& array) {
                               return array.shape.size();
                             })
      .def_property_readonly(
          "dtype",
          [](const Array& array) {
            return FactsOf(array.type).name;
          },
          "'bool', 'uint8', 'int32', 'float32' or 'float64'.")
      .def_property_readonly("nbytes", &BytesOf)
      .def("__len__",
           [](const Array& array) {
             if (array.shape.empty()) throw py::type_error("it has no dimensions");
             return array.shape[0];
           })
      .def("__getitem__", &Item, "A row, or some rows, without a copy; a[i, j] is a number.")
      .def(
          "tolist",
          [](const py::object& self) {
            return py::reinterpret_steal<py::object>(PyMemoryView_FromObject(self.ptr()))
                .attr("tolist")();
          },
          "Nested lists, copied.")
      .def("copy", &CopyOf, "The same numbers in memory of their own.")
      .def("__dlpack__", &ToDlpack, py::kw_only(), py::arg("stream") = py::none(),
           py::arg("max_version") = py::none(), py::arg("dl_device") = py::none(),
           py::arg("copy") = py::none())
      .def("__dlpack_device__",
           [](const Array& /*array*/) {
             return py::make_tuple(static_cast<int>(kDlCpu), 0);
           })
      .def("__repr__", &Repr);
}

}  // namespace bulletnav::python
