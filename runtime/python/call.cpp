// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/python/call.hpp"

#include <algorithm>
#include <cmath>

#include "kanec/abi.h"
#include "runtime/python/errors.hpp"

namespace kanec::python {
namespace {

constexpr std::array<const char*, 3> state_names = {"x", "y", "ydot"};

std::vector<npy_intp> with_count(npy_intp count, const std::vector<long>& shape) {
  std::vector<npy_intp> all = {count};
  all.insert(all.end(), shape.begin(), shape.end());
  return all;
}

// (rows, columns, count) seen as (count, rows, columns).
py::object count_first(const py::object& array) {
  const int axes = PyArray_NDIM(array_of(array));
  std::vector<npy_intp> places = {axes - 1};
  for (int axis = 0; axis < axes - 1; ++axis) places.push_back(axis);
  PyArray_Dims order = {places.data(), axes};
  PyObject* seen = PyArray_Transpose(array_of(array), &order);
  if (seen == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::object>(seen);
}

template <class Real>
std::span<const Real> span_of(PyArrayObject* array) {
  return {static_cast<const Real*>(PyArray_DATA(array)), static_cast<std::size_t>(PyArray_SIZE(array))};
}

// Not an array of numbers in any case.
bool is_single(PyObject* object) {
  return PyUnicode_Check(object) || PyComplex_Check(object) || object == Py_None || PyFloat_Check(object) ||
         PyLong_Check(object) || PyArray_CheckScalar(object) ||
         (PyArray_Check(object) && PyArray_NDIM(reinterpret_cast<PyArrayObject*>(object)) == 0);
}

}  // namespace

Call::Call(const Callable& callable, const Arguments& arguments) : callable_(callable), arguments_(arguments) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (arguments.state[i] == nullptr) continue;
    state_[i] = PyArray_Check(arguments.state[i]) ? py::reinterpret_borrow<py::object>(arguments.state[i])
                                                  : as_array(arguments.state[i], where(state_names[i]));
    PyArrayObject* array = array_of(state_[i]);
    const int axes = PyArray_NDIM(array);
    if ((axes != 1 && axes != 2) || PyArray_DIM(array, axes - 1) != width(i))
      refuse(where(state_names[i]), description(state_[i].ptr()),
             "shape " + shape_text({width(i)}) + ", or (count, " + std::to_string(width(i)) + ") for many states");
  }
}

std::string Call::where(const char* what) const {
  return callable_.model->evaluator.model().name() + ", " + callable_.function.name + ": " + what;
}

npy_intp Call::width(std::size_t i) const {
  const kanec_model& model = callable_.model->evaluator.model().abi();
  return i == 0 ? model.nx : model.ny;
}

bool Call::reads(std::size_t i) const {
  const Function& function = callable_.function;
  return i == 0 ? function.reads_x : i == 1 ? function.reads_y : function.reads_ydot;
}

const std::string& Call::value_name(int number) const {
  return callable_.model->value_names[static_cast<std::size_t>(number)];
}

PyObject* Call::result() {
  find_count();
  if (count_ < 0) return one_state();
  return reads_float() ? many_states<float>() : many_states<double>();
}

// One state

double Call::single(PyObject* object, const char* what) const {
  return PyFloat_Check(object) ? PyFloat_AS_DOUBLE(object) : number(object, where(what));
}

std::span<const double> Call::one(std::size_t i) {
  if (!reads(i)) return {};
  if (!state_[i]) refuse(where(state_names[i]), "nothing", "an array of shape " + shape_text({width(i)}));
  PyArrayObject* array = array_of(state_[i]);
  if (PyArray_TYPE(array) != NPY_DOUBLE || !PyArray_ISCARRAY_RO(array)) {
    state_[i] = converted(array, NPY_DOUBLE, where(state_names[i]));
    array = array_of(state_[i]);
  }
  return {static_cast<const double*>(PyArray_DATA(array)), static_cast<std::size_t>(width(i))};
}

