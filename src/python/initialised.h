// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <utility>

namespace line_plane_segmentation {

/// Returns the C++ object of a Python object. An object created by __new__ alone has none: pybind11 would
/// allocate it without constructing it.
/// @throws pybind11::type_error if the object has none, or is of another class
template <typename Class>
Class& initialised(const pybind11::object& self) {
  const bool is_one = pybind11::isinstance<Class>(self);
  auto* const instance = reinterpret_cast<pybind11::detail::instance*>(self.ptr());
  if (!is_one || !instance->get_value_and_holder().holder_constructed()) {
    throw pybind11::type_error("self is not an object on which __init__() was called");
  }
  return self.cast<Class&>();
}

/// Binds a method to objects on which __init__() was called.
template <typename Class, typename Result, typename... Arguments>
auto initialised(Result (Class::*method)(Arguments...)) {
  return [method](const pybind11::object& self, Arguments... arguments) -> Result {
    return (initialised<Class>(self).*method)(std::forward<Arguments>(arguments)...);
  };
}

template <typename Class, typename Result, typename... Arguments>
auto initialised(Result (Class::*method)(Arguments...) const) {
  return [method](const pybind11::object& self, Arguments... arguments) -> Result {
    return (initialised<Class>(self).*method)(std::forward<Arguments>(arguments)...);
  };
}

}  // namespace line_plane_segmentation