void Call::set_values(Evaluator& evaluator) const {
  std::vector<double> parameters(evaluator.parameters().begin(), evaluator.parameters().end());
  std::vector<double> inputs(evaluator.inputs().begin(), evaluator.inputs().end());
  bool any_parameter = false, any_input = false;
  for (const auto& [place, object] : arguments_.values) {
    const double value = single(object, value_name(place).c_str());
    const auto k = static_cast<std::size_t>(place);
    const bool is_parameter = k < parameters.size();
    (is_parameter ? parameters[k] : inputs[k - parameters.size()]) = value;
    (is_parameter ? any_parameter : any_input) = true;
  }
  if (any_parameter) evaluator.set_parameters(parameters);
  if (any_input) evaluator.set_inputs(inputs);
}

PyObject* Call::one_state() {
  const StateView state = {arguments_.t == nullptr ? 0.0 : single(arguments_.t, "t"), one(0), one(1), one(2)};
  const std::vector<long>& shape = callable_.shape;
  const py::object out = result_array({shape.begin(), shape.end()}, NPY_DOUBLE, Order::states);
  const std::span<double> numbers = {static_cast<double*>(PyArray_DATA(array_of(out))),
                                     static_cast<std::size_t>(callable_.function.size)};
  const auto evaluate = [&](const Evaluator& evaluator) {
    if (!callable_.is_long) return evaluator.evaluate(callable_.function, state, numbers);
    const py::gil_scoped_release unlocked;
    evaluator.evaluate(callable_.function, state, numbers);
  };
  if (arguments_.values.empty()) {
    evaluate(callable_.model->evaluator);
  } else {
    Evaluator own = callable_.model->evaluator;
    set_values(own);
    evaluate(own);
  }
  return out.inc_ref().ptr();
}

// Many states

void Call::set_count(PyArrayObject* array, npy_intp count, const std::string& what) {
  auto* object = reinterpret_cast<PyObject*>(array);
  if (count_ >= 0 && count != count_)
    refuse(what, description(object), std::to_string(count_) + " states, as " + description(counted_) + " has");
  count_ = count;
  counted_ = object;
}

void Call::find_count() {
  for (std::size_t i = 0; i < 3; ++i)
    if (state_[i] && PyArray_NDIM(array_of(state_[i])) == 2)
      set_count(array_of(state_[i]), PyArray_DIM(array_of(state_[i]), 0), where(state_names[i]));
  const auto look = [&](PyObject* object, const char* name) {
    if (is_single(object)) return;
    kept_.push_back(as_array(object, where(name)));
    PyArrayObject* array = array_of(kept_.back());
    if (PyArray_NDIM(array) != 1)
      refuse(where(name), description(kept_.back().ptr()), "a number, or an array of shape (count,)");
    set_count(array, PyArray_DIM(array, 0), where(name));
  };
  if (arguments_.t != nullptr) look(arguments_.t, "t");
  for (const auto& [place, object] : arguments_.values) look(object, value_name(place).c_str());
}

// Whether all that is given for many states, and read, is in float.
bool Call::reads_float() const {
  bool any = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!state_[i] || !reads(i) || PyArray_NDIM(array_of(state_[i])) != 2) continue;
    if (PyArray_TYPE(array_of(state_[i])) != NPY_FLOAT) return false;
    any = true;
  }
  return any;
}

// That of out where it is given; else entry after entry where all arrays stand so.
Order Call::order(int type) const {
  if (arguments_.out != nullptr)
    return PyArray_ISCARRAY(reinterpret_cast<PyArrayObject*>(arguments_.out)) ? Order::states : Order::entries;
  bool any = false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!state_[i] || !reads(i)) continue;
    PyArrayObject* array = array_of(state_[i]);
    if (PyArray_NDIM(array) != 2 || PyArray_TYPE(array) != type || !entry_after_entry(array)) return Order::states;
    any = any || !PyArray_ISCARRAY_RO(array);
  }
  return any ? Order::entries : Order::states;
}

// One state for all.
template <class Real>
py::object Call::repeated(std::span<const Real> state, Order order) const {
  auto array =
      py::reinterpret_steal<py::object>(new_array({count_, static_cast<npy_intp>(state.size())}, type_number<Real>));
  auto* to = static_cast<Real*>(PyArray_DATA(array_of(array)));
  if (order == Order::states)
    for (npy_intp j = 0; j < count_; ++j) to = std::copy(state.begin(), state.end(), to);
  else
    for (const Real number : state) to = std::fill_n(to, count_, number);
  return array;
}

template <class Real>
std::span<const Real> Call::many(std::size_t i, Order order) {
  if (!reads(i)) return {};
  const std::string what = where(state_names[i]);
  if (!state_[i]) refuse(what, "nothing", "an array of shape " + shape_text({count_, width(i)}));
  PyArrayObject* array = array_of(state_[i]);
  if (PyArray_NDIM(array) == 1) {
    const py::object one = converted(array, type_number<Real>, what);
    kept_.push_back(repeated(span_of<Real>(array_of(one)), order));
  } else {
    kept_.push_back(order == Order::states ? converted(array, type_number<Real>, what)
                                           : converted_by_entries(array, type_number<Real>, what));
  }
  return span_of<Real>(array_of(kept_.back()));
}

template <class Real>
std::span<const Real> Call::times() {
  if (arguments_.t == nullptr) return {};
  const py::object given = as_array(arguments_.t, where("t"));
  kept_.push_back(converted(array_of(given), type_number<Real>, where("t")));
  return span_of<Real>(array_of(kept_.back()));
}

Values Call::values() {
  Values values{&callable_.model->evaluator, {}};
  for (const auto& [place, object] : arguments_.values) {
    const std::string what = where(value_name(place).c_str());
    Given given{place, 0.0, {}};
    if (is_single(object)) {
      given.value = number(object, what);
    } else {
      const py::object array = as_array(object, what);
      kept_.push_back(converted(array_of(array), NPY_DOUBLE, what));
      given.each = span_of<double>(array_of(kept_.back()));
    }
    const std::span<const double> all = given.each.data() == nullptr ? std::span(&given.value, 1) : given.each;
    if (!std::all_of(all.begin(), all.end(), [](double value) { return std::isfinite(value); }))
      refuse(what, "a number that is not finite", "finite numbers");
    values.given.push_back(given);
  }
  return values;
}

template <class Real>
PyObject* Call::many_states() {
  if (arguments_.out != nullptr) check_out(with_count(count_, callable_.shape), type_number<Real>);
  const Order order = this->order(type_number<Real>);
  StatesView<Real> states;
  states.count = count_;
  states.order = order;
  states.t = times<Real>();
  states.x = many<Real>(0, order);
  states.y = many<Real>(1, order);
  states.ydot = many<Real>(2, order);
  const Values given = values();
  const py::object out = result_array(with_count(count_, callable_.shape), type_number<Real>, order);
  const std::span<Real> numbers = {static_cast<Real*>(PyArray_DATA(array_of(out))),
                                   static_cast<std::size_t>(PyArray_SIZE(array_of(out)))};
  {
    const py::gil_scoped_release unlocked;
    callable_.model->batches->evaluate(callable_.request, states, given, numbers);
  }
  return out.inc_ref().ptr();
}

// Results

void Call::check_out(const std::vector<npy_intp>& shape, int type) const {
  auto* out = reinterpret_cast<PyArrayObject*>(arguments_.out);
  const bool fits = PyArray_Check(arguments_.out) && PyArray_TYPE(out) == type && PyArray_ISWRITEABLE(out) &&
                    PyArray_NDIM(out) == static_cast<int>(shape.size()) &&
                    std::equal(shape.begin(), shape.end(), PyArray_DIMS(out)) &&
                    (PyArray_ISCARRAY(out) || (count_ >= 0 && entry_after_entry(out)));
  if (!fits)
    refuse(where("out"), description(arguments_.out),
           std::string("a writeable array of ") + (type == NPY_FLOAT ? "float32" : "float64") + ", shape " +
               shape_text(shape) + ", without gaps");
  for (std::size_t i = 0; i < 3; ++i)
    if (state_[i] && overlap(out, array_of(state_[i])))
      refuse(where("out"), std::string("memory of ") + state_names[i], "an array of its own");
}

py::object Call::result_array(const std::vector<npy_intp>& shape, int type, Order order) {
  if (arguments_.out != nullptr) {
    if (count_ < 0) check_out(shape, type);
    return py::reinterpret_borrow<py::object>(arguments_.out);
  }
  if (order == Order::states) return py::reinterpret_steal<py::object>(new_array(shape, type));
  std::vector<npy_intp> turned(shape.begin() + 1, shape.end());
  turned.push_back(shape.front());
  return count_first(py::reinterpret_steal<py::object>(new_array(turned, type)));
}

}  // namespace kanec::python
